// Deviations along runs of readings whose neighbours resemble each other: sums of two stationary autoregressive
// processes of order 1, such as the noise of a load cell and that of a camera.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "statistics/neighbour_correlations.h"

namespace mixity {

/// Deviations d = first u + second v, where u and v have variance 1.
struct TwoProcesses {
  std::vector<std::vector<std::size_t>> runs;  // indices of the deviations of each run, in their order
  std::vector<double> places;                  // of each deviation: its place along its run, rising
  std::vector<double> first, second;           // weights; not both 0
  /// Columns, a number for each deviation. Each run has its own multiple of each, which is no noise: likelihoods are
  /// restricted to what is left.
  std::vector<std::vector<double>> own{};
};

/// Deviations that decide about correlations: of more the first ones.
inline constexpr std::size_t kDeciding = 20000;

/// Correlations, and factors of the weights.
struct ScaledCorrelations {
  NeighbourCorrelations correlations;
  double first = 1, second = 1;
};

/// Turns correlated deviations into independent ones of variance 1, one after the other: each less what those before
/// it predict, over the standard deviation of that (Kalman's filter; Harvey 1989, Forecasting, Structural Time Series
/// Models and the Kalman Filter, chapter 3).
class Decorrelation {
 public:
  Decorrelation(const TwoProcesses& processes, const ScaledCorrelations& at);

  /// `values`: the first deviation, then one every `stride` numbers.
  void apply(std::span<double> values, std::size_t stride = 1) const;
  /// For each deviation the share, 0..1, of the variance of second u - first v, which it does not contain, that the
  /// deviations before it predict.
  const std::vector<double>& predicted_across() const { return predicted_across_; }
  /// ln of the determinant of the deviations' covariances.
  double log_determinant() const { return log_determinant_; }

 private:
  struct Step {
    std::size_t row;
    bool begins;                    // a run
    double decay_1, decay_2;        // of the predictions since the step before
    double first, second;           // the weights
    double gain_1, gain_2, per_sd;  // of the innovation; 1/its standard deviation
  };
  std::vector<Step> steps_;
  std::vector<double> predicted_across_;
  double log_determinant_ = 0;
};

/// ln L of the deviations, without -n/2 ln(2 pi).
double log_likelihood(const TwoProcesses& processes, std::span<const double> deviations, const ScaledCorrelations& at);

/// The correlations of greatest likelihood, whatever the unit of the deviations, to 1e-4; 0 where BIC does not ask for
/// one (Schwarz 1978); both alike where it asks for that and the data do not tell which one it is; ln L with them in
/// the unit of greatest likelihood, but for a constant. Of many deviations the first kDeciding decide. `second_factor`: by
/// which the second weights grow with their correlation, where something else than the deviations determines them.
struct ChosenCorrelations {
  NeighbourCorrelations correlations{};
  double log_likelihood = 0;
};
ChosenCorrelations choose_correlations(const TwoProcesses& processes, std::span<const double> deviations,
                                       const std::function<double(double)>& second_factor);

/// Those of greatest likelihood next to these correlations; one that is 0 stays so. `more`: ln L of other data, such as
/// the readings of one axis alone. Each number is changed in turn, a correlation at a fixed variance of the
/// innovations, since otherwise it would move with the factor; repeat the call until nothing changes.
ScaledCorrelations improve(const TwoProcesses& processes, std::span<const double> deviations,
                           const NeighbourCorrelations& from,
                           const std::function<double(const ScaledCorrelations&)>& more);

}  // namespace mixity
