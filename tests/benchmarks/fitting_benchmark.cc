// What a fit costs, side by side in one run: the fit that is shown (Ceres, verdict, profile interval), the same through
// the batch engine, and one bootstrap replicate. Times per fit of the 200 points of data/mergel2018.csv.
#include <benchmark/benchmark.h>

#include "fitting/fit.h"
#include "fitting/single_fit.h"

namespace mixity {
namespace {

const Dataset& mergel() {
  static const Dataset data = load_dataset(MIXITY_ROOT "/data/mergel2018.csv");
  return data;
}

template <class Model>
ToughnessObjective<Model> objective() {
  std::vector<ToughnessPoint> points;
  for (std::size_t i = 0; i < mergel().points.size(); ++i) points.push_back(*mergel().toughness(i));
  return {std::move(points), Scale::log, FreeChoice<Model>({{0.15}, {}}, {})};
}

template <class Model>
void Sweep(benchmark::State& state) {
  const auto problem = objective<Model>();
  const auto cost = problem.single_cost();
  for (auto _ : state) benchmark::DoNotOptimize(cost->at(0.0123, {}));
}
BENCHMARK_TEMPLATE(Sweep, PapangeloCiavarella);
BENCHMARK_TEMPLATE(Sweep, WatersGuduru);
BENCHMARK_TEMPLATE(Sweep, Johnson);

template <class Model>
void ShownFit(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(fit_model(mergel(), Model::info.key));
}
BENCHMARK_TEMPLATE(ShownFit, PapangeloCiavarella);
BENCHMARK_TEMPLATE(ShownFit, WatersGuduru);

template <class Model>
void BatchFit(benchmark::State& state) {
  const auto problem = objective<Model>();
  const FreeParameter& parameter = problem.parameters()[0];
  for (auto _ : state) {
    const auto cost = problem.single_cost();
    const SingleFit fit = solve_single(*cost, problem);
    const double allowance = cost_allowance(0.95, fit.sum_of_squares, problem.residual_count(), 1, false);
    benchmark::DoNotOptimize(profile_interval(*cost, parameter, fit.x, fit.sum_of_squares, 0.95, allowance));
  }
}
BENCHMARK_TEMPLATE(BatchFit, PapangeloCiavarella);
BENCHMARK_TEMPLATE(BatchFit, WatersGuduru);

template <class Model>
void Bootstrap(benchmark::State& state) {
  const auto problem = objective<Model>();
  const SingleFit fit = solve_single(*problem.single_cost(), problem);
  std::vector<std::size_t> runs;
  for (const Point& point : mergel().points) runs.push_back(point.curve);
  constexpr std::size_t kReplicates = 1000;
  const auto threads = static_cast<unsigned>(state.range(0));
  for (auto _ : state)
    benchmark::DoNotOptimize(bootstrap(problem, {fit.x}, runs, {kReplicates, Resample::points, 1, threads}, 0.95));
  state.counters["time/replicate"] = benchmark::Counter(static_cast<double>(state.iterations() * kReplicates),
                                                        benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK_TEMPLATE(Bootstrap, PapangeloCiavarella)->Arg(1)->Arg(2)->UseRealTime();

}  // namespace
}  // namespace mixity

BENCHMARK_MAIN();
