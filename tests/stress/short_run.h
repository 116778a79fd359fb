// The short form of a run of random cases, for the tests.
#pragma once

#include <gtest/gtest.h>

#include "stress/tally.h"

namespace mixity::stress {

inline constexpr std::uint64_t kShortSeed = 20261121;  // not the first of tools/stress

/// So many cases, or under sanitizers, which slow 50-digit arithmetic down, so many.
constexpr std::size_t short_run([[maybe_unused]] std::size_t cases, [[maybe_unused]] std::size_t sanitized) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return sanitized;
#else
  return cases;
#endif
}

inline void expect_explained(const Tally& tally) {
  EXPECT_EQ(tally.failures, 0u);
  for (const std::string& why : tally.first_failures) ADD_FAILURE() << why;
}

}  // namespace mixity::stress
