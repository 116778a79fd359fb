// mixity instability as its users run it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <string>

#include "cli/run_program.h"

namespace mixity::cli {
namespace {

using Json = nlohmann::json;

constexpr double kPi = std::numbers::pi;

Json json_of(const Words& words) {
  const ProgramResult result = run_program(words);
  EXPECT_EQ(result.exit_code, 0) << joined(words) << result.err;
  return Json::parse(result.out);
}

std::set<std::string> keys_of(const Json& object) {
  std::set<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.insert(key);
  return keys;
}

TEST(InstabilityCommand, PrintsEveryFoldAsJson) {
  const Json report =
      json_of({"instability", "--model=c", "--lambda=0.15", "--load=3", "--stiffness=1", "--format=json"});
  for (const char* key : {"model", "lambda", "load", "folds"}) EXPECT_TRUE(report.contains(key)) << key;
  EXPECT_EQ(report["model"], "c");
  EXPECT_EQ(report["lambda"], 0.15);
  EXPECT_EQ(report["load"], 3);
  ASSERT_EQ(report["folds"].size(), 3u);
  const char* controls[] = {"load", "displacement", "stiffness"};
  for (std::size_t i = 0; i < 3; ++i) {
    const Json& fold = report["folds"][i];
    for (const char* key : {"control", "T", "u", "A", "psi", "jumps_to", "area_lost"})
      EXPECT_TRUE(fold.contains(key)) << key;
    EXPECT_EQ(fold["control"], controls[i]);
    EXPECT_EQ(fold["jumps_to"], "hertz");
    const double A = fold["A"], hertz = kPi * std::pow(0.75 * 3, 2.0 / 3);
    EXPECT_NEAR(fold["area_lost"].get<double>(), A - hertz, 1e-13);
  }
  // in full precision: the closed form of the load-control fold, a few roundings
  const double T = report["folds"][0]["T"], expected = std::sqrt(3 * kPi * (3 * kPi + 6) / 0.15);
  EXPECT_NEAR(T, expected, 1e-14 * expected);
  // u + T/k has its largest value between those of the other two controls
  const auto area = [&](int i) { return report["folds"][static_cast<std::size_t>(i)]["A"].get<double>(); };
  EXPECT_GT(area(0), area(2));
  EXPECT_GT(area(2), area(1));
}

TEST(InstabilityCommand, KeepsColumnsApartHoweverLongTheirNumbers) {
  const ProgramResult result =
      run_program({"instability", "--model=c", "--lambda=0.15", "--load=-4.7123889", "--stiffness=0.001234"});
  std::size_t seen = 0;
  for (const std::string& line : lines_of(result.out)) {
    if (!line.starts_with("    stiffness")) continue;
    ++seen;
    std::istringstream words(line);
    // the control is two words, and eight columns follow
    EXPECT_EQ(std::distance(std::istream_iterator<std::string>(words), {}), 9) << line;
  }
  EXPECT_GT(seen, 0u) << result.out << result.err;
}

TEST(InstabilityCommand, SaysThatASmoothContactHasNone) {
  const Json report = json_of({"instability", "--model=b", "--lambda=0.15", "--load=30", "--format=json"});
  EXPECT_TRUE(report["folds"].is_array() && report["folds"].empty());
  const ProgramResult text = run_program({"instability", "--model=b", "--lambda=0.15", "--load=30"});
  EXPECT_NE(text.out.find("none"), std::string::npos) << text.out;
}

TEST(InstabilityCommand, NamesTheJumpOfEachKind) {
  const auto first = [](const Words& words) { return json_of(words)["folds"][0]["jumps_to"].get<std::string>(); };
  EXPECT_EQ(first({"instability", "--model=c", "--lambda=0.15", "--load=-1", "--format=json"}), "off_contact");
  EXPECT_EQ(first({"instability", "--model=c", "--lambda=0.15", "--load=1", "--format=json"}), "hertz");
  const Json a = json_of({"instability", "--model=a", "--lambda=0.95", "--load=0", "--format=json"});
  ASSERT_EQ(a["folds"].size(), 2u);  // under load; none under displacement, by the brute-force tables
  EXPECT_EQ(a["folds"][0]["jumps_to"], "lower_branch");
  EXPECT_EQ(a["folds"][1]["jumps_to"], "upper_branch");
  EXPECT_LT(a["folds"][1]["area_lost"].get<double>(), 0);
}

TEST(InstabilityCommand, NamesTheParametersOfBk) {
  const Json report =
      json_of({"instability", "--model=bk", "--parameters=r=1.774,eta=2.284", "--load=1", "--format=json"});
  EXPECT_EQ(keys_of(report), (std::set<std::string>{"model", "r", "eta", "load", "folds"}));
}

}  // namespace
}  // namespace mixity::cli
