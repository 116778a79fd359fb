// Standard errors as functions of the true value, estimated from the scatter of points about a fitted curve.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fitting/point_indices.h"
#include "fitting/standard_errors.h"
#include "statistics/autoregression.h"

namespace mixity {

/// The points of a fit and the nearest places on the fitted curve, in the order of the residuals.
struct NearestPlaces {
  std::vector<double> residuals;  // in units of the fit's standard errors
  std::vector<double> T, A;       // at these places, as they would be read
  /// A residual is load_T times the noise in |T| plus load_A times that in A, each in its standard error; load_T^2 +
  /// load_A^2 = 1.
  std::vector<double> load_T, load_A;
  std::vector<double> axes{};      // the residuals of the axes of elliptic contacts, behind the others in the Jacobian
  std::vector<double> pull_off{};  // those of pull-off loads, the last
};

/// What the estimate knows about one axis.
struct AxisErrors {
  std::span<const double> sigma;  // used in the fit, per residual
  bool known;                     // stated or from columns: not estimated
  double least;                   // a standard error that is added in any case
};

struct ErrorModels {
  std::optional<ErrorModel> T, A;        // null where known
  std::uint32_t parts = 0;               // bits: which of the four parts (constant and share of T and A) are estimated
  bool differences = true;               // whether second differences of T's readings are used
  std::vector<double> run_factors{};     // factors on the errors of each run; empty: 1
  NeighbourCorrelations correlations{};  // of neighbours' noise in A (first) and T (second)
  double log_likelihood = 0;             // of the residuals under these errors when they were chosen, up to a constant

  double factor(std::size_t run) const { return run_factors.empty() ? 1 : run_factors[run]; }
};

/// weighting: all parts are estimated, ignoring correlations; choosing: parts and correlations are chosen; refining:
/// those chosen are estimated; ending: the parts alone are estimated, which ends the iteration.
enum class Stage { weighting, choosing, refining, ending };

/// Estimates the error model from the squared residuals by restricted likelihood. The parts, a constant and a
/// proportional one for each axis, are chosen by BIC. For T, second differences of its readings in file order also
/// count, unless the areas contradict them (Carroll & Ruppert 1988, Transformation and Weighting in Regression, chapter
/// 3). Runs get a factor where they differ beyond chance (Bartlett 1937), shrunk by its uncertainty; each axis gets a
/// correlation of neighbours. `used`: indices of the points; `leverages`: those of their residuals, 0..1; `before`: the
/// last estimate; `own`: columns of which each run has its own multiple, which is not noise and is subtracted;
/// `may_correlate`: whether neighbours may. Null if all residuals are 0.
std::optional<ErrorModels> estimate_errors(const Dataset& data, const PointIndices& used, const NearestPlaces& nearest,
                                           std::span<const double> leverages, const AxisErrors& T, const AxisErrors& A,
                                           const ErrorModels& before, Stage stage,
                                           const std::vector<std::vector<double>>& own, bool may_correlate);

/// The share of squared residuals that is independent: squares of neighbours correlate by rho^2.
inline double independence(double rho) { return (1 - rho * rho) / (1 + rho * rho); }
inline double independence(const NeighbourCorrelations& rho) {
  return std::min(independence(rho.first), independence(rho.second));
}

/// The residuals as autocorrelated processes along the runs.
TwoProcesses processes_of(const Dataset& data, const PointIndices& used, std::span<const double> load_T,
                          std::span<const double> load_A);

}  // namespace mixity
