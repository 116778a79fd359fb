#include "dataset/exclusion.h"

#include <gtest/gtest.h>

#include "dataset/load_text.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace exclusion_test {

constexpr const char* kRuns =
    "P [mN],T [mN],A [mm^2],sigma_A [mm^2],curve\n"
    "5,0,0.40,0.001,first\n"
    "5,20,0.39,0.002,first\n"
    "8.004,-0.1,0.45,0.003,second\n"
    "8.001,-20,0.44,0.004,second\n"
    "8.002,-40,0.43,0.005,second\n";
const Overrides kConstants{{"radius", "9.42 mm"}, {"modulus", "2.133 MPa"}, {"toughness", "27 mJ/m^2"}};

Dataset runs_without(const Exclusion& which) {
  const TemporaryFolder folder;
  Dataset data = load_dataset(folder.write("runs.csv", kRuns), kConstants);
  exclude(data, which);
  return data;
}

TEST(Exclusion, OfLinesIsOfferedOnlyWhereItLeavesOutThesePointsAlone) {
  const Dataset data = runs_without({});
  EXPECT_EQ(lines_text(data, {0, 1, 4}), "2-3,6");
  Dataset side_by_side = data;  // the runs share their lines
  for (std::size_t i : {2, 3}) side_by_side.points[i].line = data.points[i - 2].line;
  EXPECT_EQ(lines_text(side_by_side, {0, 1}), "");
  EXPECT_EQ(lines_text(side_by_side, {0, 1, 2, 3}), "2-3");
}

TEST(Exclusion, OfLinesKeepsTheRestTogether) {
  const Dataset data = runs_without({.lines = {{2, 3}, {5, 5}}});
  ASSERT_EQ(data.points.size(), 2U);
  EXPECT_EQ(data.points[1].line, 6U);
  EXPECT_EQ(data.rows, data.points.size() + data.excluded.size());
  ASSERT_EQ(data.errors.size(), 2U);
  EXPECT_NEAR(data.errors[1].A * data.display.area_scale, 0.005, 1e-15);
  // the first run is gone
  EXPECT_EQ(data.curves, std::vector<std::string>{"second"});
  EXPECT_EQ(data.points[1].curve, 0U);
  ASSERT_EQ(data.shear_reversed.size(), 1U);
  EXPECT_TRUE(data.shear_reversed[0]);
  EXPECT_GT(data.points[1].T, 0);
}

TEST(Exclusion, OfARunGoesByItsNameOrItsLoad) {
  for (const char* run : {"first", "5 mN", "0.005 N", "5.004 mN"})
    EXPECT_EQ(runs_without({.runs = {run}}).points.size(), 3U);
  EXPECT_EQ(runs_without({.runs = {"8 mN"}}).points.size(), 2U);
  EXPECT_EQ(runs_without({}).points.size(), 5U);
}

TEST(Exclusion, OfARunByItsLoadTakesADecimalComma) {
  EXPECT_EQ(runs_without({.runs = {"5", "00 mN"}}).points.size(), 3U);
  EXPECT_EQ(runs_without({.runs = {"8", "0 mN"}}).points.size(), 2U);
  EXPECT_THROW(runs_without({.runs = {"5", "10 mN"}}), InputError);
}

/// A list between commas reaches exclude() in parts.
TEST(Exclusion, OfARunWhoseNameHasCommas) {
  const TemporaryFolder folder;
  const std::string path = folder.write(
      "runs.csv",
      "P [mN];T [mN];A [mm^2];curve\n5;0;0.40;0,5 mN\n5;20;0.39;0,5 mN\n8;0;0.45;1,5 mN\n9;0;0.46;left,  wet, old\n"
      "9;1;0.44;left\n");
  const auto left_after = [&](const std::vector<std::string>& names) {
    Dataset data = load_dataset(path, kConstants);
    exclude(data, {.runs = names});
    return data.curves;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(left_after({"0", "5 mN"}), (Names{"1,5 mN", "left,  wet, old", "left"}));
  EXPECT_EQ(left_after({"0", "5 mN", "1", "5 mN"}), (Names{"left,  wet, old", "left"}));
  EXPECT_EQ(left_after({"left", "wet", "old"}), (Names{"0,5 mN", "1,5 mN", "left"}));
  EXPECT_EQ(left_after({"left", "0", "5 mN"}), (Names{"1,5 mN", "left,  wet, old"}));
  EXPECT_THROW(left_after({"left", "wet"}), InputError);
}

TEST(Exclusion, OfWhatIsNotThereIsRefused) {
  for (const char* run : {"third", "5", "5 mm", "5.02 mN"})
    EXPECT_THROW(runs_without({.runs = {run}}), InputError) << run;
  EXPECT_THROW(runs_without({.lines = {{1, 1}}}), InputError);
  EXPECT_THROW(runs_without({.lines = {{7, 9}}}), InputError);
  EXPECT_THROW(runs_without({.lines = {{2, 9}}}), InputError);
}

TEST(Exclusion, TakesLinesAsTheyAreWritten) {
  EXPECT_EQ(parse_lines("17")->last, 17U);
  EXPECT_EQ(parse_lines(" 4 - 7 ")->first, 4U);
  for (const char* text : {"", "a", "0", "7-4", "4-", "-4", "4-5-6", "1.5", "99999999999999999999"})
    EXPECT_FALSE(parse_lines(text)) << text;
}

TEST(Exclusion, PointsAreWrittenAsLinesThatItReads) {
  const Dataset data = load_text("P,T,A\n1,0,5\n1,1,4\n1,2,3\n1,3,2\n1,4,1\n");
  EXPECT_EQ(lines_text(data, {0, 2, 3, 4}), "2,4-6");
  EXPECT_EQ(lines_text(data, {4, 3}), "5-6");
  EXPECT_EQ(lines_text(data, {}), "");
}

}  // namespace exclusion_test
}  // namespace mixity
