#include "solver/interval.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "solver/linear_algebra.h"
#include "statistics/distributions.h"

namespace mixity {
namespace {

/// A bound counts as reached at this fraction of its distance from the minimum.
constexpr double kAtBound = 1e-15;
/// A step towards an end is only rounding below this fraction of the end's distance from the minimum.
constexpr double kRounding = 1e-12;

struct End {
  double x;
  EndStatus status;
};

/// The cost that ends an interval, and a cost lower than the minimum if the search meets one.
struct EndSearch {
  double least, allowance;       // the cost at the minimum, and its allowed rise
  double deep;                   // a cost below this is lower than the minimum by more than rounding
  std::vector<double> deeper{};  // all parameters there

  EndSearch(double least_cost, double allowed, double rounding, double part)
      : least(least_cost),
        allowance(allowed),
        deep(std::pow(std::max(std::sqrt(least_cost) - rounding, 0.0), 2) - part * allowed) {}
  /// The remaining allowance, as a difference of roots: linear in x for a parabola, so that Newton's step is exact.
  double left(double cost) const { return std::sqrt(allowance) - std::sqrt(std::max(cost - least, 0.0)); }
};

/// Newton's method on left(), outwards from the minimum, between the last value inside and the first one outside.
End find_end(Profile& profile, const FreeParameter& parameter, double best, double direction, double first_step,
             EndSearch& search, const SolverOptions& options) {
  const double bound = direction < 0 ? parameter.lower : parameter.upper;
  const EndStatus at_end = parameter.start ? EndStatus::open : EndStatus::at_bound;  // a start: no physical bounds
  // without scatter the error may be lost in the rounding of x
  const double step = std::max(first_step, std::numeric_limits<double>::epsilon() * std::abs(best));
  double inside = best, outside = bound, x = best + direction * step;
  std::vector<double> all_inside = profile.point();
  const auto newton = [&](const std::optional<Profile::Value>& here) {
    const double rise = here ? std::sqrt(std::max(here->cost - search.least, 0.0)) : 0;
    const double slope = rise > 0 ? 0.5 * here->slope / rise : 0;  // of that square root
    return slope * direction > 0 ? x + search.left(here ? here->cost : 0) / slope : bound + direction;
  };
  const auto between = [&](double next, double end) {
    return (next - inside) * direction > 0 && (end - next) * direction > 0;
  };
  bool bracketed = false, exceeded = false;  // a value was beyond the allowance, or not finite; the former
  std::optional<Profile::Value> again;       // a lower cost at `outside`
  double cost_outside = 0;
  for (int i = 0; i < options.most_iterations; ++i) {
    if ((x - bound) * direction >= 0) x = bound;
    const auto here = again ? std::exchange(again, std::nullopt) : profile(x, i == 0 ? options.profile_first : 1);
    if (here && here->cost < search.deep) {
      search.deep = here->cost;
      search.deeper = profile.point();
    }
    const bool within = here && here->cost <= search.least + search.allowance;
    if (within && x == bound) return {x, at_end};
    (within ? inside : outside) = x;
    if (within) {
      all_inside = profile.point();
      if (outside == x) {  // it was that of another minimum over the others
        outside = bound;
        bracketed = exceeded = false;
      }
    } else {
      cost_outside = here ? here->cost : 0;
    }
    bracketed |= !within;
    exceeded |= here && !within;
    double next = newton(here);
    const double farthest = bracketed ? outside : best + 4 * (x - best);
    const bool inner = between(next, farthest);
    // Newton's method squares the error. A step within rounding may lead out of the bracket, where x is its end.
    const bool may_end = here && here->slope * direction > 0 && (inner || exceeded || !bracketed);
    const bool ends =
        may_end && std::abs(next - x) <= (inner ? options.interval_step : kRounding) * std::abs(next - best);
    if (ends && i > 0) return {next, EndStatus::found};
    if (ends && !inner) continue;  // the first value is less accurate
    if (!inner) {
      // The cost inside does not rise to that outside: there another minimum over the others may be lower.
      if (within && exceeded && all_inside.size() > 1) again = profile.from(all_inside, outside, cost_outside);
      next = again ? outside : bracketed ? 0.5 * (inside + outside) : farthest;
    }
    // The cost jumps only at the bound itself, where another parameter would have to be infinite.
    if (exceeded && outside == bound && std::abs(inside - bound) <= kAtBound * std::abs(best - bound))
      return {bound, at_end};
    if (bracketed && std::abs(outside - inside) <= 4e-16 * std::abs(outside))
      return {inside, exceeded ? EndStatus::found : EndStatus::open};
    x = next;
  }
  return {inside, EndStatus::open};
}

}  // namespace

double cost_allowance(double confidence, double sum_of_squares, std::size_t n, std::size_t p, bool known_errors,
                      double freedom) {
  if (known_errors)
    return std::isinf(freedom) ? chi_squared_quantile(confidence, 1) : fisher_quantile(confidence, 1, freedom);
  const auto rest = static_cast<double>(n - p);
  return sum_of_squares / rest * fisher_quantile(confidence, 1, std::min(rest, freedom));
}

Profile::Profile(const Problem& problem, const Minimum& best, double decrease, const SolverOptions& options)
    : problem_(problem), decrease_(decrease), kernel_(problem, options), x_(best.x), best_{best.x, {}} {
  if (x_.size() > 1) best_.cost = kernel_.at(x_);
}

void Profile::begin(std::size_t k) {
  if (k != k_ || found_.empty()) found_ = {best_.x};
  k_ = k;
  x_ = best_.x;
  last_ = best_;
}

std::vector<Eigen::Index> Profile::others(std::size_t k, const std::vector<double>& x, const CostValue& cost) const {
  std::vector<Eigen::Index> list;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (const auto at = static_cast<Eigen::Index>(i); i != k && cost.finite && cost.slope_size[at] > 0 &&
                                                      !problem_.parameters()[i].held_by_bound(x[i], cost.gradient[at]))
      list.push_back(at);
  return list;
}

double Profile::reach(std::size_t k, double rise) {
  const CostValue& cost = kernel_.at(best_.x);
  if (!cost.finite) return 0;
  const auto at = static_cast<Eigen::Index>(k);
  const std::vector<Eigen::Index> open = others(k, best_.x, cost);
  const Eigen::VectorXd across = cost.hessian(open, at);
  const double slope = std::abs(cost.gradient[at]),
               curvature = cost.hessian(at, at) - across.dot(solve_symmetric(cost.hessian(open, open), across));
  return rise / (slope + std::sqrt(slope * slope + std::max(curvature, 0.0) * rise));
}

/// To first order the minimum over the others moves by -H_oo^-1 H_ok per unit of parameter k; the remaining gradient at
/// the anchor is corrected, too.
std::vector<double> Profile::along_tangent(const Anchor& anchor, double value) const {
  const auto k = static_cast<Eigen::Index>(k_);
  std::vector<double> x = anchor.x;
  const std::vector<Eigen::Index> open = others(k_, x, anchor.cost);
  const Eigen::VectorXd shift =
      solve_symmetric(anchor.cost.hessian(open, open),
                      anchor.cost.hessian(open, k) * (anchor.x[k_] - value) - anchor.cost.gradient(open));
  x[k_] = value;
  if (shift.allFinite())
    for (std::size_t i = 0; i < open.size(); ++i)
      x[static_cast<std::size_t>(open[i])] += shift[static_cast<Eigen::Index>(i)];
  return x;
}

std::vector<double> Profile::predicted(const Anchor& anchor, double value) const {
  constexpr std::size_t kFewest = 4, kMost = 7;  // minima; more hardly predict better
  std::vector<double> tangent = along_tangent(anchor, value);
  if (found_.size() < kFewest) return tangent;
  std::vector<const std::vector<double>*> nearest;
  for (const auto& one : found_) nearest.push_back(&one);
  const std::size_t n = std::min(kMost, nearest.size());
  std::partial_sort(
      nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(n), nearest.end(),
      [&](const auto* x, const auto* y) { return std::abs((*x)[k_] - value) < std::abs((*y)[k_] - value); });
  std::vector<double> x = tangent, column(n);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (i == k_) continue;
    for (std::size_t j = 0; j < n; ++j) column[j] = (*nearest[j])[i];
    double before = column[0];
    for (std::size_t order = 1; order < n; ++order) {  // Neville's scheme
      before = column[0];
      for (std::size_t j = 0; j + order < n; ++j) {
        const double one = (*nearest[j])[k_], other = (*nearest[j + order])[k_];
        column[j] = ((value - other) * column[j] + (one - value) * column[j + 1]) / (one - other);
      }
    }
    if (!(std::abs(column[0] - before) < std::abs(column[0] - tangent[i]))) return tangent;
    x[i] = problem_.parameters()[i].clamped(column[0]);
  }
  return x;
}

std::optional<Kernel::Held> Profile::descend_from(const Anchor& anchor, double value, double decrease) {
  if (auto minimum = kernel_.descend_held(predicted(anchor, value), k_, decrease)) return minimum;
  std::vector<double> x = anchor.x;
  x[k_] = value;
  return kernel_.descend_held(x, k_, decrease);
}

std::optional<Profile::Value> Profile::operator()(double value, double share) {
  if (x_.size() == 1) {
    x_[0] = value;
    const CostValue& cost = kernel_.at(x_);
    return cost.finite ? std::optional(Value{cost.value, 2 * cost.gradient[0]}) : std::nullopt;
  }
  // Starts from the nearer of the two known minima; if that does not converge, from the other.
  const bool last_is_near = std::abs(value - last_.x[k_]) < std::abs(value - best_.x[k_]);
  auto minimum = descend_from(last_is_near ? last_ : best_, value, share * decrease_);
  Anchor here;
  if (minimum) here = {minimum->x, kernel_.last()};
  if (!minimum || !minimum->settled) {
    const auto other = descend_from(last_is_near ? best_ : last_, value, share * decrease_);
    if (other && (!minimum || other->cost < minimum->cost)) {
      minimum = other;
      here = {other->x, kernel_.last()};
    }
  }
  if (!minimum) return std::nullopt;
  return take(*minimum, std::move(here));
}

std::optional<Profile::Value> Profile::from(const std::vector<double>& x, double value, double above) {
  // minima beyond x may lie in another basin, to which an interpolation would lead
  std::erase_if(found_, [&](const auto& one) { return (one[k_] - x[k_]) * (value - x[k_]) > 0; });
  const Anchor anchor{x, kernel_.at(x)};
  const auto minimum = descend_from(anchor, value, decrease_);
  if (!minimum || !(minimum->cost < above)) return std::nullopt;
  return take(*minimum, {minimum->x, kernel_.last()});
}

Profile::Value Profile::take(const Kernel::Held& minimum, Anchor here) {
  last_ = std::move(here);
  x_ = last_.x;
  const double value = x_[k_];
  const bool known = std::any_of(found_.begin(), found_.end(), [&](const auto& one) { return one[k_] == value; });
  if (minimum.settled && !known) found_.push_back(minimum.next);
  return {minimum.cost, minimum.slope, minimum.settled};
}

std::vector<Interval> profile_intervals(const Problem& problem, const Minimum& best, double confidence,
                                        double allowance, const std::vector<std::optional<double>>& standard_errors,
                                        const Progress& progress, const SolverOptions& options) {
  const double variance = residual_variance(problem, best.sum_of_squares);
  Profile profile(problem, best, options.profile_decrease * allowance, options);
  std::vector<Interval> intervals;
  for (std::size_t k = 0; k < best.x.size(); ++k) {
    if (progress) progress(static_cast<double>(k) / static_cast<double>(best.x.size()));
    const FreeParameter& parameter = problem.parameters()[k];
    const double x = best.x[k];
    EndSearch search(best.sum_of_squares, allowance, residual_rounding(problem), options.deeper);
    // The end of the interval for a parabola; where it has none, a tiny step, which grows fast.
    double step =
        standard_errors[k] ? *standard_errors[k] * std::sqrt(allowance / variance) : profile.reach(k, allowance);
    if (!(step > 0 && std::isfinite(step))) step = std::max(parameter.least_size(), 1e-9 * std::abs(x));
    const auto end = [&](double bound, double direction) {
      if (x == bound) return End{x, parameter.start ? EndStatus::open : EndStatus::at_bound};
      profile.begin(k);
      return find_end(profile, parameter, x, direction, step, search, options);
    };
    const End low = end(parameter.lower, -1), high = end(parameter.upper, 1);
    intervals.push_back({confidence, low.x, high.x, low.status, high.status, search.deeper});
  }
  return intervals;
}

DrawnProfile draw_profile(const Problem& problem, const Minimum& best, std::size_t k, double low, double high,
                          std::size_t count, double allowance, double variance, const SolverOptions& options) {
  DrawnProfile drawn{{{best.x[k], 0.0}}, allowance / variance};
  // Outwards from the best: each minimum over the others starts from the last one.
  const std::size_t half = count / 2;
  Profile profile(problem, best, options.profile_decrease * allowance, options);
  for (const double end : {low, high}) {
    profile.begin(k);
    for (std::size_t i = 1; i <= half; ++i) {
      const double x = best.x[k] + (end - best.x[k]) * static_cast<double>(i) / static_cast<double>(half);
      if (x == best.x[k]) continue;
      if (const auto here = profile(x)) drawn.points.emplace_back(x, (here->cost - best.sum_of_squares) / variance);
    }
  }
  std::sort(drawn.points.begin(), drawn.points.end());
  return drawn;
}

}  // namespace mixity
