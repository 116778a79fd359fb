// What the tests of every objective of loads share: points off the curve, with all constants of the experiment free,
// and a Jacobian against differences.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "fitting/model_problem.h"
#include "fitting/synthetic_runs.h"

namespace mixity {

inline std::vector<ParameterValues> typical_cases(const ContactModel& model) {
  if (model.parameters().size() == 2) return {{1.774, 2.284}, {0.7, 1.5}};
  return {{0.0023}, {0.15}, {0.8}};
}

/// Points off the curve by some percent, at T from none to close before the fold.
inline std::vector<MeasuredPoint> points_off(const std::string& model, const ParameterValues& p, double sigma_T = 0.02,
                                             double upto = 0.93) {
  std::vector<MeasuredPoint> list;
  SeededNoise noise(1, 0.02);
  const Dataset data = synthetic_runs(model, p, {-1, 0.5, 20}, 6, upto, [&] { return 0.03 + noise(); });
  const PointPlaces places(data);
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const Point& q = data.points[i];
    list.push_back({q.P, q.T, q.A, sigma_T * shear_to_lose_area(model, p, q.P), 0.02 * q.A, places.at(i)});
  }
  return list;
}

/// All parameters of the model and all constants, without that of approaches if loads are held.
inline FreeChoice everything_free(const ContactModel& model, double shear_weight = 1) {
  Candidate base;
  base.constants.shear_weight = shear_weight;
  base.constants.approach_held = model.holds_approach();
  FreeChoice choice(model, base, {});
  for (const Constant c : kAllConstants)
    if (c != kApproachOffset || model.holds_approach()) choice.add(c, {std::string(kConstantNames[c]), -1, 1, 0.0});
  return choice;
}

inline std::vector<double> solver_point(const ParameterValues& p, const Constants& constants, bool approach = false) {
  std::vector<double> x(p.begin(), p.end());
  for (const Constant c : kAllConstants)
    if (c != kApproachOffset || approach) x.push_back(constants[c]);
  return x;
}

inline const std::vector<Constants> kSomeConstants{
    {}, {{0.02, -0.03, 0.01, -0.01, 0.015, 0.05, 0.02, -0.01, 0.04, 0.03, -0.02, 0.01, 0.05}}};
inline constexpr Constants kWrongConstants{{0.1, -0.2, 0.05, -0.04, 0.02, 0.3, -0.02, -0.05, 0, 0.04, -0.03, 0.02, 0.06}};

/// The same contact, read with constants that `c` puts right.
inline std::vector<MeasuredPoint> misread(std::vector<MeasuredPoint> points, const Constants& c) {
  for (MeasuredPoint& q : points) {
    const ConstantsScale scale(c, q.place);
    q = {scale.measured_load(q.P), scale.measured_shear(q.T), scale.measured_area(q.A),
         q.sigma_T / scale.force,  q.sigma_A / scale.area,    q.place};
  }
  return points;
}

inline std::vector<double> residuals_of(const Problem& problem, const std::vector<double>& x) {
  std::vector<double> residuals(problem.residual_count());
  EXPECT_TRUE(problem.evaluate(x, residuals, {}));
  return residuals;
}

/// Every entry against (8 (r(h) - r(-h)) - (r(2h) - r(-2h)))/12h. `tolerance` is relative to the largest of its column;
/// beside it a difference loses what rounding leaves of a residual, 1e-12, over its step.
inline void expect_jacobian(const Problem& problem, const std::vector<double>& x, double tolerance,
                            const std::string& where) {
  const std::size_t n = problem.residual_count(), p = x.size();
  std::vector<double> residuals(n), jacobian(n * p);
  ASSERT_TRUE(problem.evaluate(x, residuals, jacobian)) << where;
  for (std::size_t k = 0; k < p; ++k) {
    const double h = x[k] != 0 ? 3e-4 * std::abs(x[k]) : 1e-3;
    const auto moved = [&](double by) {
      std::vector<double> y = x;
      y[k] += by;
      return residuals_of(problem, y);
    };
    const auto a = moved(-2 * h), b = moved(-h), c = moved(h), d = moved(2 * h);
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i) largest = std::max(largest, std::abs(jacobian[i * p + k]));
    EXPECT_GT(largest, 0) << where << ' ' << k;
    for (std::size_t i = 0; i < n; ++i)
      EXPECT_NEAR(jacobian[i * p + k], (8 * (c[i] - b[i]) - (d[i] - a[i])) / (12 * h), tolerance * largest + 1e-12 / h)
          << where << " point " << i << " parameter " << k;
  }
}

}  // namespace mixity
