// Decorrelates the residuals of a fit: subtracts the prediction from neighbours, then what the points of a run share.
#pragma once

#include <memory>
#include <optional>

#include "fitting/point_indices.h"
#include "fitting/standard_errors.h"
#include "solver/random_effects.h"
#include "statistics/autoregression.h"

namespace mixity {

class Whitening {
 public:
  Whitening(std::optional<Decorrelation> neighbours, std::optional<GroupWhitening> runs)
      : neighbours_(std::move(neighbours)), runs_(std::move(runs)) {}

  /// Works in place; `stride`: distance between rows.
  void apply(std::span<double> values, std::size_t stride = 1) const {
    if (neighbours_) neighbours_->apply(values, stride);
    if (runs_) runs_->apply(values, stride);
  }
  double log_determinant() const {
    return (neighbours_ ? neighbours_->log_determinant() : 0) + (runs_ ? runs_->log_determinant() : 0);
  }
  /// Decorrelation::predicted_across; empty where neighbours do not correlate.
  std::span<const double> predicted_across() const {
    return neighbours_ ? std::span<const double>(neighbours_->predicted_across()) : std::span<const double>();
  }

 private:
  std::optional<Decorrelation> neighbours_;
  std::optional<GroupWhitening> runs_;
};

/// Whitens quantities that are fitted by run, after decorrelating their columns by `neighbours`; null without any.
std::optional<GroupWhitening> whitening_of_runs(const Dataset& data, const PointIndices& used,
                                                const StandardErrors& errors,
                                                const std::optional<Decorrelation>& neighbours);

/// Null if the residuals are independent.
std::shared_ptr<const Whitening> whitening_of(const Dataset& data, const PointIndices& used,
                                              const StandardErrors& errors);

}  // namespace mixity
