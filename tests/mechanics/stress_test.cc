// The short form of tools/stress: random contacts, another seed than its first.
#include <gtest/gtest.h>

#include "stress/contacts.h"

namespace mixity::stress {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::size_t kCases = 400;  // 50-digit arithmetic is slow under sanitizers
#else
constexpr std::size_t kCases = 8000;
#endif

TEST(Stress, EveryRandomAreaFulfilsThePrintedEquation) {
  const Tally tally = random_contacts(20261121, kCases);
  EXPECT_EQ(tally.failures, 0u);
  for (const std::string& why : tally.first_failures) ADD_FAILURE() << why;
  EXPECT_LE(tally.worst_error, 4e-15) << tally.worst_case;  // the header's promise away from folds
  EXPECT_GT(tally.answered, kCases / 2);
}

}  // namespace
}  // namespace mixity::stress
