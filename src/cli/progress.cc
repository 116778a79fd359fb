#include "cli/progress.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <memory>
#include <mutex>

namespace mixity::cli {
namespace {

using Clock = std::chrono::steady_clock;

struct Line {
  explicit Line(std::string text) : what(std::move(text)) {}
  ~Line() {
    if (shown) std::fprintf(stderr, "\r\033[K");
  }

  void update(double fraction) {
    const std::lock_guard lock(mutex);
    const auto now = Clock::now();
    using std::chrono::milliseconds;
    if (fraction >= 1) {  // what comes next is not the bar's
      if (shown) std::fprintf(stderr, "\r\033[K");
      shown = false;
    } else {
      if (now - start < milliseconds(1000) || (shown && now - last < milliseconds(200))) return;
      constexpr std::size_t kWidth = 30;
      const auto full = static_cast<std::size_t>(kWidth * fraction);
      std::fprintf(stderr, "\r\033[K%s [%s%s] %3.0f%%", what.c_str(), std::string(full, '=').c_str(),
                   std::string(kWidth - full, ' ').c_str(), 100 * fraction);
      shown = true;
      last = now;
    }
    std::fflush(stderr);
  }

  std::string what;
  std::mutex mutex;
  Clock::time_point start = Clock::now(), last;
  bool shown = false;
};

}  // namespace

Progress progress_line(const std::string& what) {
  if (!isatty(STDERR_FILENO)) return {};
  const auto line = std::make_shared<Line>(what);
  return [line](double fraction) { line->update(fraction); };
}

}  // namespace mixity::cli
