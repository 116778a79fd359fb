// In the browser the kernel makes the last descent in place of Ceres; tests check that both reach the same minimum.
#include "solver/descent.h"

namespace mixity {

std::optional<Minimum> descend_with_ceres(const Problem& problem, const std::vector<double>& start,
                                          const SolverOptions& options) {
  SolverOptions kernel = options;
  kernel.engine = Engine::kernel;
  return descend(problem, start, kernel);
}

std::string_view solver_version() { return "none"; }

}  // namespace mixity
