// mixity design and mixity simulate as a user meets them.
#include <gtest/gtest.h>

#include "cli/run_program.h"
#include "dataset/temporary_folder.h"

namespace mixity::cli {
namespace command_design_test {

Words with_plan(Words words, const std::string& loads = "--loads=1,4 mN") {
  words.insert(words.end(), {"--model=c", "--lambda=0.01", "--radius=9.42 mm", "--modulus=2.133 MPa +/- 3%",
                             "--toughness=27 mJ/m^2"});
  if (!loads.empty()) words.push_back(loads);
  return words;
}

TEST(DesignCommand, SaysWhatAPlanTellsAndWhichLoadsTellMost) {
  const ProgramResult result =
      run_program(with_plan({"design", "--load_range=0.5,10 mN", "--runs=2", "--wanted=5%", "--experiments=50"}));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  for (const char* part : {"[[Plan]]", "expected standard error of lambda", "against model b: chi^2", "[[Next load]]",
                           "best for lambda:", "[[Best 2 loads for lambda]]", "evenly spaced loads:", "[[Runs needed]]",
                           "[[50 simulated experiments at", "the right model has a probability above 95% in"})
    EXPECT_NE(result.out.find(part), std::string::npos) << part << result.out;
}

/// The repeated load bounds the drift far more than any other run does.
TEST(DesignCommand, SaysWhatRepeatingTheFirstLoadTellsOfADrift) {
  const Words plan{"design",
                   "--model=c",
                   "--lambda=0.05",
                   "--models=c",
                   "--sigma_A=1%",
                   "--loads=3,6,12,25 mN",
                   "--radius=9.42 mm",
                   "--modulus=2.133 MPa +/- 5%",
                   "--toughness=27 mJ/m^2 +/- 10%"};
  Words drifting = plan;
  drifting.emplace_back("--modulus_drift=0 +/- 0.03");
  const ProgramResult result = run_program(drifting);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const std::string error = "expected standard error of modulus_drift: ";
  const std::size_t first = result.out.find(error), again = result.out.find("first load once more at the end"),
                    second = result.out.find(error, again);
  ASSERT_NE(second, std::string::npos) << result.out;
  EXPECT_LT(std::stod(result.out.substr(second + error.size())),
            0.5 * std::stod(result.out.substr(first + error.size())))
      << result.out;
  EXPECT_EQ(run_program(plan).out.find("once more"), std::string::npos);
}

TEST(DesignCommand, SaysWhatTellsTheCouplingsOfAnEllipseApart) {
  const Words common{
      "design",          "--shape=ellipse",  "--model=c",           "--poisson_ratio=0.5",   "--points=12",
      "--models=c",      "--radius=9.42 mm", "--modulus=2.133 MPa", "--toughness=27 mJ/m^2", "--loads=4 mN",
      "--lambda_II=0.01"};
  Words apart = common, equal = common;
  apart.emplace_back("--lambda_III=0.005");
  equal.emplace_back("--lambda_III=0.01");
  const ProgramResult result = run_program(apart);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("lambda_III is told from lambda_II soonest at 4 mN up to 95% of the jump: by 1 run"),
            std::string::npos)
      << result.out;
  EXPECT_NE(run_program(equal).out.find("no number of runs tells lambda_III from lambda_II"), std::string::npos);
}

TEST(DesignCommand, PlansHeldApproaches) {
  const ProgramResult result = run_program(with_plan({"design", "--control=approach", "--approach_offset=0 +/- 0.2 um",
                                                      "--load_range=2,20 um", "--points=9", "--runs=1"},
                                                     "--loads=3,8 um"));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  for (const char* part : {"approaches 3, 8 um", "[[Next approach]]", "delta [um]  error of lambda",
                           "[[Best 1 approaches for lambda]]", "evenly spaced approaches:"})
    EXPECT_NE(result.out.find(part), std::string::npos) << part << result.out;
  EXPECT_EQ(result.out.find("mN"), std::string::npos) << result.out;
  const Words csv = {"design", "--control=approach", "--load_range=2,20 um", "--points=9", "--format=csv"};
  EXPECT_EQ(lines_of(run_program(with_plan(csv, "")).out).at(0), "delta [um],standard_error,chi2_a,chi2_b");
}

TEST(DesignCommand, ListsCandidatesAsCsv) {
  const auto lines = lines_of(run_program(with_plan({"design", "--load_range=0.5,10 mN", "--format=csv"})).out);
  ASSERT_EQ(lines.size(), 22u);
  EXPECT_EQ(lines[0], "load [mN],standard_error,chi2_a,chi2_b");
  EXPECT_TRUE(lines[1].starts_with("0.5,0.0"));
}

TEST(DesignCommand, RefusesWhatCannotBePlanned) {
  for (const auto& [words, message] : std::vector<std::pair<Words, std::string>>{
           {with_plan({"design"}, ""), "flag '--loads' is missing"},
           {with_plan({"design"}, "--loads=1,4"), "needs a unit such as mN"},
           {with_plan({"design", "--runs=2"}), "flag '--load_range' is missing"},
           {with_plan({"design", "--load_range=10,1 mN"}), "it must be two rising loads"},
           {with_plan({"design", "--load_range=-5,1 mN"}), "flag '--load_range': a load lies at or below pull-off"},
           {with_plan({"design", "--control=approach", "--load_range=1,2 mN"}, "--loads=3 um"),
            "it must be two rising approaches, \"0.5,10 um\""},
           {with_plan({"design", "--control=approach", "--load_range=-5,10 um"}, "--loads=3 um"),
            "flag '--load_range': an approach lies below pull-off"},
           {with_plan({"design", "--goal=fame"}), "it must be error or model"},
           {with_plan({"design", "--reach=2"}), "reach must lie above 0"},
           {with_plan({"design", "--sigma_A=2 mN"}), "sigma_A must be a percentage or an area"},
           {with_plan({"design", "--experiments=1"}), "it must be a whole number from 2 to 10000000"},
           {with_plan({"design", "--runs=1e9", "--load_range=1,2 mN"}), "it must be a whole number from 1 to 100"},
           {with_plan({"design", "--points=1e6"}), "points of all runs would take some 2 GB; at most 1000000"},
           {with_plan({"simulate", "--points=1e8"}), "points of all runs would take some 60 GB; at most 10000000"},
           {{"curve", "--model=c", "--lambda=0.1", "--load=1", "--points=1e8"}, "a whole number from 2 to 10000000"},
           {{"map", "--model=c", "--grid=1e5"}, "a whole number from 2 to 10000"}}) {
    const ProgramResult result = run_program(words);
    EXPECT_EQ(result.exit_code, 2) << message;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
  }
}

TEST(SimulateCommand, TakesOneLoadUnderEitherNameAndPrintsItAsStated) {
  const auto simulated = [](const Words& loads) {
    Words words{"simulate",         "--model=c",           "--lambda=0.004",
                "--radius=9.42 mm", "--modulus=2.133 MPa", "--toughness=27 mJ/m^2",
                "--points=3"};
    words.insert(words.end(), loads.begin(), loads.end());
    return run_program(words);
  };
  for (const char* load : {"1.2", "2", "3.7", "0.3"}) {
    const ProgramResult one = simulated({std::string("--load=") + load + " mN"});
    ASSERT_EQ(one.exit_code, 0) << one.err;
    EXPECT_EQ(fields_of(lines_of(one.out)[1])[1], load);
    EXPECT_EQ(one.out, simulated({std::string("--loads=") + load + " mN"}).out);
  }
  EXPECT_EQ(simulated({"--load=1 mN", "--loads=2 mN"}).complaint(),
            "mixity: flags '--load' and '--loads': give one of them");
  EXPECT_EQ(simulated({"--load=1,2 mN"}).out, simulated({"--load=1.2 mN"}).out);
  EXPECT_EQ(simulated({"--loads=0,5 mN,1,2 mN"}).complaint(),
            "mixity: flag '--loads' is '0,5 mN,1,2 mN'; write \"0.5 mN,1.2 mN\" or \"0 mN,5 mN,1 mN,2 mN\"");
  EXPECT_EQ(simulated({"--loads=1,2; 3,5 mN"}).out, simulated({"--loads=1.2,3.5 mN"}).out);
}

TEST(SimulateCommand, WritesAnExperimentThatCanBeFitted) {
  const TemporaryFolder folder;
  const std::string path = folder.path("x.csv");
  ASSERT_EQ(run_program(with_plan({"simulate", "--seed=3", "--out=" + path})).exit_code, 0);
  const ProgramResult fit = run_program({"fit", path, "--models=c"});
  EXPECT_EQ(fit.exit_code, 0) << fit.out;
  EXPECT_NE(fit.out.find("reconstructed"), std::string::npos);
  EXPECT_EQ(run_program(with_plan({"simulate", "--seed=3"})).out, content_of(path));
  EXPECT_NE(run_program(with_plan({"simulate", "--seed=4"})).out, content_of(path));
}

TEST(SimulateCommand, WritesStatedErrorsAsTheyWereStated) {
  const std::string table =
      run_program(with_plan({"simulate", "--sigma_T=0.2 mN", "--sigma_A=0.003 mm^2", "--points=3"})).out;
  const auto rows = lines_of(table);
  ASSERT_EQ(rows.size(), 7) << table;
  for (std::size_t i = 1; i < rows.size(); ++i) EXPECT_TRUE(rows[i].ends_with(",0.2,0.003")) << rows[i];
}

}  // namespace command_design_test
}  // namespace mixity::cli
