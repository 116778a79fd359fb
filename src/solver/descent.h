// One descent to a minimum: Ceres, then Newton steps on the gradient to the last digits.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "solver/options.h"
#include "solver/problem.h"
#include "solver/results.h"

namespace mixity {

/// From one start, by the engine of the options. Null if no finite cost was found from there.
std::optional<Minimum> descend(const Problem& problem, const std::vector<double>& start,
                               const SolverOptions& options = {});

/// The same by Ceres, in a file of its own: where there is no Ceres, another one stands for it (explorer).
std::optional<Minimum> descend_with_ceres(const Problem& problem, const std::vector<double>& start,
                                          const SolverOptions& options);

/// The version of Ceres.
std::string_view solver_version();

}  // namespace mixity
