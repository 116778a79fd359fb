// Every fold over the whole domain, under load, displacement and through a spring, against Newton's method in 100
// digits on the printed equation and the condition that the driving quantity is stationary along it.
#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/equilibrium.h"
#include "mechanics/folds.h"
#include "mechanics/printed_equation.h"

namespace mixity {
namespace fold_extremes_test {

using Number = truth::Digits<100>;

#if defined(__SANITIZE_ADDRESS__)
constexpr std::size_t kStride = 12;  // slow under sanitizers: every twelfth fold
#else
constexpr std::size_t kStride = 1;
#endif

const double kLoads[] = {
    -4.71238898038469, -4.71238898038469 * (1 - 1e-12), -4.7, -1, -1e-12, 0, 1e-12, 1, 30.4, 1e4, 1e8};
constexpr double kStiffness = 2;

/// F = 0 and dF x dV = 0 in (y, T), V being what drives the contact.
template <class Model>
struct FoldEquations {
  Parameters<Model> p;
  double P;
  Control::Kind kind;

  Number F(const Number& y, const Number& T) const { return truth::residual_of<Model, Number>(p, P, y, T); }
  Number V(const Number& y, const Number& T) const {
    if (kind == Control::Kind::load) return T;
    const Number u = Number(3) / 4 * T / cbrt(Number(Number(3) / 4 * (y + P)));
    return kind == Control::Kind::displacement ? u : Number(u + T / kStiffness);
  }
  Number G(const Number& y, const Number& T) const {
    const Number e = y * Number(1e-30), d = T * Number(1e-30);
    const Number F_y = F(y + e, T) - F(y - e, T), F_T = F(y, T + d) - F(y, T - d);
    const Number V_y = V(y + e, T) - V(y - e, T), V_T = V(y, T + d) - V(y, T - d);
    return (F_y * V_T - F_T * V_y) / (4 * e * d);
  }
  /// Newton from (y, T), which it moves to the fold.
  void solve(Number& y, Number& T) const {
    for (int i = 0; i < 6; ++i) {
      const Number e = y * Number(1e-20), d = T * Number(1e-20), F0 = F(y, T), G0 = G(y, T);
      const Number F_y = (F(y + e, T) - F0) / e, F_T = (F(y, T + d) - F0) / d;
      const Number G_y = (G(y + e, T) - G0) / e, G_T = (G(y, T + d) - G0) / d;
      const Number determinant = F_y * G_T - F_T * G_y;
      y -= (F0 * G_T - F_T * G0) / determinant;
      T -= (F_y * G0 - G_y * F0) / determinant;
    }
  }
};

template <class Model>
void expect_folds(const std::vector<Parameters<Model>>& list, std::size_t at_least) {
  std::size_t found = 0;
  for (const auto& p : list)
    for (const double P : kLoads)
      for (const auto kind : {Control::Kind::load, Control::Kind::displacement, Control::Kind::stiffness})
        for (const Fold& fold : find_folds(EquilibriumCurve(Model{}, p, P), {kind, kStiffness})) {
          const auto where = [&] {
            return ::testing::Message() << Model::info.key << " p0=" << p[0] << " P=" << P << " control "
                                        << to_string(kind) << " T=" << fold.T;
          };
          for (const double value : {fold.T, fold.u, fold.A, fold.psi, fold.area_after, fold.area_lost})
            ASSERT_TRUE(std::isfinite(value)) << where();
          if (++found % kStride != 0) continue;
          Number y = fold.place.position.y, T = fold.T;
          FoldEquations<Model>{p, P, kind}.solve(y, T);
          // T is stationary there and keeps its digits; y is a root of the derivative, whose slope vanishes towards the
          // cusp of model a: 1e-9 there, 1e-14 elsewhere.
          EXPECT_NEAR(static_cast<double>(Number(fold.T / T)), 1, 1e-14) << where();
          const double error = static_cast<double>(Number((fold.place.position.y - y) / (y + P)));
          EXPECT_NEAR(error, 0, Model::info.key == "a" ? 1e-9 : 1e-14) << where();
        }
  EXPECT_GE(found, at_least);
}

const std::vector<double> kLambdas{1e-12, 1e-6, 0.0023, 0.15, 0.5, 8.0 / 9, 1 - 1e-12, 1.0};

template <class Model>
std::vector<Parameters<Model>> with_lambdas(std::initializer_list<double> further = {}) {
  std::vector<Parameters<Model>> list;
  list.reserve(std::size(kLambdas) + further.size());
  for (const double lambda : kLambdas) list.push_back({lambda});
  for (const double lambda : further) list.push_back({lambda});
  return list;
}

TEST(FoldExtremes, ModelA) { expect_folds<Johnson>(with_lambdas<Johnson>(), 100); }
TEST(FoldExtremes, ModelB) { expect_folds<WatersGuduru>(with_lambdas<WatersGuduru>({1.3, 1.7, 2.0}), 250); }
TEST(FoldExtremes, ModelC) { expect_folds<PapangeloCiavarella>(with_lambdas<PapangeloCiavarella>(), 264); }
TEST(FoldExtremes, ModelBk) {
  expect_folds<BenzeggaghKenane>({{1.774, 2.284}, {1.5, 1}, {2, 1}, {3, 2.5}, {4, 2}, {0.7, 1.5}, {0.5, 0.5}}, 231);
}

/// At any load and stiffness that doubles hold: numbers, and no more folds than the law can have (model c one, which
/// has a closed form; a and b a pair; bk a pair and the last one).
template <class Model>
void expect_finite(const Parameters<Model>& p, std::size_t at_most) {
  for (const double P : {-4.71238898038469, -4.7123889803799, -4.7, -1e-3, -1e-300, 0.0, 1e-300, 5.5, 1e8, 1e150})
    for (const Control& control :
         {Control{Control::Kind::load}, Control{Control::Kind::displacement}, Control{Control::Kind::stiffness, 1e-300},
          Control{Control::Kind::stiffness, 2}, Control{Control::Kind::stiffness, 1e300}}) {
      const auto folds = find_folds(EquilibriumCurve(Model{}, p, P), control);
      EXPECT_LE(folds.size(), at_most) << Model::info.key << " p0=" << p[0] << " P=" << P << ' '
                                       << to_string(control.kind);
      for (const Fold& fold : folds)
        for (const double value : {fold.T, fold.u, fold.A, fold.psi, fold.area_after, fold.area_lost})
          EXPECT_TRUE(std::isfinite(value)) << Model::info.key << " p0=" << p[0] << " P=" << P << " T=" << fold.T;
    }
}

TEST(FoldExtremes, AreFiniteAtAnyExtreme) {
  for (const double q : {0.0, 1e-300, 1e-160, 1e-16, 1e-6, 0.0023, 0.5, 8.0 / 9, 1 - 1e-16, 1.0}) {
    expect_finite<Johnson>({q}, 2);
    expect_finite<WatersGuduru>({2 * q}, 2);
    expect_finite<PapangeloCiavarella>({q}, 1);
  }
  int defined = 0;
  for (const double r : {1e-3, 0.5, 1.0, 1.5, 2.0, 1e3})
    for (const double eta : {0.01, 0.5, 1.0, 2.3, 100.0})
      if (BenzeggaghKenane::equilibrium_domain({r, eta}).empty()) {
        expect_finite<BenzeggaghKenane>({r, eta}, 3);
        ++defined;
      }
  EXPECT_GE(defined, 18);
}

}  // namespace fold_extremes_test
}  // namespace mixity
