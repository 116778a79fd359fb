// Whether noise alone makes tests of a fit fail. The tests are linear in the noise. Where T scatters so widely that
// A(T) is curved within its error, they fail without any fault.
#pragma once

#include "fitting/options.h"
#include "fitting/result.h"

namespace mixity {

/// Whether the tests fail less clearly than 1.5 times, in -ln p, what one of ten experiments gives that are simulated
/// from the fit and fitted with its errors and correlations. False, without any simulation, where the curvature within
/// the errors does not matter, the points scatter far less than stated errors, or a test fails that does not compare
/// residuals with noise: points beyond the last equilibrium, areas that stay constant, constants far from what was
/// stated.
bool noise_alone_fails_alike(const Dataset& data, const FitResult& fit, const FitOptions& options);

}  // namespace mixity
