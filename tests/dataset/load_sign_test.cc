// Files that have compression as negative.
#include <gtest/gtest.h>

#include "base/number_text.h"
#include "dataset/check.h"
#include "dataset/load_text.h"
#include "dataset/pooled.h"
#include "dataset/signs.h"
#include "mechanics/contact.h"

namespace mixity {
namespace load_sign_test {

/// JKR's areas at these loads, less as T grows; `sign` of P, `size` of the areas.
std::string contacts(const std::vector<double>& loads, double sign, double size = 1) {
  std::string text;
  for (const double P : loads)
    for (int i = 0; i < 6; ++i)
      text += shortest(sign * P) + "," + std::to_string(i) + "," +
              shortest(size * area_from_radius(jkr_radius(P)) * (1 - 0.005 * i * i)) + "\n";
  return text;
}
const std::string kHeader = "P,T,A\n";

TEST(LoadSign, OfCompressionReadAsNegativeIsTurnedWithANote) {
  const std::vector<double> loads{30, 15, 6, -1.5};
  const Dataset good = load_text(kHeader + contacts(loads, 1)), negative = load_text(kHeader + contacts(loads, -1));
  EXPECT_EQ(good.curves, negative.curves);
  EXPECT_EQ(good.curve_loads, negative.curve_loads);
  ASSERT_EQ(good.points.size(), negative.points.size());
  for (std::size_t i = 0; i < good.points.size(); ++i) EXPECT_EQ(good.points[i].P, negative.points[i].P);
  EXPECT_EQ(texts_of(negative.notes), std::vector<std::string>{kLoadsReversed});
  EXPECT_TRUE(good.notes.empty());
  // areas off by a power of ten say nothing of JKR, but still grow
  EXPECT_EQ(load_text(kHeader + contacts(loads, -1, 100)).curves, good.curves);
  // one load: its areas are those of -P
  EXPECT_EQ(load_text(kHeader + contacts({15}, -1)).curves, std::vector<std::string>{"P=15"});
}

TEST(LoadSign, IsLeftAsItIsAndAskedForWhereThatIsNotSure) {
  const Dataset one = load_text(kHeader + contacts({15}, -1, 100));
  EXPECT_EQ(one.curves, std::vector<std::string>{"P=-15"});
  std::string odd;
  for (const std::string& line : find_oddities(one)) odd += line + "\n";
  EXPECT_NE(odd.find("if the file has compression as negative, its P are to be multiplied by -1"), std::string::npos);
  EXPECT_EQ(load_text(kHeader + contacts({-1, -2}, 1)).curves, (std::vector<std::string>{"P=-1", "P=-2"}));
}

TEST(LoadSign, IsOneOfAllFilesOfADataSet) {
  const TemporaryFolder folder;
  const std::vector<RunFile> files{{folder.write("a.csv", kHeader + contacts({30}, -1))},
                                   {folder.write("b.csv", kHeader + contacts({1}, -1))}};
  const Dataset pooled = load_pooled(files, {});
  EXPECT_EQ(pooled.curve_loads, (std::vector<double>{30, 1}));
}

}  // namespace load_sign_test
}  // namespace mixity
