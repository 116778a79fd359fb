// mixity fit as its users run it: exit codes, verdicts, JSON and files.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/run_program.h"
#include "cli/shown_lines.h"
#include "dataset/temporary_folder.h"

namespace mixity::cli {
namespace command_fit_test {

using Json = nlohmann::json;

// f = 1/(1 - 3/4 sin^2 psi), model c with lambda = 1/4, from 40-digit arithmetic.
constexpr const char* kModelC =
    "psi [deg],Gc_over_GIc\n0,1\n20,1.0961707109158706\n40,1.4490274177146591\n60,2.2857142857142857\n"
    "75,3.3306635447028234\n";

TEST(Program, AFitThatIsNotOkIsExitOneAndVisible) {
  const TemporaryFolder folder;
  // JKR areas, 40 digits: no shear, so that nothing is said of lambda
  const std::string no_shear = folder.write("a.csv", "P,T,A\n1,0,19.614936466006521\n5,0,23.887269575794426\n");
  const std::string one_point = folder.write("b.csv", "P,T,A\n1,1,19\n");
  const std::string no_point = folder.write("c.csv", "P,T,A\n1,nan,19\n");
  for (const std::string& path : {no_shear, one_point, no_point}) {
    const ProgramResult text = run_program({"fit", path, "--models=c"});
    EXPECT_EQ(text.exit_code, 1);
    EXPECT_EQ(text.err, "");
    EXPECT_NE(text.out.find("NOT IDENTIFIABLE"), std::string::npos) << text.out;
    EXPECT_EQ(text.out.find("nan,"), std::string::npos);
    const ProgramResult json = run_program({"fit", path, "--models=c", "--format=json"});
    EXPECT_EQ(json.exit_code, 1);
    const Json fit = Json::parse(json.out)["datasets"][0]["fits"][0];
    EXPECT_EQ(fit["status"], "not_identifiable");
    EXPECT_TRUE(fit["parameters"]["lambda"]["value"].is_null());
  }
}

TEST(Program, AFitFindsTheLambdaThatMadeTheData) {
  const TemporaryFolder folder;
  const ProgramResult result = run_program({"fit", folder.write("a.csv", kModelC), "--models=c", "--format=json"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  // 1e-12: f is given to 16 digits and enters as its logarithm, lambda as a well-conditioned function of it
  EXPECT_NEAR(Json::parse(result.out)["datasets"][0]["fits"][0]["parameters"]["lambda"]["value"].get<double>(), 0.25,
              1e-12);
}

/// Whatever was given by flags.
TEST(Program, ASavedDefinitionGivesTheSameNumbers) {
  const TemporaryFolder folder;
  const std::string saved = folder.path("saved.toml");
  const std::vector<std::string> flags{"--models=c,b",
                                       "--modulus=2.1 MPa +/- 5%",
                                       "--load_offset=0 +/- 0.3 mN",
                                       "--sigma_A=0.7%",
                                       "--exclude=3,30-32",
                                       "--leave_out=P=2",
                                       "--bootstrap=20",
                                       "--seed=3",
                                       "--confidence=0.9",
                                       "--loss=cauchy",
                                       "--per=curve"};
  std::vector<std::string> words{"fit", MIXITY_ROOT "/data/mergel2018.csv", "--format=csv", "--save=" + saved};
  words.insert(words.end(), flags.begin(), flags.end());
  const ProgramResult given = run_program(words), again = run_program({"fit", saved, "--format=csv"});
  EXPECT_EQ(given.err, "");
  EXPECT_EQ(given.exit_code, again.exit_code);
  EXPECT_EQ(given.out, again.out);
  EXPECT_NE(given.out.find("mergel2018"), std::string::npos);
  // a flag wins over the definition
  const ProgramResult other =
      run_program({"fit", saved, "--format=csv", "--youngs_modulus=1.5 MPa", "--poisson_ratio=0.5"});
  EXPECT_EQ(other.err, "");
  EXPECT_NE(other.out, again.out);
  expect_refused({"fit", saved, saved, "--save=" + folder.path("both.toml")}, 2,
                 "flag '--save' needs exactly one data set");
}

TEST(Program, JsonHasTheKeysOfItsSchema) {
  const TemporaryFolder folder;
  const std::string path = folder.write(
      "a.csv",
      "P,T,A,include\n1,0,19.6,1\n1,5,19.2,1\n1,7,18.9,0\n1,10,18,1\n1,,18,1\n5,0,23.9,1\n5,8,23,1\n5,12,22,1\n");
  const ProgramResult result = run_program({"fit", path, "--models=a,b,c", "--format=json"});
  const Json document = Json::parse(result.out);
  EXPECT_TRUE(document["schema"].is_string());
  ASSERT_EQ(document["datasets"].size(), 1);
  const Json& data = document["datasets"][0];
  EXPECT_EQ(data["path"], path);
  EXPECT_EQ(data["provenance"], "unstated");
  EXPECT_EQ(data["points"], 8);
  EXPECT_EQ(data["used"], 6);
  EXPECT_EQ(data["excluded"],
            Json::parse(R"([{"line": 4, "reason": "include = 0"}, {"line": 6, "reason": "T is empty"}])"));
  ASSERT_EQ(data["fits"].size(), 3);
  for (const Json& fit : data["fits"]) {
    for (const char* key : {"model", "objective", "status", "message", "parameters", "r2", "rmse", "max_abs_residual",
                            "area", "paper", "published"})
      EXPECT_TRUE(fit.contains(key)) << key;
    for (const char* key : {"value", "stderr", "lower", "upper", "at_bound"})
      EXPECT_TRUE(fit["parameters"]["lambda"].contains(key)) << key;
    for (const char* key : {"r2", "rmse", "unpredicted"}) EXPECT_TRUE(fit["area"].contains(key)) << key;
    EXPECT_EQ(fit["objective"], "curve");
  }
  EXPECT_EQ(data["fits"][1]["model"], "b");
  EXPECT_EQ(data["fits"][1]["parameters"]["lambda"]["upper"], 2);
}

TEST(Program, PointsWithoutAPhaseAngleAreLeftOutOfToughnessAndKeptForAreas) {
  const TemporaryFolder folder;
  // Hertz has 2.5933 at P = 1
  const std::string path = folder.write(
      "a.csv", "P,T,A\n1,-0.01,19.6\n1,5,19.2\n1,7,18.9\n1,10,18\n1,25,2.59\n5,0,23.9\n5,8,23\n5,12,22\n5,,9\n");
  for (const auto& [objective, used] : {std::pair{"toughness", 7}, {"curve", 8}}) {
    const Words words{"fit", path, "--models=a,c", std::string("--objective=") + objective};
    Words json = words;
    json.push_back("--format=json");
    const Json data = Json::parse(run_program(json).out)["datasets"][0];
    EXPECT_EQ(data["points"], 9);
    EXPECT_EQ(data["used"], 8);
    EXPECT_EQ(data["excluded"], Json::parse(R"([{"line": 10, "reason": "T is empty"}])"));
    EXPECT_EQ(data["notes"][0], "1 of 8 points has T < 0, used as it is: equilibrium depends on T^2");
    for (const Json& fit : data["fits"]) {
      EXPECT_EQ(fit["used"], used) << objective;
      EXPECT_EQ(fit["excluded"].size(), 8 - used);
      for (const Json& point : fit["excluded"]) EXPECT_EQ(point["line"], 6);
    }
    const std::string text = run_program(words).out;
    EXPECT_NE(text.find("# data rows    = 9, used 8, excluded 1, in 2 loading runs"), std::string::npos) << text;
    EXPECT_EQ(text.find("    without line 6: y <= 0: the area does not exceed that of Hertz") != std::string::npos,
              used == 7)
        << text;
    EXPECT_NE(text.find(", " + std::to_string(used) + " points\n"), std::string::npos) << text;
  }
}

TEST(Program, AFitDefinitionComparesWithWhatWasPublished) {
  const TemporaryFolder folder;
  folder.write("a.csv", kModelC);
  const std::string definition =
      folder.write("fit.toml",
                   "data = \"a.csv\"\nmodels = [\"c\"]\n[published.c]\n"
                   "lambda = {value = 0.26, tolerance = 0.005}\nr2 = {value = 1, tolerance = 1e-9}\n");
  const Json fit = Json::parse(run_program({"fit", definition, "--format=json"}).out)["datasets"][0]["fits"][0];
  EXPECT_TRUE(fit["area"].is_null());
  EXPECT_EQ(fit["published"]["lambda"]["value"], 0.26);
  EXPECT_EQ(fit["published"]["lambda"]["tolerance"], 0.005);
  EXPECT_EQ(fit["published"]["lambda"]["agrees"], false);
  EXPECT_EQ(fit["published"]["r2"]["agrees"], true);
}

TEST(Program, ADefinitionBehindALinkNamesTheFileThatTheSystemFinds) {
  const TemporaryFolder folder;
  for (const char* name : {"shared/fits", "shared/data", "here/data"})
    std::filesystem::create_directories(folder.path(name));
  folder.write("shared/data/d.csv", "P,T,A\n1,0,19.6\n1,1,19.5\n");
  folder.write("here/data/d.csv", "P,T,A\n1,0,9\n1,1,8.9\n1,2,8.7\n");
  folder.write("shared/fits/x.toml", "data = \"../data/d.csv\"\nmodels = [\"c\"]\n");
  std::filesystem::create_symlink("../shared/fits", folder.path("here/fits"));
  const auto points = [&](const std::string& definition) {
    return Json::parse(run_program({"fit", folder.path(definition), "--format=json"}).out)["datasets"][0]["points"];
  };
  EXPECT_EQ(points("here/fits/x.toml"), 2);
  EXPECT_EQ(points("shared/fits/x.toml"), 2);
}

TEST(Program, ReconstructedDataAreCalledThatInEveryOutput) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.csv", kModelC);
  for (const char* format : {"text", "json", "csv"}) {
    const ProgramResult result =
        run_program({"fit", path, "--provenance=reconstructed", "--format", format, "--out", folder.path("out")});
    EXPECT_NE(result.out.find("tests the program, not the physics"), std::string::npos) << format;
  }
  for (const char* name : {"a_residuals.csv", "a_curves.csv", "fits.csv", "fits.json", "fits.txt"})
    EXPECT_NE(content_of(folder.path("out/" + std::string(name))).find("reconstructed"), std::string::npos) << name;
  EXPECT_NE(run_program({"check", path, "--provenance=reconstructed"}).out.find("tests the program, not the physics"),
            std::string::npos);
}

TEST(Program, OutputThatCannotBeWrittenIsExitFourAndLeavesNothing) {
  const TemporaryFolder folder;
  const std::string data = folder.write("a.csv", kModelC), file = folder.write("file", "");
  expect_refused({"fit", data, "--out", file + "/folder"}, 4, file + "/folder: cannot be created: Not a directory");
  const std::string plot = folder.write("plot.csv", "a,\nX,Y\n0,1\n");
  expect_refused({"import", plot, "--x=psi", "--y=Gc", "--out", file + "/a.csv"}, 4,
                 file + ": cannot be created: Not a directory");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 3);
}

TEST(Program, FilesAreWrittenWithoutLeftovers) {
  const TemporaryFolder folder;
  const std::string data = folder.write("a.csv", kModelC);
  EXPECT_EQ(run_program({"fit", data, "--models=c", "--out", folder.path("new/out")}).exit_code, 0);
  Words names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path("new/out"))) {
    names.push_back(entry.path().filename().string());
    EXPECT_GT(entry.file_size(), 0) << names.back();
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (Words{".mixity-files", "a_curves.csv", "a_residuals.csv", "fits.csv", "fits.json", "fits.txt"}));
}

TEST(FitCommand, PrintsWhatTheDocumentsShow) {
  std::string printed = run_program({"fit", MIXITY_ROOT "/data/mergel2018.csv", "--models=c,b"}).out;
  if (const std::size_t at = printed.find(MIXITY_ROOT "/"); at != std::string::npos)
    printed.erase(at, std::string(MIXITY_ROOT "/").size());
  EXPECT_GE(count_of_shown_lines(section_of("docs/statistics.md", "## Output of a fit"), printed), 20);
}

}  // namespace command_fit_test
}  // namespace mixity::cli
