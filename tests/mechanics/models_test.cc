// Claims every model of the registry must fulfil; a new model is tested here without a new line.
#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/contact_model.h"
#include "mechanics/equilibrium.h"
#include "mechanics/measurement.h"
#include "mechanics/model_types.h"
#include "mechanics/printed_equation.h"

namespace mixity {
namespace models_test {

using truth::kEps;

/// Some parameter values inside the range, among them one near each end.
template <class Model>
std::vector<Parameters<Model>> samples() {
  std::vector<Parameters<Model>> list;
  for (const double q : {1e-6, 0.0023, 0.15, 0.5, 0.9, 1 - 1e-9}) {
    Parameters<Model> p;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const ParameterInfo& info = Model::parameters[i];
      p[i] = info.lower > 0 ? info.typical * (0.4 + 1.3 * q) : info.upper * q;
    }
    list.push_back(p);
  }
  return list;
}

const double kAngles[] = {0, 1e-9, 1e-4, 0.1, 0.4, 0.785, 0.9, 1.2, 1.5, 1.5707};

template <class Model>
class EveryModel : public ::testing::Test {};
TYPED_TEST_SUITE(EveryModel, ModelTypes);

TYPED_TEST(EveryModel, HasToughnessOneAtPureModeOne) {
  for (const auto& p : samples<TypeParam>()) EXPECT_EQ(TypeParam::log_toughness(p, Mixity<double>{1, 0}).value, 0);
}

TYPED_TEST(EveryModel, GradientMatchesAutodiff) {
  constexpr int N = static_cast<int>(parameter_count<TypeParam>);
  using Jet = ceres::Jet<double, N>;
  for (const auto& p : samples<TypeParam>())
    for (const double psi : kAngles) {
      const auto mixity = mixity_from_angle(psi);
      std::array<Jet, parameter_count<TypeParam>> jets;
      for (int i = 0; i < N; ++i) jets[i] = Jet(p[i], i);
      const auto jet = TypeParam::log_toughness(jets, Mixity<Jet>{Jet(mixity.cos), Jet(mixity.sin)});
      const auto plain = TypeParam::log_toughness(p, mixity);
      EXPECT_EQ(plain.value, jet.value.a);
      for (int i = 0; i < N; ++i) {
        // Both differentiate the same expression; rounding is that of the terms, which cancel at most tenfold.
        // Autodiff takes ln B from B, which near B = 1 carries one rounding; the analytic form does not.
        const double scale = std::abs(jet.value.v[i]) + std::abs(plain.value) * 1e-3;
        EXPECT_NEAR(plain.gradient[i], jet.value.v[i], 200 * kEps * scale + kEps) << "psi " << psi << " p " << p[0];
      }
    }
}

TYPED_TEST(EveryModel, ShearTermDerivativesMatchAutodiff) {
  constexpr int N = static_cast<int>(parameter_count<TypeParam>);
  using Jet = ceres::Jet<double, 1>;
  for (const auto& p : samples<TypeParam>())
    for (const double y : {1e-3, 0.3, 2.0, 9.4, 30.0, 1e3})
      for (const double T : {1e-4, 0.1, 1.0, 9.4, 50.0, 1e4}) {
        std::array<Jet, parameter_count<TypeParam>> jets;
        for (int i = 0; i < N; ++i) jets[i] = Jet(p[i]);
        const auto jet = TypeParam::shear_term(jets, Jet(y, 0), Jet(T));
        const auto plain = TypeParam::shear_term(p, y, T);
        // d1 and d2 of a degree-2 homogeneous function: rounding relative to value/y and value/y^2, or to the
        // natural size of the function where the value itself is small.
        const double size = std::min(T * T, y * y + T * T) + plain.value;
        EXPECT_NEAR(plain.d1, jet.value.v[0], 1e-13 * (size / y + std::abs(plain.d1))) << y << ' ' << T << ' ' << p[0];
        EXPECT_NEAR(plain.d2, jet.d1.v[0], 1e-13 * (size / (y * y) + std::abs(plain.d2)))
            << y << ' ' << T << ' ' << p[0];
      }
}

/// g = (1 + tan^2 psi)/f and tau^2 = y^2 (g - 1): the two ways in which a model is written say the same.
TYPED_TEST(EveryModel, ShearTermAgreesWithToughness) {
  for (const auto& p : samples<TypeParam>())
    for (const double y : {1e-3, 0.3, 9.4, 1e3})
      for (const double T : {1e-4, 0.1, 9.4, 1e4}) {
        const double f = std::exp(TypeParam::log_toughness(p, mixity_from_loads(y, T)).value);
        const double from_f = (y * y + T * T) / f;
        // rounding of y^2 + T^2 and of exp
        EXPECT_NEAR(TypeParam::shear_term(p, y, T).value + y * y, from_f, 1e-14 * (y * y + T * T));
      }
}

/// What predict returns fulfils the equation as the paper prints it: the circle holds for every model.
TYPED_TEST(EveryModel, EquilibriumFulfilsThePrintedEquation) {
  for (const auto& p : samples<TypeParam>())
    for (const double P : {-4.7, -1.0, 0.0, 1.0, 30.4, 1e4}) {
      const LoadedContact contact(TypeParam{}, p, P);
      if (!contact.obstacle().empty()) continue;
      const double end = std::min(contact.branches().front().T_bottom, 1e6);
      for (const double part : {1e-8, 0.01, 0.5, 0.9, 0.99}) {
        const double T = part * end;
        const Equilibrium found = contact.at(T);
        ASSERT_EQ(found.status, EquilibriumStatus::ok);
        const auto residual = [&](double y) { return truth::residual_of<TypeParam>(p, P, y, T); };
        // The root of the printed equation lies within a few roundings of y, amplified 1/sqrt(1 - part) at most
        // tenfold by the fold.
        const double width = 40 * kEps * (found.y + std::abs(P));
        EXPECT_LT(residual(found.y - width), 0) << TypeParam::info.key << ' ' << p[0] << ' ' << P << ' ' << T;
        EXPECT_GT(residual(found.y + width), 0) << TypeParam::info.key << ' ' << p[0] << ' ' << P << ' ' << T;
      }
    }
}

TYPED_TEST(EveryModel, AreaFallsAsShearGrows) {
  for (const auto& p : samples<TypeParam>())
    for (const double P : {-3.0, 0.0, 5.0}) {
      const LoadedContact contact(TypeParam{}, p, P);
      if (!contact.obstacle().empty()) continue;
      const double end = std::min(contact.branches().front().T_bottom, 1e3);
      double last = contact.at(0).y;
      EXPECT_DOUBLE_EQ(last, contact.jkr_edge_load());
      for (int i = 1; i <= 50; ++i) {
        const double y = contact.at(end * i / 50).y;
        EXPECT_LE(y, last);
        last = y;
      }
    }
}

TEST(Registry, HoldsTheFourModelsInOrder) {
  std::string keys;
  for_each_model([&](auto model) { keys += std::string(decltype(model)::info.key) + ' '; });
  EXPECT_EQ(keys, "a b c bk ");
  EXPECT_FALSE(ContactModel::find("d"));
}

}  // namespace models_test
}  // namespace mixity
