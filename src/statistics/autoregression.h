// Deviations along runs of readings that correlate with their neighbours: sums of two stationary autoregressive
// processes of order 1, such as the noise of a load cell and that of a camera.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "statistics/neighbour_correlations.h"
#include "statistics/two_processes.h"

namespace mixity {

/// Number of deviations that decide about correlations: the first ones.
inline constexpr std::size_t kDeciding = 20000;

/// Turns correlated deviations into independent ones of variance 1: subtracts from each its prediction from those
/// before, and divides by the standard deviation of the rest (Kalman's filter; Harvey 1989, Forecasting, Structural
/// Time Series Models and the Kalman Filter, chapter 3).
class Decorrelation {
 public:
  Decorrelation(const TwoProcesses& processes, const ScaledCorrelations& at);

  /// `values`: every stride-th number is a deviation.
  void apply(std::span<double> values, std::size_t stride = 1) const;
  /// Per deviation, the fraction 0..1 of the variance of second u - first v that earlier deviations predict. The
  /// deviation itself does not contain that combination.
  const std::vector<double>& predicted_across() const { return predicted_across_; }
  /// ln of the determinant of the covariance matrix of the deviations.
  double log_determinant() const { return log_determinant_; }

 private:
  struct Step {
    std::size_t row;
    bool begins;                    // the first deviation of a run
    double decay_1, decay_2;        // of the predictions since the last step
    double first, second;           // the weights
    double gain_1, gain_2, per_sd;  // gains for the innovation; 1/its standard deviation
  };
  std::vector<Step> steps_;
  std::vector<double> predicted_across_;
  double log_determinant_ = 0;
};

/// Correlations of maximum likelihood to 1e-4, whatever the unit of the deviations; 0 where BIC rejects one (Schwarz
/// 1978); equal where BIC requires one and the data do not tell which. ln L is that in the unit of maximum likelihood,
/// up to a constant. Only the first kDeciding deviations are used. `second_factor`: the factor on the second weights as
/// a function of their correlation, where these are not determined by the deviations.
struct ChosenCorrelations {
  NeighbourCorrelations correlations{};
  double log_likelihood = 0;
};
ChosenCorrelations choose_correlations(const TwoProcesses& processes, std::span<const double> deviations,
                                       const std::function<double(double)>& second_factor);

/// The local maximum of likelihood from these correlations; one that is 0 stays 0. `more`: ln L of other data, such as
/// the readings of one axis alone. Changes each number in turn, a correlation at fixed variance of the innovations,
/// since otherwise it would vary with the factor. Repeat the call until nothing changes.
ScaledCorrelations improve(const TwoProcesses& processes, std::span<const double> deviations,
                           const NeighbourCorrelations& from,
                           const std::function<double(const ScaledCorrelations&)>& more);

}  // namespace mixity
