// Standard errors of measured loads and areas: from the file's columns, from flags, or from the scatter of the points.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "base/enum_names.h"
#include "base/units.h"
#include "dataset/dataset.h"

namespace mixity {

/// A standard error stated for all points: "1%" of each value, or one quantity such as "0.002 mm^2" (a bare number if
/// the data are dimensionless).
using StatedError = Quantity;

/// scatter: estimated from the points; assumed: 1 %, with too few points for an estimate.
enum class ErrorSource { columns, stated, scatter, assumed, exact };
constexpr std::string_view to_string(ErrorSource source) {
  constexpr std::string_view kNames[] = {"columns", "stated", "scatter", "assumed", "exact"};
  return name_among(kNames, source);
}

struct StandardErrors {
  std::vector<double> T, A;  // per point of the data set, dimensionless
  ErrorSource source_T = ErrorSource::scatter, source_A = ErrorSource::scatter;
  std::optional<double> scatter;  // the relative error, where it was estimated or assumed
  // How many errors of 0 were raised to kLeastError of the largest value.
  std::size_t raised_T = 0, raised_A = 0;

  /// True if the size of the errors is known, not only their proportions.
  bool absolute() const { return source_A == ErrorSource::columns || source_A == ErrorSource::stated; }
};

/// Stated errors take precedence over columns. Where neither T nor A has one, both get the same relative error,
/// estimated from the distance of points from the line between their neighbours in the run, without repeated rows; or 1
/// % if fewer than three points have neighbours. Where only A has one, T gets that estimate with `both_axes` (too large
/// rather than too small, since it includes the scatter of A), and is exact otherwise. `both_axes`: the fit needs both
/// errors, so those of 0 are raised to kLeastError of the largest value. Throws InputError for an empty field in a
/// column of errors, for an error of A of 0 without `both_axes`, and for a stated error with a wrong unit.
StandardErrors standard_errors(const Dataset& data, const std::optional<StatedError>& sigma_T,
                               const std::optional<StatedError>& sigma_A, bool both_axes = false);

}  // namespace mixity
