// Combines several problems into one. Each has its own parameters, and all share further ones.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "solver/problem.h"

namespace mixity {

class JointProblem final : public Problem {
 public:
  /// The parameters are the first `own` of each part, part after part, then the common ones, which follow them in the
  /// same order in each part. There must be at least one part; the parts must outlive this object.
  JointProblem(std::vector<const Problem*> parts, std::size_t own) : parts_(std::move(parts)), own_(own) {
    for (const Problem* part : parts_) {
      const auto& all = part->parameters();
      parameters_.insert(parameters_.end(), all.begin(), all.begin() + static_cast<std::ptrdiff_t>(own_));
      residuals_ += part->residual_count();
    }
    const auto& first = parts_[0]->parameters();
    parameters_.insert(parameters_.end(), first.begin() + static_cast<std::ptrdiff_t>(own_), first.end());
  }

  std::size_t residual_count() const override { return residuals_; }
  const std::vector<FreeParameter>& parameters() const override { return parameters_; }
  bool known_errors() const override { return parts_[0]->known_errors(); }
  double data_norm() const override {
    double sum = 0;
    for (const Problem* part : parts_) sum += std::pow(part->data_norm(), 2);
    return std::sqrt(sum);
  }

  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override {
    const std::size_t p = parameters_.size(), common = p - parts_.size() * own_, of_part = own_ + common;
    std::vector<double> at(of_part), rows;
    std::copy(x.end() - static_cast<std::ptrdiff_t>(common), x.end(), at.begin() + static_cast<std::ptrdiff_t>(own_));
    std::fill(jacobian.begin(), jacobian.end(), 0.0);
    std::size_t from = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const std::size_t n = parts_[i]->residual_count();
      std::copy_n(x.begin() + static_cast<std::ptrdiff_t>(i * own_), own_, at.begin());
      rows.resize(jacobian.empty() ? 0 : n * of_part);
      if (!parts_[i]->evaluate(at, residuals.subspan(from, n), rows)) return false;
      for (std::size_t r = 0; !rows.empty() && r < n; ++r) {
        const double* const row = rows.data() + r * of_part;
        double* const to = jacobian.data() + (from + r) * p;
        std::copy_n(row, own_, to + i * own_);
        std::copy_n(row + own_, common, to + p - common);
      }
      from += n;
    }
    return true;
  }

 private:
  std::vector<const Problem*> parts_;
  std::size_t own_, residuals_ = 0;
  std::vector<FreeParameter> parameters_;
};

}  // namespace mixity
