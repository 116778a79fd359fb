// The three objectives on loads and areas: their residuals against what they are called, their Jacobians against
// central differences.
#include "fitting/experiment_objective.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fitting/synthetic_runs.h"
#include "fitting/toughness_objective.h"
#include "mechanics/model_types.h"

namespace mixity {
namespace {

template <class Model>
std::vector<Parameters<Model>> cases() {
  if constexpr (parameter_count<Model> == 2)
    return {{1.774, 2.284}, {0.7, 1.5}};
  else
    return {{0.0023}, {0.15}, {0.8}};
}

/// Points off the curve by some percent, at T from none to close before the fold.
template <class Model>
std::vector<MeasuredPoint> points(const Parameters<Model>& p, double sigma_T = 0.02, double upto = 0.93) {
  std::vector<MeasuredPoint> list;
  SeededNoise noise(1, 0.02);
  const Dataset data = synthetic_runs<Model>(p, {-1, 0.5, 20}, 6, upto, [&] { return 0.03 + noise(); });
  for (const Point& q : data.points)
    list.push_back({q.P, q.T, q.A, sigma_T * shear_to_lose_area<Model>(p, q.P), 0.02 * q.A});
  return list;
}

/// All parameters of the model and all corrections free.
template <class Model>
FreeChoice<Model> everything() {
  FreeChoice<Model> choice({}, {});
  for (const Correction c : {kToughness, kModulus, kLoadOffset, kAreaOffset})
    choice.add(c, {std::string(kCorrectionNames[c]), -1, 1, 0.0});
  return choice;
}

template <class Model, template <class> class Residuals>
ExperimentObjective<Model, Residuals> objective(const std::vector<MeasuredPoint>& points,
                                                FreeChoice<Model> choice = everything<Model>()) {
  const std::vector<double> ones(points.size(), 1.0);
  return {points, ones, ones, std::move(choice)};
}

template <class Model>
std::vector<double> at(const Parameters<Model>& p, const Corrections& corrections) {
  std::vector<double> x(p.begin(), p.end());
  x.insert(x.end(), corrections.begin(), corrections.end());
  return x;
}

std::vector<double> residuals_of(const LeastSquares& problem, const std::vector<double>& x) {
  std::vector<double> residuals(problem.residual_count());
  EXPECT_TRUE(problem.evaluate(x, residuals, {}));
  return residuals;
}

/// Every entry against (8 (r(h) - r(-h)) - (r(2h) - r(-2h)))/12h. `tolerance` is relative to the largest of its column.
void expect_jacobian(const LeastSquares& problem, const std::vector<double>& x, double tolerance,
                     const std::string& where) {
  const std::size_t n = problem.residual_count(), p = x.size();
  std::vector<double> residuals(n), jacobian(n * p);
  ASSERT_TRUE(problem.evaluate(x, residuals, jacobian)) << where;
  for (std::size_t k = 0; k < p; ++k) {
    const double h = 3e-4 * (x[k] != 0 ? std::abs(x[k]) : 1);
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
      EXPECT_NEAR(jacobian[i * p + k], (8 * (c[i] - b[i]) - (d[i] - a[i])) / (12 * h), tolerance * largest)
          << where << " point " << i << " parameter " << k;
  }
}

template <class Model>
class ExperimentJacobian : public ::testing::Test {};
TYPED_TEST_SUITE(ExperimentJacobian, ModelTypes);

const std::vector<Corrections> kCorrections{{0, 0, 0, 0}, {0.02, -0.03, 0.05, -0.01}};

// Tolerances: a residual of size 1 to 10 is good to some 1e-13 (areas and nearest points to 1e-15 over errors of 2 %),
// which h makes 1e-9 of it for lambda = 0.0023; h^4 = 1e-14 of a fifth derivative that reaches 1e4 near the fold.

TYPED_TEST(ExperimentJacobian, OfToughnessMatchesDifferences) {
  for (const Parameters<TypeParam>& p : cases<TypeParam>())
    for (const Corrections& c : kCorrections)
      expect_jacobian(objective<TypeParam, ToughnessResiduals>(points<TypeParam>(p)), at<TypeParam>(p, c), 1e-8,
                      std::to_string(p[0]));
}

TYPED_TEST(ExperimentJacobian, OfAreaMatchesDifferences) {
  for (const Parameters<TypeParam>& p : cases<TypeParam>())
    for (const Corrections& c : kCorrections)
      expect_jacobian(objective<TypeParam, AreaResiduals>(points<TypeParam>(p, 0.02, 0.85)), at<TypeParam>(p, c), 1e-8,
                      std::to_string(p[0]));
}

TYPED_TEST(ExperimentJacobian, OfCurveMatchesDifferences) {
  for (const Parameters<TypeParam>& p : cases<TypeParam>())
    for (const Corrections& c : kCorrections)
      expect_jacobian(objective<TypeParam, CurveResiduals>(points<TypeParam>(p)), at<TypeParam>(p, c), 1e-8,
                      std::to_string(p[0]));
}

/// Beyond the fold the area objective differentiates the fold itself, by differences of its own: good to 1e-5.
TEST(ExperimentJacobian, OfAreaBeyondTheFoldIsThatOfTheFold) {
  for (const double lambda : {0.0023, 0.15}) {
    const Parameters<PapangeloCiavarella> p{lambda};
    std::vector<MeasuredPoint> beyond = points<PapangeloCiavarella>(p);
    for (MeasuredPoint& q : beyond) q.T = (1.1 + 0.01 * q.T) * shear_to_lose_area<PapangeloCiavarella>(p, q.P);
    const auto problem = objective<PapangeloCiavarella, AreaResiduals>(beyond);
    // A_T = pi (3/4)^(2/3) (3 pi + P)^(2/3) of model c, whatever lambda
    const std::vector<double> x = at<PapangeloCiavarella>(p, {});
    const std::vector<double> r = residuals_of(problem, x);
    std::vector<double> again(r.size()), jacobian(r.size() * x.size());
    ASSERT_TRUE(problem.evaluate(x, again, jacobian));
    for (std::size_t i = 0; i < r.size(); ++i) {
      const double A = pi<double>() * std::pow(0.75 * (3 * pi<double>() + beyond[i].P), 2.0 / 3);
      EXPECT_NEAR(r[i], (A - beyond[i].A) / beyond[i].sigma_A, 1e-12 * A / beyond[i].sigma_A);
      EXPECT_NEAR(jacobian[i * x.size()], 0, 1e-9 * A / beyond[i].sigma_A / lambda);  // rounding over h
      // dA/d(load offset) = 2/3 A/(3 pi + P)
      const double by_load = 2.0 / 3 * A / (3 * pi<double>() + beyond[i].P) / beyond[i].sigma_A;
      EXPECT_NEAR(jacobian[i * x.size() + 3], by_load, 1e-6 * by_load);
    }
  }
}

TYPED_TEST(ExperimentJacobian, AreaResidualIsModelMinusDataInStandardErrors) {
  const Parameters<TypeParam> p = cases<TypeParam>()[1];
  const auto measured = points<TypeParam>(p);
  const std::vector<double> r =
      residuals_of(objective<TypeParam, AreaResiduals>(measured), at<TypeParam>(p, Corrections{}));
  for (std::size_t i = 0; i < r.size(); ++i) {
    const MeasuredPoint& q = measured[i];
    const double y = LoadedContact<TypeParam>(p, q.P).at(q.T).y;
    // the same area by the same formulas, but for the order of roundings
    EXPECT_NEAR(r[i], (area_from_radius(radius_from_edge_load(y, q.P)) - q.A) / q.sigma_A, 1e-12);
  }
}

/// Where T is exact the distance is A's; for small errors of T it differs by (sigma_T dA/dT/sigma_A)^2.
TYPED_TEST(ExperimentJacobian, CurveTendsToAreaWhereTIsExact) {
  for (const Parameters<TypeParam>& p : cases<TypeParam>()) {
    const std::vector<double> x = at<TypeParam>(p, Corrections{});
    const auto area = residuals_of(objective<TypeParam, AreaResiduals>(points<TypeParam>(p, 0, 0.6)), x);
    const auto exact = residuals_of(objective<TypeParam, CurveResiduals>(points<TypeParam>(p, 0, 0.6)), x);
    for (std::size_t i = 0; i < area.size(); ++i)
      EXPECT_NEAR(area[i], exact[i], 1e-12) << i;  // within 4e-15 of an area that is 50 standard errors
    for (const double sigma_T : {1e-2, 3e-3}) {
      const auto curve = residuals_of(objective<TypeParam, CurveResiduals>(points<TypeParam>(p, sigma_T, 0.6)), x);
      // |dA/dT| is below A/T_scale there, so that the errors' ratio is below sigma_T/0.02, and its square halves into
      // the secant of a small angle; residuals reach 3.
      const double off = 3 * 0.5 * std::pow(sigma_T / 0.02, 2);
      for (std::size_t i = 0; i < area.size(); ++i) EXPECT_NEAR(curve[i], area[i], off) << sigma_T << ' ' << i;
    }
  }
}

TYPED_TEST(ExperimentJacobian, ToughnessResidualIsThatOfThePhaseAngles) {
  const Parameters<TypeParam> p = cases<TypeParam>()[0];
  const auto measured = points<TypeParam>(p);
  std::vector<ToughnessPoint> converted;
  converted.reserve(measured.size());
  for (const MeasuredPoint& q : measured) converted.push_back(*toughness_of_area(q.P, q.T, q.A));
  const ToughnessObjective<TypeParam> plain(converted, Scale::log, FreeChoice<TypeParam>({p, {}}, {}));
  const FreeChoice<TypeParam> choice({p, {}}, {});
  const auto loaded = objective<TypeParam, ToughnessResiduals>(measured, choice);
  const std::vector<double> x(p.begin(), p.end()), one = residuals_of(plain, x), other = residuals_of(loaded, x);
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(one[i], other[i], 1e-13) << i;  // roundings of ln f
}

/// Corrections that undo a change of the constants: the same contact in other units has the same residuals.
TYPED_TEST(ExperimentJacobian, CorrectionsUndoWhatWrongConstantsDo) {
  const Parameters<TypeParam> p = cases<TypeParam>()[1];
  const Corrections c{0.1, -0.2, 0.3, -0.05};
  const CorrectedScale scale(c);
  const auto right = points<TypeParam>(p);
  auto wrong = right;
  for (MeasuredPoint& q : wrong)
    q = {q.P / scale.force - c[kLoadOffset], q.T / scale.force, scale.measured_area(q.A), q.sigma_T / scale.force,
         q.sigma_A / scale.area};
  const auto compare = [&](const LeastSquares& one, const LeastSquares& other) {
    const auto r = residuals_of(one, at<TypeParam>(p, {})), s = residuals_of(other, at<TypeParam>(p, c));
    for (std::size_t i = 0; i < r.size(); ++i) EXPECT_NEAR(r[i], s[i], 1e-11);  // roundings over errors of 2 %
  };
  compare(objective<TypeParam, ToughnessResiduals>(right), objective<TypeParam, ToughnessResiduals>(wrong));
  compare(objective<TypeParam, AreaResiduals>(right), objective<TypeParam, AreaResiduals>(wrong));
  compare(objective<TypeParam, CurveResiduals>(right), objective<TypeParam, CurveResiduals>(wrong));
}

/// With eta < 1 the curve leaves JKR straight down: a point above that has its nearest place at this corner, where the
/// curve's normal says nothing of the distance.
TEST(CurveResiduals, AboveTheCornerOfASmallExponentTheDistanceCounts) {
  for (const double eta : {0.1, 0.36, 0.45}) {
    const double P = 17, A = area_from_radius(jkr_radius(P));
    CurveResiduals<BenzeggaghKenane> residuals({0.68, eta}, P, 20);
    for (const double T : {0.0, 0.01}) {
      const auto r = residuals({P, T, A + 0.6, 1, 1});
      ASSERT_TRUE(r);
      EXPECT_NEAR(r->value, -std::hypot(T, 0.6), 1e-9) << eta << ' ' << T;
    }
  }
}

}  // namespace
}  // namespace mixity
