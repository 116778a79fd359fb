// How often each solver was right, wrong and said so, or wrong and claimed to have converged, on one kind of cost.
#pragma once

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "fitting/unit_cases.h"

namespace mixity::precision {

class ConvergenceTable {
 public:
  /// `in_units`: which unit a number was in is shown, too.
  ConvergenceTable(std::string title, bool in_units) : title_(std::move(title)), in_units_(in_units) {}
  void count(const std::string& solver, const std::string& data, std::size_t unit, bool right, bool claims) {
    if (!rows_.contains(solver)) order_.push_back(solver);
    Tally& tally = rows_[solver];
    ++(right ? tally.right : claims ? tally.silent : tally.said_so);
    if (right || !claims) return;
    ++tally.silent_in[data];
    ++tally.silent_by_unit[unit];
  }

  void print() const {
    std::printf("\n%s\n\n", title_.c_str());
    std::printf("| solver | right | wrong and said so | wrong but \"converged\" | runs |\n|---|---|---|---|---|\n");
    for (const std::string& solver : order_) {
      const Tally& tally = rows_.at(solver);
      const auto share = [&](int n) { return 100.0 * n / tally.runs(); };
      std::printf("| %s | %.1f %% | %.1f %% | %.1f %% | %d |\n", solver.c_str(), share(tally.right),
                  share(tally.said_so), share(tally.silent), tally.runs());
    }
    if (std::none_of(rows_.begin(), rows_.end(), [](const auto& row) { return row.second.silent > 0; })) return;
    std::printf("\nWrong but \"converged\", by data set:\n\n");
    for (const std::string& solver : order_)
      if (!rows_.at(solver).silent_in.empty()) print_where(solver, rows_.at(solver));
  }

 private:
  struct Tally {
    int right = 0, said_so = 0, silent = 0;
    std::map<std::string, int> silent_in{};  // by data set
    std::array<int, kAreaUnits.size()> silent_by_unit{};
    int runs() const { return right + said_so + silent; }
  };

  void print_where(const std::string& solver, const Tally& tally) const {
    std::printf("- %s:", solver.c_str());
    const char* comma = " ";
    for (const auto& [data, n] : tally.silent_in) {
      std::printf("%s%s %d", comma, data.c_str(), n);
      comma = "; ";
    }
    if (in_units_) std::printf("; by unit:");
    for (std::size_t i = 0; in_units_ && i < kAreaUnits.size(); ++i)
      std::printf(" %s %d", kAreaUnits[i].name, tally.silent_by_unit[i]);
    std::printf("\n");
  }

  std::string title_;
  bool in_units_;
  std::map<std::string, Tally> rows_;
  std::vector<std::string> order_;
};

}  // namespace mixity::precision
