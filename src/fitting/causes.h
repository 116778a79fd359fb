// Possible causes of failed tests: constants that are wrong, quantities that differ between the runs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fitting/explanations.h"

namespace mixity {

/// A possible cause, and the fit that includes it.
struct Cause {
  enum class Kind { constant, runs, one_run };
  Kind kind;
  std::string name;  // of the constant or quantity
  std::string run;   // for one_run: the run that differs
  Message size;      // the estimated size, as a clause
  Message remedy;    // the option that fits it
  Points points;     // the points fitted: all, or without the run
  FitResult fit;
  double misfit;        // -2 ln L, comparable between causes
  std::string value{};  // of a constant, with its unit
};

/// How much tougher the contact is without shear, as a clause.
std::string hysteresis_text(double value);

/// -2 ln L of a fit, up to a constant that depends on the points alone.
double misfit(const FitResult& fit);
double misfit(double squares, double log_variances, std::size_t points, bool known_errors);

/// The causes that explain the points and have a misfit within `range` of the best. The first one has the least sum of
/// misfit and implausibility of its size. `before`: the misfit of these points without a cause.
std::vector<Cause> causes(const Case& of, const Points& points, double before, double range);

/// A contact that is not circular leaves residuals that look like autocorrelated noise of T. Where neighbours
/// correlate, returns the fit with free shape if it does about as well without correlation and changes the first
/// parameter by an amount that matters.
std::optional<Cause> shape_instead_of_memory(const Case& of);

/// Where the score test of a constant nearly fails: of the fits with one constant free that do about as well, the value
/// being plausible, those that reach farthest beyond the interval at either end.
std::vector<Cause> beside_the_fit(const Case& of);

/// Whether a test shows that the runs differ, by more than chance and by an amount that matters.
bool runs_differ(const FitResult& fit, double chance);

}  // namespace mixity
