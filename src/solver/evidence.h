// The evidence of a model, its likelihood averaged over its priors, and what it leaves of one parameter: the posterior.
#pragma once

#include <optional>

#include "solver/options.h"
#include "solver/problem.h"
#include "solver/results.h"

namespace mixity {

/// How the residuals of the data are to be read.
struct EvidenceOptions {
  RangePrior prior = RangePrior::uniform;  // of parameter 0
  double confidence = 0.95;
  /// What the residuals were divided by where their size is not known: it is averaged over with Jeffreys' prior 1/unit.
  /// 0: they are in standard errors.
  double unit = 0;
};

/// `problem` with its priors, from the minimum. Over parameter 0 by quadrature, to 1e-6; over the others by Laplace's
/// method at each of its values, with their normal priors, or uniform ones over their ranges. Null if the range or a
/// cost is not finite, nothing scatters, or the quadrature does not settle (a kink in the profile). About 12 to 40
/// profiled values.
std::optional<Evidence> evidence(const Problem& problem, const Minimum& best, std::optional<double> standard_error,
                                 const EvidenceOptions& choice, const SolverOptions& options = {});

}  // namespace mixity
