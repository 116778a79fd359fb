// Decides whether noise alone makes tests of a fit fail. The tests assume residuals that are linear in the noise. Where
// T scatters so widely that A(T) is curved within its error, they fail although nothing is wrong.
#pragma once

#include "fitting/options.h"
#include "fitting/result.h"

namespace mixity {

/// Whether -ln p of the failed tests is less than 1.5 times that of one of ten experiments, simulated from the fit and
/// fitted with its errors and correlations. False, without simulation, where curvature within the errors does not
/// matter, where the points scatter far less than their stated errors, or where a failed test does not compare
/// residuals with noise: points beyond the last equilibrium, constant areas, constants far from their stated values.
bool noise_alone_fails_alike(const Dataset& data, const FitResult& fit, const FitOptions& options);

}  // namespace mixity
