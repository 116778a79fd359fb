// What a prediction costs, side by side in one run: ours, a plain Brent search on the printed equation, and the bare
// cost of one square root and one cube root, which a closed form cannot do without. Times are per point.
#include <benchmark/benchmark.h>

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <random>

#include "mechanics/batch.h"
#include "mechanics/sampling.h"

namespace mixity {
namespace {

constexpr double kLoad = 3;
constexpr std::size_t kPoints = 1024;

template <class Model>
Parameters<Model> typical() {
  Parameters<Model> p{};
  for (std::size_t i = 0; i < p.size(); ++i) p[i] = Model::parameters[i].typical;
  return p;
}

/// Loads spread at random over the stable branch, seeded, rising as in an experiment.
template <class Model>
std::vector<double> loads() {
  const double end = std::min(LoadedContact<Model>(typical<Model>(), kLoad).branches().front().T_bottom, 100.0);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0, 0.99 * end);
  std::vector<double> T(kPoints);
  for (double& t : T) t = uniform(random);
  std::sort(T.begin(), T.end());
  return T;
}

void per_point(benchmark::State& state) {
  state.counters["time/point"] = benchmark::Counter(static_cast<double>(state.iterations() * kPoints),
                                                    benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void SquareRootAndCubeRoot(benchmark::State& state) {
  const std::vector<double> T = loads<PapangeloCiavarella>();
  for (auto _ : state)
    for (const double t : T) benchmark::DoNotOptimize(std::cbrt(std::sqrt(t) + 1));
  per_point(state);
}
BENCHMARK(SquareRootAndCubeRoot);

template <class Model>
void Predict(benchmark::State& state) {
  const LoadedContact<Model> contact(typical<Model>(), kLoad);
  const std::vector<double> T = loads<Model>();
  for (auto _ : state)
    for (const double t : T) benchmark::DoNotOptimize(area_from_radius(radius_from_edge_load(contact.at(t).y, kLoad)));
  per_point(state);
}
BENCHMARK_TEMPLATE(Predict, PapangeloCiavarella);
BENCHMARK_TEMPLATE(Predict, Johnson);
BENCHMARK_TEMPLATE(Predict, WatersGuduru);
BENCHMARK_TEMPLATE(Predict, BenzeggaghKenane);

template <class Model>
void PredictBatch(benchmark::State& state) {
  const std::vector<double> T = loads<Model>();
  std::vector<double> areas(T.size());
  for (auto _ : state) benchmark::DoNotOptimize(predict_areas<Model>(typical<Model>(), kLoad, T, areas));
  per_point(state);
}
BENCHMARK_TEMPLATE(PredictBatch, PapangeloCiavarella);
BENCHMARK_TEMPLATE(PredictBatch, Johnson);
BENCHMARK_TEMPLATE(PredictBatch, WatersGuduru);

/// What one would write without the circle: a in y^2 + T^2 = 8 pi a^3 f(psi) by a bracketing search to the last digits,
/// between the fold of this branch and JKR.
template <class Model>
void BrentOnPrintedEquation(benchmark::State& state) {
  const Parameters<Model> p = typical<Model>();
  const double lambda = p[0], pi_ = pi<double>();
  const auto f = [&](double y, double T) {
    const double psi = std::atan2(T, y);
    if (Model::info.key == "a") return 1 + (1 - lambda) * std::pow(std::tan(psi), 2);
    if (Model::info.key == "b") return 1 + std::pow(std::tan((1 - lambda / 2) * psi), 2);
    return 1 / (1 + (lambda - 1) * std::pow(std::sin(psi), 2));
  };
  const double top = jkr_radius(kLoad) * (1 + 1e-9);
  const double bottom = radius_from_edge_load(LoadedContact<Model>(p, kLoad).branches().front().y_bottom, kLoad);
  const std::vector<double> T = loads<Model>();
  for (auto _ : state)
    for (const double t : T) {
      const auto residual = [&](double a) {
        const double y = 4.0 / 3 * a * a * a - kLoad;
        return y * y + t * t - 8 * pi_ * a * a * a * f(y, t);
      };
      std::uintmax_t evaluations = 100;
      const auto a = boost::math::tools::toms748_solve(residual, bottom, top,
                                                       boost::math::tools::eps_tolerance<double>(50), evaluations);
      benchmark::DoNotOptimize(area_from_radius(a.first));
    }
  per_point(state);
}
BENCHMARK_TEMPLATE(BrentOnPrintedEquation, PapangeloCiavarella);
BENCHMARK_TEMPLATE(BrentOnPrintedEquation, Johnson);
BENCHMARK_TEMPLATE(BrentOnPrintedEquation, WatersGuduru);

template <class Model>
void CurvePoints(benchmark::State& state) {
  const EquilibriumCurve<Model> curve(typical<Model>(), kLoad);
  const auto ranges = drawable_ranges(curve, 100.0);
  for (auto _ : state) benchmark::DoNotOptimize(sample_uniform(curve, ranges, kPoints));
  per_point(state);
}
BENCHMARK_TEMPLATE(CurvePoints, PapangeloCiavarella);
BENCHMARK_TEMPLATE(CurvePoints, Johnson);
BENCHMARK_TEMPLATE(CurvePoints, WatersGuduru);

template <class Model>
void Folds(benchmark::State& state) {
  const EquilibriumCurve<Model> curve(typical<Model>(), kLoad);
  for (auto _ : state) benchmark::DoNotOptimize(find_folds(curve, {Control::Kind::stiffness, 1.0}));
}
BENCHMARK_TEMPLATE(Folds, PapangeloCiavarella);
BENCHMARK_TEMPLATE(Folds, Johnson);
BENCHMARK_TEMPLATE(Folds, WatersGuduru);

}  // namespace
}  // namespace mixity

BENCHMARK_MAIN();
