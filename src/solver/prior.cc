#include "solver/prior.h"

#include <cmath>

namespace mixity {

SolvedWithPriors solve_with_priors(const Problem& data, const StartingPoints& starting, const SolverOptions& options) {
  const auto& parameters = data.parameters();
  const auto known = static_cast<std::size_t>(
      std::count_if(parameters.begin(), parameters.end(), [](const FreeParameter& one) { return one.prior > 0; }));
  const std::size_t n = data.residual_count(), unknown = parameters.size() - known;
  double unit = 1;
  Verdict verdict = solve(ProblemWithPriors(data), starting, options);
  std::vector<double> residuals(n);
  for (int i = 0; i < 50 && !data.known_errors() && n > unknown && !verdict.best.x.empty(); ++i) {
    const auto square = sum_of_squares(data, verdict.best.x, residuals);
    if (!square || !(*square > 0)) break;
    const double before = unit;
    unit = std::sqrt(*square / static_cast<double>(n - unknown));
    const StartingPoints near{verdict.best.x};
    verdict = solve(ProblemWithPriors(data, unit), i == 0 ? starting : near, options);
    if (std::abs(unit - before) <= 1e-9 * unit) break;
  }
  return {std::move(verdict), unit};
}

}  // namespace mixity
