// How others fit lambda to points (T, A) with errors in both: with Ceres, each point's place on its curve beside
// lambda; and by Gauss-Newton on the printed equation, linearised in the errors.
#pragma once

#include <array>
#include <vector>

#include "benchmarks/precision/explicit_curve.h"
#include "benchmarks/precision/solvers.h"

namespace mixity::precision {

/// w = T/y of a point as measured; far along the curve if its area does not exceed that of Hertz.
inline double measured_ratio(const PlanePoint& point) {
  const double a = std::sqrt(point.A / pi<double>()), y = 4.0 / 3 * a * a * a - point.P;
  constexpr double kFarthest = 1e3;
  return y > point.T / kFarthest ? point.T / y : kFarthest;
}

/// Both deviations of a point from its place w on the curve, in standard errors.
template <class Model>
class PlaceCost final : public ceres::SizedCostFunction<2, 1, 1> {
 public:
  explicit PlaceCost(const PlanePoint& point) : point_(point) {}
  bool Evaluate(const double* const* x, double* residuals, double** jacobians) const override {
    const auto place = curve_place<Model, double>(x[0][0], point_.P, x[1][0]);
    residuals[0] = (place.T - point_.T) / point_.sigma_T;
    residuals[1] = (place.A - point_.A) / point_.sigma_A;
    const std::array<std::array<double, 2>, 2> slopes{
        {{place.T_lambda / point_.sigma_T, place.A_lambda / point_.sigma_A},
         {place.T_w / point_.sigma_T, place.A_w / point_.sigma_A}}};
    for (std::size_t k = 0; jacobians && k < 2; ++k)
      if (jacobians[k]) std::copy(slopes[k].begin(), slopes[k].end(), jacobians[k]);
    return std::isfinite(residuals[0]) && std::isfinite(residuals[1]);
  }

 private:
  PlanePoint point_;
};

/// As its manual treats such problems: the places are eliminated by the Schur complement.
template <class Model>
Answer with_ceres_places(const std::vector<PlanePoint>& points, double start, double tolerance) {
  double lambda = start;
  std::vector<double> places;
  places.reserve(points.size());
  ceres::Problem fit;
  ceres::Solver::Options options;
  options.linear_solver_ordering = std::make_shared<ceres::ParameterBlockOrdering>();
  for (const PlanePoint& point : points) {
    places.push_back(measured_ratio(point));
    fit.AddResidualBlock(new PlaceCost<Model>(point), nullptr, &lambda, &places.back());
    options.linear_solver_ordering->AddElementToGroup(&places.back(), 0);
  }
  options.linear_solver_ordering->AddElementToGroup(&lambda, 1);
  fit.SetParameterLowerBound(&lambda, 0, Model::parameters[0].lower);
  fit.SetParameterUpperBound(&lambda, 0, Model::parameters[0].upper);
  options.linear_solver_type = ceres::DENSE_SCHUR;
  options.max_num_iterations = kIterations;
  options.function_tolerance = options.gradient_tolerance = options.parameter_tolerance = tolerance;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &fit, &summary);
  return {lambda, summary.termination_type == ceres::CONVERGENCE, claim_of(summary),
          static_cast<double>(summary.num_residual_evaluations)};
}

/// f of the law as printed, and its derivative in y at fixed T. That in T follows: f depends on T/y alone.
template <class S>
struct Toughness {
  S f, by_y;
};

template <class S>
Toughness<S> printed_toughness(const Johnson&, const S& lambda, double y, double T) {
  const S rise = (1.0 - lambda) * (T * T / (y * y));
  return {1.0 + rise, -2.0 / y * rise};
}
template <class S>
Toughness<S> printed_toughness(const WatersGuduru&, const S& lambda, double y, double T) {
  const S k = 1.0 - 0.5 * lambda, t = tan(k * std::atan2(T, y)), f = 1.0 + t * t;
  return {f, -2.0 * T / (y * y + T * T) * k * t * f};
}
template <class S>
Toughness<S> printed_toughness(const PapangeloCiavarella&, const S& lambda, double y, double T) {
  const double sin2 = T * T / (y * y + T * T);
  const S f = 1.0 / (1.0 + (lambda - 1.0) * sin2);
  return {f, -2.0 * y * sin2 / (y * y + T * T) * (1.0 - lambda) * f * f};
}

/// F over its standard error: the distance from the curve to first order.
template <class Model, class S>
S linearised_distance(const S& lambda, const PlanePoint& point) {
  const double pi_ = pi<double>(), a = std::sqrt(point.A / pi_), cube = a * a * a, T = point.T;
  const double y = 4.0 / 3 * cube - point.P;
  const auto [f, by_y] = printed_toughness(Model{}, lambda, y, T);
  const S F_T = 2 * T + 8 * pi_ * cube * y / T * by_y;
  const S F_A = 2 * a / pi_ * (2 * y - 8 * pi_ * cube * by_y) - 12 * a * f;
  const S u = F_T * point.sigma_T, v = F_A * point.sigma_A;
  return (y * y + T * T - 8 * pi_ * cube * f) / sqrt(u * u + v * v);
}

/// What a careful script does. Steps that would raise the sum are halved, bounds are kept.
template <class Model>
Answer linearised_gauss_newton(const std::vector<PlanePoint>& points, double start, double tolerance) {
  using Jet = ceres::Jet<double, 1>;
  struct Sum {
    double cost = 0, slope = 0, curvature = 0;
  };
  int sweeps = 0;
  const auto sum_at = [&](double lambda) {
    ++sweeps;
    Sum sum;
    for (const PlanePoint& point : points) {
      const Jet r = linearised_distance<Model, Jet>(Jet(lambda, 0), point);
      sum.cost += r.a * r.a;
      sum.slope += r.a * r.v[0];
      sum.curvature += r.v[0] * r.v[0];
    }
    return sum;
  };
  double lambda = start;
  Sum here = sum_at(lambda);
  for (int i = 0; i < kIterations; ++i) {
    const double lower = Model::parameters[0].lower, upper = Model::parameters[0].upper;
    const double next = std::clamp(lambda - here.slope / here.curvature, lower, upper);
    double step = next - lambda;
    Sum there = sum_at(lambda + step);
    for (int k = 0; k < 30 && !(there.cost <= here.cost) && std::abs(step) > tolerance * std::abs(lambda); ++k)
      there = sum_at(lambda + (step *= 0.5));
    if (there.cost <= here.cost) {
      lambda += step;
      here = there;
    }
    if (std::abs(step) <= tolerance * std::abs(lambda)) return {lambda, true, "converged", 1.0 * sweeps};
  }
  return {lambda, false, "no convergence", 1.0 * sweeps};
}

}  // namespace mixity::precision
