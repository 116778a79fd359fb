// Models of elliptic contacts behind ContactModel: areas, distances with and without axes, derivatives, ends.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "mechanics/contact.h"
#include "mechanics/contact_model.h"

namespace mixity {
namespace elliptic_model_test {

ContactModel model(const char* key) { return ContactModel::find(key).value(); }

/// Measured points beside a curve.
struct Readings {
  std::vector<double> P, T, A, sigma_T, sigma_A, q, sigma_q, slant;
  PlanePoints points(bool axes) const {
    PlanePoints all{P, T, A, sigma_T, sigma_A};
    if (axes) {
      all.q = q;
      all.sigma_q = sigma_q;
      all.slant = slant;
    }
    return all;
  }
  std::size_t size() const { return P.size(); }
};

Readings beside(const ContactModel& of, const ParameterValues& p, std::vector<double> loads, double noise,
                std::size_t each, double slant = 0) {
  Readings all;
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (const double P : loads) {
    const double end = std::min(of.first_stable_end(p, P), 50.0);  // that of a may be infinite
    std::vector<double> T;
    for (std::size_t i = 0; i < each; ++i)
      T.push_back(0.98 * end * static_cast<double>(i) / static_cast<double>(each - 1));
    const Ellipses states = ContactModel::find(std::string(of.info().key.substr(0, of.info().key.find('-'))))
                                ->ellipses(*of.ends_of(p), P, T);
    for (std::size_t i = 0; i < each; ++i) {
      const double A = pi<double>() * states.at[i].a * states.at[i].b, s_T = noise * end, s_A = noise * A;
      all.P.push_back(P);
      all.T.push_back(T[i] + s_T * normal(random));
      all.A.push_back(A + s_A * normal(random));
      all.sigma_T.push_back(s_T);
      all.sigma_A.push_back(s_A);
      all.q.push_back(std::log(states.at[i].a / states.at[i].b) + noise * normal(random));
      all.sigma_q.push_back(noise);
      all.slant.push_back(slant);
    }
  }
  return all;
}

struct Distances {
  std::vector<double> r, dP, dT, dA, p, T, A, q, axes_r, axes_dP, axes_dT, axes_dA, axes_p, s1, s2, s3, s4;
  bool good = false;
  Distances(const ContactModel& of, const ParameterValues& at, const PlanePoints& points) {
    const std::size_t n = points.P.size();
    for (auto* const one : {&r, &dP, &dT, &dA, &T, &A, &q, &axes_r, &axes_dP, &axes_dT, &axes_dA, &s1, &s2, &s3, &s4})
      one->resize(n);
    p.resize(n * at.size());
    axes_p.resize(n * at.size());
    CurveDistances out{r, dP, dT, dA, p, T, A, {axes_r, axes_dP, axes_dT, axes_dA, axes_p, s1, s2, s3, s4}, q};
    good = of.curve_distances(at, points, Search::global, true, out);
  }
  double squares() const {
    double sum = 0;
    for (std::size_t i = 0; i < r.size(); ++i) sum += r[i] * r[i] + axes_r[i] * axes_r[i];
    return sum;
  }
};

TEST(EllipticModel, IsFoundUnderTheKeyOfItsLaw) {
  const ContactModel two = model("c-ellipse"), one = model("bk-ellipse-equal");
  ASSERT_EQ(two.parameters().size(), 3u);
  EXPECT_EQ(two.parameters()[0].name, "lambda_II");
  EXPECT_EQ(two.parameters()[1].name, "lambda_III");
  EXPECT_EQ(two.parameters()[2].name, "poisson_ratio");
  EXPECT_EQ(one.parameters().size(), model("bk").parameters().size() + 1);
  EXPECT_EQ(two.circle().info().key, "c");
  EXPECT_EQ(one.circle().info().key, "bk");
  EXPECT_EQ(model("c").circle().info().key, "c");
  EXPECT_TRUE(is_elliptic("c-ellipse") && is_elliptic("bk-ellipse-equal"));
  EXPECT_FALSE(is_elliptic("c") || is_elliptic("nothing-ellipse"));
  EXPECT_FALSE(ContactModel::find("c-ellipse-ellipse"));
  EXPECT_FALSE(ContactModel::find("nothing-ellipse"));
  EXPECT_EQ(model("c-ellipse").obstacle(ParameterValues{0.1, 0.1, 0.6}), "poisson_ratio must lie between 0 and 0.5");
}

/// lambda_III/(1 - nu) = lambda_II of model c is a circle.
TEST(EllipticModel, OfEqualCouplingsHasTheCirclesNumbers) {
  const ContactModel ellipse = model("c-ellipse"), circle = model("c");
  for (const double nu : {0.0, 0.3, 0.5})
    for (const double P : {-3.0, 0.0, 3.0, 30.0}) {
      const double l = 0.2;
      const ParameterValues p{l, l * (1 - nu), nu}, one{l};
      const Readings readings = beside(ellipse, p, {P}, 0.02, 9);
      const Distances found(ellipse, p, readings.points(false)), right(circle, one, readings.points(false));
      ASSERT_TRUE(found.good && right.good);
      for (std::size_t i = 0; i < readings.size(); ++i) {
        // both have rounding errors of T/sigma_T = 50; the derivatives of the circle are good to 1e-10
        EXPECT_NEAR(found.r[i], right.r[i], 1e-12) << P << ' ' << i;
        EXPECT_NEAR(found.T[i] / right.T[i], 1, 1e-9);
        EXPECT_NEAR(found.dT[i] / right.dT[i], 1, 1e-8);
        EXPECT_NEAR(found.dP[i] / right.dP[i], 1, 1e-8);
        EXPECT_NEAR(found.p[3 * i] + found.p[3 * i + 1] * (1 - nu), right.p[i], 1e-8 * std::abs(right.p[i]) + 1e-9)
            << i;
        EXPECT_NEAR(found.q[i], 0, 1e-13);
      }
      EXPECT_NEAR(ellipse.first_stable_end(p, P) / circle.first_stable_end(one, P), 1, 1e-12);
    }
}

/// The nearest of 20,000 states in each of which the equations hold.
void finds_the_nearest(const char* key, const ParameterValues& p, double P, double noise, std::size_t readings_each) {
  const ContactModel of = model(key);
  const Readings readings = beside(of, p, {P}, noise, readings_each);
  const Distances found(of, p, readings.points(true));
  ASSERT_TRUE(found.good);
  const double end = std::min(of.first_stable_end(p, P), 60.0);
  std::vector<double> T;
  for (int k = 0; k <= 20000; ++k) T.push_back(end * (1 - std::pow(1 - k / 20000.0, 2)));
  const auto circle = ContactModel::find(std::string(key).substr(0, 1));
  const Ellipses states = circle->ellipses(*of.ends_of(p), P, T);
  for (std::size_t i = 0; i < readings.size(); ++i) {
    double best = 1e300;
    for (std::size_t k = 0; k < T.size(); ++k) {
      if (states.at[k].status != EquilibriumStatus::ok) continue;
      const double a = states.at[k].a, b = states.at[k].b, A = pi<double>() * a * b;
      best = std::min(best, std::pow((T[k] - std::abs(readings.T[i])) / readings.sigma_T[i], 2) +
                                std::pow((A - readings.A[i]) / readings.sigma_A[i], 2) +
                                std::pow((std::log(a / b) - readings.q[i]) / readings.sigma_q[i], 2));
    }
    const double square = found.r[i] * found.r[i] + found.axes_r[i] * found.axes_r[i];
    EXPECT_LE(square, best * (1 + 1e-9) + 1e-12) << key << P << ' ' << i;
    // unless the nearest state is on the unstable part, the step of the search costs at most 1e-5
    if (found.T[i] < 0.97 * end) {
      EXPECT_NEAR(square, best, 1e-4 * (1 + best)) << key << P << ' ' << i;
    }
  }
}

TEST(EllipticModel, FindsTheNearestState) {
  for (const auto& [key, p] : std::vector<std::pair<const char*, ParameterValues>>{
           {"c-ellipse", {0.3, 0.1, 0.5}}, {"b-ellipse", {0.6, 0.3, 0.4}}, {"a-ellipse", {0.9, 0.6, 0.3}}})
    for (const double P : {-2.0, 3.0}) finds_the_nearest(key, p, P, 0.05, 8);
}

/// Law a's T grows without bound where the area hardly changes: also there, and for a cost without steps.
TEST(EllipticModel, FindsTheNearestStateTowardsAnAsymptote) {
  for (const ParameterValues& p :
       {ParameterValues{0.107, 0.0138, 0.5}, ParameterValues{0.5, 0.445, 0.5}, ParameterValues{0.05, 0.01, 0.5}})
    for (const double P : {2.0, 16.0}) finds_the_nearest("a-ellipse", p, P, 0.006, 25);
}

/// Beside lambda = 1 the edge of law a stays nearly closed at one end of the contact while T rises again. A state there
/// as steps of 2e-4 in phi have it, in six digits.
TEST(EllipticModel, FollowsACurveAlongWhichAnEdgeIsNearlyClosed) {
  const ContactModel of = model("a-ellipse");
  const ParameterValues p{1 - 0x1p-53, 1 - 0x1p-53, 0.5};
  const double P = 1.965872454195172;
  EXPECT_LT(of.curve(p, P, {.T_most = 40.0}).points.size(), 1000u);  // not 20,000
  // the curve is followed as far as the largest T that was measured
  const Readings two{{P, P}, {6.82818, 12}, {5.81693, 4}, {1e-3, 1}, {1e-3, 1}, {0.282872, 0}, {1e-3, 1}, {0, 0}};
  const Distances found(of, p, two.points(true));
  ASSERT_TRUE(found.good);
  EXPECT_LT(std::hypot(found.r[0], found.axes_r[0]), 0.02);  // six digits of T, in standard errors
}

/// Against central differences, of each residual by itself.
TEST(EllipticModel, HasTheDerivativesOfItsResiduals) {
  for (const auto& [key, p] : std::vector<std::pair<const char*, ParameterValues>>{
           {"c-ellipse", {0.3, 0.1, 0.4}}, {"b-ellipse", {0.6, 0.3, 0.4}}, {"c-ellipse-equal", {0.2, 0.4}}}) {
    const ContactModel of = model(key);
    Readings readings = beside(of, p, {-2.0, 3.0, 20.0}, 0.05, 12, 0.3);
    const Distances at(of, p, readings.points(true));
    ASSERT_TRUE(at.good);
    const std::size_t count = p.size(), n = readings.size();
    // differences are good to 1e-10/h; that of the direction of the curve over a short step to 1e-6 of a small part
    const auto compare = [&](const Distances& up, const Distances& down, double h, std::size_t i, double slope,
                             double axes_slope, const std::string& what) {
      const double right = (up.r[i] - down.r[i]) / (2 * h), axes_right = (up.axes_r[i] - down.axes_r[i]) / (2 * h);
      const double size = std::abs(right) + std::abs(axes_right);
      EXPECT_NEAR(slope, right, 3e-6 * size + 1e-9 / h) << key << ' ' << what << ' ' << i;
      EXPECT_NEAR(axes_slope, axes_right, 3e-6 * size + 1e-9 / h) << key << " axes " << what << ' ' << i;
    };
    for (std::size_t k = 0; k < count; ++k) {
      const double h = 1e-4 * p[k];
      ParameterValues up = p, down = p;
      up[k] += h;
      down[k] -= h;
      const Distances above(of, up, readings.points(true)), below(of, down, readings.points(true));
      for (std::size_t i = 0; i < n; ++i)
        compare(above, below, h, i, at.p[i * count + k], at.axes_p[i * count + k], std::to_string(k));
    }
    const auto check = [&](std::vector<double> Readings::*list, bool logarithmic, const std::vector<double>& d,
                           const std::vector<double>& axes_d, const std::string& what) {
      constexpr double kStep = 1e-4;
      Readings up = readings, down = readings;
      for (double& one : up.*list) one += kStep * (logarithmic ? one : 1);
      for (double& one : down.*list) one -= kStep * (logarithmic ? one : 1);
      const Distances above(of, p, up.points(true)), below(of, p, down.points(true));
      for (std::size_t i = 0; i < n; ++i) compare(above, below, kStep, i, d[i], axes_d[i], what);
    };
    check(&Readings::P, false, at.dP, at.axes_dP, "P");
    check(&Readings::T, false, at.dT, at.axes_dT, "T");
    check(&Readings::A, false, at.dA, at.axes_dA, "A");
    check(&Readings::sigma_T, true, at.s1, at.s3, "sigma_T");
    check(&Readings::sigma_A, true, at.s2, at.s4, "sigma_A");
  }
}

TEST(EllipticModel, HasTheSlopesOfItsAreas) {
  const ContactModel of = model("c-ellipse");
  const ParameterValues p{0.3, 0.1, 0.4};
  const auto areas = [&](const ParameterValues& at, double P, double T) {
    double A;
    EquilibriumStatus status;
    of.areas_at(at, P, {&T, 1}, {&A, 1}, {&status, 1});
    return A;
  };
  const double P = 3, T = 12, A = areas(p, P, T);
  std::array<double, 3> slopes{};
  std::vector<Values> values;
  for (const double& one : p) values.push_back({&one, 0});
  std::vector<std::span<double>> out;
  for (double& one : slopes) out.emplace_back(&one, 1);
  of.area_slopes(values, {&P, 0}, {&T, 0}, {&A, 1}, out);
  for (std::size_t k = 0; k < 3; ++k) {
    const double h = 1e-5;
    ParameterValues up = p, down = p;
    up[k] += h;
    down[k] -= h;
    EXPECT_NEAR(slopes[k], (areas(up, P, T) - areas(down, P, T)) / (2 * h), 1e-8 * std::abs(slopes[k]) + 1e-9) << k;
  }
  double back;
  of.tangential_loads(values, {&P, 0}, {&A, 0}, {&back, 1});
  EXPECT_NEAR(back, T, 1e-11);
  // A falls by alpha T^2 at small T
  const double A0 = areas(p, P, 0), small = 1e-2;
  EXPECT_NEAR(of.shear_sensitivity(p, A0).value(), (A0 - areas(p, P, small)) / (small * small), 1e-6);
}

}  // namespace elliptic_model_test
}  // namespace mixity
