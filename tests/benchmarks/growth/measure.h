// Time and memory of one task, in a process of its own, so that none is charged with what another left behind.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace mixity::growth {

struct Cost {
  double seconds = 0;  // median of the repetitions
  double bytes = 0;    // most that was held at once beyond what the preparation held
};

/// A line of /proc/self/status in bytes.
inline double memory(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == name + ":") {
      double kilobytes = 0;
      status >> kilobytes;
      return 1024 * kilobytes;
    }
  return 0;
}

/// Repeats until half a second is filled, at least three and at most 101 times; once if it takes more than ten seconds.
inline Cost measured_here(const std::function<void()>& task) {
  using Clock = std::chrono::steady_clock;
  std::ofstream("/proc/self/clear_refs") << "5";  // the peak counts from here
  const double before = memory("VmRSS");
  std::vector<double> seconds;
  double sum = 0;
  while (seconds.size() < 3 || (sum < 0.5 && seconds.size() < 101)) {
    const auto start = Clock::now();
    task();
    seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
    sum += seconds.back();
    if (sum > 10) break;
  }
  std::sort(seconds.begin(), seconds.end());
  return {seconds[seconds.size() / 2], std::max(0.0, memory("VmHWM") - before)};
}

/// `prepare` makes the task; both happen in a child. Null if the child ends badly.
inline std::optional<Cost> measured(const std::function<std::function<void()>()>& prepare) {
  int ends[2];
  if (pipe(ends) != 0) return std::nullopt;
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    const Cost cost = measured_here(prepare());
    const bool written = write(ends[1], &cost, sizeof cost) == sizeof cost;
    _exit(written ? 0 : 1);
  }
  close(ends[1]);
  Cost cost;
  const bool told = read(ends[0], &cost, sizeof cost) == sizeof cost;
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  return told && status == 0 ? std::optional(cost) : std::nullopt;
}

/// Exponent x of growth as n^x by least squares of the logarithms, over the sizes that cost more than `fixed`: below,
/// what is paid whatever the size hides it. Null with fewer than two such sizes.
inline std::optional<double> exponent(const std::vector<std::pair<double, double>>& costs, double fixed) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& [size, cost] : costs) {
    if (!(cost > fixed)) continue;
    const double u = std::log(size), v = std::log(cost);
    n += 1, x += u, y += v, xx += u * u, xy += u * v;
  }
  if (n < 2) return std::nullopt;
  return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace mixity::growth
