// How often a solver is wrong and says that it converged: area data in seven units, from eleven starts. Each solver is
// run with the tolerances it comes with, and with 1e-15 everywhere. Right: within 1e-6 of the global minimum, or within
// 1e-3 standard errors. A value out of lambda's range tells its reader that it is wrong. With --serve solvers
// of another process take part (convergence_server.h).
#include <glog/logging.h>

#include "benchmarks/precision/convergence_server.h"
#include "benchmarks/precision/log_toughness.h"
#include "benchmarks/precision/peers.h"
#include "fitting/fit.h"
#include "fitting/unit_cases.h"

namespace mixity::precision {
namespace {

constexpr std::array<double, 11> kStarts{0.001, 0.01, 0.05, 0.1,  0.2,  0.35,
                                         0.5,   0.65, 0.8,  0.95, 0.999};  // of the range

/// The derivatives of one implicit step are exact, so that "analytic" and "automatic" differ in name only.
template <class Model>
class AreaProblem : public AreaDifferences<Model> {
 public:
  using AreaDifferences<Model>::AreaDifferences;
  bool evaluate(double x, double* residuals, double* slopes) const {
    if (!slopes) return (*this)(&x, residuals);
    using Jet = ceres::Jet<double, 1>;
    const Jet at(x, 0);
    std::vector<Jet> r(this->size());
    if (!(*this)(&at, r.data())) return false;
    for (std::size_t i = 0; i < r.size(); ++i) {
      residuals[i] = r[i].a;
      slopes[i] = r[i].v[0];
    }
    return true;
  }
};

/// Of one data set, in every unit.
template <class Model>
std::vector<AreaProblem<Model>> problems(const Dataset& data) {
  std::vector<AreaProblem<Model>> list;
  list.reserve(kAreaUnits.size());
  for (const AreaUnit& unit : kAreaUnits) list.emplace_back(data, data.contact->area_unit() / unit.square_metres);
  return list;
}

template <class Model>
void run_peers(const UnitCase& at, const std::vector<AreaProblem<Model>>& units, const BestValue& best,
               ConvergenceTable& table) {
  for (const auto& peer : peers<AreaProblem<Model>>())
    for (const bool tight : {false, true})
      for (std::size_t k = 0; k < units.size(); ++k) {
        const AreaProblem<Model>& problem = units[k];
        for (const double start : kStarts) {
          const Tolerances tolerances = tight ? Tolerances{1e-15, 1e-15, 1e-15, 0} : peer.usual;
          const Answer answer = peer.solve(problem, start * problem.upper, tolerances);
          const bool inside = answer.x >= problem.lower && answer.x <= problem.upper;
          table.count(peer.name + (tight ? ", 1e-15" : ""), at.name, k, is_right(answer.x, best),
                      answer.converged && inside);
        }
      }
}

/// As a user has it: a file in these units, and a status. It takes no start.
template <class Model>
void run_ours(const UnitCase& at, const BestValue& best, ConvergenceTable& table) {
  for (std::size_t k = 0; k < kAreaUnits.size(); ++k) {
    const AreaUnit& unit = kAreaUnits[k];
    const Dataset data = at.in(unit);
    const auto count = [&](const char* name, const FitResult& fit, const BestValue& truth) {
      const double x = fit.has_values() ? fit.parameters[0].value.value_or(std::nan("")) : std::nan("");
      const bool right = is_right(x, truth);
      table.count(name, at.name, k, right, fit.status == FitStatus::ok);
      if (!right || fit.status != FitStatus::ok)
        std::fprintf(stderr, "%s, %s in %s: %s, lambda %.10g, best %.10g +/- %.2g. %s\n", name, at.name.c_str(),
                     unit.name, std::string(to_string(fit.status)).c_str(), x, truth.x, truth.standard_error,
                     fit.message.c_str());
    };
    const FitOptions area{.objective = Objective::area, .sigma_A = parse_quantity(at.sigma_in(unit))};
    count("mixity, area", fit_model(data, Model::info.key, area), best);
    count("mixity, area, without interval", fit_model(data, Model::info.key, value_only(area)), best);
    const FitResult toughness = fit_model(data, Model::info.key);
    std::vector<ToughnessPoint> points;
    for (const std::size_t i : toughness.used) points.push_back(*data.toughness(i));
    const double x = static_cast<double>(exact_minimum<Model>(points));
    count("mixity, toughness", toughness, {x, toughness.parameters.at(0).stderr_.value_or(0), {}});
  }
}

template <class Model>
void run(const UnitCase& at, ConvergenceTable& table, ConvergenceServer& server) {
  const Dataset data = at.in({"m^2", 1});
  const BestValue best = best_value<Model>(data, 8000);
  std::fprintf(stderr, "%s: best %.10g +/- %.2g, %d minima within 10 %%\n", at.name.c_str(), best.x,
               best.standard_error, best.minima);
  run_ours<Model>(at, best, table);
  const auto units = problems<Model>(data);
  run_peers<Model>(at, units, best, table);
  server.add(at.name, best, units);
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
  precision::ConvergenceTable table;
  precision::ConvergenceServer server;
  const std::vector<UnitCase> cases = unit_cases(MIXITY_ROOT "/data/mergel2018.csv");
  for (const UnitCase& at : cases)
    with_model(at.model, [&](auto model) {
      if constexpr (parameter_count<decltype(model)> == 1) precision::run<decltype(model)>(at, table, server);
    });
  if (serves && !server.serve(precision::kStarts, table)) return 1;
  table.print();
  std::printf("\n%zu data sets x %zu units x %zu starts; mixity takes no start.\n", cases.size(), kAreaUnits.size(),
              precision::kStarts.size());
} catch (const std::exception& error) {
  std::fprintf(stderr, "precision_convergence: %s\n", error.what());
  return 1;
}
