// Fits with one possible cause of failed tests, and what they are called.
#pragma once

#include <string>

#include "fitting/causes.h"
#include "fitting/constants.h"

namespace mixity {

/// The fit of these points with the constant free.
Cause with_free(const Case& of, Constant constant, const Points& points);
/// With a random effect by run of the quantity.
Cause by_run(const Case& of, const std::string& quantity, const Points& points);
/// With another stiffness of the machine that holds an approach. It is exact in a fit, so that it is searched beside.
Cause with_stiffness(const Case& of, const Points& points);

/// Whether a fit explains the points and may end ok: one that moves the first parameter to a bound does not.
bool is_explanation(const Case& of, const FitResult& with);
/// Whether a quantity that differs in one run alone explains the points better than one that differs in all.
bool is_of_one_run(const Cause& cause);
/// How implausible the size of a cause is, in -2 ln L (plausible_size.h).
double implausibility(const Case& of, const Cause& cause);
/// Sets the texts, and for a quantity that differs in one run the fit without it if that explains the points.
void describe(const Case& of, Cause& cause);

}  // namespace mixity
