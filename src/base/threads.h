// Work on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <future>
#include <thread>
#include <vector>

#include "base/stop.h"

namespace mixity {

/// Number of processors; 1 if unknown, and in a browser, where threads are not used. Cached, since the system opens a
/// file to find it.
inline std::size_t processors() {
#ifdef __EMSCRIPTEN__
  return 1;
#endif
  static const std::size_t count = std::max(1u, std::thread::hardware_concurrency());
  return count;
}

namespace threads_detail {

/// Processors on which no thread of this file works; below 0 if there are more threads. The first caller has one.
inline std::atomic<std::ptrdiff_t>& idle() {
  static std::atomic<std::ptrdiff_t> count = static_cast<std::ptrdiff_t>(processors()) - 1;
  return count;
}

}  // namespace threads_detail

/// Counts processors as busy (below 0: as idle) for as long as it exists.
class BusyProcessors {
 public:
  explicit BusyProcessors(std::ptrdiff_t count) : count_(count) { threads_detail::idle() -= count_; }
  ~BusyProcessors() { threads_detail::idle() += count_; }
  BusyProcessors(const BusyProcessors&) = delete;
  BusyProcessors& operator=(const BusyProcessors&) = delete;

 private:
  std::ptrdiff_t count_;
};

namespace threads_detail {

/// `helpers`: already counted as busy. Each has its processor until it finds no more work, the caller while it works.
template <class Run>
void run_with(std::size_t helpers, const Run& run) {
  const auto help = [&run, check = stop_check()] {
    const Stoppable stoppable(check);
    struct End {
      ~End() { ++idle(); }
    } const end;
    run();
  };
  std::vector<std::future<void>> running;
  for (std::size_t k = 0; k < helpers; ++k) running.push_back(std::async(help));
  run();
  const BusyProcessors waiting(-1);
  constexpr std::chrono::milliseconds kPause(20);
  for (auto& one : running) {
    // who waits may be the only one who is told to stop
    while (stop_check() && one.wait_for(kPause) != std::future_status::ready) may_go_on();
    one.get();
  }
}

}  // namespace threads_detail

/// Calls run() on this many threads, including the calling one, and waits for all. The calls share the work. If the
/// system grants fewer threads, some calls start late and find no work left.
template <class Run>
void run_on_threads(std::size_t threads, const Run& run) {
  if (threads < 2) return run();
  threads_detail::idle() -= static_cast<std::ptrdiff_t>(threads - 1);
  threads_detail::run_with(threads - 1, run);
}

/// The same on at most this many threads, as far as processors are idle: parallel work inside of parallel work would
/// otherwise start more threads than can run.
template <class Run>
void run_on_idle_processors(std::size_t most, const Run& run) {
  const auto wanted = static_cast<std::ptrdiff_t>(most) - 1;
  std::ptrdiff_t idle = threads_detail::idle(), helpers = 0;
  do {
    helpers = std::min(wanted, idle);
    if (helpers <= 0) return run();
  } while (!threads_detail::idle().compare_exchange_weak(idle, idle - helpers));
  threads_detail::run_with(static_cast<std::size_t>(helpers), run);
}

/// Calls body(i) for each i < n, on as many threads as there are idle processors, in any order.
template <class Body>
void parallel_for(std::size_t n, const Body& body) {
  std::atomic<std::size_t> next = 0;
  run_on_idle_processors(n, [&] {
    for (std::size_t i; (i = next++) < n;) body(i);
  });
}

}  // namespace mixity
