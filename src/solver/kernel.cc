#include "solver/kernel.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <span>
#include <vector>

#include "base/threads.h"
#include "solver/linear_algebra.h"

namespace mixity {
namespace {

/// The cost of any problem, from its residuals and Jacobian. Of several parts each is summed apart, and then their
/// sums: the result does not depend on how many threads there are, and no array has all rows.
class GeneralCost final : public Cost {
 public:
  explicit GeneralCost(const Problem& problem) : problem_(problem), parts_(problem.parts()) {}

  void at(std::span<const double> x, std::span<const double> weights, CostValue& cost) override {
    clear(x.size(), cost);
    if (parts_ > 1 && weights.empty()) return sum_parts(x, cost);
    residuals_.resize(problem_.residual_count());
    jacobian_.resize(problem_.residual_count() * x.size());
    cost.finite = problem_.evaluate_again(x, residuals_, jacobian_, memory_);
    if (cost.finite) sum(residuals_, jacobian_, weights, cost);
    finish(cost);
  }

  void keep() override {
    kept_ = memory_;
    kept_of_parts_ = memory_of_parts_;
  }
  void restore() override {
    memory_ = kept_;
    memory_of_parts_ = kept_of_parts_;
  }

 private:
  static void clear(std::size_t parameters, CostValue& cost) {
    const auto p = static_cast<Eigen::Index>(parameters);
    cost.value = 0;
    cost.gradient.setZero(p);
    cost.hessian.setZero(p, p);
    cost.finite = true;
  }

  void sum_parts(std::span<const double> x, CostValue& cost) {
    std::vector<CostValue> sums(parts_);
    memory_of_parts_.resize(problem_.memory_of_parts(), 0.0);
    std::atomic<std::size_t> next = 0;
    run_on_idle_processors(parts_, [&] {
      std::vector<double> residuals, jacobian;
      for (std::size_t part; (part = next++) < parts_;) {
        CostValue& one = sums[part];
        clear(x.size(), one);
        one.finite = problem_.evaluate_part_again(part, x, residuals, jacobian, memory_of_parts_);
        if (one.finite) sum(residuals, jacobian, {}, one);
      }
    });
    for (const CostValue& one : sums) {
      cost.value += one.value;
      cost.gradient += one.gradient;
      cost.hessian += one.hessian;
      cost.finite &= one.finite;
    }
    if (!cost.finite) memory_of_parts_.clear();  // how far other blocks had come may depend on the threads
    finish(cost);
  }

  static void sum(std::span<const double> residuals, std::span<const double> jacobian, std::span<const double> weights,
                  CostValue& cost) {
    const Eigen::Index p = cost.gradient.size();
    if (p == 1) return sum_few<1>(residuals, jacobian, weights, cost);
    if (p == 2) return sum_few<2>(residuals, jacobian, weights, cost);
    if (p == 3) return sum_few<3>(residuals, jacobian, weights, cost);
    const auto J = as_matrix(jacobian, static_cast<std::size_t>(p));
    const auto r = as_vector(residuals);
    if (weights.empty() && p <= kNarrow) {
      sum_narrow(J, r, cost);
    } else if (weights.empty()) {
      cost.value = r.squaredNorm();
      cost.gradient.noalias() = J.transpose() * r;
      cost.hessian.noalias() = J.transpose() * J;
    } else {
      const auto W = Eigen::Map<const Eigen::VectorXd>(weights.data(), r.size());
      const Eigen::MatrixXd WJ = W.asDiagonal() * J;
      cost.value = r.dot(W.cwiseProduct(r));
      cost.gradient.noalias() = WJ.transpose() * r;
      cost.hessian.noalias() = WJ.transpose() * J;
    }
  }

  /// For few parameters: Eigen's products of such narrow matrices need several times as long.
  template <int kCount>
  static void sum_few(std::span<const double> residuals, std::span<const double> jacobian,
                      std::span<const double> weights, CostValue& cost) {
    std::array<double, kCount> gradient{};
    std::array<std::array<double, kCount>, kCount> hessian{};
    double value = 0;
    for (std::size_t i = 0; i < residuals.size(); ++i) {
      const double w = weights.empty() ? 1 : weights[i], r = residuals[i];
      const double* const row = jacobian.data() + i * kCount;
      value += w * r * r;
      for (std::size_t k = 0; k < kCount; ++k) {
        const double slope = w * row[k];
        gradient[k] += slope * r;
        for (std::size_t l = 0; l <= k; ++l) hessian[k][l] += slope * row[l];
      }
    }
    cost.value = value;
    for (int k = 0; k < kCount; ++k) {
      cost.gradient[k] = gradient[static_cast<std::size_t>(k)];
      for (int l = 0; l < kCount; ++l)
        cost.hessian(k, l) =
            hessian[static_cast<std::size_t>(std::max(k, l))][static_cast<std::size_t>(std::min(k, l))];
    }
  }

  /// By products of columns, which need half as long as Eigen's of such narrow matrices.
  static constexpr Eigen::Index kNarrow = 8;
  static void sum_narrow(const Eigen::Map<const RowMajorMatrix>& J, const Eigen::Map<const Eigen::VectorXd>& r,
                         CostValue& cost) {
    constexpr Eigen::Index kAtOnce = 128;  // rows: their columns stay in the processor's cache
    const Eigen::Index p = J.cols();
    cost.value = r.squaredNorm();
    Eigen::Matrix<double, kAtOnce, kNarrow> columns;
    for (Eigen::Index begin = 0; begin < r.size(); begin += kAtOnce) {
      const Eigen::Index n = std::min(kAtOnce, r.size() - begin);
      for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index k = 0; k < p; ++k) columns(i, k) = J(begin + i, k);
      for (Eigen::Index k = 0; k < p; ++k) {
        const auto column = columns.col(k).head(n);
        cost.gradient[k] += column.dot(r.segment(begin, n));
        for (Eigen::Index l = 0; l <= k; ++l) cost.hessian(k, l) += column.dot(columns.col(l).head(n));
      }
    }
    for (Eigen::Index k = 0; k < p; ++k)
      for (Eigen::Index l = 0; l < k; ++l) cost.hessian(l, k) = cost.hessian(k, l);
  }

  static void finish(CostValue& cost) {
    if (!cost.finite) return;
    cost.slope_size = cost.hessian.diagonal().cwiseSqrt();
    cost.finite = std::isfinite(cost.value) && cost.gradient.allFinite() && cost.hessian.allFinite();
  }

  const Problem& problem_;
  std::size_t parts_;
  std::vector<double> residuals_, jacobian_, memory_, kept_;
  std::vector<double> memory_of_parts_, kept_of_parts_;  // one array: many pieces of several threads are hard to free
};

}  // namespace

std::unique_ptr<Cost> Problem::cost() const { return std::make_unique<GeneralCost>(*this); }

Kernel::Kernel(const Problem& problem, const SolverOptions& options)
    : problem_(problem), options_(options), cost_(problem.cost()), rounding_(residual_rounding(problem)) {}

const CostValue& Kernel::at(std::span<const double> x) {
  cost_->at(x, {}, here_);
  return here_;
}

bool Kernel::begin(std::span<const double> x, std::span<const double> weights) {
  cost_->at(x, weights, here_);
  if (here_.finite) first_ = here_.value;
  return here_.finite;
}

std::optional<Minimum> Kernel::descend(std::span<const double> start, std::span<const double> weights,
                                       std::optional<std::size_t> held) {
  const std::vector<FreeParameter>& parameters = problem_.parameters();
  std::vector<double> x(start.begin(), start.end());
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = parameters[k].clamped(x[k]);
  if (!begin(x, weights)) return std::nullopt;
  if (x.size() == 1 && !held) return newton(x[0], parameters[0].lower, parameters[0].upper, false, weights);
  return gauss_newton(std::move(x), weights, held, nullptr);
}

std::optional<Minimum> Kernel::explore(const Start& start) {
  if (start.low.empty() || (start.x.size() == 1 && !start.in_bracket)) return descend(start.x);
  if (!begin(start.x, {})) return std::nullopt;
  if (start.in_bracket) return newton(start.x[0], start.low[0], start.high[0], true, {});
  return gauss_newton(start.x, {}, {}, &start);
}

/// Newton's method on the gradient, between bounds and values that its sign excludes. A bound is the minimum if the
/// cost falls towards it.
Minimum Kernel::newton(double x, double low, double high, bool known, std::span<const double> weights) {
  double last_x = x, last_slope = 0;
  int steps = 0;
  bool low_known = known, high_known = known;
  const auto relative = [&] {
    const double scale = here_.slope_size[0] * std::sqrt(here_.value);
    return scale > 0 ? std::abs(here_.gradient[0]) / scale : 0.0;
  };
  const auto end = [&](bool converged) {
    const double size = relative();
    return Minimum{{x}, here_.value, size, converged || size <= options_.stationary, steps > options_.many_steps};
  };
  for (int i = 0; i < options_.most_iterations; ++i) {
    steps = i;
    const double slope = here_.gradient[0], curvature = here_.hessian(0, 0);
    if (relative() <= options_.kernel_stationary) return end(true);
    if ((slope > 0 && x <= low) || (slope < 0 && x >= high)) return {{x}, here_.value, 0, true};
    (slope > 0 ? high : low) = x;
    (slope > 0 ? high_known : low_known) = true;
    double next = curvature > 0 ? x - slope / curvature : slope > 0 ? low : high;
    const double move = next - x;
    if (cost_->exact_curvature() && curvature > 0 && next > low && next < high &&
        std::abs(move) <= 1e-9 * std::abs(x)) {
      // With exact curvature Newton's step squares the error: it is the last step, and the parabola gives the cost.
      here_.value = std::max(here_.value + move * (2 * slope + curvature * move), 0.0);
      return {{next}, here_.value, 0, true};
    }
    // The secant of the slopes includes the curvature that Gauss-Newton neglects.
    if (!cost_->exact_curvature() && i > 0 && slope != last_slope) {
      const double secant = x - slope * (x - last_x) / (slope - last_slope);
      if (std::abs(secant - x) < 0.1 * std::abs(x - last_x)) next = secant;
    }
    // Test before the bracket, which has x as one end, changes the step.
    if (std::abs(next - x) <= 2e-16 * std::abs(x)) return end(true);
    const bool bounded = std::isfinite(low) && std::isfinite(high);
    if (next <= low)
      next = !low_known ? low : low > 0 && high > 16 * low ? std::sqrt(low * high) : 0.5 * (low + high);
    else if (next >= high)
      next = !high_known ? high : 0.5 * (low + high);
    if (!std::isfinite(next)) return end(false);
    if (std::abs(next - x) <= 2e-16 * std::abs(x) || (bounded && high - low <= 2e-16 * high)) return end(true);
    cost_->at({&next, 1}, weights, there_);
    // The cost rose although it falls at x: a minimum lies between.
    if (there_.finite && std::sqrt(there_.value) > std::sqrt(here_.value) + rounding_) {
      (next > x ? high : low) = next;
      (next > x ? high_known : low_known) = true;
      continue;
    }
    last_x = x;
    last_slope = slope;
    x = next;
    std::swap(here_, there_);
    if (!here_.finite) break;
  }
  return here_.finite ? end(false) : Minimum{{x}, std::numeric_limits<double>::infinity(), 1, false};
}

double Kernel::stationarity(const std::vector<double>& x, std::optional<std::size_t> held) {
  open_.clear();
  double largest = 0;
  const double r = std::sqrt(here_.value);
  for (std::size_t k = 0; k < x.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    const double g = here_.gradient[i], scale = here_.slope_size[i] * r;
    if (k == held || problem_.parameters()[k].held_by_bound(x[k], g)) continue;
    if (!(here_.slope_size[i] > 0)) continue;  // no residual depends on it
    open_.push_back(i);
    if (scale > 0) largest = std::max(largest, std::abs(g) / scale);
  }
  return largest;
}

double Kernel::find_step(double damping) {
  const auto m = static_cast<Eigen::Index>(open_.size());
  // scaled to a unit diagonal, so that damping and factors do not depend on the parameters' units
  Eigen::MatrixXd H(m, m);
  Eigen::VectorXd g(m);
  for (Eigen::Index k = 0; k < m; ++k) {
    g[k] = here_.gradient[open_[k]] / here_.slope_size[open_[k]];
    for (Eigen::Index l = 0; l < m; ++l)
      H(k, l) = (here_.hessian(open_[k], open_[l]) + secant_ * along_[open_[k]] * along_[open_[l]]) /
                (here_.slope_size[open_[k]] * here_.slope_size[open_[l]]);
    H(k, k) += damping;
  }
  step_ = solve_symmetric(H, -g);
  const double gain = -g.dot(step_);
  for (Eigen::Index k = 0; k < m; ++k) step_[k] /= here_.slope_size[open_[k]];
  return gain;
}

bool Kernel::add_curvature(const Eigen::VectorXd& step, const Eigen::VectorXd& change) {
  constexpr double kMore = 1.5;  // times the expected one: up to this, undamped steps at least halve the distance
  along_ = here_.hessian * step;
  const double expected = step.dot(along_), found = step.dot(change);
  const bool more = expected > 0 && found > kMore * expected;
  secant_ = more ? (found - expected) / (expected * expected) : 0;
  return more;
}

bool Kernel::too_long(const std::vector<double>& x, const Start& reach) const {
  for (Eigen::Index k = 0; k < step_.size(); ++k) {
    const auto at = static_cast<std::size_t>(open_[k]);
    const double below = reach.x[at] - reach.low[at], above = reach.high[at] - reach.x[at], step = step_[k];
    const double growth = std::max(1.0, std::abs(x[at]) / std::max(std::abs(reach.x[at]), above));
    // a step to a bound that is also the end of the box is allowed
    if ((step < 0 && below > 0 && -step > growth * below) || (step > 0 && above > 0 && step > growth * above))
      return true;
  }
  return false;
}

Minimum Kernel::gauss_newton(std::vector<double> x, std::span<const double> weights, std::optional<std::size_t> held,
                             const Start* reach) {
  constexpr double kFirstDamping = 1e-4, kMostDamping = 1e16;
  constexpr double kNear = 0.1;  // of the cost: what an undamped step may gain close to the minimum
  // Steps to where the problem is not defined, when a descent creeps along that edge.
  constexpr int kMostUndefined = 200;
  int undefined = 0;
  double damping = 0, size = stationarity(x, held);
  std::vector<double> next = x;
  secant_ = 0;
  along_.setZero(static_cast<Eigen::Index>(x.size()));
  for (int i = 0; i < options_.most_iterations && size > options_.kernel_stationary_of_several; ++i) {
    double gain = find_step(damping);
    for (; reach && too_long(x, *reach) && damping < 1; gain = find_step(damping))
      damping = std::max(10 * damping, kFirstDamping);
    if (damping == 0 && gain >= 0 && gain <= enough_) return {x, here_.value, size, true};
    // Farther off, a secant may lead to another minimum.
    const bool near = damping == 0 && gain < kNear * here_.value;
    next = x;
    for (Eigen::Index k = 0; k < step_.size(); ++k) {
      const auto at = static_cast<std::size_t>(open_[k]);
      next[at] = problem_.parameters()[at].clamped(x[at] + step_[k]);
    }
    if (next == x && damping == 0) return {x, here_.value, size, true};  // lost in the rounding of x
    const bool usable = step_.allFinite();
    if (usable) cost_->at(next, weights, there_);
    if (usable && !there_.finite && ++undefined > kMostUndefined) break;
    const double roundings = 1e-14 * here_.value;  // for a sum of squares, roughly
    if (!usable || !there_.finite || !(there_.value <= here_.value + roundings)) {
      const bool first = usable && there_.finite && near && secant_ == 0;
      if (first && add_curvature(as_vector(next) - as_vector(x), there_.gradient - here_.gradient)) continue;
      damping = std::max(10 * damping, kFirstDamping);
      if (damping > kMostDamping) break;
      continue;
    }
    std::swap(here_, there_);
    std::swap(x, next);
    secant_ = 0;
    if (near) add_curvature(as_vector(x) - as_vector(next), here_.gradient - there_.gradient);
    damping = damping > 1e-6 ? 0.1 * damping : 0;
    const double before = size;
    size = stationarity(x, held);
    // only rounding is left: no step improves
    if (size < options_.stationary && size > 0.5 * before) break;
  }
  return {x, here_.value, size, size <= options_.stationary};
}

std::optional<Kernel::Held> Kernel::descend_held(std::span<const double> start, std::size_t held, double decrease) {
  enough_ = decrease;
  const auto minimum = descend(start, {}, held);
  enough_ = 0;
  if (!minimum) return std::nullopt;
  Held result{minimum->x, here_.value, 2 * here_.gradient[static_cast<Eigen::Index>(held)], minimum->stationary,
              minimum->x};
  if (!minimum->stationary || open_.empty()) return result;
  const double gain = find_step(0);
  if (!(gain >= 0 && gain <= decrease)) return result;
  result.cost -= gain;
  for (Eigen::Index k = 0; k < step_.size(); ++k)
    result.slope += 2 * here_.hessian(static_cast<Eigen::Index>(held), open_[k]) * step_[k];
  for (Eigen::Index k = 0; k < step_.size(); ++k) {
    double& value = result.next[static_cast<std::size_t>(open_[k])];
    value = problem_.parameters()[static_cast<std::size_t>(open_[k])].clamped(value + step_[k]);
  }
  return result;
}

}  // namespace mixity
