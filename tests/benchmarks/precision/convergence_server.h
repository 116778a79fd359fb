// The costs of the convergence tables for solvers of another process, so that they see the very numbers that the others
// see and are judged by the same rule. tools/peers/convergence_rows.py is such a process.
//
// First comes a line of JSON for each data set, then "serving". Requests are lines:
//   residuals DATA UNIT LAMBDA             answered by as many native doubles as there are points
//   slopes DATA UNIT LAMBDA                likewise
//   count DATA UNIT LAMBDA CLAIMS SOLVER   an answer for its table; CLAIMS: 1 if the solver says that it converged
// DATA and UNIT count from 0. The end of the requests ends the serving.
#pragma once

#include <cstring>
#include <functional>
#include <iostream>

#include "benchmarks/precision/convergence_table.h"
#include "benchmarks/precision/solvers.h"

namespace mixity::precision {

class ConvergenceServer {
 public:
  /// `units`: the problem of the data set in each unit. Answers are counted in `table`, which must outlive this.
  template <class Problem>
  void add(const std::string& data, const BestValue& best, std::vector<Problem> units, ConvergenceTable& table) {
    const Problem& any = units.front();
    Served served{data, any.size(), units.size(), any.lower, any.upper, best, &table, {}, {}};
    served.residuals = [units](std::size_t unit, double x, double* out) { fill(units[unit], x, out); };
    served.slopes = [units](std::size_t unit, double x, double* out) { fill_slopes(units[unit], x, out); };
    served_.push_back(std::move(served));
  }

  /// False after a line that is no request.
  template <std::size_t N>
  bool serve(const std::array<double, N>& starts) const {
    announce(starts);
    std::string line;
    while (std::getline(std::cin, line)) {
      char what[16] = "";
      std::size_t data = 0, unit = 0;
      double x = 0;
      int claims = 0, solver = 0;
      const int read = std::sscanf(line.c_str(), "%15s %zu %zu %lf %d %n", what, &data, &unit, &x, &claims, &solver);
      if (read < 4 || data >= served_.size() || unit >= served_[data].units) {
        std::fprintf(stderr, "no request: %s\n", line.c_str());
        return false;
      }
      const Served& at = served_[data];
      if (std::strcmp(what, "count") == 0 && read == 5)
        at.table->count(line.substr(static_cast<std::size_t>(solver)), at.name, unit, is_right(x, at.best),
                        claims && x >= at.lower && x <= at.upper);
      else
        answer(at, std::strcmp(what, "slopes") == 0 ? at.slopes : at.residuals, unit, x);
    }
    return true;
  }

 private:
  using Sweep = std::function<void(std::size_t unit, double x, double* out)>;
  struct Served {
    std::string name;
    std::size_t points, units;
    double lower, upper;
    BestValue best;
    ConvergenceTable* table;
    Sweep residuals, slopes;
  };

  template <std::size_t N>
  void announce(const std::array<double, N>& starts) const {
    for (const Served& at : served_) {
      std::printf(R"({"data": "%s", "points": %zu, "lower": %.17g, "upper": %.17g, "units": %zu, "starts": [)",
                  at.name.c_str(), at.points, at.lower, at.upper, at.units);
      for (std::size_t i = 0; i < N; ++i) std::printf("%s%.17g", i > 0 ? ", " : "", starts[i] * at.upper);
      std::printf("]}\n");
    }
    std::printf("serving\n");
    std::fflush(stdout);
  }

  static void answer(const Served& at, const Sweep& sweep, std::size_t unit, double x) {
    std::vector<double> out(at.points);
    sweep(unit, x, out.data());
    std::fwrite(out.data(), sizeof(double), out.size(), stdout);
    std::fflush(stdout);
  }

  std::vector<Served> served_;
};

}  // namespace mixity::precision
