// The short form of tools/stress: random fits, another seed than its first.
#include <gtest/gtest.h>

#include "stress/fits.h"

namespace mixity::stress {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::size_t kCases = 300;
#else
constexpr std::size_t kCases = 3000;
#endif

TEST(Stress, NoRandomFitClaimsWhatThePrintedCostContradicts) {
  const Tally tally = random_fits(20261121, kCases);
  EXPECT_EQ(tally.failures, 0u);
  for (const std::string& why : tally.first_failures) ADD_FAILURE() << why;
  EXPECT_GT(tally.answered, kCases / 4);
}

}  // namespace
}  // namespace mixity::stress
