#include "fitting/interval.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

namespace mixity {
namespace {

/// A problem with one of its parameters held.
class HeldProblem final : public WrappedProblem {
 public:
  HeldProblem(const LeastSquares& problem, std::size_t k, double value)
      : WrappedProblem(problem), parameters_(problem.parameters()), k_(k), value_(value) {
    parameters_.erase(parameters_.begin() + static_cast<std::ptrdiff_t>(k));
  }
  const std::vector<FreeParameter>& parameters() const override { return parameters_; }
  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override {
    const std::size_t p = parameters_.size(), n = residual_count();
    std::vector<double> all(x.begin(), x.end()), whole(jacobian.empty() ? 0 : n * (p + 1));
    all.insert(all.begin() + static_cast<std::ptrdiff_t>(k_), value_);
    if (!problem_.evaluate(all, residuals, whole)) return false;
    if (jacobian.empty()) return true;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < p; ++j) jacobian[i * p + j] = whole[i * (p + 1) + j + (j >= k_)];
    return true;
  }

 private:
  std::vector<FreeParameter> parameters_;
  std::size_t k_;
  double value_;
};

struct End {
  double x;
  EndStatus status;
};

/// Where costs on the way out lie below the minimum, by more than roundings of |r| explain.
struct Depth {
  double least;
  std::vector<double> place{};

  Depth(double sum_of_squares, double allowance, double rounding)
      : least(std::pow(std::max(std::sqrt(sum_of_squares) - rounding, 0.0), 2) - 1e-6 * allowance) {}
  bool is_below(double cost) const { return cost < least; }
  void see(std::vector<double> x, double cost) {
    least = cost;
    place = std::move(x);
  }
};

/// Outwards from the minimum in growing steps until the cost exceeds the limit, then back to where it does.
End find_end(Profile profile, const FreeParameter& parameter, double best, double limit, double direction,
             double first_step, Depth& depth) {
  const double bound = direction < 0 ? parameter.lower : parameter.upper;
  const bool scanned = !parameter.start;  // the range of a correction is only wide, not physical
  double inside = best, inside_excess = -1, step = first_step;
  const auto look = [&](double x) {
    const auto cost = profile(x);
    if (cost && depth.is_below(*cost)) depth.see(profile.place(), *cost);
    return cost;
  };
  for (int i = 0; i < 200; ++i, step *= 1.6) {
    double next = best + direction * step;
    const bool last = direction < 0 ? next <= bound : next >= bound;
    if (last) next = bound;
    if (next == inside && !last) continue;  // a step below the resolution of doubles
    auto cost = look(next);
    // Where the cost ends: back towards what is inside, for a place beyond the limit before that.
    const bool past_the_end = !cost;
    for (int halving = 0; past_the_end && halving < 30 && !(cost && *cost > limit); ++halving) {
      const double middle = 0.5 * (inside + next);
      cost = look(middle);
      if (cost && *cost <= limit) {
        inside = middle;
        inside_excess = *cost / limit - 1;
      } else {
        next = middle;
      }
    }
    if (past_the_end && !(cost && *cost > limit)) return {inside, EndStatus::open};
    const double excess_here = *cost / limit - 1;
    if (excess_here > 0) {
      if (next == inside) return {inside, EndStatus::found};
      std::uintmax_t evaluations = 60;
      const auto excess = [&](double x) { return profile(x).value_or(2 * limit) / limit - 1; };
      const bool down = direction < 0;
      const auto ends = boost::math::tools::toms748_solve(
          excess, down ? next : inside, down ? inside : next, down ? excess_here : inside_excess,
          down ? inside_excess : excess_here,
          [&](double low, double high) { return high - low <= 1e-11 * std::abs(0.5 * (low + high) - best); },
          evaluations);
      return {0.5 * (ends.first + ends.second), EndStatus::found};
    }
    if (last) return {bound, scanned ? EndStatus::at_bound : EndStatus::open};
    inside = next;
    inside_excess = excess_here;
  }
  return {inside, EndStatus::open};
}

/// One side of a one-parameter interval: outwards until the cost exceeds the limit or ends, then Newton's method on it,
/// kept between what lies within and what does not.
End find_end(SingleCost& cost, const FreeParameter& parameter, double best, double limit, double direction,
             double first_step, Depth& depth) {
  const double bound = direction < 0 ? parameter.lower : parameter.upper;
  double inside = best, outside = best, step = first_step;
  bool exceeded = false;  // by a finite cost
  CostValue here;
  for (int i = 0; outside == best; ++i, step *= 2) {
    if (i == 200) return {inside, EndStatus::open};  // steps below the resolution of doubles
    double next = best + direction * step;
    const bool last = direction < 0 ? next <= bound : next >= bound;
    if (last) next = bound;
    here = cost.at(next, {});
    if (here.finite && depth.is_below(here.value)) depth.see({next}, here.value);
    if (here.finite && here.value <= limit) {
      if (last) return {bound, parameter.start ? EndStatus::open : EndStatus::at_bound};
      inside = next;
    } else {
      outside = next;
    }
    exceeded |= here.finite && here.value > limit;
  }
  const auto end = [&](double at) { return exceeded ? End{at, EndStatus::found} : End{inside, EndStatus::open}; };
  double x = outside;
  for (int i = 0; i < 80; ++i) {
    double next = here.finite ? x - (here.value - limit) / here.slope : outside;
    const double low = std::min(inside, outside), high = std::max(inside, outside);
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    // Newton squares the error: what is left is 1e-14 of the distance, times the cost's curvature.
    if (std::abs(next - x) <= 1e-8 * std::abs(next - best)) return end(next);
    x = next;
    here = cost.at(x, {});
    const bool within = here.finite && here.value <= limit;
    (within ? inside : outside) = x;
    exceeded |= here.finite && !within;
  }
  return end(x);
}

}  // namespace

std::string_view to_string(EndStatus status) {
  switch (status) {
    case EndStatus::found:
      return "found";
    case EndStatus::at_bound:
      return "at_bound";
    case EndStatus::open:
      break;
  }
  return "open";
}

double cost_allowance(double confidence, double sum_of_squares, std::size_t n, std::size_t p, bool known_errors) {
  using namespace boost::math;
  // in double, to a few roundings: long double takes eight times as long, a sixth of a whole fit in the batch engine
  using InDouble = policies::policy<policies::promote_double<false>>;
  if (known_errors) return quantile(chi_squared_distribution<double, InDouble>(1), confidence);
  const auto freedom = static_cast<double>(n - p);
  return sum_of_squares / freedom * quantile(fisher_f_distribution<double, InDouble>(1, freedom), confidence);
}

Profile::Profile(const LeastSquares& problem, const Minimum& best, std::size_t k)
    : problem_(problem), k_(k), others_(best.x) {
  others_.erase(others_.begin() + static_cast<std::ptrdiff_t>(k));
}

std::vector<double> Profile::place() const {
  std::vector<double> all = others_;
  all.insert(all.begin() + static_cast<std::ptrdiff_t>(k_), value_);
  return all;
}

std::optional<double> Profile::operator()(double value) {
  value_ = value;
  const HeldProblem held(problem_, k_, value);
  if (others_.empty()) {
    std::vector<double> residuals(held.residual_count());
    return sum_of_squares(held, {}, residuals);
  }
  const auto minimum = descend(held, others_);
  if (!minimum) return std::nullopt;
  others_ = minimum->x;
  return minimum->sum_of_squares;
}

Interval profile_interval(const LeastSquares& problem, const Minimum& best, std::size_t k, double confidence,
                          double allowance, std::optional<double> standard_error) {
  const FreeParameter& parameter = problem.parameters()[k];
  if (best.x.size() == 1)
    return profile_interval(*problem.single_cost(), parameter, best.x[0], best.sum_of_squares, confidence, allowance,
                            residual_rounding(problem));
  const double limit = best.sum_of_squares + allowance, x = best.x[k];
  // Without a standard error (at a bound) the first step is tiny: the steps grow fast.
  const double step = standard_error ? *standard_error : 1e-9 * (parameter.upper - parameter.lower);
  const Profile profile(problem, best, k);
  Depth depth(best.sum_of_squares, allowance, residual_rounding(problem));
  const auto end = [&](double bound, double direction) {
    return x == bound ? End{x, EndStatus::at_bound} : find_end(profile, parameter, x, limit, direction, step, depth);
  };
  const End low = end(parameter.lower, -1), high = end(parameter.upper, 1);
  return {confidence, low.x, high.x, low.status, high.status, depth.place};
}

Interval profile_interval(SingleCost& cost, const FreeParameter& parameter, double x, double sum_of_squares,
                          double confidence, double allowance, double rounding) {
  const double limit = sum_of_squares + allowance, sensitivity = cost.at(x, {}).slope_size;
  const double widest = parameter.upper - parameter.lower;
  const double step = sensitivity > 0 ? std::min(std::sqrt(allowance) / sensitivity, widest) : 1e-9 * widest;
  Depth depth(sum_of_squares, allowance, rounding);
  const auto end = [&](double bound, double direction) {
    return x == bound ? End{x, EndStatus::at_bound} : find_end(cost, parameter, x, limit, direction, step, depth);
  };
  const End low = end(parameter.lower, -1), high = end(parameter.upper, 1);
  return {confidence, low.x, high.x, low.status, high.status, depth.place};
}

DrawnProfile draw_profile(const LeastSquares& problem, const Minimum& best, std::size_t k, double low, double high,
                          std::size_t count, double allowance, double variance) {
  DrawnProfile drawn{{{best.x[k], 0.0}}, allowance / variance};
  // From the best outwards, since each minimum over the others starts from the one before.
  const std::size_t half = count / 2;
  for (const double end : {low, high}) {
    Profile profile(problem, best, k);
    for (std::size_t i = 1; i <= half; ++i) {
      const double x = best.x[k] + (end - best.x[k]) * static_cast<double>(i) / static_cast<double>(half);
      const auto cost = x == best.x[k] ? std::nullopt : profile(x);
      if (cost && std::isfinite(*cost)) drawn.points.emplace_back(x, (*cost - best.sum_of_squares) / variance);
    }
  }
  std::sort(drawn.points.begin(), drawn.points.end());
  return drawn;
}

}  // namespace mixity
