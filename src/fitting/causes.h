// What may be the cause where tests of a fit fail: constants that are wrong, quantities that differ between the runs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fitting/explanations.h"

namespace mixity {

/// One cause, fitted.
struct Cause {
  enum class Kind { constant, runs, one_run };
  Kind kind;
  std::string name;  // of the constant, or of the quantity that differs
  std::string run;   // of one_run
  Message size;      // what it would be: a clause
  Message remedy;    // the option that fits it
  Points points;     // all, or without the run
  FitResult fit;
  double misfit;  // -2 ln L, to be compared with that of other causes
};

/// -2 ln L of a fit, but for a constant of the points.
double misfit(const FitResult& fit);

/// The causes that explain the points, without those that are worse than the best by more than `range`; first the one
/// with the least sum of misfit and implausibility of its size.
std::vector<Cause> causes(const Case& of, const Points& points, double range);

/// A contact that is no circle leaves residuals that look like noise of T with a memory. Where neighbours correlate,
/// the fit with the shape free, if it does about as well without correlation and moves the first parameter by an amount
/// that matters.
std::optional<Cause> shape_instead_of_memory(const Case& of);

/// Whether a test says that the runs differ, by more than chance and by an amount that matters.
bool runs_differ(const FitResult& fit, double chance);

}  // namespace mixity
