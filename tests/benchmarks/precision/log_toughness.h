// The paper's cost, sum (ln f of the model - ln f)^2 over (psi, f) points, as a user of another library would write it,
// and its least value in 50 digits.
#pragma once

#include <cmath>
#include <stdexcept>
#include <vector>

#include "fitting/toughness_objective.h"
#include "many_digits.h"
#include "mechanics/registry.h"

namespace mixity::precision {

using Exact = truth::Digits50;

/// What the logarithm is taken of, from what can be computed once for each point.
template <class S, class Point>
S log_argument(const Johnson&, const S& lambda, const Point& point) {
  return S(1) + (S(1) - lambda) * point.first;
}
template <class S, class Point>
S log_argument(const WatersGuduru&, const S& lambda, const Point& point) {
  using std::tan;
  const S t = tan((S(1) - 0.5 * lambda) * point.first);
  return S(1) + t * t;
}
template <class S, class Point>
S log_argument(const PapangeloCiavarella&, const S& lambda, const Point& point) {
  return point.second + lambda * point.first;
}

template <class Model>
class LogToughness {
 public:
  double lower = Model::parameters[0].lower, upper = Model::parameters[0].upper;
  mutable long sweeps = 0;

  explicit LogToughness(const std::vector<ToughnessPoint>& points) {
    for (const ToughnessPoint& point : points) {
      points_.push_back(Model::packed_point(point.mixity));
      targets_.push_back(std::log(point.ratio));
    }
  }
  std::size_t size() const { return points_.size(); }

  template <class S>
  bool operator()(const S* x, S* residuals) const {
    using std::log;
    ++sweeps;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const S argument = log_argument(Model{}, *x, points_[i]);
      if (!(argument > S(0))) return false;
      residuals[i] = static_cast<double>(Model::kLogSign) * log(argument) - targets_[i];
    }
    return true;
  }

  bool evaluate(double x, double* residuals, double* slopes) const {
    ++sweeps;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const auto at = Model::packed_form(x, points_[i]);
      if (!(at.argument > 0)) return false;
      residuals[i] = static_cast<double>(Model::kLogSign) * std::log(at.argument) - targets_[i];
      if (slopes) slopes[i] = at.slope;
    }
    return true;
  }

 private:
  std::vector<decltype(Model::packed_point(Mixity<double>{}))> points_;
  std::vector<double> targets_;
};

/// Cost in 50 digits with half its slope.
template <class Model>
struct ExactCost {
  std::vector<Mixity<Exact>> mixities;
  std::vector<Exact> targets;

  explicit ExactCost(const std::vector<ToughnessPoint>& points) {
    for (const ToughnessPoint& point : points) {
      mixities.push_back({Exact(point.mixity.cos), Exact(point.mixity.sin)});
      targets.push_back(log(Exact(point.ratio)));
    }
  }
  struct Value {
    Exact cost, slope;
  };
  Value operator()(const Exact& x) const {
    Value sum{0, 0};
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const auto at = Model::template log_toughness<Exact>({x}, mixities[i]);
      const Exact r = at.value - targets[i];
      sum.cost += r * r;
      sum.slope += r * at.gradient[0];
    }
    return sum;
  }
};

/// The least value of the whole range to 30 digits or more: every rise of the slope through zero on a dense grid,
/// bisected, then Newton's method; the slope is seen to change sign around the result. A bound if the cost is least
/// there.
template <class Model>
Exact exact_minimum(const std::vector<ToughnessPoint>& points) {
  const ExactCost<Model> exact(points);
  const auto problem = LogToughness<Model>(points);
  std::vector<double> r(points.size()), J(points.size()), places;
  const auto slope = [&](double x) {
    double sum = 0;
    if (!problem.evaluate(x, r.data(), J.data())) return std::nan("");
    for (std::size_t i = 0; i < r.size(); ++i) sum += r[i] * J[i];
    return sum;
  };
  for (int i = 0; i < 400; ++i) places.push_back(problem.upper * 0.02 * std::pow(10.0, -10 + i / 40.0));
  for (int i = 1; i < 2000; ++i) places.push_back(problem.upper * (0.02 + 0.98 * i / 2000.0));
  std::vector<Exact> found{Exact(problem.upper)};
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    double low = places[i], high = places[i + 1];
    if (!(slope(low) < 0 && slope(high) >= 0)) continue;
    for (int k = 0; k < 20; ++k) (slope(0.5 * (low + high)) < 0 ? low : high) = 0.5 * (low + high);
    Exact x = 0.5 * (low + high);
    for (int k = 0; k < 8; ++k) {
      const Exact h = x * Exact(1e-20);
      x -= exact(x).slope * 2 * h / (exact(x + h).slope - exact(x - h).slope);
    }
    const Exact width = x * Exact(1e-30);
    if (!(exact(x - width).slope < 0 && exact(x + width).slope > 0))
      throw std::runtime_error("no minimum where sought");
    found.push_back(x);
  }
  if (slope(places.front()) > 0) found.push_back(Exact(problem.lower));
  Exact best = found.front();
  for (const Exact& x : found)
    if (exact(x).cost < exact(best).cost) best = x;
  return best;
}

}  // namespace mixity::precision
