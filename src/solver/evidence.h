// The evidence of a model (its likelihood averaged over its priors) and the posterior of one parameter.
#pragma once

#include <optional>

#include "solver/options.h"
#include "solver/problem.h"
#include "solver/results.h"

namespace mixity {

struct EvidenceOptions {
  RangePrior prior = RangePrior::uniform;  // of parameter 0
  double confidence = 0.95;
  double from = 0;  // where a log-uniform prior begins
  /// Divisor of residuals whose size is unknown; averaged over with Jeffreys' prior 1/unit. 0: the residuals are in
  /// standard errors.
  double unit = 0;
};

/// The evidence of a problem that includes its priors. Integrates over parameter 0 by quadrature, to 1e-6 (to 1e-3
/// where the density has kinks), and over the others by Laplace's method at each value, with normal priors or uniform
/// ones over their ranges. Null if the range is empty or not finite, if a cost is not finite, if there is no scatter,
/// or if the quadrature does not converge. Needs about 6 to 40 values of a single parameter, whose slopes are used, too,
/// and 10 to 70 profiled ones of several.
std::optional<Evidence> evidence(const Problem& problem, const Minimum& best, std::optional<double> standard_error,
                                 const EvidenceOptions& choice, const SolverOptions& options = {});

}  // namespace mixity
