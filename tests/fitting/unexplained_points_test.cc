// Points that no model describes: their fit takes not many more evaluations than that of points that one describes.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <random>

#include "fitting/fit.h"
#include "fitting/synthetic_runs.h"
#include "mechanics/laws/known_laws.h"

namespace mixity {
namespace unexplained_points_test {

constexpr std::size_t kPoints = 60;  // of a run
const std::vector<double> kLoads{2, 4, 12, 40, 120};

std::atomic<int> asked = 0;

/// Model c as a function that counts how often it is asked: once for each set of parameters that is not among the last.
void define_counted() {
  if (find_law("counted_c")) return;
  const auto sampler = std::make_shared<const LawSampler>(
      [](std::span<const double> psi, std::span<const double> p, std::span<double> f) {
        ++asked;
        for (std::size_t i = 0; i < psi.size(); ++i) f[i] = 1 / (1 + (p[0] - 1) * std::pow(std::sin(psi[i]), 2));
      });
  LawError error;
  ASSERT_TRUE(define_law({"counted_c", "law(psi)", {{"l", 0, 1, 0.15}}, "", false, sampler}, error)) << error.message;
}

/// A = A0 course(T/T_last), with noise of 0.2 % and T_last = 3 P.
Dataset runs_of(const std::function<double(double)>& course) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, 0.002);
  Dataset data = empty_runs();
  for (const double P : kLoads) {
    const std::size_t curve = data.curves.size();
    data.curves.push_back("run " + std::to_string(curve + 1));
    data.curve_loads.push_back(P);
    const double A0 = area_from_radius(jkr_radius(P));
    for (std::size_t i = 0; i < kPoints; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(kPoints - 1);
      data.points.push_back(
          {data.points.size() + 2, curve, P, 3 * P * share, A0 * course(share) * (1 + noise(random))});
    }
  }
  data.rows = data.points.size();
  return data;
}

int evaluations(const Dataset& data) {
  asked = 0;
  fit_model(data, "counted_c");
  return asked;
}

/// The bound: 1.0 to 6.4 times as many, as the fit also looks for a cause. With rounds of errors that go on although
/// they leap to and fro, and are repeated where they cannot end elsewhere, it is up to 16 times.
TEST(UnexplainedPoints, TakeAFewTimesTheEvaluationsOfPointsThatTheModelDescribes) {
  constexpr int kMost = 10;  // the step takes 8.5 times as many; 22 where errors leap to the last round
  define_counted();
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, 0.002);
  const int described = evaluations(synthetic_runs("c", {0.15}, kLoads, kPoints, 0.9, [&] { return noise(random); }));
  std::uniform_real_distribution<double> any(0.3, 1.7);
  const std::pair<const char*, std::function<double(double)>> courses[] = {
      {"parabola", [](double t) { return 1 - 0.15 * t * t; }},
      {"linear", [](double t) { return 1 - 0.5 * t; }},
      {"step", [](double t) { return t > 0.5 ? 0.7 : 1.0; }},
      {"rising", [](double t) { return 1 + 0.15 * t * t; }},
      {"constant", [](double) { return 1.0; }},
      {"random", [&](double) { return any(random); }}};
  for (const auto& [name, course] : courses) EXPECT_LT(evaluations(runs_of(course)), kMost * described) << name;
}

}  // namespace unexplained_points_test
}  // namespace mixity
