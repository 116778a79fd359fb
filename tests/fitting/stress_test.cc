#include <gtest/gtest.h>

#include "stress/fits.h"
#include "stress/short_run.h"

namespace mixity::stress {
namespace {

TEST(Stress, NoRandomFitClaimsWhatThePrintedCostContradicts) {
  constexpr std::size_t kCases = short_run(3000, 300);
  const Tally tally = random_fits(kShortSeed, kCases);
  expect_explained(tally);
  EXPECT_GT(tally.answered, kCases / 4);
}

}  // namespace
}  // namespace mixity::stress
