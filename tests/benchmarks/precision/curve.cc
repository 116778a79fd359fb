// Fitting lambda to points (T, A) under the objective `curve`, orthogonal distances in standard errors: time against
// error, mixity's solvers beside Ceres with a place on the curve for each point, and beside the printed equation
// linearised in the errors. Some 100 points at eight loads. The truth is lambda of the least squares in 50 digits.
//
// With --turns solvers of another process take part (turns.h); tools/peers/curve_rows.py is such a process.
#include "mechanics/curve.h"

#include <glog/logging.h>

#include <memory>
#include <random>

#include "benchmarks/curve/noisy_runs.h"
#include "benchmarks/precision/counted.h"
#include "benchmarks/precision/curve_peers.h"
#include "benchmarks/precision/explicit_curve.h"
#include "benchmarks/precision/precision.h"
#include "benchmarks/precision/turns.h"
#include "fitting/fit.h"
#include "fitting/models.h"
#include "fitting/prepare.h"
#include "solver/kernel.h"

namespace mixity::precision {
namespace {

constexpr double kError = 0.02;  // standard errors of T and A, of the true values

/// Up to 0.95 of the jump, as noisy_runs.h has it, or both sides of it: phi within 0.1 of the fold's, pi/2 in model c.
enum class Place { runs, fold };

template <class Model>
Dataset runs(double lambda, double noise) {
  Dataset data = noisy_runs(std::string(Model::info.key), {lambda}, {.points = 100, .noise = noise});
  if (noise == 0) {
    data.errors.clear();  // what was measured is exact, and its standard errors are stated all the same
    for (const Point& point : data.points) data.errors.push_back({kError * point.T, kError * point.A, 0});
  }
  return data;
}

Dataset at_the_fold(double lambda, double noise) {
  constexpr std::size_t kPoints = 13;  // of each load
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  Dataset data;
  data.path = data.name = "synthetic";
  data.has_loads = true;
  for (const double P : kMergelLoads) {
    const EquilibriumCurve curve(PapangeloCiavarella{}, {lambda}, P);
    data.curves.push_back(std::to_string(data.curves.size() + 1));
    data.curve_loads.push_back(P);
    for (std::size_t i = 0; i < kPoints; ++i) {
      const CurvePoint true_place =
          curve.point(0.5 * pi<double>() + 0.1 * (2 * static_cast<double>(i) / (kPoints - 1) - 1));
      const PointErrors errors{kError * true_place.T, kError * true_place.A, 0};
      const double T = true_place.T * (1 + noise * normal(random)), A = true_place.A * (1 + noise * normal(random));
      data.points.push_back({data.points.size() + 2, data.curves.size() - 1, P, T, A});
      data.errors.push_back(errors);
    }
  }
  data.rows = data.points.size();
  return data;
}

template <class Model>
struct Case {
  std::string name;
  Dataset data;
  std::vector<PlanePoint> points;
  std::unique_ptr<ModelProblem> objective;
  double start;  // half of what the points were made of, a good one: all descents are given it
  Exact truth;

  Case(double lambda, double noise, Place place = Place::runs) : start(0.5 * lambda) {
    char text[80];
    std::snprintf(text, sizeof text, "%s, lambda %g, %s%s", std::string(Model::info.key).c_str(), lambda,
                  place == Place::fold ? "at the fold, " : "", noise > 0 ? "2 % noise" : "clean");
    name = text;
    if constexpr (std::is_same_v<Model, PapangeloCiavarella>)
      data = place == Place::fold ? at_the_fold(lambda, noise) : runs<Model>(lambda, noise);
    else
      data = runs<Model>(lambda, noise);
    for (std::size_t i = 0; i < data.points.size(); ++i) {
      const Point& point = data.points[i];
      points.push_back({point.P, point.T, point.A, data.errors[i].T, data.errors[i].A});
    }
    const ContactModel model = model_named(std::string(Model::info.key));
    objective = make_problem(data, options(), prepare(data, model, options(), Objective::curve, nullptr));
    truth = exact_curve_fit<Model>(points);
  }

  static FitOptions options() { return {.objective = Objective::curve}; }
  double error(double x) const {
    return std::isfinite(x) ? static_cast<double>(abs(Exact(x) - truth) / truth)
                            : std::numeric_limits<double>::infinity();
  }
};

SolverOptions kernel_at(double tolerance) {
  SolverOptions options;
  options.kernel_stationary = options.stationary = tolerance;
  return options;
}

/// The descents start where all others do; the whole fit takes no start.
template <class Model>
void add_rows(const Case<Model>& at, std::vector<Row>& rows) {
  const auto add = [&](const char* method, double tolerance, const Answer& answer, std::function<void()> run) {
    rows.push_back(
        {"curve", at.name, method, tolerance, at.error(answer.x), answer.sweeps, answer.claim, std::move(run)});
  };
  const auto answer_of = [](const std::optional<Minimum>& minimum, double sweeps) {
    if (!minimum) return Answer{std::nan(""), false, "failed", sweeps};
    const bool at_bound = minimum->x[0] <= Model::parameters[0].lower || minimum->x[0] >= Model::parameters[0].upper;
    return Answer{minimum->x[0], minimum->stationary,
                  at_bound              ? "at_bound"
                  : minimum->stationary ? "converged"
                                        : "no convergence",
                  sweeps};
  };
  const FitResult whole = fit_model(at.data, Model::info.key, at.options());
  const double value = whole.has_values() ? *whole.parameters[0].value : std::nan("");
  add("mixity whole fit", 0, {value, true, std::string(to_string(whole.status))},
      [&at] { fit_model(at.data, Model::info.key, at.options()); });
  const CountedProblem counted(*at.objective);
  for (int digits = 2; digits <= 15; ++digits) {
    const double tolerance = std::pow(10.0, -digits);
    const auto descend = [start = at.start, tolerance](const Problem& problem) {
      return Kernel(problem, kernel_at(tolerance)).descend({{start}});
    };
    counted.sweeps = 0;
    const auto minimum = descend(counted);
    add("mixity kernel", tolerance, answer_of(minimum, static_cast<double>(counted.sweeps)),
        [&at, descend] { descend(*at.objective); });
  }
  struct Peer {
    const char* name;
    Answer (*solve)(const std::vector<PlanePoint>& points, double start, double tolerance);
  };
  for (const auto& [method, solve] :
       {Peer{"Ceres places", with_ceres_places<Model>}, Peer{"linearised", linearised_gauss_newton<Model>}})
    for (int digits = 2; digits <= 15; ++digits) {
      const double tolerance = std::pow(10.0, -digits);
      const auto run = [&at, tolerance, solve = solve] { return solve(at.points, at.start, tolerance); };
      add(method, tolerance, run(), [run] { run(); });
    }
}

/// All that a solver of another process needs to know.
template <class Model>
void print_case(const Case<Model>& at) {
  constexpr ParameterInfo lambda = Model::parameters[0];
  std::printf(R"({"case": "%s", "model": "%s", "lower": %.17g, "upper": %.17g, "start": %.17g, "truth": "%s")",
              at.name.c_str(), std::string(Model::info.key).c_str(), lambda.lower, lambda.upper, at.start,
              at.truth.str(40).c_str());
  print_array("P", at.points, [](const PlanePoint& point) { return point.P; });
  print_array("T", at.points, [](const PlanePoint& point) { return point.T; });
  print_array("A", at.points, [](const PlanePoint& point) { return point.A; });
  print_array("sigma_T", at.points, [](const PlanePoint& point) { return point.sigma_T; });
  print_array("sigma_A", at.points, [](const PlanePoint& point) { return point.sigma_A; });
  std::printf("}\n");
}

template <class Model>
std::vector<std::unique_ptr<Case<Model>>> cases(const std::vector<double>& lambdas) {
  std::vector<std::unique_ptr<Case<Model>>> list;
  for (const double lambda : lambdas)
    for (const double noise : {0.0, kError}) list.push_back(std::make_unique<Case<Model>>(lambda, noise));
  return list;
}

}  // namespace
}  // namespace mixity::precision

int main(int count, char** arguments) try {
  using namespace mixity;
  using namespace mixity::precision;
  FLAGS_minloglevel = google::GLOG_FATAL;  // of Ceres: what fails is counted
  const TurnArguments wanted(count, arguments);
  if (!wanted.known) return 2;
  const auto a = cases<Johnson>({0.5, 0.97});
  const auto b = cases<WatersGuduru>({0.0023, 0.6, 1.9});
  auto c = cases<PapangeloCiavarella>({0.0023, 0.5, 0.97});
  for (const double noise : {0.0, kError})
    c.push_back(std::make_unique<Case<PapangeloCiavarella>>(0.15, noise, Place::fold));
  std::vector<Row> rows;
  const auto add = [&](const auto& cases) {
    for (const auto& at : cases) {
      if (wanted.turns) print_case(*at);
      add_rows(*at, rows);
    }
  };
  add(a);
  add(b);
  add(c);
  measure(rows, kRepetitions, wanted.turn());
  print(rows);
} catch (const std::exception& error) {
  std::fprintf(stderr, "precision_curve: %s\n", error.what());
  return 1;
}
