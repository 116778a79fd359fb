// Files of many blocks.
#include <gtest/gtest.h>

#include "dataset/load_text.h"

namespace mixity {
namespace large_file_test {

constexpr std::size_t kRows = 60000;  // some 1 MB: several blocks

/// Runs that come back again and again, and every 100th row left out.
std::string many_rows() {
  std::string text = "curve,P,T,A,include\n";
  for (std::size_t i = 0; i < kRows; ++i)
    text += "run " + std::to_string(i * i % 7) + ",3," + std::to_string(i % 50) + "e-3," + std::to_string(20 + i % 5) +
            (i % 100 == 99 ? ",0\n" : ",1\n");
  return text;
}

TEST(LargeFile, PointsStandInTheOrderOfTheFile) {
  const Dataset data = load_text(many_rows());
  EXPECT_EQ(data.rows, kRows);
  EXPECT_EQ(data.curves, (std::vector<std::string>{"run 0", "run 1", "run 4", "run 2"}));
  EXPECT_EQ(data.curve_loads, std::vector<double>(4, 3.0));
  ASSERT_EQ(data.excluded.size(), kRows / 100);
  ASSERT_EQ(data.points.size(), kRows - kRows / 100);
  std::size_t used = 0, excluded = 0;
  for (std::size_t i = 0; i < kRows; ++i) {
    if (i % 100 == 99) {
      EXPECT_EQ(data.excluded[excluded].line, i + 2);
      EXPECT_EQ(data.excluded[excluded++].reason, "include = 0");
      continue;
    }
    const Point& point = data.points[used++];
    ASSERT_EQ(point.line, i + 2);
    ASSERT_EQ(data.curves[point.curve], "run " + std::to_string(i * i % 7));
    ASSERT_EQ(point.T, static_cast<double>(i % 50) / 1000);
    ASSERT_EQ(point.A, static_cast<double>(20 + i % 5));
  }
}

TEST(LargeFile, PointsOfEqualLoadAreARunWhereverTheyStand) {
  std::string text = "P,T,A\n";
  for (std::size_t i = 0; i < kRows; ++i) text += std::to_string(1 + i / 7 % 3) + ",0.5,20\n";
  const Dataset data = load_text(text);
  EXPECT_EQ(data.curves, (std::vector<std::string>{"P=1", "P=2", "P=3"}));
  EXPECT_EQ(data.curve_loads, (std::vector<double>{1, 2, 3}));
  for (std::size_t i = 0; i < kRows; ++i) ASSERT_EQ(data.points[i].curve, i / 7 % 3);
}

TEST(LargeFile, ARunIsTurnedRoundByAllOfItsPoints) {
  std::string text = "curve,P,T,A\n";
  // at first the shear of the second run is about zero, that of the third above it
  for (std::size_t i = 0; i < kRows; ++i) {
    const bool late = i >= kRows / 2;
    const int sign = i % 3 == 0 ? 1 : i % 3 == 1 ? (late ? -100 : (i / 3 % 2 ? 1 : -1)) : (late ? -1 : 1);
    text += "run " + std::to_string(i % 3) + ",3," + std::to_string(sign) + "e-3,20\n";
  }
  const Dataset data = load_text(text);
  ASSERT_EQ(data.points.size(), kRows);
  ASSERT_EQ(data.notes.size(), 2);
  EXPECT_EQ(texts_of(data.notes)[0], "a run sheared in the negative direction was reversed (T -> -T): run 1");
  EXPECT_EQ(texts_of(data.notes)[1], "15000 of 60000 points have T < 0, used as they are: equilibrium depends on T^2");
  for (std::size_t i = 1; i < kRows; i += 3)
    ASSERT_EQ(data.points[i].T, i >= kRows / 2 ? 0.1 : i / 3 % 2 ? -1e-3 : 1e-3);
}

TEST(LargeFile, TheFirstErrorInTheFileIsTheOneThatIsTold) {
  const std::string good = "3,0.5,20\n";
  std::string text = "P,T,A\n";
  for (std::size_t i = 0; i < 40000; ++i) text += good;
  text += "3,oops,20\n";
  for (std::size_t i = 0; i < 40000; ++i) text += i % 10 ? good : "3,later,20\n";
  for (int repetition = 0; repetition < 5; ++repetition)
    EXPECT_EQ(load_error(text), "a.csv:40002:3: column 'T': 'oops' is not a number");
}

TEST(LargeFile, TheHeaderMayComeAfterManyComments) {
  std::string text;
  for (std::size_t i = 0; i < 40000; ++i) text += "# a comment\n";
  text += "P,T,A\n3,0.5,20\n";
  const Dataset data = load_text(text);
  ASSERT_EQ(data.points.size(), 1);
  EXPECT_EQ(data.points[0].line, 40002);
}

}  // namespace large_file_test
}  // namespace mixity
