#include "analysis/run_all.h"

#include <atomic>
#include <exception>
#include <filesystem>
#include <mutex>
#include <optional>
#include <utility>

#include "analysis/meter.h"
#include "base/threads.h"

namespace mixity {

bool has_small_files(const FitRequest& request) {
  constexpr std::uintmax_t kSmall = 1 << 22;
  std::uintmax_t size = 0;
  const auto add = [&](const std::string& path) {
    std::error_code unknown;
    const std::uintmax_t one = std::filesystem::file_size(path, unknown);
    if (!unknown) size += one;  // of a pipe: not known, and read once
  };
  if (request.runs.empty()) add(request.data_path);
  for (const RunFile& file : request.runs) add(file.path);
  return size < kSmall;
}

std::vector<Analysis> run_all(const std::vector<FitRequest>& requests,
                              const std::function<Analysis(const FitRequest&, const Progress&)>& run_one,
                              const Progress& progress) {
  const std::size_t n = requests.size();
  std::vector<std::optional<Analysis>> found(n);
  std::vector<std::exception_ptr> failures(n);
  std::atomic<std::size_t> first_failure = n;
  std::mutex mutex;
  Meter meter(progress, std::vector<double>(n, 1.0));
  const auto work = [&](std::size_t i) {
    if (i > first_failure) return;
    try {
      found[i] = run_one(requests[i], meter.part(i));
    } catch (...) {
      failures[i] = std::current_exception();
      const std::lock_guard lock(mutex);
      first_failure = std::min(first_failure.load(), i);
    }
  };
  std::vector<std::size_t> small;
  for (std::size_t i = 0; i < n; ++i)
    if (has_small_files(requests[i])) small.push_back(i);
  parallel_for(small.size(), [&](std::size_t k) { work(small[k]); });
  for (std::size_t i = 0; i < n; ++i)
    if (!found[i] && !failures[i]) work(i);
  std::vector<Analysis> results;
  for (std::size_t i = 0; i < n; ++i) {
    if (failures[i]) std::rethrow_exception(failures[i]);
    results.push_back(std::move(*found[i]));
  }
  return results;
}

}  // namespace mixity
