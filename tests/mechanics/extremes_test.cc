// The whole domain and its edges: more than 20,000 cases, each area judged by the printed equation in 50 digits.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mechanics/area_judge.h"
#include "mechanics/batch.h"
#include "mechanics/printed_equation.h"
#include "mechanics/states.h"

namespace mixity {
namespace extremes_test {

using truth::Digits50;

#if defined(__SANITIZE_ADDRESS__)
constexpr std::size_t kStride = 9;  // 50-digit arithmetic is slow under sanitizers: every ninth case
#else
constexpr std::size_t kStride = 1;
#endif

const std::vector<double> kLambdas{0, 1e-300, 1e-12, 1e-6, 0.0023, 0.15, 0.5, 8.0 / 9, 1 - 1e-12, 1};
const std::vector<double> kLoads{
    -4.71238898038469, -4.71238898038469 * (1 - 1e-12), -4.7, -1, -1e-12, 0, 1e-12, 1, 30.4, 1e4, 1e8};

template <class Model>
std::vector<Parameters<Model>> cases() {
  std::vector<Parameters<Model>> list;
  if constexpr (parameter_count<Model> == 2) {
    return {{1.774, 2.284}, {1.5, 1}, {2, 1}, {3, 2.5}, {4, 2}, {0.7, 1.5}, {0.5, 0.5}, {1, 1}, {1e-3, 0.1}, {2, 100}};
  } else {
    for (const double lambda : kLambdas) list.push_back({lambda});
    if (Model::parameters[0].upper == 2)
      for (const double lambda : {1.3, 1.7, 2 - 1e-12, 2.0}) list.push_back({lambda});
    return list;
  }
}

/// Fractions of the first instability: the ends, a regular sweep, and random places.
std::vector<double> fractions() {
  std::vector<double> list{0,         1e-300,    1e-8, 1e-3,      1 - 1e-3, 1 - 1e-6, 1 - 1e-9,
                           1 - 1e-12, 1 - 1e-15, 1,    1 + 1e-12, 1.001,    2,        1e10};
  for (int i = 1; i < 25; ++i) list.push_back(i / 25.0);
  std::mt19937_64 random(20190301);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 12; ++i) list.push_back(uniform(random));
  return list;
}

struct Tally {
  std::size_t cases = 0, solved = 0, refused = 0;
  std::vector<int> iterations;
};

template <class Model>
void judge_one(const LoadedContact<Model>& contact, const Judge<Model>& judge, Tally& tally) {
  const Equilibrium found = contact.at(judge.T);
  ++tally.cases;
  tally.iterations.push_back(found.iterations);
  ++(found.status == EquilibriumStatus::ok ? tally.solved : tally.refused);
  double error = 0;
  EXPECT_EQ(wrong_with_area(contact, judge, error), "")
      << Model::info.key << " p0=" << judge.p[0] << " P=" << judge.P << " T=" << judge.T << " y=" << found.y;
}

template <class Model>
Tally run_grid() {
  Tally tally;
  std::size_t counter = 0;
  for (const Parameters<Model>& p : cases<Model>())
    for (const double P : kLoads) {
      const LoadedContact contact(Model{}, p, P);
      EXPECT_TRUE(contact.obstacle().empty()) << contact.obstacle();
      const double fold = contact.branches().front().T_bottom;
      const double w = Model::small_shear(p);
      const double scale = std::isfinite(fold) ? fold : circle_radius(P) / std::sqrt(w > 0 && w < 1e9 ? w : 1.0);
      std::vector<double> loads{1e150, 1e-300, 1e-8};
      for (const double fraction : fractions()) loads.push_back(fraction * scale);
      for (const double T : loads) {
        if (T > kLargestLoad || ++counter % kStride != 0) continue;
        judge_one(contact, Judge<Model>{p, P, T}, tally);
      }
    }
  std::sort(tally.iterations.begin(), tally.iterations.end());
  return tally;
}

template <class Model>
void expect_grid() {
  const Tally tally = run_grid<Model>();
  EXPECT_GE(tally.cases * kStride, 5000u);
  EXPECT_GT(tally.solved, tally.refused);
  EXPECT_LE(tally.iterations[tally.iterations.size() / 2], 4);
  ::testing::Test::RecordProperty("cases", static_cast<int>(tally.cases));
}

TEST(Extremes, ModelAIsRightOverItsWholeDomain) { expect_grid<Johnson>(); }
TEST(Extremes, ModelBIsRightOverItsWholeDomain) { expect_grid<WatersGuduru>(); }
TEST(Extremes, ModelCIsRightOverItsWholeDomain) { expect_grid<PapangeloCiavarella>(); }
TEST(Extremes, ModelBkIsRightOverItsWholeDomain) { expect_grid<BenzeggaghKenane>(); }

/// The state found is the one that loading from T = 0 reaches: no root of the printed equation lies above it, unless T
/// is beyond the first fold, where the contact has jumped.
template <class Model>
void expect_upper_branch() {
  for (const Parameters<Model>& p : cases<Model>())
    for (const double P : kLoads) {
      const LoadedContact contact(Model{}, p, P);
      const double fold = std::min(contact.branches().front().T_bottom, 1e20);
      for (const double fraction : {0.3, 0.9, 0.999}) {
        const Judge<Model> judge{p, P, fraction * fold};
        const Equilibrium found = contact.at(judge.T);
        if (contact.jkr_edge_load() - found.y < 1e-9 * found.y) continue;  // nothing lies between
        ASSERT_EQ(found.status, EquilibriumStatus::ok);
        if (kStride > 1) continue;
        EXPECT_TRUE(judge.nothing_above(found.y)) << Model::info.key << ' ' << p[0] << ' ' << P << ' ' << judge.T;
      }
    }
}

TEST(Extremes, TheStateFoundIsTheOneThatLoadingReaches) {
  expect_upper_branch<Johnson>();
  expect_upper_branch<WatersGuduru>();
  expect_upper_branch<PapangeloCiavarella>();
  expect_upper_branch<BenzeggaghKenane>();
}

TEST(Extremes, BatchAndSinglePredictionsAgree) {
  for_each_model([](auto model) {
    using Model = decltype(model);
    for (const Parameters<Model>& p : cases<Model>())
      for (const double P : kLoads) {
        const LoadedContact contact(Model{}, p, P);
        const double end = std::min(contact.branches().front().T_bottom, 1e100);
        std::vector<double> T{-1, std::nan(""), HUGE_VAL, 0, 1e-300, end * 1.001, 2e150};
        for (int i = 0; i <= 40; ++i) T.push_back(end * i / 40);
        // falling, repeated, wildly spaced: guesses from earlier points must not show in the answer
        for (int i = 40; i >= 0; i -= 3) T.push_back(end * i / 40);
        for (int i = 1; i < 40; ++i) T.push_back(end * std::pow(2, -40 + i + i % 2));
        for (int i = 0; i < 40; ++i) T.push_back(end * 0.999 * (i * 17 % 41) / 41);
        std::vector<double> areas(T.size(), -1);
        std::size_t ok = 0;
        const std::size_t found = predict_areas(LoadedContact(Model{}, p, P), T, areas);
        for (std::size_t i = 0; i < T.size(); ++i) {
          const Equilibrium single = contact.at(T[i]);
          const bool exists = single.status == EquilibriumStatus::ok;
          ok += exists;
          const double A = exists ? area_from_radius(radius_from_edge_load(single.y, P)) : 0;
          // At the fold itself an area is known to sqrt(eps), at the cusp of model a (lambda = 8/9) to cbrt(eps).
          EXPECT_NEAR(areas[i], A, (T[i] > 0.999 * end ? 1e-5 : 4e-15) * A)
              << Model::info.key << ' ' << p[0] << ' ' << P << ' ' << T[i];
        }
        EXPECT_EQ(found, ok);
      }
  });
}

}  // namespace extremes_test
}  // namespace mixity
