// The whole domain and its edges: more than 20,000 cases, each area judged by the printed equation in 50 digits.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mechanics/batch.h"
#include "mechanics/prediction.h"
#include "mechanics/printed_equation.h"

namespace mixity {
namespace {

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
struct Judge {
  Parameters<Model> p;
  double P, T;

  Digits50 residual(const Digits50& y, const Digits50& shear) const {
    if (T < 1e15) return truth::residual_of<Model>(p, P, y, shear);
    using truth::Digits700;
    return Digits50(truth::residual_of<Model, Digits700>(p, P, Digits700(y), Digits700(shear)));
  }
  Digits50 edge_load_of(const Digits50& A) const {
    const Digits50 a = sqrt(Digits50(A / truth::kPi));
    return Digits50(4) / 3 * a * a * a - P;
  }
  /// True if the printed equation changes sign between areas within this relative distance of A. The middle is asked,
  /// too: near a fold it may lie between two roots.
  bool brackets(double A, double tolerance) const {
    const Digits50 low = edge_load_of(Digits50(A) * (1 - Digits50(tolerance)));
    const Digits50 high = edge_load_of(Digits50(A) * (1 + Digits50(tolerance)));
    const Digits50 middle = edge_load_of(A);
    const bool below = low <= 0 || residual(low, T) <= 0 || residual(middle, T) <= 0;
    return below && residual(high, T) >= 0;
  }
  /// The same for some distance up to the tolerance: near a fold the next root may lie closer than that.
  bool root_within(double A, double tolerance) const {
    for (double t = std::min(4e-15, tolerance); t < 2 * tolerance; t *= 2)
      if (brackets(A, std::min(t, tolerance))) return true;
    return false;
  }
  /// How many times a relative change of T, P or of the equation's own terms is magnified in A.
  double condition(double y) const {
    const Digits50 h = Digits50(1e-12) * y, k = Digits50(1e-12) * T;
    const Digits50 R_y = (residual(y + h, T) - residual(y - h, T)) / (2 * h);
    const Digits50 R_T = T > 0 ? Digits50((residual(y, T + k) - residual(y, T - k)) / (2 * k)) : Digits50(0);
    const Digits50 terms = abs(R_T * T) + 6 * truth::kPi * std::abs(P);
    return static_cast<double>(Digits50(terms / (abs(R_y) * (Digits50(y) + P) * 1.5)));
  }
  /// The printed residual in double at places above y: positive if no root lies there, as must be on the upper branch.
  bool nothing_above(double y) const {
    const double top = 3 * pi<double>() + circle_radius(P);
    for (int i = 1; i < 40; ++i) {
      const double z = y + (top - y) * (1e-4 + (1 - 2e-4) * i / 40);
      if (residual(z, T) < 0) return false;
    }
    return true;
  }
};

template <class Model>
void judge_one(const LoadedContact<Model>& contact, const Judge<Model>& judge, Tally& tally) {
  const Equilibrium found = contact.at(judge.T);
  ++tally.cases;
  tally.iterations.push_back(found.iterations);
  const auto where = [&] {
    return ::testing::Message() << Model::info.key << " p0=" << judge.p[0] << " P=" << judge.P << " T=" << judge.T
                                << " y=" << found.y;
  };
  if (found.status != EquilibriumStatus::ok) {
    ++tally.refused;
    EXPECT_EQ(found.status, EquilibriumStatus::no_equilibrium) << where();
    EXPECT_GT(judge.T, contact.last_load()) << where();
    return;
  }
  ++tally.solved;
  const ContactState state = contact_state(judge.P, judge.T, found.y);
  for (const double value : {state.y, state.a, state.A, state.u, state.psi, state.f})
    ASSERT_TRUE(std::isfinite(value)) << where();

  // A few roundings away from folds; towards one, what the condition number leaves of a double, and at the fold itself
  // (where it is infinite) sqrt(eps), or at the cusp of model a, where three states meet, its cube root.
  const double condition = found.y > 0 ? judge.condition(found.y) : 1;
  const bool regular = condition < 3;
  const double at_fold = Model::info.key == "a" ? 2e-5 : 3e-7;
  // At the fold to the last digit the equation may have no root for this double T: the fold's own area is right then.
  if (std::abs(judge.T / contact.branches().front().T_bottom - 1) < 4e-15) {
    EXPECT_NEAR(state.y, contact.branches().front().y_bottom, at_fold * (state.y + std::abs(judge.P))) << where();
    return;
  }
  const double tolerance = regular ? 4e-15 : std::min(4e-15 + 8e-16 * condition, at_fold);
  EXPECT_TRUE(judge.root_within(state.A, tolerance)) << where() << " condition " << condition;
}

template <class Model>
Tally run_grid() {
  Tally tally;
  std::size_t counter = 0;
  for (const Parameters<Model>& p : cases<Model>())
    for (const double P : kLoads) {
      const LoadedContact<Model> contact(p, P);
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
      const LoadedContact<Model> contact(p, P);
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
        const LoadedContact<Model> contact(p, P);
        const double end = std::min(contact.branches().front().T_bottom, 1e100);
        std::vector<double> T{-1, std::nan(""), HUGE_VAL, 0, 1e-300, end * 1.001, 2e150};
        for (int i = 0; i <= 40; ++i) T.push_back(end * i / 40);
        // falling, repeated, wildly spaced: guesses from earlier points must not show in the answer
        for (int i = 40; i >= 0; i -= 3) T.push_back(end * i / 40);
        for (int i = 1; i < 40; ++i) T.push_back(end * std::pow(2, -40 + i + i % 2));
        for (int i = 0; i < 40; ++i) T.push_back(end * 0.999 * (i * 17 % 41) / 41);
        std::vector<double> areas(T.size(), -1);
        std::size_t ok = 0;
        const std::size_t found = predict_areas<Model>(p, P, T, areas);
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

}  // namespace
}  // namespace mixity
