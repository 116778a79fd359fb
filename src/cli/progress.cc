#include "cli/progress.h"

#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>

namespace mixity::cli {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// Redrawn by a thread, so that the elapsed time advances during a long step.
class Line {
 public:
  explicit Line(std::string what) : what_(std::move(what)) {}
  ~Line() {
    thread_.request_stop();
    if (thread_.joinable()) thread_.join();
    if (shown_) std::fprintf(stderr, "\r\033[K");
  }

  void reach(double fraction) {
    const std::lock_guard lock(mutex_);
    fraction_ = fraction;
    if (fraction < 1 || !shown_) return;
    std::fprintf(stderr, "\r\033[K");  // removes the bar
    shown_ = false;
  }

 private:
  void run(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    const auto wait = [&](milliseconds time) {
      wake_.wait_for(lock, stop, time, [] { return false; });
      return !stop.stop_requested();
    };
    for (bool on = wait(milliseconds(1000)); on; on = wait(milliseconds(200)))
      if (fraction_ < 1) draw();
  }

  void draw() {
    constexpr std::size_t kWidth = 30;
    const auto full = static_cast<std::size_t>(kWidth * fraction_);
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - start_).count();
    std::fprintf(stderr, "\r\033[K%s [%s%s] %3.0f%%, %lld s", what_.c_str(), std::string(full, '=').c_str(),
                 std::string(kWidth - full, ' ').c_str(), 100 * fraction_, static_cast<long long>(seconds));
    std::fflush(stderr);
    shown_ = true;
  }

  std::string what_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  Clock::time_point start_ = Clock::now();
  double fraction_ = 0;
  bool shown_ = false;
  std::jthread thread_{[this](const std::stop_token& stop) { run(stop); }};
};

}  // namespace

Progress progress_line(const std::string& what) try {
  if (!isatty(STDERR_FILENO)) return {};
  const auto line = std::make_shared<Line>(what);
  return [line](double fraction) { line->reach(fraction); };
} catch (const std::system_error&) {  // no thread: go on without a bar
  return {};
}

}  // namespace mixity::cli
