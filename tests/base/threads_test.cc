#include "base/threads.h"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

namespace mixity {
namespace threads_test {

TEST(ParallelFor, CallsEachIndexOnce) {
  for (const std::size_t n : {0, 1, 2, 1000}) {
    std::vector<std::atomic<int>> calls(n);
    parallel_for(n, [&](std::size_t i) { ++calls[i]; });
    for (const auto& one : calls) EXPECT_EQ(one, 1);
  }
}

TEST(ParallelFor, PassesExceptionsOn) {
  EXPECT_THROW(parallel_for(10, [](std::size_t i) { i == 7 ? throw std::runtime_error("seven") : void(); }),
               std::runtime_error);
}

TEST(RunOnThreads, CallsAsManyTimesAsThereAreThreadsAndOnceAtLeast) {
  for (const int threads : {0, 1, 3}) {
    std::atomic<int> calls = 0;
    run_on_threads(static_cast<std::size_t>(threads), [&] { ++calls; });
    EXPECT_EQ(calls, std::max(threads, 1));
  }
}

/// The most calls that run at once.
template <class Start>
int most_at_once(const Start& start) {
  std::atomic<int> now = 0, most = 0;
  start([&] {
    const int here = ++now;
    for (int before = most; before < here && !most.compare_exchange_weak(before, here);) continue;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    --now;
  });
  return most;
}

TEST(RunOnIdleProcessors, StartsNoThreadInsideWorkThatHasAllProcessors) {
  const BusyProcessors but_three(static_cast<std::ptrdiff_t>(processors()) - 3);
  for (const std::size_t outer : {1, 2, 3, 5}) {
    const int most = most_at_once([&](const auto& wait) {
      parallel_for(outer, [&](std::size_t) { parallel_for(20, [&](std::size_t) { wait(); }); });
    });
    EXPECT_LE(most, 3) << outer;
    EXPECT_GE(most, 2) << outer;
  }
  const BusyProcessors others(2);
  EXPECT_EQ(most_at_once([&](const auto& wait) { parallel_for(20, [&](std::size_t) { wait(); }); }), 1);
}

/// Only the thread that waits is told to stop; those that work for it are, too.
TEST(Stoppable, StopsWorkOnAllThreadsWhileTheCallerWaits) {
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<bool> stop = false, working = false, caller_is_done = false;
  const StopCheck check = [&] {
    if (std::this_thread::get_id() == caller && working && caller_is_done) stop = true;
    if (stop) throw std::runtime_error("stopped");
  };
  const auto work = [&] {
    run_on_threads(2, [&] {
      if (std::this_thread::get_id() == caller) {
        while (!working) std::this_thread::yield();
        caller_is_done = true;
        return;
      }
      for (working = true;; std::this_thread::sleep_for(std::chrono::milliseconds(1))) may_go_on();
    });
  };
  {
    const Stoppable stoppable(&check);
    EXPECT_THROW(work(), std::runtime_error);
  }
  stop = true;
  EXPECT_NO_THROW(may_go_on()) << "without a check nothing stops";
}

TEST(RunOnIdleProcessors, HasItsProcessorsBackAfterEachCallAndEachException) {
  const std::ptrdiff_t before = threads_detail::idle();
  const BusyProcessors more(-2);
  run_on_threads(4, [] {});
  parallel_for(10, [](std::size_t) {});
  EXPECT_THROW(parallel_for(10, [](std::size_t) { throw std::runtime_error("each"); }), std::runtime_error);
  EXPECT_EQ(threads_detail::idle(), before + 2);
}

}  // namespace threads_test
}  // namespace mixity
