// Standard errors of measured loads and areas: from the file's columns, from flags, or from the scatter of the points.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "base/units.h"
#include "dataset/dataset.h"

namespace mixity {

/// A standard error stated for all points: "1%" of each value, or one quantity such as "0.002 mm^2" (a bare number if
/// the data are dimensionless).
using StatedError = Quantity;

/// scatter: estimated from the points; assumed: 1 %, for want of enough points to estimate it.
enum class ErrorSource { columns, stated, scatter, assumed, exact };
std::string_view to_string(ErrorSource source);

struct StandardErrors {
  std::vector<double> T, A;  // per point of the data set, dimensionless
  ErrorSource source_T = ErrorSource::scatter, source_A = ErrorSource::scatter;
  std::optional<double> scatter;  // the relative error, where it was estimated or assumed
  // Points for whose error of 0 kLeastError of the largest value stands, which the distance from a curve needs.
  std::size_t raised_T = 0, raised_A = 0;

  /// True if the size of the errors is known, and not only their proportions: that of A's is stated.
  bool absolute() const { return source_A == ErrorSource::columns || source_A == ErrorSource::stated; }
};

/// Stated errors win over columns. Where neither T nor A has one, both get the same relative error, estimated from how
/// far points lie from the line between their neighbours in the run, rows that repeat one left out; or 1 % if fewer
/// than three points have neighbours. Where only A has one, T gets that estimate if `both_axes` (the part of the
/// scatter that is A's makes it too large rather than too small) and counts as exact otherwise. `both_axes`: errors
/// stated as 0 are raised to kLeastError of the largest value, since a distance in both axes needs both. An InputError:
/// a point whose field in a column of errors is empty, or without `both_axes` 0 for A; a stated error whose unit is
/// none of the quantity's.
StandardErrors standard_errors(const Dataset& data, const std::optional<StatedError>& sigma_T,
                               const std::optional<StatedError>& sigma_A, bool both_axes = false);

}  // namespace mixity
