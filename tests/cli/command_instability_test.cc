// mixity instability as its users run it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "cli/run_program.h"
#include "dataset/temporary_folder.h"

namespace mixity::cli {
namespace command_instability_test {

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
    if (line.find(" stiffness ") == std::string::npos) continue;
    ++seen;
    std::istringstream words(line);
    // the load, the control in two words, and seven columns
    EXPECT_EQ(std::distance(std::istream_iterator<std::string>(words), {}), 10) << line;
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

/// The same contact with and without units, and as it is fitted to areas that it has.
TEST(InstabilityCommand, SpeaksInTheUnitsOfTheConstantsOrOfTheData) {
  const Words constants{"--radius=9.42 mm", "--modulus=2.133 MPa", "--toughness=27 mJ/m^2"};
  const auto with = [&](Words words) {
    words.insert(words.end(), constants.begin(), constants.end());
    return words;
  };
  const double force = 9.42 * 27e-3, xi = std::cbrt(2.133e6 * 9.42e-3 / 27e-3);  // mN
  const Json bare = json_of({"instability", "--model=c", "--lambda=0.01", "--load=" + std::to_string(4 / force),
                             "--stiffness=" + std::to_string(1200 / (xi * xi * 27e-3)), "--format=json"}),
             in_units = json_of(with({"instability", "--model=c", "--lambda=0.01", "--load=4 mN", "--units=mN,um",
                                      "--stiffness=1200 N/m", "--format=json"}));
  EXPECT_EQ(in_units["units"]["displacement"], "um");
  ASSERT_EQ(in_units["folds"].size(), 3u);
  const double um = 9.42e3 / (xi * xi);
  for (std::size_t i = 0; i < 3; ++i) {  // the numbers of the bare command are cut at six decimals
    EXPECT_NEAR(in_units["folds"][i]["T"].get<double>(), force * bare["folds"][i]["T"].get<double>(), 1e-5);
    EXPECT_NEAR(in_units["folds"][i]["u"].get<double>(), um * bare["folds"][i]["u"].get<double>(), 1e-4);
  }
  EXPECT_NEAR(in_units["folds"][2]["stiffness"].get<double>(), 1200, 1e-9);

  const TemporaryFolder folder;
  std::string csv = "P [mN],T [mN],A [mm^2]\n";
  const ProgramResult areas = run_program(with({"predict", "--model=c", "--lambda=0.01", "--load=4 mN",
                                                "--shear=0,10,15,20,25,30,33,36,38 mN", "--units=mN,mm"}));
  for (const std::string& line : lines_of(areas.out)) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
    // a thousandth up and down in turn: exact areas would have no errors to speak of
    if (cells[0] == "4")
      csv += "4," + cells[1] + ',' + std::to_string(std::stod(cells[4]) * (csv.size() % 2 ? 1.001 : 0.999)) + '\n';
  }
  const std::string data = folder.write("run.csv", csv);
  const Json fitted = json_of(with({"instability", data, "--models=c", "--checks=false", "--format=json"}));
  const Json& fold = fitted["loads"][0]["folds"][0];
  EXPECT_DOUBLE_EQ(fitted["loads"][0]["load"].get<double>(), 4);
  EXPECT_EQ(fitted["units"]["force"], "mN");
  EXPECT_GT(fold["T_stderr"].get<double>(), 0);
  EXPECT_NEAR(fold["T"].get<double>(), in_units["folds"][0]["T"].get<double>(), 4 * fold["T_stderr"].get<double>());
  const ProgramResult beyond =
      run_program(with({"predict", data, "--models=c", "--checks=false", "--loads=4 mN", "--shear=10,500 mN"}));
  EXPECT_EQ(lines_of(beyond.out).at(0), "P [mN],T [mN],A [mm^2],A_stderr [mm^2],status");
  EXPECT_TRUE(lines_of(beyond.out).at(2).ends_with(",,,no_equilibrium")) << beyond.out;
  expect_refused(with({"instability", data, "--loads=4 mm"}), 2, "flag '--loads' must be forces such as \"3, 8 mN\"");
  EXPECT_EQ(run_program(with({"instability", data, "--load=4 mN"})).out,
            run_program(with({"instability", data, "--loads=4 mN"})).out);
  expect_refused(
      {"instability", "--model=c", "--lambda=0.1", "--load=1", "--stiffness=1 N/m"}, 2,
      "flag '--stiffness' is '1 N/m'; it must be a number; a unit needs --radius, --modulus and --toughness");
}

TEST(InstabilityCommand, NamesTheParametersOfBk) {
  const Json report =
      json_of({"instability", "--model=bk", "--parameters=r=1.774,eta=2.284", "--load=1", "--format=json"});
  EXPECT_EQ(keys_of(report), (std::set<std::string>{"model", "r", "eta", "load", "folds", "mode_III"}));
}

TEST(InstabilityCommand, SaysWhereTheInterfaceSlidesBeforeItJumps) {
  const std::string data = MIXITY_ROOT "/data/mergel2018.csv";
  const ProgramResult told = run_program({"instability", data, "--shear_strength=0.1 MPa", "--loads=4 mN"});
  EXPECT_NE(told.out.find("the interface slides first"), std::string::npos) << told.out;
  const auto json = nlohmann::json::parse(
      run_program({"instability", data, "--shear_strength=0.1 MPa", "--loads=4 mN", "--format=json"}).out);
  EXPECT_EQ(json["slides_first"], nlohmann::json({4.0}));
  const auto strong = nlohmann::json::parse(
      run_program({"instability", data, "--shear_strength=10 MPa", "--loads=4 mN", "--format=json"}).out);
  EXPECT_EQ(strong["slides_first"], nlohmann::json::array());
}

TEST(InstabilityCommand, HasTheFoldsOfAHeldApproach) {
  const Words contact{"--model=c", "--lambda=0.05", "--approach=3", "--normal_stiffness=2"};
  const auto with = [&](Words words, const Words& more) {
    words.insert(words.end(), contact.begin(), contact.end());
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  const Json report = json_of(with({"instability"}, {"--format=json"}));
  EXPECT_EQ(report["control"], "approach");
  EXPECT_EQ(report["load"], 3.0);
  ASSERT_EQ(report["folds"].size(), 2u);
  // 6 digits, as `predict` says it of the same contact
  const ProgramResult predicted = run_program(with({"predict"}, {"--shear=200"}));
  const std::size_t at = predicted.err.find("jumps at T = ");
  ASSERT_NE(at, std::string::npos) << predicted.err;
  EXPECT_NEAR(report["folds"][0]["T"], std::strtod(predicted.err.c_str() + at + 13, nullptr), 1e-4);
  EXPECT_GT(report["folds"][1]["u"], report["folds"][0]["u"]);
  EXPECT_EQ(run_program({"instability", MIXITY_ROOT "/data/mergel2018.csv", "--approach=3 um"}).exit_code, 2);
}

Words of_ellipse(const Words& more) {
  Words words{"instability", "--shape=ellipse", "--poisson_ratio=0.5"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(InstabilityCommand, HasTheFoldsOfEllipses) {
  const Json report =
      json_of(of_ellipse({"--model=c", "--lambda_II=0.008", "--lambda_III=0", "--load=3", "--format=json"}));
  EXPECT_EQ(report["model"], "c-ellipse");
  ASSERT_EQ(report["folds"].size(), 2u);
  // 6 digits, as `predict` says it of the same contact
  const ProgramResult predicted = run_program({"predict", "--shape=ellipse", "--poisson_ratio=0.5", "--model=c",
                                               "--lambda_II=0.008", "--lambda_III=0", "--load=3", "--shear=180"});
  const std::size_t at = predicted.err.find("jumps at T = ");
  ASSERT_NE(at, std::string::npos) << predicted.err;
  const double T = std::strtod(predicted.err.c_str() + at + 13, nullptr);
  EXPECT_NEAR(report["folds"][0]["T"], T, 1e-3);
  EXPECT_GT(report["folds"][1]["u"], report["folds"][0]["u"]);
  // through a spring the jump comes between those of a held load and a held displacement
  const Json through = json_of(
      of_ellipse({"--model=c", "--lambda_II=0.008", "--lambda_III=0", "--load=3", "--stiffness=1", "--format=json"}));
  ASSERT_EQ(through["folds"].size(), 3u);
  EXPECT_EQ(through["folds"][2]["control"], "stiffness");
  EXPECT_GT(through["folds"][0]["A"], through["folds"][2]["A"]);
  EXPECT_GT(through["folds"][2]["A"], through["folds"][1]["A"]);
}

TEST(InstabilityCommand, SaysWhereTheEdgeOfAnEllipseCloses) {
  const Words contact{"--model=b", "--lambda_II=0.8", "--lambda_III=0.2", "--load=300"};
  Words as_json = contact;
  as_json.emplace_back("--format=json");
  const Json report = json_of(of_ellipse(as_json));
  EXPECT_TRUE(report["folds"].empty());
  ASSERT_EQ(report["closings"].size(), 2u);
  EXPECT_EQ(report["closings"][0]["end"], "closes_along");
  const std::string text = run_program(of_ellipse(contact)).out;
  EXPECT_NE(text.find("the edge closes or slips at the ends of a"), std::string::npos) << text;
  EXPECT_EQ(text.find("none"), std::string::npos) << text;
}

TEST(InstabilityCommand, KeepsTheShapeOfAFitWhoseModelIsNamed) {
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/ellipses.csv";
  const Words constants{"--radius=9.42 mm", "--modulus=2.133 MPa", "--toughness=27 mJ/m^2"};
  Words simulate{"simulate",         "--shape=ellipse",  "--model=b",
                 "--lambda_II=0.8",  "--lambda_III=0.2", "--poisson_ratio=0.5",
                 "--loads=50,80 mN", "--sigma_A=0.5%",   "--sigma_T=0.5%",
                 "--seed=1",         "--reach=0.9",      "--out=" + path};
  simulate.insert(simulate.end(), constants.begin(), constants.end());
  ASSERT_EQ(run_program(simulate).exit_code, 0);
  const Json report = json_of({"instability", path, "--shape=ellipse", "--model=b", "--format=json"});
  EXPECT_EQ(report["model"], "b-ellipse");
  ASSERT_EQ(report["loads"].size(), 2u);
  for (const Json& load : report["loads"]) {
    const Json& closing = load["closings"].at(0);
    const double T = closing["T"], error = closing["T_stderr"];
    EXPECT_GT(error, 0);
    EXPECT_LT(error, 0.02 * T);  // lambda is known to a percent
  }
}

}  // namespace command_instability_test
}  // namespace mixity::cli
