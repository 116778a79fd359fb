// mode_III, in every command that knows a tangential load, as users run it.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "averaged_mode_III.h"
#include "cli/run_program.h"
#include "dataset/dataset.h"

namespace mixity::cli {
namespace mode_III_test {

const Words kContact{"--radius=9.42 mm", "--modulus=2.133 MPa", "--toughness=27 mJ/m^2"};

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::string out_of(const Words& words) {
  const ProgramResult result = run_program(words);
  EXPECT_EQ(result.exit_code, 0) << joined(words) << result.err;
  return result.out;
}

/// Columns by name; fields without a number are NaN.
std::map<std::string, std::vector<double>> columns_of(const Words& words) {
  const auto lines = lines_of(out_of(words));
  std::map<std::string, std::vector<double>> columns;
  const auto names = fields_of(lines.at(0));
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto fields = fields_of(lines[i]);
    for (std::size_t k = 0; k < names.size(); ++k) {
      char* end = nullptr;
      const double value = std::strtod(fields.at(k).c_str(), &end);
      columns[names[k]].push_back(end != fields[k].c_str() && *end == 0 ? value : std::nan(""));
    }
  }
  return columns;
}

/// Model c at lambda averaged is model c at 1.5 lambda by half, but for psi and f. A few roundings remain; those of y
/// next to Hertz are of the size of 4/3 a^3.
void expect_same_states(const Words& command, const std::vector<std::string>& but_for = {"psi [rad]", "f", "phi"}) {
  const auto averaged = columns_of(with(command, {"--lambda=0.2", "--mode_III=averaged"})),
             half = columns_of(with(command, {"--lambda=0.3", "--mode_III=half"})),
             unstated = columns_of(with(command, {"--lambda=0.3"}));
  for (const auto& [name, values] : averaged) {
    if (std::find(but_for.begin(), but_for.end(), name) != but_for.end()) continue;
    ASSERT_EQ(values.size(), half.at(name).size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (std::isnan(values[i]) && std::isnan(half.at(name)[i])) continue;
      EXPECT_NEAR(values[i], half.at(name)[i], 1e-12 * std::max(1.0, std::abs(values[i])))
          << joined(command) << name << i;
      EXPECT_EQ(half.at(name)[i], unstated.at(name)[i]) << joined(command) << name;
    }
  }
}

TEST(ModeIIIOfCommands, PredictionsAndCurvesAreInTrueShears) {
  for (const Words& contact : {Words{}, kContact}) {
    expect_same_states(with({"predict", "--model=c", "--load=3", "--shear=0,1,2,5,9,40"}, contact),
                       {"psi [rad]", "psi", "f"});
    expect_same_states(with({"curve", "--model=c", "--load=3", "--points=40"}, contact), {"psi [rad]", "psi", "f"});
  }
}

TEST(ModeIIIOfCommands, PredictedAreasAreThoseOfTheAveragedCriterion) {
  for (const auto& [model, lambda] : {std::pair("a", 0.3), std::pair("b", 0.4), std::pair("c", 0.2)}) {
    const auto found = columns_of({"predict", std::string("--model=") + model, "--lambda=" + std::to_string(lambda),
                                   "--load=3", "--shear=0,2,5", "--mode_III=averaged"});
    for (std::size_t i = 0; i < 3; ++i) {
      const double T = found.at("T")[i], y = found.at("y")[i], a = found.at("a")[i];
      EXPECT_NEAR(found.at("A")[i], averaged_area(model, lambda, 1.5, 3, T), 1e-12);
      EXPECT_NEAR(std::tan(found.at("psi")[i]), std::sqrt(1.5) * T / y, 1e-13);
      EXPECT_NEAR(found.at("u")[i], 0.75 * T / a, 1e-14);
      EXPECT_NEAR(found.at("f")[i], averaged_law(model, lambda, found.at("psi")[i]), 1e-12);
    }
  }
}

TEST(ModeIIIOfCommands, RadiiAtAShearAreThoseOfTheAveragedCriterion) {
  const auto found =
      columns_of({"curve", "--model=b", "--lambda=0.4", "--shear=4", "--points=9", "--mode_III=averaged"});
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(found.at("T")[i], 4);
    const double a = found.at("a")[i], size = 8 * std::numbers::pi * a * a * a;
    EXPECT_NEAR(averaged_excess("b", 0.4, 1.5, found.at("P")[i], 4, a) / size, 0, 1e-12);
  }
}

TEST(ModeIIIOfCommands, MapsAreOfTrueShears) {
  const Words map{"map", "--model=c", "--grid=2", "--load_range=1,9", "--tau0=2"};
  const auto averaged = columns_of(with(map, {"--lambda_range=0.1,0.2", "--mode_III=averaged"})),
             half = columns_of(with(map, {"--lambda_range=0.15,0.3"}));
  for (const char* name : {"T_end", "T_strength"})
    for (std::size_t i = 0; i < 4; ++i) {
      if (std::isnan(half.at(name)[i]) && std::isnan(averaged.at(name)[i])) continue;
      EXPECT_NEAR(averaged.at(name)[i], half.at(name)[i], 1e-12 * half.at(name)[i]) << name;
    }
  EXPECT_EQ(averaged.at("regime"), half.at("regime"));
}

TEST(ModeIIIOfCommands, FoldsAreInTrueShears) {
  const auto folds = [](const Words& more) {
    return nlohmann::json::parse(
        out_of(with({"instability", "--model=c", "--load=3 mN", "--stiffness=50 N/m", "--format=json"},
                    with(kContact, more))))["folds"];
  };
  const auto averaged = folds({"--lambda=0.2", "--mode_III=averaged"}), half = folds({"--lambda=0.3"});
  ASSERT_EQ(averaged.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
    for (const char* name : {"T", "u", "A", "area_lost"})
      EXPECT_NEAR(averaged[i][name].get<double>(), half[i][name].get<double>(), 1e-11) << name;
}

TEST(ModeIIIOfCommands, FoldsNameIt) {
  const Words command{"instability", "--model=c", "--lambda=0.2", "--load=3"};
  const Words averaged{"--mode_III=averaged", "--poisson_ratio=0.3"};
  EXPECT_NE(out_of(with(command, averaged)).find(", mode III averaged (kappa = 1.21429 at nu = 0.3)"),
            std::string::npos);
  EXPECT_EQ(out_of(command).find("mode III"), std::string::npos);
  const auto json = [&](const Words& more) {
    return nlohmann::json::parse(out_of(with(with(command, {"--format=json"}), more)));
  };
  EXPECT_EQ(json(averaged)["mode_III"], "averaged");
  EXPECT_EQ(json({})["mode_III"], "half");
}

TEST(ModeIIIOfCommands, PoissonsRatioOfAContactEnters) {
  const Words command{"predict", "--model=b", "--load=3", "--shear=0,2,5", "--lambda=0.4"};
  const auto at = [&](const Words& more) { return columns_of(with(command, more)).at("A"); };
  EXPECT_EQ(at({"--mode_III=averaged", "--poisson_ratio=0"}), at({}));  // kappa = 1
  EXPECT_EQ(at({"--mode_III=averaged", "--poisson_ratio=0.5"}), at({"--mode_III=averaged"}));
  EXPECT_GT(at({"--mode_III=averaged", "--poisson_ratio=0.3"})[2], at({"--mode_III=averaged"})[2]);
  expect_refused(with(command, {"--mode_III=half", "--poisson_ratio=0.3"}), 3,
                 "--poisson_ratio: needs youngs_modulus, too");
}

TEST(ModeIIIOfCommands, WhatIsSimulatedIsFitted) {
  const TemporaryFolder folder;
  for (const char* model : {"a", "b", "c"}) {
    const std::string data = folder.path(std::string(model) + ".csv");
    out_of(with({"simulate", std::string("--model=") + model, "--lambda=0.2", "--loads=1,4,8 mN", "--sigma_T=1e-9%",
                 "--sigma_A=1e-9%", "--mode_III=averaged", "--poisson_ratio=0.4", "--out=" + data},
                kContact));
    // 1e-9: the noise is 1e-11
    for (const Point& q : load_dataset(data).points)
      EXPECT_NEAR(averaged_area(model, 0.2, 1.6 / 1.2, q.P, q.T), q.A, 1e-9 * q.A) << model;
    // the TOML that simulate writes has the convention and Poisson's ratio
    const auto fit = [&](const Words& more) {
      return nlohmann::json::parse(
          out_of(with({"fit", data, std::string("--models=") + model, "--format=json"}, more)))["datasets"][0];
    };
    const auto averaged = fit({});
    EXPECT_EQ(averaged["mode_III"], "averaged");
    EXPECT_NEAR(averaged["kappa"].get<double>(), 1.6 / 1.2, 1e-15);
    EXPECT_NEAR(averaged["fits"][0]["parameters"]["lambda"]["value"].get<double>(), 0.2, 1e-9) << model;
  }
}

TEST(ModeIIIOfCommands, EveryTextOfAFitNamesIt) {
  const TemporaryFolder folder;
  const std::string data = MIXITY_ROOT "/data/mergel2018.csv";
  for (const auto& [flag, text] :
       {std::pair("--mode_III=half", "mode III half\n"), std::pair("--note=none", "mode III half\n"),
        std::pair("--mode_III=averaged", "mode III averaged (kappa = 1.5 at nu = 0.5, not stated)")})
    EXPECT_NE(out_of({"fit", data, "--models=c", flag}).find(text), std::string::npos) << flag;
  EXPECT_NE(out_of({"check", data, "--mode_III=averaged"}).find("mode III        averaged (kappa"), std::string::npos);
  EXPECT_NE(out_of(with({"design", "--model=c", "--lambda=0.1", "--loads=1,4 mN", "--mode_III=averaged"}, kContact))
                .find("mode III averaged (kappa = 1.5"),
            std::string::npos);
  const std::string page = folder.path("page");
  out_of({"report", data, "--models=c", "--mode_III=averaged", "--out=" + page});
  EXPECT_NE(content_of(page + "/report.html").find("Mode III at the edge: averaged (kappa = 1.5"), std::string::npos);
  EXPECT_NE(content_of(page + "/summary.md").find("Mode III at the edge: averaged"), std::string::npos);
  EXPECT_NE(content_of(page + "/results.json").find("\"mode_III\": \"averaged\""), std::string::npos);
}

TEST(ModeIIIOfCommands, PredictionsOfAFitAreInReadings) {
  const std::string data = MIXITY_ROOT "/data/mergel2018.csv";
  const auto at = [&](const char* command, const Words& more) {
    return columns_of(with({command, data, "--model=c"}, more));
  };
  const Words shears{"--loads=4", "--shear=0,2,5"}, averaged{"--mode_III=averaged"};
  // lambda differs by the rounding of its minimum
  const auto same = [](const auto& one, const auto& other, const char* name) {
    ASSERT_EQ(one.at(name).size(), other.at(name).size());
    for (std::size_t i = 0; i < one.at(name).size(); ++i)
      EXPECT_NEAR(one.at(name)[i], other.at(name)[i], 1e-6 * std::abs(one.at(name)[i])) << name;
  };
  for (const char* name : {"T [mN]", "A [mm^2]", "A_stderr [mm^2]"})
    same(at("predict", shears), at("predict", with(shears, averaged)), name);
  for (const char* name : {"T [mN]", "A [mm^2]"})
    same(at("curve", {"--loads=4", "--points=9"}), at("curve", with(averaged, {"--loads=4", "--points=9"})), name);
}

TEST(ModeIIIOfCommands, ADefinitionKeepsPoissonsRatioBesideAnotherModulus) {
  const TemporaryFolder folder;
  folder.write("lab.toml",
               "radius = \"9.42 mm\"\nyoungs_modulus = \"1.6 MPa\"\npoisson_ratio = 0.3\ntoughness = \"27 mJ/m^2\"\n"
               "mode_III = \"averaged\"\n");
  const std::string data = folder.write("a.csv", "P [mN],T [mN],A [mm^2]\n4,0,0.353\n4,2,0.350\n4,4,0.34\n4,6,0.33\n"),
                    fit = folder.write(
                        "fit.toml",
                        "data = \"a.csv\"\n[constants]\nradius = \"9.42 mm\"\nyoungs_modulus = \"1.6 MPa\"\n"
                        "poisson_ratio = 0.3\ntoughness = \"27 mJ/m^2\"\nmode_III = \"averaged\"\n");
  for (const Words& words : {Words{"fit", data, "--definition=" + folder.path("lab.toml")}, Words{"fit", fit}}) {
    const auto set = nlohmann::json::parse(
        run_program(with(words, {"--modulus=2.133 MPa", "--models=c", "--format=json"})).out)["datasets"][0];
    EXPECT_NEAR(set["kappa"].get<double>(), 1.7 / 1.4, 1e-15) << joined(words);
  }
}

}  // namespace mode_III_test
}  // namespace mixity::cli
