// The equilibrium curve of a load as one writes it from the printed equation, and lambda of the points nearest to such
// curves in 50 digits. Nothing here comes from mixity's own curve or distances.
//
// With w = T/y = tan psi and g(w) = (1 + w^2)/f the printed equation y^2 + T^2 = 8 pi a^3 f(psi) is
// y^2 g = 6 pi (y + P), so that y = (3 pi + sqrt(9 pi^2 + 6 pi P g))/g and T = w y: explicit from T = 0 through the
// fold to Hertz, but for P < 0, where it ends far beyond the fold at a square root of zero.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "many_digits.h"
#include "mechanics/registry.h"

namespace mixity::precision {

using Exact = truth::Digits50;

/// A measured point and its standard errors, dimensionless.
struct PlanePoint {
  double P, T, A, sigma_T, sigma_A;
};

/// g and its derivatives in w and lambda.
template <class S>
struct LoadRatio {
  S g, by_w, by_lambda;
};

template <class S>
LoadRatio<S> load_ratio(const Johnson&, const S& lambda, const S& w) {
  const S w2 = w * w, d = S(1) + (S(1) - lambda) * w2;
  return {(S(1) + w2) / d, S(2) * w * lambda / (d * d), (S(1) + w2) * w2 / (d * d)};
}
template <class S>
LoadRatio<S> load_ratio(const WatersGuduru&, const S& lambda, const S& w) {
  using std::atan, std::cos, std::sin;
  const S k = S(1) - lambda / S(2), psi = atan(w), c = cos(k * psi), s = sin(k * psi), stretch = S(1) + w * w;
  return {stretch * c * c, S(2) * c * (w * c - k * s), stretch * c * s * psi};
}
template <class S>
LoadRatio<S> load_ratio(const PapangeloCiavarella&, const S& lambda, const S& w) {
  return {S(1) + lambda * w * w, S(2) * lambda * w, w * w};
}

/// T and A at w with their derivatives in w and lambda; not finite where the curve has ended.
template <class S>
struct CurvePlace {
  S T, A, T_w, A_w, T_lambda, A_lambda;
};

template <class Model, class S>
CurvePlace<S> curve_place(const S& lambda, const S& P, const S& w) {
  using std::cbrt, std::sqrt;
  const LoadRatio<S> ratio = load_ratio(Model{}, lambda, w);
  const S three_pi = S(3) * pi<S>(), root = sqrt(three_pi * (three_pi + S(2) * P * ratio.g));
  const S y = (three_pi + root) / ratio.g, by_g = -y * y / (S(2) * root);
  const S a = cbrt(S(3) * (y + P) / S(4)), A_y = pi<S>() / (S(2) * a);
  const S y_w = by_g * ratio.by_w, y_lambda = by_g * ratio.by_lambda;
  return {w * y, pi<S>() * a * a, y + w * y_w, A_y * y_w, w * y_lambda, A_y * y_lambda};
}

/// A zero of f near x, to 40 digits: Newton's method, its derivative by differences that take no more digits than that.
template <class Function>
Exact newton(const Function& f, Exact x) {
  const Exact h = abs(x) * Exact(1e-20);
  for (int k = 0; k < 20; ++k) {
    const Exact step = f(x) * 2 * h / (f(x + h) - f(x - h));
    x -= step;
    if (abs(step) <= abs(x) * Exact(1e-40)) return x;
  }
  throw std::runtime_error("Newton's method does not settle");
}

/// The sum of squared distances of points from their curves, in standard errors, with half its slope in lambda.
template <class Model>
class DistanceSum {
 public:
  explicit DistanceSum(const std::vector<PlanePoint>& points) : points_(points), nearest_(points.size()) {}

  template <class S>
  struct Value {
    S cost, slope;
  };

  /// Each nearest place from a search of its whole curve, in double. Later calls in 50 digits start from there.
  Value<double> search(double lambda) {
    Value<double> sum{0, 0};
    for (std::size_t i = 0; i < points_.size(); ++i) {
      nearest_[i] = nearest(lambda, points_[i]);
      add(at<double>(lambda, points_[i], nearest_[i]), sum);
    }
    return sum;
  }

  Value<Exact> exact(const Exact& lambda) const {
    Value<Exact> sum{0, 0};
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const auto slope = [&](const Exact& w) { return along<Exact>(lambda, points_[i], w); };
      const Exact w = newton(slope, Exact(nearest_[i]));
      add(at<Exact>(lambda, points_[i], w), sum);
    }
    return sum;
  }

 private:
  template <class S>
  struct Deviation {
    S T, A;  // in standard errors
    CurvePlace<S> place;
    S sigma_T, sigma_A;
  };

  template <class S>
  static Deviation<S> at(const S& lambda, const PlanePoint& point, const S& w) {
    const CurvePlace<S> place = curve_place<Model, S>(lambda, S(point.P), w);
    const S sigma_T(point.sigma_T), sigma_A(point.sigma_A);
    return {(place.T - S(point.T)) / sigma_T, (place.A - S(point.A)) / sigma_A, place, sigma_T, sigma_A};
  }
  /// Half the slope of the squared distance along the curve.
  template <class S>
  static S along(const S& lambda, const PlanePoint& point, const S& w) {
    const Deviation<S> d = at<S>(lambda, point, w);
    return d.T * d.place.T_w / d.sigma_T + d.A * d.place.A_w / d.sigma_A;
  }
  /// The place is nearest, so that its own motion does not count.
  template <class S>
  static void add(const Deviation<S>& d, Value<S>& sum) {
    sum.cost += d.T * d.T + d.A * d.A;
    sum.slope += d.T * d.place.T_lambda / d.sigma_T + d.A * d.place.A_lambda / d.sigma_A;
  }

  /// Of places spread by v/(1 - v), which resolves the fold and what is far beyond it.
  static double nearest(double lambda, const PlanePoint& point) {
    constexpr int kPlaces = 400;
    const double scale = 1 / std::sqrt(Model::small_shear({lambda}));
    const auto place = [&](int i) { return scale * i / (kPlaces - i); };
    double least = std::numeric_limits<double>::infinity();
    int best = 0;
    for (int i = 0; i < kPlaces; ++i) {
      const Deviation<double> d = at<double>(lambda, point, place(i));
      if (const double square = d.T * d.T + d.A * d.A; square < least) {
        least = square;
        best = i;
      }
    }
    double low = place(std::max(best - 1, 0)), high = place(std::min(best + 1, kPlaces - 1));
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (low + high);
      (along(lambda, point, middle) < 0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  const std::vector<PlanePoint>& points_;
  std::vector<double> nearest_;
};

/// lambda of the least sum of the whole range, to 30 digits: the lowest of a grid, its slope's sign bisected, then
/// Newton's method; the slope is seen to change sign around the result. The upper bound if the sum falls towards it.
template <class Model>
Exact exact_curve_fit(const std::vector<PlanePoint>& points) {
  DistanceSum<Model> sum(points);
  const double upper = Model::parameters[0].upper;
  std::vector<double> grid;
  for (int i = 0; i < 24; ++i) grid.push_back(upper * 0.02 * std::pow(10.0, -4 + i / 6.0));
  for (int i = 0; i < 40; ++i) grid.push_back(upper * (0.02 + 0.98 * i / 40));
  grid.push_back(upper * (1 - 1e-6));
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (const double cost = sum.search(grid[i]).cost; cost < least) {
      least = cost;
      best = i;
    }
  if (best == 0) throw std::runtime_error("the least sum lies below the grid");
  if (best + 1 == grid.size() && sum.search(grid.back()).slope < 0) return Exact(upper);
  double low = grid[best - 1], high = grid[std::min(best + 1, grid.size() - 1)];
  for (int k = 0; k < 30; ++k) {
    const double middle = 0.5 * (low + high);
    (sum.search(middle).slope < 0 ? low : high) = middle;
  }
  sum.search(0.5 * (low + high));
  const auto slope = [&](const Exact& x) { return sum.exact(x).slope; };
  const Exact x = newton(slope, Exact(0.5 * (low + high)));
  const Exact width = x * Exact(1e-30);
  if (!(slope(x - width) < 0 && slope(x + width) > 0)) throw std::runtime_error("no minimum where sought");
  return x;
}

}  // namespace mixity::precision
