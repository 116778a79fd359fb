// A model that is chosen at run time gives what its type gives.
#include "mechanics/contact_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mechanics/equilibrium.h"
#include "mechanics/registry.h"
#include "mechanics/states.h"

namespace mixity {
namespace contact_model_test {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

template <class Model>
std::vector<double> typical() {
  std::vector<double> p;
  for (const ParameterInfo& info : Model::parameters) p.push_back(info.typical);
  return p;
}

TEST(AnyModel, HasTheAreasOfItsTypeInAnyOrderOfLoads) {
  for_each_model([](auto instance) {
    using Model = decltype(instance);
    const std::vector<double> values = typical<Model>();
    Parameters<Model> p;
    std::copy(values.begin(), values.end(), p.begin());
    std::vector<double> P, T;
    for (int i = 0; i < 300; ++i) {
      P.push_back(i % 7 < 3 ? 5 : 5 * std::sin(i));
      T.push_back(0.7 * i * (i % 2 == 0 ? 1 : -1));
    }
    P[17] = kNaN;
    P[18] = -10;
    T[19] = kNaN;
    std::vector<double> A(P.size());
    std::vector<EquilibriumStatus> status(P.size());
    std::vector<Values> parameters;
    for (const double& value : values) parameters.push_back({&value, 0});
    const ContactModel model = ContactModel::find(Model::info.key).value();
    model.areas(parameters, {P.data(), 1}, {T.data(), 1}, A, status);
    for (std::size_t i = 0; i < P.size(); ++i) {
      const Equilibrium wanted = LoadedContact(Model{}, p, P[i]).at(std::abs(T[i]));
      ASSERT_EQ(status[i], wanted.status) << Model::info.key << i;
      ASSERT_EQ(std::isnan(A[i]), wanted.status != EquilibriumStatus::ok);
      if (std::isnan(A[i])) continue;
      const double exact = area_from_radius(radius_from_edge_load(wanted.y, P[i]));
      EXPECT_NEAR(A[i], exact, 1e-14 * exact);  // 4e-15 each
      // and back, where the branch is stable and not flat: at small T the area hardly tells it
      double back = 0;
      model.tangential_loads(parameters, {&P[i], 0}, {&A[i], 0}, {&back, 1});
      if (std::abs(T[i]) > 2) {
        EXPECT_NEAR(back, std::abs(T[i]), 1e-9 * std::abs(T[i])) << Model::info.key << ' ' << P[i];
      }
    }
    EXPECT_EQ(status[17], EquilibriumStatus::invalid);
    EXPECT_EQ(status[18], EquilibriumStatus::no_equilibrium);
  });
}

TEST(AnyModel, TakesOneValueForAllOrOneForEach) {
  const std::vector<double> lambdas{0.1, 0.1, 0.2, 2, 0.3};
  const double P = 3, T = 4;
  std::vector<double> A(5), one(1);
  std::vector<EquilibriumStatus> status(5), one_status(1);
  const Values each[] = {{lambdas.data(), 1}};
  const ContactModel model = ContactModel::find("c").value();
  model.areas(each, {&P, 0}, {&T, 0}, A, status);
  EXPECT_EQ(status[3], EquilibriumStatus::invalid);  // lambda > 1
  for (const std::size_t i : {0u, 1u, 2u, 4u}) {
    const Values alone[] = {{&lambdas[i], 0}};
    model.areas(alone, {&P, 0}, {&T, 0}, one, one_status);
    EXPECT_EQ(A[i], one[0]);
  }
}

TEST(AnyModel, HasTheSlopesOfItsAreas) {
  const double P = 2, m = 1.3;
  const std::vector<double> T{0, 3, -8, 12, 500};
  for (const ContactModel& model : ContactModel::published()) {
    const std::string_view key = model.info().key;
    const std::vector<double> p = key == "bk" ? std::vector{1.8, m} : std::vector{0.15};
    const auto at = [&](const std::vector<double>& values) {
      std::vector<double> A(T.size());
      std::vector<EquilibriumStatus> status(T.size());
      model.areas_at(values, P, T, A, status);
      return A;
    };
    std::vector<Values> all;
    for (const double& one : p) all.push_back({&one, 0});
    std::vector<std::vector<double>> slopes(p.size(), std::vector<double>(T.size()));
    const std::vector<std::span<double>> out(slopes.begin(), slopes.end());
    const std::vector<double> A = at(p);
    model.area_slopes(all, {&P, 0}, {T.data(), 1}, A, out);
    for (std::size_t k = 0; k < p.size(); ++k) {
      const double h = 1e-5;
      std::vector<double> above = p, below = p;
      above[k] += h;
      below[k] -= h;
      const std::vector<double> more = at(above), less = at(below);
      EXPECT_EQ(slopes[k][0], 0) << key;
      for (std::size_t i = 0; i < T.size(); ++i) {
        ASSERT_EQ(std::isnan(slopes[k][i]), std::isnan(A[i])) << key;
        // central differences are right to h^2
        if (std::isnan(A[i])) continue;
        EXPECT_NEAR(slopes[k][i], (more[i] - less[i]) / (2 * h), 1e-6) << key << ' ' << i;
      }
    }
  }
}

TEST(AnyModel, HasTheToughnessOfItsFormula) {
  const double lambda = 0.3, half_pi = std::acos(0.0);
  const std::vector<double> psi{0, 0.4, half_pi, -0.1, 1.6};
  std::vector<double> f(5);
  const Values p[] = {{&lambda, 0}};
  ContactModel::find("c")->toughness_ratios(p, {psi.data(), 1}, f);
  EXPECT_EQ(f[0], 1);
  EXPECT_NEAR(f[1], 1 / (1 + (0.3 - 1) * std::pow(std::sin(0.4), 2)), 1e-15);
  EXPECT_NEAR(f[2], 1 / 0.3, 1e-15);
  EXPECT_TRUE(std::isnan(f[3]) && std::isnan(f[4]));
}

TEST(AnyModel, HasFoldsRegimesAndCurvesOrAReason) {
  const std::vector<double> p{0.15}, wrong{1.5}, two{0.1, 0.2};
  const ContactModel model = ContactModel::find("c").value();
  const auto folds = model.folds(p, 2, {Control::Kind::load});
  ASSERT_EQ(folds.size(), 1u);
  EXPECT_NEAR(folds[0].T, circle_radius(2.0) / std::sqrt(0.15), 1e-12);
  EXPECT_EQ(model.regime(p, 2).value().fracture, Regime::jump);
  EXPECT_EQ(model.curve(p, 2, {.points = 50}).points.size(), 50u);
  EXPECT_EQ(model.problem(p, 2), "");
  EXPECT_TRUE(model.folds(wrong, 2, {Control::Kind::load}).empty());
  EXPECT_EQ(model.problem(wrong), model.obstacle(wrong));
  EXPECT_NE(model.problem(wrong), "");
  EXPECT_EQ(model.problem(two), "model c has 1 parameter, not 2");
  EXPECT_FALSE(ContactModel::find("x"));
  EXPECT_TRUE(model.folds(p, -5, {Control::Kind::load}).empty());
  EXPECT_NE(model.problem(p, -5).find("pull-off"), std::string::npos);
  EXPECT_FALSE(model.regime(p, -5));
}

}  // namespace contact_model_test
}  // namespace mixity
