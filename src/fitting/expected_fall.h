// By how much a cause of failed tests is expected to improve a fit, from its tests alone.
#pragma once

#include <cstddef>
#include <limits>

#include "fitting/constants.h"
#include "fitting/result.h"

namespace mixity {

struct ExpectedFall {
  double chi2;    // of the sum of squares in units of the errors' scatter
  double misfit;  // of -2 ln L (causes.h)
};
/// If the tests do not tell it.
inline constexpr ExpectedFall kUnknownFall{std::numeric_limits<double>::infinity(),
                                           std::numeric_limits<double>::infinity()};

/// Once the constant is free, from its score test. `points`: how many of the fit's points, evenly chosen, are fitted;
/// `times`: a factor on the fall of chi^2.
ExpectedFall expected_fall(const FitResult& fit, Constant constant, std::size_t points, double times = 1);
/// Once the tested quantity has a random effect by run, or an own value in one run, whichever does better; as if all
/// runs determined the quantity equally well.
ExpectedFall expected_fall(const FitResult& fit, const RunTest& test, std::size_t points);

/// Whether chi^2 with known errors remains so large after that fall that the fit cannot explain the points.
bool stays_too_large(const FitResult& fit, const ExpectedFall& fall, std::size_t points);

}  // namespace mixity
