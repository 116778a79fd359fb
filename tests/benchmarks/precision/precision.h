// Work-precision tables: what a method costs and how wrong it is, over a sweep of its tolerance. Programs print rows as
// CSV; tools/work_precision makes tables and figures of them.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

namespace mixity::precision {

/// One method at one tolerance on one case.
struct Row {
  std::string task;                     // "predict", "fit", "curve"
  std::string case_name;                // "c, near the fold"
  std::string method;                   // "TOMS 748"
  double tolerance = 0;                 // asked for; 0: the method has none
  double error = 0;                     // relative to the truth in 50 digits; infinite if there is no answer
  double evaluations = 0;               // of the function, per answer
  std::string claim{};                  // what the method says of its answer: "ok", "converged", "failed", ...
  std::function<void()> run{};          // one answer, for timing
  double median_ns = 0, spread_ns = 0;  // filled by measure(): spread is half the range between the quartiles
};

/// Times every row. Each repetition visits all rows in turn, so that what disturbs the machine disturbs all; a visit
/// runs a row as often as fills `batch_ns`.
inline void measure(std::vector<Row>& rows, int repetitions = 21, double batch_ns = 2e5) {
  using Clock = std::chrono::steady_clock;
  const auto time = [](const Row& row, int times) {
    const auto start = Clock::now();
    for (int i = 0; i < times; ++i) row.run();
    return std::chrono::duration<double, std::nano>(Clock::now() - start).count() / times;
  };
  std::vector<int> times;
  std::vector<std::vector<double>> samples(rows.size());
  for (const Row& row : rows) {
    time(row, 1);  // caches, pages
    times.push_back(std::clamp(static_cast<int>(batch_ns / std::max(time(row, 3), 1.0)), 1, 100000));
  }
  for (int repetition = 0; repetition < repetitions; ++repetition)
    for (std::size_t i = 0; i < rows.size(); ++i) samples[i].push_back(time(rows[i], times[i]));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::sort(samples[i].begin(), samples[i].end());
    const auto at = [&](double part) {
      return samples[i][static_cast<std::size_t>(part * static_cast<double>(samples[i].size() - 1))];
    };
    rows[i].median_ns = at(0.5);
    rows[i].spread_ns = 0.5 * (at(0.75) - at(0.25));
  }
}

inline void print(const std::vector<Row>& rows) {
  std::printf("task,case,method,tolerance,error,evaluations,median_ns,spread_ns,claim\n");
  for (const Row& row : rows)
    std::printf("%s,\"%s\",%s,%.3g,%.3g,%.6g,%.5g,%.3g,%s\n", row.task.c_str(), row.case_name.c_str(),
                row.method.c_str(), row.tolerance, row.error, row.evaluations, row.median_ns, row.spread_ns,
                row.claim.c_str());
}

}  // namespace mixity::precision
