// The vectorised ln f against the reference form of the same law.
#include "mechanics/packed_toughness.h"

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace mixity {
namespace packed_toughness_test {

template <class Model>
void expect_same_law() {
  using Jet = ceres::Jet<double, 1>;
  std::vector<Mixity<double>> mixities;
  for (int i = 0; i <= 400; ++i) mixities.push_back(mixity_from_angle(1.5 * i / 400));
  for (const double off : {1e-2, 1e-3, 1e-4}) mixities.push_back(mixity_from_angle(0.5 * pi<double>() - off));
  const std::size_t n = mixities.size();  // not a multiple of the vector length
  std::vector<double> first, second, value(n), slope(n), curvature(n);
  for (const auto& mixity : mixities) {
    const PackedPoint<double> point = Model::packed_point(mixity);
    first.push_back(point.first);
    second.push_back(point.second);
  }
  for (const double lambda : {0.0, 1e-6, 0.0023, 0.15, 0.9, 1.0}) {
    packed_log_toughness(Model{}, lambda, first.data(), second.data(), n, value.data(), slope.data(), curvature.data());
    for (std::size_t i = 0; i < n; ++i) {
      const auto exact = Model::log_toughness({lambda}, mixities[i]);
      const Mixity<Jet> mixity{Jet(mixities[i].cos), Jet(mixities[i].sin)};
      const double bend = Model::log_toughness(std::array{Jet(lambda, 0)}, mixity).gradient[0].v[0];
      const auto where = [&] { return ::testing::Message() << Model::info.key << ' ' << lambda << " point " << i; };
      // Some roundings; model b's tangent magnifies that of its angle by 1/(pi/2 - psi), at most 1e4 here.
      const double eps = Model::info.key == "b" ? 4e-12 : 4e-15;
      EXPECT_NEAR(value[i], exact.value, eps * (1 + std::abs(exact.value))) << where();
      EXPECT_NEAR(slope[i], exact.gradient[0], eps * (1e-3 + std::abs(exact.gradient[0]))) << where();
      EXPECT_NEAR(curvature[i], bend, 2 * eps * (1e-3 + std::abs(bend))) << where();
    }
  }
}

TEST(PackedToughness, HasTheSameValuesAndDerivativesAsTheLaw) {
  int with_packed_form = 0;
  for_each_model([&](auto model) {
    using Model = decltype(model);
    if constexpr (HasPackedForm<Model>) {
      expect_same_law<Model>();
      ++with_packed_form;
    }
  });
  EXPECT_EQ(with_packed_form, 3);  // a, b, c
}

}  // namespace packed_toughness_test
}  // namespace mixity
