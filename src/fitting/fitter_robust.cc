// Minima of robust losses. The scale depends on the fit, so both are found in turn.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fitting/fitter.h"
#include "solver/descent.h"
#include "solver/prior.h"
#include "solver/robust.h"
#include "statistics/student.h"

namespace mixity {

Verdict Fitter::find_robust_minimum(Verdict verdict) {
  const double scale = options_.loss_scale.value_or(usual_scale(options_.loss));
  const bool known = problem_->known_errors();
  std::vector<double> x = verdict.best.x;
  if (x.empty() && !known) x = value_of_least_spread(*problem_);
  for (int i = 0; i < (known ? 1 : 3) && (known || !x.empty()); ++i) {
    const double unit = known ? 1.0 : spread(*problem_, x);
    if (!(unit > 0)) return verdict;  // an exact fit
    result_.loss_scale = scale * unit;
    robust_.emplace(*problem_, options_.loss, result_.loss_scale);
    verdict = minimum_of(*robust_);
    x = verdict.best.x;
  }
  return verdict;
}

/// The minimum with Student's errors, whose scale and degrees of freedom are found in turn with the parameters. When
/// these have converged, the lowest minimum is searched for; if it is elsewhere, they converge again.
Verdict Fitter::find_minimum_of_student(Verdict verdict) {
  constexpr int kMost = 100;
  constexpr double kSettled = 1e-6;  // relative change of scale and degrees of freedom; an interval changes as much
  const bool known = problem_->known_errors();
  std::vector<double> x = verdict.best.x;
  if (x.empty()) x = value_of_least_spread(*problem_);
  std::vector<double> residuals(problem_->residual_count());
  const auto n = static_cast<double>(residuals.size());
  const double rest = n - static_cast<double>(unknown() + 1), correction = known ? 1 : std::sqrt(n / rest);
  SolverOptions quick = solver_;
  quick.engine = Engine::kernel;
  bool searched = false;
  for (int i = 0; i < kMost && !x.empty(); ++i) {
    const bool exact = !problem_->evaluate(x, residuals, {}) || spread(residuals) <= 100 * residual_rounding(*problem_);
    if (exact) {
      if (robust_) verdict = minimum_of(*problem_);
      robust_.reset();
      result_.loss_scale = result_.loss_freedom = 0;
      return verdict;
    }
    const StudentErrors errors = student_errors(residuals, known);
    const double scale = correction * std::sqrt(errors.freedom) * errors.scale;
    const bool settled = std::abs(scale / result_.loss_scale - 1) < kSettled &&
                         std::abs(errors.freedom / result_.loss_freedom - 1) < kSettled;
    if (settled && searched) return verdict;
    result_.loss_scale = scale;
    result_.loss_freedom = errors.freedom;
    robust_.emplace(*problem_, Loss::t, scale, errors.freedom);
    const auto next = settled ? std::nullopt : descend(ProblemWithPriors(*robust_), x, quick);
    searched = !next;
    if (searched) verdict = minimum_of(*robust_);
    x = next ? next->x : verdict.best.x;
  }
  if (x.empty()) return verdict;
  if (!searched) verdict = minimum_of(*robust_);
  verdict.status = FitStatus::not_converged;
  verdict.message = "the degrees of freedom of the errors, which depend on the parameters, did not settle";
  return verdict;
}

}  // namespace mixity
