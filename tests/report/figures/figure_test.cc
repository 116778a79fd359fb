#include "report/figures/figure.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

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

TEST(Figure, LawsOfTheLiteratureAreToldApartFromEachOther) {
  const std::vector<std::string> keys{"a", "b", "c", "bk", "power", "linear", "quadratic", "hutchinson_suo"};
  for (const std::string& one : keys)
    for (const std::string& other : keys)
      if (one != other) {
        EXPECT_TRUE(model_line(one) != model_line(other) || model_color(one) != model_color(other)) << one << other;
        EXPECT_TRUE(model_symbol(one) != model_symbol(other) || model_color(one) != model_color(other)) << one << other;
      }
}

TEST(Figure, AnEllipseLooksLikeItsCircle) {
  EXPECT_EQ(model_line("c-ellipse"), model_line("c"));
  EXPECT_EQ(model_color("b-ellipse"), model_color("b"));
}

}  // namespace figure_test
}  // namespace mixity
