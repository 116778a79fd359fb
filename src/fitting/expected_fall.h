// By how much a cause of failed tests improves a fit, foretold from its tests without a further fit.
#pragma once

#include <cstddef>

#include "fitting/constants.h"
#include "fitting/result.h"

namespace mixity {

/// The fall of the misfit (causes.h) of `points` of the fit's points, evenly chosen, once the constant is free; from
/// its score test. Infinite if that does not tell. `times`: a factor on the fall of chi^2.
double expected_fall(const FitResult& fit, Constant constant, std::size_t points, double times = 1);
/// The same where the tested quantity has a random effect by run, or an own value in one run, whichever does better.
/// For runs that determine the quantity equally well.
double expected_fall(const FitResult& fit, const RunTest& test, std::size_t points);

}  // namespace mixity
