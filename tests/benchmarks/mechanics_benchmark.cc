// What a prediction costs, side by side in one run: ours, a plain Brent search on the printed equation, and the bare
// cost of one square root and one cube root, which a closed form cannot do without. Times are per point.
#include <benchmark/benchmark.h>

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <random>

#include "mechanics/batch.h"
#include "mechanics/contact_model.h"
#include "mechanics/curve_distance.h"
#include "mechanics/laws/known_laws.h"
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
  const double end = std::min(LoadedContact(Model{}, typical<Model>(), kLoad).branches().front().T_bottom, 100.0);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0, 0.99 * end);
  std::vector<double> T(kPoints);
  for (double& t : T) t = uniform(random);
  std::sort(T.begin(), T.end());
  return T;
}

void per_point(benchmark::State& state, std::size_t points = kPoints) {
  state.counters["time/point"] = benchmark::Counter(static_cast<double>(state.iterations() * points),
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
  const LoadedContact contact(Model{}, typical<Model>(), kLoad);
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
  for (auto _ : state)
    benchmark::DoNotOptimize(predict_areas(LoadedContact(Model{}, typical<Model>(), kLoad), T, areas));
  per_point(state);
}
BENCHMARK_TEMPLATE(PredictBatch, PapangeloCiavarella);
BENCHMARK_TEMPLATE(PredictBatch, Johnson);
BENCHMARK_TEMPLATE(PredictBatch, WatersGuduru);

/// A law as somebody types it, and the published one that it is, by their keys: areas of all points.
void AreasByKey(benchmark::State& state, const char* key, const char* text, double upper) {
  LawError error;
  if (text) define_law({key, text, {{"l", 0, upper, 0.15}}}, error);
  const std::vector<double> T = loads<WatersGuduru>();
  std::vector<double> A(T.size());
  std::vector<EquilibriumStatus> status(T.size());
  const double lambda = 0.15, P = kLoad;
  const Values parameter{&lambda, 0};
  const ContactModel model = ContactModel::find(key).value();
  for (auto _ : state) {
    model.areas({&parameter, 1}, {&P, 0}, {T.data(), 1}, A, status);
    benchmark::DoNotOptimize(A.data());
  }
  per_point(state);
}
BENCHMARK_CAPTURE(AreasByKey, b, "b", nullptr, 2);
BENCHMARK_CAPTURE(AreasByKey, typed_b, "typed_b", "1 + tan((1-l/2)*psi)^2", 2);
BENCHMARK_CAPTURE(AreasByKey, typed_a, "typed_a", "1 + (1-l)*tan(psi)^2", 1);
BENCHMARK_CAPTURE(AreasByKey, typed_c, "typed_c", "1/(1 + (l-1)*sin(psi)^2)", 1);
BENCHMARK_CAPTURE(AreasByKey, criterion_c, "criterion_c", "K_I^2 + l*K_II^2 = 1", 1);

/// Semi-axes of elliptic contacts at 10^5 tangential loads, to compare with the areas of AreasByKey/b.
void EllipseAxes(benchmark::State& state, const char* key) {
  constexpr std::size_t kMany = 100000;
  const ContactModel model = ContactModel::find(key).value();
  const double II = 0.15, III = 0.05;
  const EndParameters ends{{&II, 1}, {&III, 1}, 0.5};
  const double last = model.ellipse_end(ends, kLoad, {Control::Kind::load})->T;
  std::vector<double> T(kMany);
  for (std::size_t i = 0; i < kMany; ++i) T[i] = 0.99 * last * static_cast<double>(i) / kMany;
  for (auto _ : state) benchmark::DoNotOptimize(model.ellipses(ends, kLoad, T));
  per_point(state, kMany);
}
BENCHMARK_CAPTURE(EllipseAxes, c, "c");
BENCHMARK_CAPTURE(EllipseAxes, b, "b");

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
  const double bottom = radius_from_edge_load(LoadedContact(Model{}, p, kLoad).branches().front().y_bottom, kLoad);
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

/// ln f with its slope at angles up to 1.5, point by point and packed: what a step of a fit to (psi, f) data costs.
struct LawPoints {
  static constexpr std::size_t kCount = 512;
  std::vector<Mixity<double>> mixities;
  LawPoints() {
    for (std::size_t i = 0; i < kCount; ++i)
      mixities.push_back(mixity_from_angle(1.5 * static_cast<double>(i) / kCount));
  }
};

template <class Model>
void LogToughness(benchmark::State& state) {
  const LawPoints points;
  for (auto _ : state)
    for (const auto& mixity : points.mixities) benchmark::DoNotOptimize(Model::log_toughness(typical<Model>(), mixity));
  per_point(state, LawPoints::kCount);
}
BENCHMARK_TEMPLATE(LogToughness, PapangeloCiavarella);
BENCHMARK_TEMPLATE(LogToughness, Johnson);
BENCHMARK_TEMPLATE(LogToughness, WatersGuduru);
BENCHMARK_TEMPLATE(LogToughness, BenzeggaghKenane);

template <class Model>
void LogToughnessPacked(benchmark::State& state) {
  const LawPoints points;
  std::vector<double> first, second, value(LawPoints::kCount), slope(value), curvature(value);
  for (const auto& mixity : points.mixities) {
    const auto point = Model::packed_point(mixity);
    first.push_back(point.first);
    second.push_back(point.second);
  }
  for (auto _ : state) {
    packed_log_toughness(Model{}, typical<Model>()[0], first.data(), second.data(), first.size(), value.data(),
                         slope.data(), curvature.data());
    benchmark::ClobberMemory();
  }
  per_point(state, LawPoints::kCount);
}
BENCHMARK_TEMPLATE(LogToughnessPacked, PapangeloCiavarella);
BENCHMARK_TEMPLATE(LogToughnessPacked, Johnson);
BENCHMARK_TEMPLATE(LogToughnessPacked, WatersGuduru);

template <class Model>
void CurvePoints(benchmark::State& state) {
  const EquilibriumCurve curve(Model{}, typical<Model>(), kLoad);
  const auto ranges = drawable_ranges(curve, 100.0);
  for (auto _ : state) benchmark::DoNotOptimize(sample_uniform(curve, ranges, kPoints));
  per_point(state);
}
BENCHMARK_TEMPLATE(CurvePoints, PapangeloCiavarella);
BENCHMARK_TEMPLATE(CurvePoints, Johnson);
BENCHMARK_TEMPLATE(CurvePoints, WatersGuduru);

template <class Model>
void Folds(benchmark::State& state) {
  const EquilibriumCurve curve(Model{}, typical<Model>(), kLoad);
  for (auto _ : state) benchmark::DoNotOptimize(find_folds(curve, {Control::Kind::stiffness, 1.0}));
}
BENCHMARK_TEMPLATE(Folds, PapangeloCiavarella);
BENCHMARK_TEMPLATE(Folds, Johnson);
BENCHMARK_TEMPLATE(Folds, WatersGuduru);

/// Measured points of eight loads, each with a load of its own, up to 0.95 of the jump, with errors of 1 %.
template <class Model>
struct MeasuredPoints {
  std::vector<double> P, T, A, sigma_T, sigma_A;

  MeasuredPoints() {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(0, 0.95);
    std::normal_distribution<double> normal;
    constexpr double kLoads[] = {30.4, 15.0, 11.5, 6.2, 3.7, 2.0, -0.23, -1.79};
    for (std::size_t i = 0; i < kPoints; ++i) {
      const double load = kLoads[i % 8] * (1 + 0.01 * normal(random));
      const LoadedContact contact(Model{}, typical<Model>(), load);
      const double end = std::min(contact.first_branch().T_bottom, 100.0), t = uniform(random) * end;
      P.push_back(load);
      sigma_T.push_back(0.01 * end);
      sigma_A.push_back(0.01 * area_from_radius(jkr_radius(load)));
      T.push_back(std::abs(t + sigma_T.back() * normal(random)));
      A.push_back(area_from_radius(radius_from_edge_load(contact.at(t).y, load)) + sigma_A.back() * normal(random));
    }
  }
  PlanePoints points() const { return {P, T, A, sigma_T, sigma_A}; }
};

/// Distances and all their derivatives.
template <class Model, Search search>
void Distances(benchmark::State& state) {
  const MeasuredPoints<Model> measured;
  std::vector<double> r(kPoints), dP(kPoints), dT(kPoints), dA(kPoints), parameters(kPoints * parameter_count<Model>);
  CurveDistances out{r, dP, dT, dA, parameters};
  for (auto _ : state)
    benchmark::DoNotOptimize(curve_distances(Model{}, typical<Model>(), measured.points(), search, true, out));
  per_point(state);
}
BENCHMARK_TEMPLATE(Distances, PapangeloCiavarella, Search::local);
BENCHMARK_TEMPLATE(Distances, PapangeloCiavarella, Search::global);
BENCHMARK_TEMPLATE(Distances, Johnson, Search::local);
BENCHMARK_TEMPLATE(Distances, Johnson, Search::global);
BENCHMARK_TEMPLATE(Distances, WatersGuduru, Search::local);
BENCHMARK_TEMPLATE(Distances, WatersGuduru, Search::global);
BENCHMARK_TEMPLATE(Distances, BenzeggaghKenane, Search::local);
BENCHMARK_TEMPLATE(Distances, BenzeggaghKenane, Search::global);

/// What LoadedContact pays once for each load that comes near a fold.
template <class Model>
void LoadFolds(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(LoadedContact(Model{}, typical<Model>(), kLoad).branches().size());
}
BENCHMARK_TEMPLATE(LoadFolds, PapangeloCiavarella);
BENCHMARK_TEMPLATE(LoadFolds, Johnson);
BENCHMARK_TEMPLATE(LoadFolds, WatersGuduru);
BENCHMARK_TEMPLATE(LoadFolds, BenzeggaghKenane);

}  // namespace
}  // namespace mixity

BENCHMARK_MAIN();
