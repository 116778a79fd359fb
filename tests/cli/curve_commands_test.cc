// mixity curve, instability and map as their users run them.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/run_program.h"

namespace mixity::cli {
namespace {

using Json = nlohmann::json;

const double kPi = 3.14159265358979323846;

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

// ---- curve ----

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

// ---- instability ----

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

// ---- map ----

TEST(MapCommand, PrintsTheGridOfRegimes) {
  const ProgramResult result = run_program({"map", "--model=b", "--grid=5", "--load_range=1,9", "--lambda_range=0,1"});
  EXPECT_EQ(result.exit_code, 0);
  const auto lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 26u);
  EXPECT_EQ(lines[0], "P,lambda,regime,fracture,T_end,jumps_to,T_strength");
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto fields = fields_of(lines[i]);
    ASSERT_EQ(fields.size(), 7u) << lines[i];
    const double P = std::stod(fields[0]), lambda = std::stod(fields[1]);
    const double kc = (1 - lambda / 2) * std::cos(kPi * lambda / 4), P_c = 1.5 * kPi / (kc * kc);
    EXPECT_EQ(fields[2], lambda == 0 ? "1" : P < P_c ? "3" : "2") << lines[i];
    EXPECT_EQ(fields[3], fields[2]);
    EXPECT_EQ(fields[5], lambda > 0 && P < P_c ? "hertz" : "") << lines[i];
    EXPECT_EQ(fields[6], "");
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

// ---- all of them ----

/// No output at any input holds anything that is no finite number.
TEST(CurveCommands, NeverPrintNanOrInfinity) {
  const Words loads{"-4.71238898038469", "-4.7", "-1", "-1e-300", "0", "1e-300", "1", "30.4", "1e8"};
  const Words models{"--model=a", "--model=b", "--model=c", "--model=bk"};
  const Words lambdas{"--lambda=0", "--lambda=1e-300", "--lambda=1e-12", "--lambda=0.15", "--lambda=0.9999999999999999",
                      "--lambda=1"};
  const Words pairs{"--parameters=r=1.774,eta=2.284", "--parameters=r=2,eta=1", "--parameters=r=1e-3,eta=0.1"};
  const auto check = [](const Words& words) {
    const ProgramResult result = run_program(words);
    EXPECT_EQ(result.exit_code, 0) << joined(words) << result.err;
    EXPECT_EQ(result.err, "") << joined(words);
    for (const std::string& line : lines_of(result.out))
      for (const char* bad : {"nan", "NaN", "inf", "null"}) {
        if (line.find(bad) == std::string::npos) continue;
        ADD_FAILURE() << joined(words) << "prints " << line;
        return;
      }
  };
  for (const std::string& model : models)
    for (const std::string& parameter : model == "--model=bk" ? pairs : lambdas) {
      for (const std::string& load : loads) {
        check({"curve", model, parameter, "--load=" + load, "--points=33"});
        check({"curve", model, parameter, "--load=" + load, "--chord=1e-3"});
        check({"instability", model, parameter, "--load=" + load, "--stiffness=1", "--format=json"});
      }
      for (const char* shear : {"--shear=0", "--shear=1e-300", "--shear=10", "--shear=1e150"})
        check({"curve", model, parameter, shear, "--points=33"});
    }
  for (const Words& map :
       std::vector<Words>{{"map", "--model=a"}, {"map", "--model=b", "--lambda_range=0,2"}, {"map", "--model=c"}})
    for (const char* flag : {"--boundaries", "--tau0=1e-150", "--tau0=1", "--tau0=1e150"}) {
      Words words = map;
      words.insert(words.end(), {"--grid=9", "--load_range=-4.71238898038469,1e8", flag});
      check(words);
    }
}

TEST(CurveCommands, RefuseBadUsageInOneLineWithExitTwo) {
  for (const Words& words : std::vector<Words>{
           {"curve", "--lambda=0.15", "--load=1"},
           {"curve", "--model=z", "--lambda=0.15", "--load=1"},
           {"curve", "--model=c", "--load=1"},
           {"curve", "--model=c", "--lambda=1.5", "--load=1"},
           {"curve", "--model=c", "--lambda=nan", "--load=1"},
           {"curve", "--model=c", "--lambda=0.15"},
           {"curve", "--model=c", "--lambda=0.15", "--load=1", "--shear=1"},
           {"curve", "--model=c", "--lambda=0.15", "--load=-5"},
           {"curve", "--model=c", "--lambda=0.15", "--load=nan"},
           {"curve", "--model=c", "--lambda=0.15", "--load=1e300"},
           {"curve", "--model=c", "--lambda=0.15", "--load=1,2"},
           {"curve", "--model=c", "--lambda=0.15", "--load="},
           {"curve", "--model=c", "--lambda=0.15", "--load=1 mN"},
           {"curve", "--model=c", "--lambda=0.15", "--shear=-1"},
           {"curve", "--model=c", "--lambda=0.15", "--load=1", "--points=1"},
           {"curve", "--model=c", "--lambda=0.15", "--load=1", "--points=-5"},
           {"curve", "--model=c", "--lambda=0.15", "--load=1", "--points=x"},
           {"curve", "--model=c", "--lambda=0.15", "--load=1", "--chord=0"},
           {"curve", "--model=c", "--lambda=0.15", "--load=1", "--chord=nan"},
           {"curve", "--model=bk", "--parameters=r=9,eta=2", "--load=1"},
           {"curve", "--model=bk", "--parameters=r=9,eta=2", "--shear=1"},
           {"curve", "--model=c", "--lambda=0.15", "--load=1", "file.csv"},
           {"instability", "--model=c", "--lambda=0.15"},
           {"instability", "--model=c", "--lambda=0.15", "--load=-4.72"},
           {"instability", "--model=c", "--lambda=0.15", "--load=1", "--stiffness=0"},
           {"instability", "--model=c", "--lambda=0.15", "--load=1", "--stiffness=-1"},
           {"instability", "--model=c", "--lambda=0.15", "--load=1", "--format=csv"},
           {"instability", "--model=bk", "--parameters=r=9,eta=2", "--load=1"},
           {"map"},
           {"map", "--model=bk"},
           {"map", "--model=c", "--grid=1"},
           {"map", "--model=c", "--load_range=3,1"},
           {"map", "--model=c", "--load_range=-5,1"},
           {"map", "--model=c", "--load_range=1"},
           {"map", "--model=c", "--lambda_range=0,2"},
           {"map", "--model=c", "--lambda_range=0,nan"},
           {"map", "--model=c", "--tau0=0"},
           {"map", "--model=c", "--tau0=x"},
       }) {
    const ProgramResult result = run_program(words);
    EXPECT_EQ(result.exit_code, 2) << joined(words);
    EXPECT_EQ(lines_of(result.err).size(), 1u) << joined(words) << result.err;
    EXPECT_TRUE(result.err.starts_with("mixity: ")) << result.err;
    EXPECT_EQ(result.out, "") << joined(words);
  }
}

}  // namespace
}  // namespace mixity::cli
