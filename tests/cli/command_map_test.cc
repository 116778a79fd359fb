// mixity map as its users run it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "cli/run_program.h"

namespace mixity::cli {
namespace command_map_test {

constexpr double kPi = std::numbers::pi;

TEST(MapCommand, PrintsTheGridOfRegimes) {
  const ProgramResult result = run_program({"map", "--model=b", "--grid=5", "--load_range=1,9", "--lambda_range=0,1"});
  EXPECT_EQ(result.exit_code, 0);
  const auto lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 26u);
  EXPECT_EQ(lines[0], "P,lambda,regime,fracture,T_end,jumps_to,T_strength,regime_name,fracture_name");
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto fields = fields_of(lines[i]);
    ASSERT_EQ(fields.size(), 9u) << lines[i];
    const double P = std::stod(fields[0]), lambda = std::stod(fields[1]);
    const double kc = (1 - lambda / 2) * std::cos(kPi * lambda / 4), P_c = 1.5 * kPi / (kc * kc);
    EXPECT_EQ(fields[2], lambda == 0 ? "1" : P < P_c ? "3" : "2") << lines[i];
    EXPECT_EQ(fields[3], fields[2]);
    EXPECT_EQ(fields[5], lambda > 0 && P < P_c ? "hertz" : "") << lines[i];
    EXPECT_EQ(fields[6], "");
    EXPECT_EQ(fields[7], lambda == 0 ? "shrinks" : P < P_c ? "jumps" : "reaches_hertz") << lines[i];
    EXPECT_EQ(fields[8], fields[7]);
  }
}

TEST(MapCommand, PrintsTheStrengthIfAsked) {
  const ProgramResult result =
      run_program({"map", "--model=c", "--grid=3", "--load_range=0,30", "--lambda_range=0,1", "--tau0=1e-3"});
  const auto lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 10u);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto fields = fields_of(lines[i]);
    EXPECT_EQ(fields[2], "4") << lines[i];  // so weak an interface slides first
    EXPECT_EQ(fields[7], "slides_first") << lines[i];
    EXPECT_NE(fields[8], fields[7]) << lines[i];
    const double P = std::stod(fields[0]), S0 = std::sqrt(9 * kPi * kPi + 6 * kPi * P);
    const double A0 = kPi * std::pow(0.75 * (P + 3 * kPi + S0), 2.0 / 3);
    EXPECT_NEAR(std::stod(fields[6]), 1e-3 * A0, 1e-5 * 1e-3 * A0);  // A differs from A0 by alpha T^2, 1e-6
  }
}

TEST(MapCommand, PrintsTheExactBoundaries) {
  const Words base{"map", "--boundaries", "--grid=11", "--load_range=-4,40"};
  const auto lines_for = [&](const std::string& model) {
    Words words = base;
    words.push_back("--model=" + model);
    const ProgramResult result = run_program(words);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    auto lines = lines_of(result.out);
    EXPECT_EQ(lines[0], "boundary,P,lambda");
    lines.erase(lines.begin());
    return lines;
  };
  int jumps = 0, off = 0;
  for (const std::string& line : lines_for("b")) {
    const auto fields = fields_of(line);
    const double P = std::stod(fields[1]), lambda = std::stod(fields[2]);
    const double kc = (1 - lambda / 2) * std::cos(kPi * lambda / 4);
    if (fields[0] == "jump") {
      EXPECT_NEAR(P, 1.5 * kPi / (kc * kc), 1e-14 * P);
      ++jumps;
    } else {
      EXPECT_EQ(fields[0], "off_contact");
      EXPECT_EQ(P, 0);
      ++off;
    }
  }
  EXPECT_EQ(jumps, 11);
  EXPECT_GE(off, 10);
  jumps = off = 0;
  for (const std::string& line : lines_for("a")) {
    const auto fields = fields_of(line);
    const double P = std::stod(fields[1]), lambda = std::stod(fields[2]);
    if (fields[0] == "off_contact") {
      EXPECT_NEAR(lambda, 1 + 2 * P / (3 * kPi), 1e-15);
      ++off;
    } else {
      EXPECT_EQ(fields[0], "jump");
      if (P < -0.75) {
        EXPECT_NEAR(lambda, 1 + 2 * P / (3 * kPi), 1e-15);  // on the closing line
      } else {
        EXPECT_GT(lambda, 27.0 / 32);
      }
      ++jumps;
    }
  }
  EXPECT_EQ(jumps, 11);
  EXPECT_GE(off, 1);
}

}  // namespace command_map_test
}  // namespace mixity::cli
