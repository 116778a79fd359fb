#include "analysis/readable.h"

#include <gtest/gtest.h>

namespace mixity {
namespace {

TEST(Readable, ForeignTextLosesItsMarkup) { EXPECT_EQ(plain("run_1^{x}@&~"), "run\\_1\\^\\{x\\}\\@\\&\\~"); }

}  // namespace
}  // namespace mixity
