// How often a solver is wrong and says that it converged, from eleven starts: distances from the curves in seven units,
// and the paper's cost. Each solver is run with the tolerances it comes with, and with 1e-15 everywhere. Right: within
// 1e-6 of the global minimum, or within 1e-3 standard errors. A value out of lambda's range tells its reader that it is
// wrong. With --serve solvers of another process take part (convergence_server.h).
#include <glog/logging.h>

#include "benchmarks/precision/convergence_server.h"
#include "benchmarks/precision/curve_problem.h"
#include "benchmarks/precision/log_toughness.h"
#include "benchmarks/precision/peers.h"
#include "fitting/fit.h"
#include "fitting/unit_cases.h"

namespace mixity::precision {
namespace {

constexpr std::array<double, 11> kStarts{0.001, 0.01, 0.05, 0.1,  0.2,  0.35,
                                         0.5,   0.65, 0.8,  0.95, 0.999};  // of the range

/// Of one data set, in every unit: distances as an experimenter has them who multiplies by the area's standard error.
template <class Model>
std::vector<CurveProblem<Model>> problems(const UnitCase& at, const Dataset& data, double sigma_T, double sigma_A) {
  std::vector<CurveProblem<Model>> list;
  list.reserve(kAreaUnits.size());
  for (const AreaUnit& unit : kAreaUnits) list.emplace_back(data, sigma_T, sigma_A, at.sigma_A / unit.square_metres);
  return list;
}

template <class Problem>
void run_peers(const UnitCase& at, const std::vector<Problem>& units, const BestValue& best, ConvergenceTable& table) {
  for (const auto& peer : peers<Problem>())
    for (const bool tight : {false, true})
      for (std::size_t k = 0; k < units.size(); ++k) {
        const Problem& problem = units[k];
        for (const double start : kStarts) {
          const Tolerances tolerances = tight ? Tolerances{1e-15, 1e-15, 1e-15, 0} : peer.usual;
          const Answer answer = peer.solve(problem, start * problem.upper, tolerances);
          const bool inside = answer.x >= problem.lower && answer.x <= problem.upper;
          table.count(peer.name + (tight ? ", 1e-15" : ""), at.name, k, is_right(answer.x, best),
                      answer.converged && inside);
        }
      }
}

struct Tables {
  ConvergenceTable curve{"Distances from the curves, in seven units", true};
  ConvergenceTable toughness{"ln f, which has no unit", false};
};

/// As a user has it: a file in these units, and a status. It takes no start.
template <class Model>
void run_ours(const UnitCase& at, const BestValue& of_curve, const BestValue& of_toughness, Tables& tables) {
  for (std::size_t k = 0; k < kAreaUnits.size(); ++k) {
    const AreaUnit& unit = kAreaUnits[k];
    const Dataset data = at.in(unit);
    const auto count = [&](const char* name, const FitOptions& options, const BestValue& best,
                           ConvergenceTable& table) {
      const FitResult fit = fit_model(data, Model::info.key, options);
      const double x = fit.has_values() ? fit.parameters[0].value.value_or(std::nan("")) : std::nan("");
      const bool right = is_right(x, best);
      table.count(name, at.name, k, right, fit.status == FitStatus::ok);
      if (!right || fit.status != FitStatus::ok)
        std::fprintf(stderr, "%s, %s in %s: %s, lambda %.10g, best %.10g +/- %.2g. %s\n", name, at.name.c_str(),
                     unit.name, std::string(to_string(fit.status)).c_str(), x, best.x, best.standard_error,
                     fit.message.text().c_str());
    };
    const FitOptions curve{.objective = Objective::curve,
                           .sigma_T = parse_quantity(at.sigma_T_text()),
                           .sigma_A = parse_quantity(at.sigma_A_in(unit))};
    count("mixity", curve, of_curve, tables.curve);
    count("mixity, without interval", value_only(curve), of_curve, tables.curve);
    count("mixity", {.objective = Objective::toughness}, of_toughness, tables.toughness);
  }
}

template <class Model>
void run(const UnitCase& at, Tables& tables, ConvergenceServer& server) {
  constexpr ParameterInfo lambda = Model::parameters[0];
  const Dataset data = at.in({"m^2", 1});
  const double sigma_T = at.sigma_T / data.contact->force_unit(), sigma_A = at.sigma_A / data.contact->area_unit();
  const BestValue of_curve = best_value(curve_residuals(model_named(at.model), data, sigma_T, sigma_A), lambda.lower,
                                        lambda.upper, 4000, true);
  // a point whose area does not exceed that of Hertz has no toughness, and the fit passes it over
  std::vector<ToughnessPoint> points;
  for (std::size_t i = 0; i < data.points.size(); ++i)
    if (const auto point = data.toughness(i)) points.push_back(*point);
  const FitResult fit = fit_model(data, Model::info.key, {.objective = Objective::toughness});
  const BestValue of_toughness{static_cast<double>(exact_minimum<Model>(points)), fit.parameters[0].stderr_.value_or(0),
                               1};
  std::fprintf(stderr, "%s: best %.10g +/- %.2g, %d minima; of ln f %.10g\n", at.name.c_str(), of_curve.x,
               of_curve.standard_error, of_curve.minima, of_toughness.x);
  run_ours<Model>(at, of_curve, of_toughness, tables);
  const auto in_units = problems<Model>(at, data, sigma_T, sigma_A);
  run_peers(at, in_units, of_curve, tables.curve);
  server.add(at.name, of_curve, in_units, tables.curve);
  const std::vector<LogToughness<Model>> of_ln_f{LogToughness<Model>(points)};
  run_peers(at, of_ln_f, of_toughness, tables.toughness);
  server.add(at.name, of_toughness, of_ln_f, tables.toughness);
}

}  // namespace
}  // namespace mixity::precision

int main(int count, char** arguments) try {
  using namespace mixity;
  FLAGS_minloglevel = google::GLOG_FATAL;  // of Ceres: what fails is counted
  const bool serves = count == 2 && arguments[1] == std::string("--serve");
  if (count > 1 && !serves) {
    std::fprintf(stderr, "usage: precision_convergence [--serve]\n");
    return 2;
  }
  precision::Tables tables;
  precision::ConvergenceServer server;
  const std::vector<UnitCase> cases = unit_cases(MIXITY_ROOT "/data/mergel2018.csv");
  for (const UnitCase& at : cases)
    for_each_model([&](auto model) {
      if constexpr (parameter_count<decltype(model)> == 1)
        if (decltype(model)::info.key == at.model) precision::run<decltype(model)>(at, tables, server);
    });
  if (serves && !server.serve(precision::kStarts)) return 1;
  tables.curve.print();
  tables.toughness.print();
  std::printf("\n%zu data sets x %zu units x %zu starts (ln f of others: one unit); mixity takes no start.\n",
              cases.size(), kAreaUnits.size(), precision::kStarts.size());
} catch (const std::exception& error) {
  std::fprintf(stderr, "precision_convergence: %s\n", error.what());
  return 1;
}
