#include "analysis/readable.h"

#include <gtest/gtest.h>

namespace mixity {
namespace readable_test {

TEST(Readable, ForeignTextLosesItsMarkup) { EXPECT_EQ(plain("run_1^{x}@&~"), "run\\_1\\^\\{x\\}\\@\\&\\~"); }

}  // namespace readable_test
}  // namespace mixity
