// mixity curve as its users run it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "cli/run_program.h"

namespace mixity::cli {
namespace command_curve_test {

constexpr double kPi = std::numbers::pi;

using Table = std::vector<std::vector<double>>;

/// Runs a command that must succeed without a word on stderr, and reads its CSV below the given header.
Table table_of(const Words& words, const std::string& header) {
  const ProgramResult result = run_program(words);
  EXPECT_EQ(result.exit_code, 0) << joined(words);
  EXPECT_EQ(result.err, "") << joined(words);
  const auto lines = lines_of(result.out);
  EXPECT_FALSE(lines.empty()) << joined(words);
  if (lines.empty()) return {};
  EXPECT_EQ(lines[0], header) << joined(words);
  Table table;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    table.emplace_back();
    for (const std::string& field : fields_of(lines[i])) table.back().push_back(std::stod(field));
  }
  return table;
}

constexpr const char* kCurveHeader = "phi,P,T,y,a,A,u,psi,f,stable";

/// Rows of the CSV obey the printed equation; the numbers are printed in full, so a few roundings remain.
TEST(CurveCommand, PrintsStatesInEquilibrium) {
  const Table table = table_of({"curve", "--model=c", "--lambda=0.15", "--load=3", "--points=33"}, kCurveHeader);
  ASSERT_EQ(table.size(), 33u);
  for (const auto& row : table) {
    ASSERT_EQ(row.size(), 10u);
    const double P = row[1], T = row[2], y = row[3], a = row[4];
    EXPECT_EQ(P, 3);
    EXPECT_NEAR(4.0 / 3 * a * a * a - P, y, 1e-13);
    EXPECT_NEAR(y * y + T * T, 8 * kPi * a * a * a * row[8], 1e-14 * 8 * kPi * a * a * a * row[8]);
    EXPECT_NEAR((y * y + T * T) / (y * y + 0.15 * T * T), row[8], 1e-13 * row[8]);  // the law
    EXPECT_NEAR(row[5], kPi * a * a, 1e-13);
    EXPECT_NEAR(row[6], 0.75 * T / a, 1e-13);
    EXPECT_NEAR(row[7], std::atan2(T, y), 1e-14);
    EXPECT_EQ(row[9], y > 3 * kPi - 1e-9 ? 1 : 0);  // model c is stable above the top of the circle
  }
  EXPECT_EQ(table.front()[2], 0);          // JKR
  EXPECT_NEAR(table.back()[3], 0, 1e-13);  // Hertz
}

TEST(CurveCommand, PrintsEitherSoManyPointsOrAsFewAsTheChordAllows) {
  const Words base{"curve", "--model=b", "--lambda=0.15", "--load=3"};
  const auto rows = [&](const std::string& flag) {
    Words words = base;
    words.push_back(flag);
    return table_of(words, kCurveHeader).size();
  };
  EXPECT_EQ(rows("--points=2"), 2u);
  EXPECT_EQ(rows("--points=77"), 77u);
  EXPECT_LT(rows("--chord=1e-2"), rows("--chord=1e-4"));
  EXPECT_LT(rows("--chord=1e-3"), 60u);
}

TEST(CurveCommand, IsOnePointWhereShearDoesNotAct) {
  for (const char* how : {"--points=7", "--chord=0.01"})
    EXPECT_EQ(table_of({"curve", "--model=c", "--lambda=0", "--load=1", how}, kCurveHeader).size(), 1u);
}

TEST(CurveCommand, RefusesACurveThatLeavesTheNumbers) {
  for (const char* lambda : {"--lambda=1e-300", "--lambda=1e-320"})
    for (const char* how : {"--points=5", "--chord=0.01"})
      expect_refused({"curve", "--model=c", lambda, "--load=1", how}, 2,
                     "the curve reaches tangential loads above 1e150, which cannot be computed");
}

TEST(CurveCommand, PrintsTheOtherViewAtConstantShear) {
  const Table table =
      table_of({"curve", "--model=c", "--lambda=0.15", "--shear=20", "--points=50"}, "P,T,y,a,A,stable");
  ASSERT_EQ(table.size(), 50u);
  for (const auto& row : table) {
    const double P = row[0], T = row[1], y = row[2], a = row[3];
    EXPECT_EQ(T, 20);
    EXPECT_NEAR(y * y + 0.15 * T * T, 6 * kPi * (y + P), 1e-14 * (y * y + 60));
    EXPECT_NEAR(4.0 / 3 * a * a * a, y + P, 1e-13 * (y + P));
    EXPECT_NEAR(row[4], kPi * a * a, 1e-13 * row[4]);
    EXPECT_EQ(row[5], y > 3 * kPi ? 1 : 0);
  }
  EXPECT_EQ(table.front()[5], 0);
  EXPECT_EQ(table.back()[5], 1);
}

TEST(CurveCommand, PrintsDimensionalColumnsWithTheirUnits) {
  const Words contact{"--radius=9.42 mm", "--modulus=2.133 MPa", "--toughness=27 mJ/m^2"};
  Words words{"curve", "--model=c", "--lambda=0.15", "--load=1 mN", "--points=3"};
  words.insert(words.end(), contact.begin(), contact.end());
  const Table table = table_of(words, "phi,P [mN],T [mN],y [mN],a [mm],A [mm^2],u [mm],psi [rad],f,stable");
  ASSERT_EQ(table.size(), 3u);
  for (const auto& row : table) {
    // 4/3 E* a^3/R - P = y, in mN and mm: E* is 2133 mN/mm^2
    EXPECT_NEAR(4.0 / 3 * 2133 * std::pow(row[4], 3) / 9.42 - row[1], row[3], 1e-11);
    EXPECT_EQ(row[1], 1);
  }
}

}  // namespace command_curve_test
}  // namespace mixity::cli
