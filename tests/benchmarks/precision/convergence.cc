// How often a solver is wrong and says that it converged: area data in seven units, from eleven starts. Each solver is
// run with the tolerances it comes with, and with 1e-15 everywhere. Right: within 1e-6 of the global minimum, or within
// 1e-3 standard errors. A value out of lambda's range tells its reader that it is wrong.
#include <glog/logging.h>

#include <map>

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

struct Tally {
  int right = 0, said_so = 0, silent = 0;
  std::map<std::string, int> silent_in{};  // by data set
  std::array<int, kAreaUnits.size()> silent_by_unit{};
  int runs() const { return right + said_so + silent; }
};

class Table {
 public:
  void count(const std::string& solver, const std::string& data, std::size_t unit, bool right, bool claims) {
    if (!rows_.contains(solver)) order_.push_back(solver);
    Tally& tally = rows_[solver];
    ++(right ? tally.right : claims ? tally.silent : tally.said_so);
    if (right || !claims) return;
    ++tally.silent_in[data];
    ++tally.silent_by_unit[unit];
  }

  void print() const {
    std::printf("| solver | right | wrong and said so | wrong but \"converged\" | runs |\n|---|---|---|---|---|\n");
    for (const std::string& solver : order_) {
      const Tally& tally = rows_.at(solver);
      const auto share = [&](int n) { return 100.0 * n / tally.runs(); };
      std::printf("| %s | %.1f %% | %.1f %% | %.1f %% | %d |\n", solver.c_str(), share(tally.right),
                  share(tally.said_so), share(tally.silent), tally.runs());
    }
    std::printf("\nWrong but \"converged\", by data set:\n\n");
    for (const std::string& solver : order_) {
      if (rows_.at(solver).silent_in.empty()) continue;
      std::printf("- %s:", solver.c_str());
      const char* comma = " ";
      for (const auto& [data, n] : rows_.at(solver).silent_in) {
        std::printf("%s%s %d", comma, data.c_str(), n);
        comma = "; ";
      }
      std::printf("; by unit:");
      for (std::size_t i = 0; i < kAreaUnits.size(); ++i)
        std::printf(" %s %d", kAreaUnits[i].name, rows_.at(solver).silent_by_unit[i]);
      std::printf("\n");
    }
  }

 private:
  std::map<std::string, Tally> rows_;
  std::vector<std::string> order_;
};

template <class Model>
void run_peers(const UnitCase& at, const Dataset& data, const BestValue& best, Table& table) {
  const double area_unit = data.contact->area_unit();
  for (const auto& peer : peers<AreaProblem<Model>>())
    for (const bool tight : {false, true})
      for (std::size_t k = 0; k < kAreaUnits.size(); ++k) {
        const AreaUnit& unit = kAreaUnits[k];
        const AreaProblem<Model> problem(data, area_unit / unit.square_metres);
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
void run_ours(const UnitCase& at, const BestValue& best, Table& table) {
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
    for (const std::size_t i : toughness.used) points.push_back({data.points[i].mixity, data.points[i].ratio});
    const double x = static_cast<double>(exact_minimum<Model>(points));
    count("mixity, toughness", toughness, {x, toughness.parameters.at(0).stderr_.value_or(0), {}});
  }
}

template <class Model>
void run(const UnitCase& at, Table& table) {
  const Dataset data = at.in({"m^2", 1});
  const BestValue best = best_value<Model>(data, 8000);
  std::fprintf(stderr, "%s: best %.10g +/- %.2g, %d minima within 10 %%\n", at.name.c_str(), best.x,
               best.standard_error, best.minima);
  run_ours<Model>(at, best, table);
  run_peers<Model>(at, data, best, table);
}

}  // namespace
}  // namespace mixity::precision

int main() {
  using namespace mixity;
  FLAGS_minloglevel = google::GLOG_FATAL;  // of Ceres: what fails is counted
  precision::Table table;
  for (const UnitCase& at : unit_cases(MIXITY_ROOT "/data/mergel2018.csv"))
    with_model(at.model, [&](auto model) {
      if constexpr (parameter_count<decltype(model)> == 1) precision::run<decltype(model)>(at, table);
    });
  table.print();
  std::printf("\n%zu data sets x %zu units x %zu starts; mixity takes no start.\n", std::size_t{6}, kAreaUnits.size(),
              precision::kStarts.size());
}
