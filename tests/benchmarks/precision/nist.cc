// NIST's 27 sets for nonlinear regression from both starts: time against the error of the worst parameter, of certified
// values of eleven digits. mixity's solver knows no physics: it gets the sets as it gets its own problems. Peers have
// the tolerances they come with and, as another row, 1e-15 everywhere. Derivatives are ceres::Jet's for all but lmdif.
#include <glog/logging.h>

#include <memory>

#include "benchmarks/precision/nist_peers.h"
#include "benchmarks/precision/precision.h"
#include "solver/descent.h"
#include "solver/kernel.h"
#include "solver/nist_problems.h"
#include "solver/solve.h"

namespace mixity::precision {
namespace {

using nist::Set;

struct Entry {
  const char* name;
  std::unique_ptr<Problem> (*problem)(const Set&, const std::vector<double>& start);
};

const auto kSets = nist::for_each_set([]<class Model>(nist::Of<Model>, const char* name) {
  return Entry{name, nist::make_problem<Model>};
});

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
