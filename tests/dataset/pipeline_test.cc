// Threads change nothing: all is taken, in order, and of several failures the first is told.
#include "dataset/pipeline.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>

namespace mixity {
namespace {

constexpr std::size_t kItems = 500;

struct Item {
  std::size_t number = 0, square = 0;
};

/// What is taken of kItems items, and the message that ends them; fails_at(stage, number) says where it throws.
template <class FailsAt>
std::pair<std::vector<std::size_t>, std::string> outcome(std::size_t threads, const FailsAt& fails_at) {
  const auto stage = [&](const char* name, std::size_t number) {
    if (fails_at(name, number)) throw std::runtime_error(std::string(name) + " " + std::to_string(number));
  };
  std::size_t next = 0;
  std::vector<std::size_t> taken;
  try {
    pipeline<Item>(
        threads,
        [&](Item& item) {
          if (next == kItems) return false;
          item.number = next++;
          stage("next", item.number);
          return true;
        },
        [&](Item& item) {
          if (item.number % 3 == 0) std::this_thread::yield();  // so that later items overtake
          stage("work", item.number);
          item.square = item.number * item.number;
        },
        [&](const Item& item) {
          stage("take", item.number);
          taken.push_back(item.square);
        });
  } catch (const std::runtime_error& error) {
    return {taken, error.what()};
  }
  return {taken, ""};
}

std::vector<std::size_t> squares(std::size_t n) {
  std::vector<std::size_t> list(n);
  for (std::size_t i = 0; i < n; ++i) list[i] = i * i;
  return list;
}

TEST(Pipeline, TakesAllInOrderWithAnyNumberOfThreads) {
  for (const std::size_t threads : {1, 2, 3, 8}) {
    const auto [taken, message] = outcome(threads, [](const std::string&, std::size_t) { return false; });
    EXPECT_EQ(taken, squares(kItems)) << threads << " threads";
    EXPECT_EQ(message, "");
  }
}

TEST(Pipeline, TellsTheFirstFailureInOrderAndTakesNothingAfterIt) {
  for (const std::size_t threads : {1, 2, 8})
    for (const std::string first : {"next", "work", "take"})
      for (int repetition = 0; repetition < 20; ++repetition) {
        // Whatever comes after the hundredth fails, too, and mostly sooner.
        const auto [taken, message] = outcome(threads, [&](const std::string& stage, std::size_t number) {
          return (number == 100 && stage == first) || (number > 100 && stage == "work");
        });
        EXPECT_EQ(message, first + " 100");
        EXPECT_EQ(taken, squares(100));
      }
}

TEST(Pipeline, WithNothingToReadDoesNothing) {
  std::atomic<int> calls = 0;
  pipeline<Item>(
      4, [](Item&) { return false; }, [&](Item&) { ++calls; }, [&](const Item&) { ++calls; });
  EXPECT_EQ(calls, 0);
}

}  // namespace
}  // namespace mixity
