// A table of growth, and the folder of its input.
#pragma once

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "growth/data.h"
#include "growth/measure.h"

namespace mixity::growth {

/// Gone with the object.
class Folder {
 public:
  Folder() : path_(std::filesystem::temp_directory_path() / ("mixity_growth_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string path(const std::string& name) const { return path_ / name; }
  /// A data set; `seed`: of its noise.
  std::string file(std::size_t n, std::size_t runs = 10, unsigned seed = 1) const {
    std::string path = this->path(std::to_string(n) + "_" + std::to_string(runs) + "_" + std::to_string(seed) + ".csv");
    if (!std::filesystem::exists(path)) write_csv(path, n, runs, seed);
    return path;
  }

 private:
  std::filesystem::path path_;
};

inline std::string time_text(double seconds) {
  char text[32];
  const double shown = seconds < 1e-3 ? 1e6 * seconds : seconds < 1 ? 1e3 * seconds : seconds;
  std::snprintf(text, sizeof text, "%.3g %s", shown, seconds < 1e-3 ? "us" : seconds < 1 ? "ms" : "s");
  return text;
}
inline std::string memory_text(double bytes) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g MB", bytes / 1048576);
  return text;
}
inline std::string exponent_text(const std::optional<double>& value) {
  char text[32];
  if (!value) return "";
  std::snprintf(text, sizeof text, "%.2f", *value);
  return text;
}

/// A task and what it costs at a size; null where it failed.
struct Row {
  std::string task;
  std::function<std::optional<Cost>(std::size_t)> cost;
};

/// The time of each task at each size, the exponent, memory at the largest and its exponent.
inline void table(const char* unit, const std::vector<std::size_t>& sizes, const std::vector<Row>& rows) {
  std::printf("\n| %s |", unit);
  for (const std::size_t n : sizes) std::printf(" %zu |", n);
  std::printf(" time grows as n^ | memory at the last | each | memory grows as n^ |\n|---|");
  for (std::size_t i = 0; i < sizes.size() + 4; ++i) std::printf("---|");
  std::printf("\n");
  for (const Row& row : rows) {
    std::printf("| %s |", row.task.c_str());
    std::vector<std::pair<double, double>> times, bytes;
    for (const std::size_t n : sizes) {
      // What has begun to take a minute would take ten at the next size.
      const auto cost = times.empty() || times.back().second < 60 ? row.cost(n) : std::nullopt;
      std::printf(" %s |", cost ? time_text(cost->seconds).c_str() : "-");
      if (!cost) continue;
      times.emplace_back(static_cast<double>(n), cost->seconds);
      bytes.emplace_back(static_cast<double>(n), cost->bytes);
    }
    const auto last = bytes.empty() ? std::pair(1.0, 0.0) : bytes.back();
    std::printf(" %s | %s | %.3g B | %s |\n", exponent_text(exponent(times, 1e-3)).c_str(),
                memory_text(last.second).c_str(), last.second / last.first,
                exponent_text(exponent(bytes, 1 << 20)).c_str());
  }
}

}  // namespace mixity::growth
