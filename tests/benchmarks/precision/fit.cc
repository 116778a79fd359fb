// Fitting lambda to points (psi, f): time against error, this program's solvers beside other libraries'. An evaluation
// is a sweep over the points, with or without derivatives. 200 points, psi evenly up to 1.54.
// With --turns solvers of another process take part (turns.h); tools/peers/fit_rows.py is such a process.
#include "fitting/fit.h"

#include <memory>
#include <random>

#include "benchmarks/precision/counted.h"
#include "benchmarks/precision/log_toughness.h"
#include "benchmarks/precision/peers.h"
#include "benchmarks/precision/precision.h"
#include "benchmarks/precision/turns.h"
#include "fitting/synthetic_runs.h"
#include "solver/interval.h"
#include "solver/solve.h"

namespace mixity::precision {
namespace {

const SolverOptions kWithKernel{.engine = Engine::kernel};

constexpr std::size_t kPoints = 200;
constexpr double kConfidence = 0.95;

/// One set of points in every form that a solver takes, and the true lambda.
template <class Model>
struct Case {
  std::string name;
  std::vector<ToughnessPoint> points;
  Dataset data;
  std::unique_ptr<ToughnessObjective> objective;
  std::unique_ptr<LogToughness<Model>> problem;
  Exact truth;

  Case(double lambda, double relative_noise) {
    SeededNoise noise(1, relative_noise);
    data.path = data.name = "synthetic";
    data.curves = {""};
    for (std::size_t i = 0; i < kPoints; ++i) {
      const auto mixity = mixity_from_angle(1.54 * (static_cast<double>(i) + 0.5) / kPoints);
      data.points.push_back({i + 2, 0, 0, 0, 0});
      points.push_back({mixity, std::exp(Model::log_toughness({lambda}, mixity).value) * (1 + noise())});
    }
    data.converted = points;
    data.rows = kPoints;
    char text[80];
    std::snprintf(text, sizeof text, "%s, lambda %g, %s", std::string(Model::info.key).c_str(), lambda,
                  relative_noise > 0 ? "2 % noise" : "clean");
    name = text;
    const ContactModel model = model_named(std::string(Model::info.key));
    objective = std::make_unique<ToughnessObjective>(points, Scale::log,
                                                     FreeChoice(model, {{Model::parameters[0].typical}, {}}, {}));
    problem = std::make_unique<LogToughness<Model>>(points);
    truth = exact_minimum<Model>(points);
  }

  /// Relative to the truth, or where that is the bound 0, to lambda's range.
  double error(double x) const {
    if (!std::isfinite(x)) return std::numeric_limits<double>::infinity();
    const Exact scale = truth > 0 ? truth : Exact(problem->upper);
    return static_cast<double>(abs(Exact(x) - truth) / scale);
  }

  /// What an answer says of itself: its reader knows lambda's range, not all solvers do.
  std::string claim(const Answer& answer) const {
    return answer.x < problem->lower || answer.x > problem->upper ? "out of range" : answer.claim;
  }
};

/// The whole fit in parts, so that sweeps can be counted: minimum, verdict and the interval's ends.
double sweeps_of_whole_fit(const Problem& objective) {
  const CountedProblem problem(objective);
  const Verdict verdict = solve(problem);
  if (!verdict.best.x.empty()) {
    const double least = verdict.best.sum_of_squares;
    profile_intervals(problem, verdict.best, kConfidence, cost_allowance(kConfidence, least, kPoints, 1, false),
                      verdict.standard_errors);
  }
  return static_cast<double>(problem.sweeps);
}

template <class Model>
void add_rows(const Case<Model>& at, std::vector<Row>& rows) {
  const CountedProblem counted(*at.objective);
  const Verdict verdict = solve(counted, {}, kWithKernel);
  rows.push_back({"fit", at.name, "mixity kernel", 0,
                  at.error(verdict.best.x.empty() ? std::nan("") : verdict.best.x[0]),
                  static_cast<double>(counted.sweeps), std::string(to_string(verdict.status)),
                  [&at] { solve(*at.objective, {}, kWithKernel); }});
  const FitResult whole = fit_model(at.data, Model::info.key);
  const double value = whole.has_values() ? *whole.parameters[0].value : std::nan("");
  rows.push_back({"fit", at.name, "mixity whole fit", 0, at.error(value), sweeps_of_whole_fit(*at.objective),
                  std::string(to_string(whole.status)), [&at] { fit_model(at.data, Model::info.key); }});
  for (const auto& peer : peers<LogToughness<Model>>())
    for (int digits = 2; digits <= 15; ++digits) {
      const double tolerance = std::pow(10.0, -digits);
      const auto run = [&at, solve = peer.solve, tolerance] {
        return solve(*at.problem, Model::parameters[0].typical, Tolerances::all(tolerance));
      };
      const Answer answer = run();
      rows.push_back({"fit", at.name, peer.name, tolerance, at.error(answer.x), answer.sweeps, at.claim(answer),
                      [run] { run(); }});
    }
}

/// The same shares of the range for all models.
template <class Model>
std::vector<std::unique_ptr<Case<Model>>> cases() {
  std::vector<std::unique_ptr<Case<Model>>> list;
  for (const double share : {0.0023, 0.3, 0.97})
    for (const double noise : {0.0, 0.02})
      list.push_back(std::make_unique<Case<Model>>(share * Model::parameters[0].upper, noise));
  return list;
}

/// All that a solver of another process needs to know.
template <class Model>
void print_case(const Case<Model>& at) {
  constexpr ParameterInfo lambda = Model::parameters[0];
  std::printf(R"({"case": "%s", "model": "%s", "lower": %.17g, "upper": %.17g, "start": %.17g, "truth": "%s")",
              at.name.c_str(), std::string(Model::info.key).c_str(), lambda.lower, lambda.upper, lambda.typical,
              at.truth.str(40).c_str());
  print_array("psi", at.points, [](const ToughnessPoint& point) { return point.psi(); });
  print_array("f", at.points, [](const ToughnessPoint& point) { return point.ratio; });
  std::printf("}\n");
}

}  // namespace
}  // namespace mixity::precision

int main(int count, char** arguments) {
  using namespace mixity::precision;
  const TurnArguments wanted(count, arguments);
  if (!wanted.known) return 2;
  std::vector<Row> rows;
  const auto add = [&](const auto& cases) {
    for (const auto& at : cases) {
      if (wanted.turns) print_case(*at);
      add_rows(*at, rows);
    }
  };
  const auto a = cases<mixity::Johnson>();
  const auto b = cases<mixity::WatersGuduru>();
  const auto c = cases<mixity::PapangeloCiavarella>();
  add(a);
  add(b);
  add(c);
  measure(rows, kRepetitions, wanted.turn());
  print(rows);
}
