#include "base/threads.h"

#include <gtest/gtest.h>

#include <stdexcept>
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

}  // namespace threads_test
}  // namespace mixity
