// Refits that seek an explanation are given up once they cannot be one.
#include <cmath>
#include <limits>

#include "fitting/causes.h"
#include "fitting/explanations.h"
#include "fitting/fitted_errors.h"
#include "fitting/fitter.h"
#include "solver/linear_algebra.h"
#include "statistics/distributions.h"

namespace mixity {

/// Whether the data alone, near the start, are described worse than that, however far the next Gauss-Newton steps may
/// go. A fit with priors cannot be better.
bool Fitter::is_beyond(double most_misfit) const {
  constexpr int kSteps = 20;
  constexpr double kAtMost = 3, kLater = 1.5;  // times the predicted fall, at first and after a step
  std::vector<double> x = starting_.near;
  if (x.empty() || !prepared_.errors) return false;
  const double variances = log_variances(data_, prepared_.used, *prepared_.errors);
  const auto cost = problem_->cost();
  CostValue at;
  double before = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kSteps; ++i) {
    cost->at(x, {}, at);
    if (!at.finite || at.value > before) return false;
    const auto exceeds = [&](double squares) {
      return misfit(squares, variances, problem_->residual_count(), problem_->known_errors()) > most_misfit;
    };
    const Eigen::VectorXd step = solve_symmetric(at.hessian, -at.gradient);
    const double fall = -at.gradient.dot(step);
    if (!exceeds(at.value) || !(fall >= 0)) return false;
    if (exceeds(std::max(at.value - (i == 0 ? kAtMost : kLater) * fall, 1e-9 * at.value))) return true;
    before = at.value;
    for (std::size_t k = 0; k < x.size(); ++k)
      x[k] = problem_->parameters()[k].clamped(x[k] + step[static_cast<Eigen::Index>(k)]);
  }
  return false;
}

/// Whether residuals with known errors and this sum of squares explain nothing, even if it were `at_most` times
/// smaller.
bool Fitter::exceeds(double squares, double freedom, double at_most) const {
  return options_.explanation_only && problem_->known_errors() && options_.loss == Loss::none && freedom > 0 &&
         chi_squared_p_value(squares / at_most, freedom) < kHardly;
}

/// Whether the squares of residuals with known errors are so large, with the neighbours' correlations that explain them
/// best, that no later round makes the fit an explanation: none divides chi^2 by more than `at_most`. `chosen`: whether
/// those of `models` are these correlations; else they are estimated, into `by_neighbours`.
bool Fitter::scatters_too_far(const NearestPlaces& nearest, const std::vector<double>& leverage,
                              const ErrorModels& models, double at_most, bool chosen,
                              std::optional<ErrorModels>& by_neighbours) const {
  if (!options_.explanation_only) return false;  // before sums over all points
  double freedom = 0;
  for (const double one : leverage) freedom += 1 - one;
  const auto fails = [&](const std::vector<double>& residuals) {
    return exceeds(as_vector(residuals).squaredNorm(), freedom, at_most);
  };
  if (!fails(nearest.residuals)) return false;
  if (!chosen) by_neighbours = estimated_errors(nearest, leverage, models, Stage::choosing, {});
  if (!chosen && !by_neighbours) return false;
  const NeighbourCorrelations& correlations = chosen ? models.correlations : by_neighbours->correlations;
  if (!correlations.any()) return true;
  std::vector<double> residuals = nearest.residuals;
  Decorrelation(processes_of(data_, prepared_.used, nearest.load_T, nearest.load_A), {correlations}).apply(residuals);
  return fails(residuals);
}

}  // namespace mixity
