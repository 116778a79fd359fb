// The curve is finite to the ends of its pieces and of the parameters.
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <vector>

#include "mechanics/curve.h"
#include "mechanics/model_types.h"
#include "mechanics/whole_curve.h"

namespace mixity {
namespace curve_extremes_test {

TYPED_TEST_SUITE(WholeCurve, ModelTypes);

const std::vector<double> kLoads{
    -4.71238898038469, -4.7123889803799, -4.7, -1.0, -1e-12, -1e-300, 0.0, 1e-300, 1e-12, 1.0, 30.4, 1e4, 1e8};

template <class Model>
std::vector<Parameters<Model>> parameters_of(std::initializer_list<double> fractions) {
  if constexpr (parameter_count<Model> == 2) {
    return {{1, 1}, {2, 1}, {2, 100}, {4, 2}, {0.7, 1.5}, {0.5, 0.5}, {1e-3, 0.1}, {1e-3, 1}, {1e-3, 100}, {1, 1e-2}};
  } else {
    std::vector<Parameters<Model>> list;
    for (const double fraction : fractions) list.push_back({Model::parameters[0].upper * fraction});
    return list;
  }
}

/// Points at these parts of every piece are finite and none of their values is negative.
template <class Model>
void expect_finite(const std::vector<Parameters<Model>>& list, const std::vector<double>& parts) {
  for (const auto& p : list)
    for (const double P : kLoads) {
      const EquilibriumCurve curve(Model{}, p, P);
      for (const CurvePiece& piece : curve.pieces())
        for (const double part : parts) {
          const double begin = curve.phi_begin(piece), end = curve.phi_end(piece);
          const double phi = part == 1 ? end : begin + (end - begin) * part;
          if (piece.end == CurveEnd::asymptote && !(phi < end)) continue;  // T is infinite there
          if (piece.from_asymptote && !(phi > begin)) continue;
          const CurvePoint q = curve.point(phi);
          bool finite = true;
          for (const double x : {q.y, q.T, q.a, q.A, q.u, q.psi, q.f, q.dy, q.dT, q.da, q.dA, q.du, q.dpsi, q.df})
            finite = finite && std::isfinite(x);
          EXPECT_TRUE(finite && q.y >= 0 && q.T >= 0 && q.psi >= 0 && q.f > 0)
              << describe<Model>(p, P, phi) << ": y " << q.y << ", T " << q.T << ", u " << q.u << ", psi " << q.psi
              << ", f " << q.f << ", dT " << q.dT << ", du " << q.du << ", dpsi " << q.dpsi;
        }
    }
}

const auto kFractions = {0.0, 1e-12, 1e-6, 0.0023, 0.15, 8.0 / 9, 1 - 1e-12, 1 - 1e-15, 1.0};

TYPED_TEST(WholeCurve, IsFiniteInside) {
  std::vector<double> parts{1e-15, 1e-12, 1e-9, 1e-6, 1 - 1e-6, 1 - 1e-9};
  for (int i = 1; i < 40; ++i) parts.push_back(i / 40.0);
  expect_finite<TypeParam>(parameters_of<TypeParam>(kFractions), parts);
}

TYPED_TEST(WholeCurve, IsFiniteAtBothEnds) { expect_finite<TypeParam>(parameters_of<TypeParam>(kFractions), {0, 1}); }

TYPED_TEST(WholeCurve, IsFiniteWhereTheSquareOfTheShearUnderflows) {
  expect_finite<TypeParam>(parameters_of<TypeParam>(kFractions), {1e-300, 1e-200, 1e-160, 1e-100});
}

/// T is up to 1e154 here, and f = T^2 beyond every double.
TYPED_TEST(WholeCurve, IsFiniteWhereLambdaIsNearlyZero) {
  if constexpr (parameter_count<TypeParam> == 1)
    expect_finite<TypeParam>(parameters_of<TypeParam>({1e-300, 1e-160, 1e-100, 1e-50, 1e-20, 1e-16}),
                             {1e-9, 1e-3, 0.1, 0.3, 0.5, 0.7, 0.9, 0.999});
}

}  // namespace curve_extremes_test
}  // namespace mixity
