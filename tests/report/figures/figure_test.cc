#include "report/figures/figure.h"

#include <gtest/gtest.h>

#include "analysis/readable.h"

namespace mixity {
namespace figure_test {

TEST(Figure, ModelsKeepThePapersLinesAndDifferInSymbolAndColour) {
  EXPECT_EQ(model_line("a"), Look::dash_dot);
  EXPECT_EQ(model_line("b"), Look::dashed);
  EXPECT_EQ(model_line("c"), Look::solid);
  for (const char* one : {"a", "b", "c", "bk"})
    for (const char* other : {"a", "b", "c", "bk"})
      if (std::string_view(one) != other) {
        EXPECT_NE(model_line(one), model_line(other));
        EXPECT_NE(model_symbol(one), model_symbol(other));
        EXPECT_NE(model_color(one), model_color(other));
      }
}

}  // namespace figure_test
}  // namespace mixity
