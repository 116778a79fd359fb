// What a fit under the objective toughness costs, side by side in one run: the fit that is shown (Ceres, verdict,
// profile interval), the same by the kernel, and one bootstrap replicate. Times per fit of the 200 points of
// data/mergel2018.csv.
#include <benchmark/benchmark.h>

#include "fitting/fit.h"
#include "fitting/toughness_objective.h"
#include "solver/interval.h"
#include "solver/resample.h"
#include "solver/solve.h"

namespace mixity {
namespace {

const SolverOptions kWithKernel{.engine = Engine::kernel};

const Dataset& mergel() {
  static const Dataset data = load_dataset(MIXITY_ROOT "/data/mergel2018.csv");
  return data;
}

ToughnessObjective objective(const char* key) {
  std::vector<ToughnessPoint> points;
  for (std::size_t i = 0; i < mergel().points.size(); ++i) points.push_back(*mergel().toughness(i));
  return {points, Scale::log, FreeChoice(ContactModel::find(key).value(), {{0.15}, {}}, {})};
}

void Sweep(benchmark::State& state, const char* key) {
  const auto problem = objective(key);
  const auto cost = problem.cost();
  const double x = 0.0123;
  CostValue value;
  for (auto _ : state) {
    cost->at({&x, 1}, {}, value);
    benchmark::DoNotOptimize(value.value);
  }
}
BENCHMARK_CAPTURE(Sweep, PapangeloCiavarella, "c")->Name("Sweep<PapangeloCiavarella>");
BENCHMARK_CAPTURE(Sweep, WatersGuduru, "b")->Name("Sweep<WatersGuduru>");
BENCHMARK_CAPTURE(Sweep, Johnson, "a")->Name("Sweep<Johnson>");

void ShownFit(benchmark::State& state, const char* key) {
  const FitOptions options{.objective = Objective::toughness};
  for (auto _ : state) benchmark::DoNotOptimize(fit_model(mergel(), key, options));
}
BENCHMARK_CAPTURE(ShownFit, PapangeloCiavarella, "c")->Name("ShownFit<PapangeloCiavarella>");
BENCHMARK_CAPTURE(ShownFit, WatersGuduru, "b")->Name("ShownFit<WatersGuduru>");

void KernelFit(benchmark::State& state, const char* key) {
  const auto problem = objective(key);
  const SolverOptions options = kWithKernel;
  for (auto _ : state) {
    const Verdict verdict = solve(problem, {}, options);
    const double allowance = cost_allowance(0.95, verdict.best.sum_of_squares, problem.residual_count(), 1, false);
    benchmark::DoNotOptimize(
        profile_intervals(problem, verdict.best, 0.95, allowance, verdict.standard_errors, {}, options));
  }
}
BENCHMARK_CAPTURE(KernelFit, PapangeloCiavarella, "c")->Name("KernelFit<PapangeloCiavarella>");
BENCHMARK_CAPTURE(KernelFit, WatersGuduru, "b")->Name("KernelFit<WatersGuduru>");

void Bootstrap(benchmark::State& state, const char* key) {
  const auto problem = objective(key);
  const std::vector<double> fitted = solve(problem, {}, kWithKernel).best.x;
  std::vector<std::size_t> runs;
  for (const Point& point : mergel().points) runs.push_back(point.curve);
  constexpr std::size_t kReplicates = 1000;
  const auto threads = static_cast<unsigned>(state.range(0));
  for (auto _ : state)
    benchmark::DoNotOptimize(bootstrap(problem, fitted, runs, {kReplicates, Resample::points, 1, threads}, 0.95));
  state.counters["time/replicate"] = benchmark::Counter(static_cast<double>(state.iterations() * kReplicates),
                                                        benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK_CAPTURE(Bootstrap, PapangeloCiavarella, "c")
    ->Name("Bootstrap<PapangeloCiavarella>")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime();

}  // namespace
}  // namespace mixity

BENCHMARK_MAIN();
