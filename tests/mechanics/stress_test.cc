#include <gtest/gtest.h>

#include "stress/contacts.h"
#include "stress/short_run.h"

namespace mixity::stress {
namespace stress_test {

TEST(Stress, EveryRandomAreaFulfilsThePrintedEquation) {
  constexpr std::size_t kCases = short_run(8000, 400);
  const Tally tally = random_contacts(kShortSeed, kCases);
  expect_explained(tally);
  EXPECT_LE(tally.worst_error, 4e-15) << tally.worst_case;  // the header's promise away from folds
  EXPECT_GT(tally.answered, kCases / 2);
}

}  // namespace stress_test
}  // namespace mixity::stress
