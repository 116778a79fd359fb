// Standard errors as functions of the true value, estimated from the scatter of the points about a fitted curve.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fitting/standard_errors.h"
#include "statistics/autoregression.h"

namespace mixity {

/// The points of a fit and the places of the fitted curve next to them, in the order of the residuals.
struct NearestPlaces {
  std::vector<double> residuals;  // in the standard errors of the fit
  std::vector<double> T, A;       // of the places, as they would be read
  /// A residual is its noise in |T| times load_T plus that in A times load_A, each in its standard error; the squares
  /// add up to 1.
  std::vector<double> load_T, load_A;
};

/// What the estimate uses of one axis.
struct AxisErrors {
  std::span<const double> sigma;  // of the fit, per residual
  bool known;                     // stated or from columns: not estimated
  double least;                   // a standard error that is always added
};

struct ErrorModels {
  std::optional<ErrorModel> T, A;        // null where known
  std::uint32_t parts = 0;               // which of the four are estimated, as bits
  bool differences = true;               // whether T's readings count
  std::vector<double> run_factors{};     // by which the errors of each run are multiplied; empty: 1
  NeighbourCorrelations correlations{};  // of the noise of A (first) and T (second)
  double log_likelihood = 0;             // of the residuals with them when they were chosen, in any unit

  double factor(std::size_t run) const { return run_factors.empty() ? 1 : run_factors[run]; }
};

/// Parts are chosen without regard to correlations; or both are chosen; or those there are estimated; or the parts
/// alone, by which the iteration ends.
enum class Stage { weighting, choosing, refining, ending };

/// The parts, a constant and a proportional one for each axis, that the points ask for (BIC), by restricted likelihood
/// from the squared residuals, and for T also from second differences of its readings in the order of the file, unless
/// the areas contradict these (Carroll & Ruppert 1988, Transformation and Weighting in Regression, chapter 3); a factor
/// for each run where they differ beyond chance (Bartlett 1937), shrunk as far as it is uncertain; and the correlation
/// of neighbours in each axis. `used`: indices of the points; `leverages`: of their residuals in the fit, 0..1;
/// `before`: the estimate so far; `own`: columns of which each run has a multiple of its own that is no noise, and that
/// is taken off the residuals. Null where the residuals are all 0.
std::optional<ErrorModels> estimate_errors(const Dataset& data, std::span<const std::size_t> used,
                                           const NearestPlaces& nearest, std::span<const double> leverages,
                                           const AxisErrors& T, const AxisErrors& A, const ErrorModels& before,
                                           Stage stage, const std::vector<std::vector<double>>& own);

/// The share of squares that are independent of each other: those of neighbours correlate by rho^2.
inline double independence(double rho) { return (1 - rho * rho) / (1 + rho * rho); }
inline double independence(const NeighbourCorrelations& rho) {
  return std::min(independence(rho.first), independence(rho.second));
}

/// The residuals as processes along the runs.
TwoProcesses processes_of(const Dataset& data, std::span<const std::size_t> used, std::span<const double> load_T,
                          std::span<const double> load_A);

}  // namespace mixity
