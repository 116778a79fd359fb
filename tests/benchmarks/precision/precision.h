// Work-precision tables: what a method costs and how wrong it is, over a sweep of its tolerance. Programs print rows as
// CSV; tools/work_precision makes tables and figures of them.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

namespace mixity::precision {

/// One method at one tolerance on one case.
struct Row {
  std::string task;                     // "predict", "drawing", "fit", "curve", "nist"
  std::string case_name;                // "c, near the fold"
  std::string method;                   // "TOMS 748"
  double tolerance = 0;                 // asked for; 0: the method has none
  double error = 0;                     // relative to the truth in 50 digits; infinite if there is no answer
  double evaluations = 0;               // of the function, per answer
  std::string claim{};                  // what the method says of its answer: "ok", "converged", "failed", ...
  std::function<void()> run{};          // one answer, for timing
  double median_ns = 0, spread_ns = 0;  // filled by measure(): spread is half the range between the quartiles
};

/// Time that this thread spent on the processor, where there is such a clock: other programs are not in it. Reading it
/// takes some 0.5 us, which is why batches are timed.
inline double thread_ns() {
#ifdef CLOCK_THREAD_CPUTIME_ID
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
#else
  using namespace std::chrono;
  return duration<double, std::nano>(steady_clock::now().time_since_epoch()).count();
#endif
}

inline constexpr int kRepetitions = 21;

/// Times every row. Each repetition visits all rows in turn, so that what disturbs the machine disturbs all; a visit
/// runs a row as often as fills `batch_ns`. Before each repetition `turn` lets others take theirs.
inline void measure(std::vector<Row>& rows, int repetitions = kRepetitions, const std::function<void()>& turn = {},
                    double batch_ns = 2e5) {
  const auto time = [](const Row& row, int times) {
    const double start = thread_ns();
    for (int i = 0; i < times; ++i) row.run();
    return (thread_ns() - start) / times;
  };
  std::vector<int> times;
  std::vector<std::vector<double>> samples(rows.size());
  for (const Row& row : rows) {
    time(row, 1);  // caches, pages
    int runs = 3;  // more and more, until reading the clock no longer counts
    double each = time(row, runs);
    while (each * runs < 0.1 * batch_ns && runs < 100000) each = time(row, runs *= 4);
    times.push_back(std::clamp(static_cast<int>(batch_ns / std::max(each, 1.0)), 1, 100000));
  }
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    if (turn) turn();
    for (std::size_t i = 0; i < rows.size(); ++i) samples[i].push_back(time(rows[i], times[i]));
  }
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
