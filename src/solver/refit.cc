#include "solver/refit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/linear_algebra.h"
#include "solver/prior.h"

namespace mixity {
namespace {

/// Cost, gradient and curvature of data and priors together, at the unit that the data have here.
struct Joint {
  double unit = 1, squares = 0;  // squares: of all residuals, the data's in that unit
  double likelihood = 0;         // -2 ln L up to a constant: it must not rise
  Eigen::VectorXd gradient, size;
  Eigen::MatrixXd curvature;
};

}  // namespace

/// Gauss-Newton. What it neglects of the curvature is learned from the gradients of successive steps (symmetric rank
/// one: Conn, Gould & Toint 1991), which for one parameter is the secant.
std::optional<NearMinimum> refit_near(const Problem& data, std::vector<double> x, const SolverOptions& options) {
  constexpr int kMost = 25;
  constexpr double kRounding = 1e-12;
  const std::vector<FreeParameter>& parameters = data.parameters();
  const std::size_t n = data.residual_count(), unknown = parameters.size() - prior_count(data);
  const auto p = static_cast<Eigen::Index>(x.size());
  if (x.empty() || n <= unknown) return std::nullopt;
  const double freedom = static_cast<double>(n - unknown);
  const bool known = data.known_errors() || unknown == parameters.size();
  const std::unique_ptr<Cost> cost = data.cost();
  CostValue here;
  const auto evaluate = [&](Joint& at) {
    cost->at(x, {}, here);
    if (!here.finite || !(here.value > 0)) return false;
    const double square = known ? 1 : here.value / freedom;
    double priors = 0;
    at.unit = std::sqrt(square);
    at.gradient = here.gradient / square;
    at.curvature = here.hessian / square;
    for (Eigen::Index k = 0; k < p; ++k) {
      const FreeParameter& one = parameters[static_cast<std::size_t>(k)];
      if (!(one.prior > 0)) continue;
      const double off = (x[static_cast<std::size_t>(k)] - *one.start) / one.prior;
      priors += off * off;
      at.gradient[k] += off / one.prior;
      at.curvature(k, k) += 1 / (one.prior * one.prior);
    }
    at.size = at.curvature.diagonal().cwiseSqrt();
    at.squares = here.value / square + priors;
    at.likelihood = (known ? here.value : freedom * std::log(here.value)) + priors;
    return bool((at.size.array() > 0).all());
  };
  Joint now, before;
  Eigen::MatrixXd missing = Eigen::MatrixXd::Zero(p, p);  // the curvature that Gauss-Newton neglects
  Eigen::VectorXd step;
  if (!evaluate(now)) return std::nullopt;
  for (int i = 0; i < kMost; ++i) {
    const double r = std::sqrt(now.squares),
                 stationarity = now.gradient.cwiseQuotient(now.size).lpNorm<Eigen::Infinity>() / r;
    if (stationarity <= options.kernel_stationary) return NearMinimum{{x, now.squares, stationarity, true}, now.unit};
    const auto scale = now.size.cwiseInverse().eval();
    const Eigen::VectorXd g = scale.cwiseProduct(now.gradient);
    const auto solved = [&](const Eigen::MatrixXd& H) -> Eigen::VectorXd {
      return solve_symmetric(scale.asDiagonal() * H * scale.asDiagonal(), -g);
    };
    Eigen::VectorXd scaled = solved(now.curvature + missing);
    if (!scaled.allFinite() || !(scaled.dot(g) < 0)) scaled = solved(now.curvature);
    step = scale.cwiseProduct(scaled);
    if (!step.allFinite()) return std::nullopt;
    for (Eigen::Index k = 0; k < p; ++k) {
      const auto at = static_cast<std::size_t>(k);
      if (x[at] + step[k] != parameters[at].clamped(x[at] + step[k])) return std::nullopt;
      x[at] += step[k];
    }
    std::swap(before, now);
    if (!evaluate(now)) return std::nullopt;
    if (!(now.likelihood <= before.likelihood + kRounding * std::abs(before.likelihood))) return std::nullopt;
    if (cost->exact_curvature()) continue;
    const Eigen::VectorXd left = now.gradient - before.gradient - (now.curvature + missing) * step;
    if (const double along = left.dot(step); std::abs(along) > 1e-8 * left.norm() * step.norm())
      missing += left * left.transpose() / along;
  }
  return std::nullopt;
}

}  // namespace mixity
