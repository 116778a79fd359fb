// NIST's 27 sets for nonlinear regression from both starts: time against the error of the worst parameter, of certified
// values of eleven digits. mixity's solver knows no physics: it gets the sets as it gets its own problems. Peers have
// the tolerances they come with and, as another row, 1e-15 everywhere. Derivatives are ceres::Jet's for all but lmdif.
#include <glog/logging.h>

#include <memory>

#include "benchmarks/precision/nist_peers.h"
#include "benchmarks/precision/precision.h"
#include "solver/descent.h"
#include "solver/jet_problem.h"
#include "solver/kernel.h"
#include "solver/nist_data.h"
#include "solver/nist_models.h"
#include "solver/solve.h"

namespace mixity::precision {
namespace {

using nist::Set;

template <class Model>
std::unique_ptr<Problem> make_problem(const Set& set, const std::vector<double>& start) {
  const nist::Observations<Model, double> data(set);
  std::vector<FreeParameter> parameters;
  for (std::size_t k = 0; k < start.size(); ++k) parameters.push_back(unbounded("b" + std::to_string(k + 1), start[k]));
  const auto residual = [data](const auto* b, std::size_t i) { return Model::value(b, data.x[i].data()) - data.y[i]; };
  return std::make_unique<JetProblem<Model::kParameters, decltype(residual)>>(data.y.size(), parameters, norm(data.y),
                                                                              false, residual);
}

struct Entry {
  const char* name;
  std::unique_ptr<Problem> (*problem)(const Set&, const std::vector<double>& start);
};

// From the lower level of difficulty to the higher, as NIST lists them.
constexpr Entry kSets[] = {
    {"Misra1a", make_problem<nist::Saturation>},
    {"Chwirut2", make_problem<nist::Chwirut>},
    {"Chwirut1", make_problem<nist::Chwirut>},
    {"Lanczos3", make_problem<nist::Lanczos>},
    {"Gauss1", make_problem<nist::Gauss>},
    {"Gauss2", make_problem<nist::Gauss>},
    {"DanWood", make_problem<nist::DanWood>},
    {"Misra1b", make_problem<nist::Misra1b>},
    {"Kirby2", make_problem<nist::Kirby2>},
    {"Hahn1", make_problem<nist::CubicOverCubic>},
    {"Nelson", make_problem<nist::Nelson>},
    {"MGH17", make_problem<nist::Mgh17>},
    {"Lanczos1", make_problem<nist::Lanczos>},
    {"Lanczos2", make_problem<nist::Lanczos>},
    {"Gauss3", make_problem<nist::Gauss>},
    {"Misra1c", make_problem<nist::Misra1c>},
    {"Misra1d", make_problem<nist::Misra1d>},
    {"Roszman1", make_problem<nist::Roszman1>},
    {"ENSO", make_problem<nist::Enso>},
    {"MGH09", make_problem<nist::Mgh09>},
    {"Thurber", make_problem<nist::CubicOverCubic>},
    {"BoxBOD", make_problem<nist::Saturation>},
    {"Rat42", make_problem<nist::Rat42>},
    {"MGH10", make_problem<nist::Mgh10>},
    {"Eckerle4", make_problem<nist::Eckerle4>},
    {"Rat43", make_problem<nist::Rat43>},
    {"Bennett5", make_problem<nist::Bennett5>},
};

struct Case {
  std::string name;
  std::vector<double> start, certified;
  std::unique_ptr<Problem> problem;

  Case(const Entry& entry, const Set& set, std::size_t which)
      : name(set.name + ", start " + std::to_string(which + 1)),
        start(set.starts[which]),
        problem(entry.problem(set, start)) {
    for (const std::string& value : set.values) certified.push_back(std::stod(value));
  }

  /// Of the parameter that is furthest off.
  double error(const std::vector<double>& x) const {
    double worst = 0;
    for (std::size_t k = 0; k < certified.size(); ++k) {
      if (k >= x.size() || !std::isfinite(x[k])) return std::numeric_limits<double>::infinity();
      worst = std::max(worst, relative_error(x[k], certified[k]));
    }
    return worst;
  }
};

Fitted judged(const Problem& problem, const std::vector<double>& start, Engine engine) {
  const Verdict verdict = solve(problem, {.near = start}, {.engine = engine});
  return {verdict.best.x, std::string(to_string(verdict.status))};
}

Fitted fitted(const std::optional<Minimum>& minimum) {
  if (!minimum) return {{}, "failed"};
  return {minimum->x, minimum->stationary ? "converged" : "no convergence"};
}

Fitted by_kernel(const Problem& problem, const std::vector<double>& start) {
  SolverOptions options;
  options.most_iterations = kIterationsOfSeveral;
  return fitted(Kernel(problem, options).descend(start));
}

/// With a verdict, and the descents alone.
void add_ours(const Case& at, std::vector<Row>& rows) {
  const auto add = [&](const char* method, auto run) {
    const Fitted answer = run();
    rows.push_back({"nist", at.name, method, 0, at.error(answer.x), 0, answer.claim, [run] { run(); }});
  };
  add("mixity", [&at] { return judged(*at.problem, at.start, Engine::ceres); });
  add("mixity by kernel", [&at] { return judged(*at.problem, at.start, Engine::kernel); });
  add("mixity descent", [&at] { return fitted(descend(*at.problem, at.start)); });
  add("mixity kernel", [&at] { return by_kernel(*at.problem, at.start); });
}

void add_peers(const Case& at, std::vector<Row>& rows) {
  for (const PeerOfSeveral& peer : peers_of_several())
    for (const bool tight : {false, true}) {
      const Tolerances tolerances = tight ? Tolerances::all(1e-15) : peer.usual;
      const auto run = [&at, solve = peer.solve, tolerances] {
        Asked asked(*at.problem);
        const Fitted answer = solve(asked, at.start, tolerances);
        return std::pair(answer, asked.sweeps);
      };
      const auto [answer, sweeps] = run();
      rows.push_back({"nist", at.name, peer.name + (tight ? " 1e-15" : ""), 0, at.error(answer.x),
                      static_cast<double>(sweeps), answer.claim, [run] { run(); }});
    }
}

}  // namespace
}  // namespace mixity::precision

int main() try {
  using namespace mixity::precision;
  FLAGS_minloglevel = google::GLOG_FATAL;  // of Ceres: what fails is counted
  std::vector<std::unique_ptr<Case>> cases;
  std::vector<Row> rows;
  for (const Entry& entry : kSets) {
    const Set set(entry.name);
    for (const std::size_t start : {0, 1}) {
      cases.push_back(std::make_unique<Case>(entry, set, start));
      add_ours(*cases.back(), rows);
      add_peers(*cases.back(), rows);
    }
  }
  measure(rows);
  print(rows);
} catch (const std::exception& error) {
  std::fprintf(stderr, "precision_nist: %s\n", error.what());
  return 1;
}
