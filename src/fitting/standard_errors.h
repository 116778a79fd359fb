// Standard errors of measured loads and areas: from the file's columns, from flags, or from the scatter of the points.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/enum_names.h"
#include "base/units.h"
#include "dataset/dataset.h"
#include "statistics/neighbour_correlations.h"

namespace mixity {

struct FitResult;

/// The mean standard error of the loads that a fit under a held approach used, in the unit of the file.
double mean_error_of_loads(const Dataset& data, const FitResult& fit);

/// What was measured beside T and A and has residuals of its own: loads at a held approach, or axes.
inline const std::vector<PointAxes>& beside(const Dataset& data) {
  return data.holds_approach() ? data.loads_beside : data.axes;
}

/// A standard error stated for all points: "1%" of each value, or one quantity such as "0.002 mm^2" (a bare number if
/// the data are dimensionless).
using StatedError = Quantity;

/// scatter: estimated from the points; assumed: 1 %, with too few points for an estimate.
enum class ErrorSource { columns, stated, scatter, assumed, exact };
constexpr std::string_view to_string(ErrorSource source) {
  constexpr std::string_view kNames[] = {"columns", "stated", "scatter", "assumed", "exact"};
  return name_among(kNames, source);
}

/// The standard error sqrt(constant^2 + (share x)^2) of a reading whose true value is x. constant: in the unit of x.
struct ErrorModel {
  double constant = 0, share = 0;
  double at(double x) const { return std::sqrt(constant * constant + share * x * (share * x)); }
};

/// Names of quantities that differ from run to run by chance: the model's first parameter, or constants.
struct RunDifferences {
  std::vector<std::string> names;
  std::vector<double> spreads;                  // standard deviations, in the solver's numbers
  std::vector<std::vector<double>> columns;     // per quantity: derivatives of the residuals, by point of the data set
  std::vector<std::vector<double>> deviations;  // per quantity and run of the data set; 0 for runs without points
  double freedom = 0;                           // of the variance of the first parameter
  bool any() const { return !names.empty(); }
};

/// From this number of points on, a fit stops at what is left of a thousandth of a standard error.
inline constexpr std::size_t kManyPoints = 1 << 16;

/// Curvature matters if the squares of the distances expected from it, in standard errors, add up to this.
inline constexpr double kCurvatureMatters = 1;

struct StandardErrors {
  std::vector<double> T, A;  // per point of the data set, dimensionless
  ErrorSource source_T = ErrorSource::scatter, source_A = ErrorSource::scatter;
  std::optional<double> scatter;  // the relative error, where it was estimated or assumed
  // How many errors of 0 were raised to kLeastError of the largest value.
  std::size_t raised_T = 0, raised_A = 0;
  std::optional<ErrorModel> model_T{}, model_A{};  // as functions of the true value; null of a column of any numbers
  std::vector<double> run_factors{};               // functions of the true value; null for a column of any numbers
  NeighbourCorrelations correlations{};            // of neighbours' noise in A (first) and T (second), along each run
  RunDifferences runs{};                           // as far as requested
  double step_T = 0, step_A = 0;                   // resolution with which T and A were read; 0: none found
  bool factor_is_free = false;                     // of stated errors only the ratios are known
  double factor = 1;                               // on stated errors; found if it is free
  double axes_factor = 1;  // of ln(a/b), where none is stated: this times the relative error of A
  double pull_off = 0;     // of loads of pull-off, where none is stated
  double freedom = 0;      // degrees of freedom of the estimate from the fit; 0: no estimate
  /// Per point of the data set, at the fitted curve: T and A, NearestPlaces::load_T and load_A, and the distance from
  /// the curve expected from its curvature. Empty before a fit.
  std::vector<double> place_T{}, place_A{}, load_T{}, load_A{}, expected{};

  /// Whether the steps of the readings are no small part of the noise: then neighbouring residuals resemble each other.
  bool coarse(std::size_t point) const {
    constexpr double kPart = 0.1;  // of the variance
    const auto part = [](double step, double sigma, double load) {
      return step * step / 12 * load * load / (sigma * sigma);
    };
    return !load_A.empty() &&
           part(step_T, T[point], std::sqrt(square_of_load_T(point))) + part(step_A, A[point], load_A[point]) > kPart;
  }
  /// load_T^2; of many points with independent noise load_T is not stored.
  double square_of_load_T(std::size_t point) const {
    return load_T.empty() ? std::max(1 - load_A[point] * load_A[point], 0.0) : load_T[point] * load_T[point];
  }
  /// True if the size of the errors is known, not only their proportions.
  bool absolute() const { return is_known(source_A) && !factor_is_free; }
  static bool is_known(ErrorSource source) {
    return source == ErrorSource::columns || source == ErrorSource::stated || source == ErrorSource::exact;
  }
};

/// Stated errors take precedence over columns. If neither T nor A has one, both get the same relative error, estimated
/// from the distance of points from the line between their neighbours in the run, ignoring repeated rows; or 1 % if
/// fewer than three points have neighbours. If only A has one, T gets that estimate with `both_axes` (too large rather
/// than too small, since it includes the scatter of A), and is exact otherwise. `both_axes`: the fit needs both errors,
/// so those of 0 are raised to kLeastError of the largest value. `whole`: the errors of all points, of which these are
/// a part; scatter and resolution are those. Throws InputError for an empty field in a column of errors, for an error
/// of A of 0 without `both_axes`, and for a stated error in a wrong unit.
StandardErrors standard_errors(const Dataset& data, const std::optional<StatedError>& sigma_T,
                               const std::optional<StatedError>& sigma_A, bool both_axes = false,
                               const StandardErrors* whole = nullptr);

/// The largest modulus of this quantity; 1 where all are 0.
double largest_value(const Dataset& data, double Point::*quantity);

}  // namespace mixity
