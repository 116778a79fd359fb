#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "cli/run_program.h"

namespace mixity::cli {
namespace {

using Json = nlohmann::json;

// f = 1/(1 - 3/4 sin^2 psi), model c with lambda = 1/4, from 40-digit arithmetic.
constexpr const char* kModelC =
    "psi [deg],Gc_over_GIc\n0,1\n20,1.0961707109158706\n40,1.4490274177146591\n60,2.2857142857142857\n"
    "75,3.3306635447028234\n";

void expect_refused(const Words& words, int exit_code, const std::string& complaint) {
  const ProgramResult result = run_program(words);
  EXPECT_EQ(result.exit_code, exit_code) << joined(words);
  EXPECT_EQ(result.complaint(), "mixity: " + complaint) << joined(words);
  EXPECT_EQ(result.out, "") << joined(words);
}

// ---- help ----

TEST(Program, HelpNamesEveryCommand) {
  for (const char* word : {"help", "--help", "-h"}) {
    const ProgramResult result = run_program({word});
    EXPECT_EQ(result.exit_code, 0) << word;
    EXPECT_EQ(result.err, "") << word;
    for (const char* command : {"fit", "predict", "check", "import", "help"})
      EXPECT_NE(result.out.find("\n  " + std::string(command) + " "), std::string::npos) << word << " " << command;
  }
}

TEST(Program, HelpOnACommandNamesItsFlags) {
  for (const auto& [command, flags] : std::vector<std::pair<std::string, Words>>{
           {"fit", {"models", "objective", "radius", "modulus", "toughness", "format", "out"}},
           {"predict", {"model", "lambda", "load", "shear", "radius"}},
           {"check", {"radius"}},
           {"import", {"x", "y", "loads", "out"}}}) {
    const ProgramResult result = run_program({"help", command});
    EXPECT_EQ(result.exit_code, 0) << command;
    EXPECT_TRUE(result.out.starts_with("mixity " + command + " ")) << result.out;
    for (const std::string& flag : flags) EXPECT_NE(result.out.find("\n  --" + flag + " "), std::string::npos) << flag;
    EXPECT_EQ(run_program({command, "--help"}).out, result.out);
  }
}

TEST(Program, TheVersionIsOneLine) {
  const ProgramResult result = run_program({"--version"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(result.out.starts_with("mixity ") && lines_of(result.out).size() == 1) << result.out;
}

TEST(Program, WithoutACommandItHelpsAndFails) {
  const ProgramResult result = run_program({});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, run_program({"help"}).out);
}

// ---- bad usage and bad input ----

TEST(Program, BadUsageIsOneLineAndExitTwo) {
  for (const auto& [words, complaint] : std::vector<std::pair<Words, std::string>>{
           {{"fitt"}, "unknown command 'fitt' (see mixity help)"},
           {{"--foo"}, "unknown command '--foo' (see mixity help)"},
           {{"help", "foo"}, "unknown command 'foo' (see mixity help)"},
           {{"fit", "--foo=1", "a.csv"}, "unknown flag '--foo' (see mixity help fit)"},
           {{"check", "a.csv", "--models=c"}, "unknown flag '--models' (see mixity help check)"},
           {{"fit", "a.csv", "--flagfile=x"}, "unknown flag '--flagfile' (see mixity help fit)"},
           {{"fit"}, "fit needs a data CSV or a fit definition (see mixity help fit)"},
           {{"fit", "a.csv", "--models"}, "flag '--models' needs a value"},
           {{"fit", "a.csv", "--models=c,z"}, "flag '--models': unknown model 'z' (known: a, b, c, bk)"},
           {{"fit", "a.csv", "--format=xml"}, "flag '--format' is 'xml'; it must be text, json or csv"},
           {{"fit", "a.csv", "--radius=9.42"},
            "flag '--radius': radius is \"9.42\"; it must be a length such as mm, written \"9.42 mm\""},
           {{"check"}, "check needs a data CSV (see mixity help check)"},
           {{"import", "a.csv"}, "import needs the axes: --x=\"T [mN]\" --y=\"A [mm^2]\""},
           {{"predict", "--model=c", "--load=1", "--shear=0"}, "model c needs --lambda"},
           {{"predict", "--model=c", "--lambda=2", "--load=1", "--shear=0"},
            "lambda is '2'; model c needs a number from 0 to 1"},
           {{"predict", "--model=c", "--lambda=nan", "--load=1", "--shear=0"},
            "lambda is 'nan'; model c needs a number from 0 to 1"},
           {{"predict", "--model=z", "--lambda=0", "--load=1", "--shear=0"},
            "flag '--model': unknown model 'z' (known: a, b, c, bk)"},
           {{"predict", "--model=c", "--lambda=0.1", "--load=1 mN", "--shear=0"},
            "flag '--load' has a unit; that needs --radius, --modulus and --toughness"},
           {{"predict", "--model=c", "--lambda=0.1", "--load=1", "--shear=0,x"},
            "flag '--shear': 'x' is not a number, or its unit is unknown"},
           {{"predict", "--model=c", "--lambda=0.1", "--load=1", "--shear=0", "--radius=1 mm"},
            "a dimensional prediction needs all of --radius, --modulus and --toughness"},
       })
    expect_refused(words, 2, complaint);
}

TEST(Program, AComplaintIsOneLineWhateverItQuotes) {
  const TemporaryFolder folder;
  const std::string field = folder.write("field.csv", "P,T,A\n1,\"a\nb\",20\n");
  for (const Words& words : std::vector<Words>{{"two\nlines"}, {"fit", "--two\nlines=3"}, {"check", field}}) {
    const ProgramResult result = run_program(words);
    EXPECT_NE(result.exit_code, 0);
    EXPECT_EQ(lines_of(result.err).size(), 1) << result.err;
  }
}

TEST(Program, TwoStatementsOfTheModulusAreBadUsage) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.csv", "P [N],T [N],A [m^2]\n1,0,1\n");
  EXPECT_EQ(run_program({"check", path, "--radius=1 m", "--toughness=1 J/m^2", "--modulus=1 Pa",
                         "--youngs_modulus=2 Pa", "--poisson_ratio=0.5"})
                .exit_code,
            2);
}

TEST(Program, BadInputIsOneLineAndExitThree) {
  const TemporaryFolder folder;
  const std::string text = folder.write("text.csv", "P,T,A\n1,abc,20\n"), missing = folder.path("none.csv");
  const std::string bad_fit = folder.write("fit.toml", "# no path\ndata = 3\n");
  for (const char* command : {"fit", "check"}) {
    expect_refused({command, text}, 3, text + ":2:3: column 'T': 'abc' is not a number");
    expect_refused({command, missing}, 3, missing + ": cannot be opened: No such file or directory");
    expect_refused({command, folder.path()}, 3, folder.path() + ": cannot be read: Is a directory");
  }
  expect_refused({"fit", bad_fit}, 3, bad_fit + ":2:8: data must be a string");
  expect_refused({"import", text, "--x=T", "--y=A"}, 3, text + ":2:3: 'abc' is not a finite number");
}

TEST(Program, APathThatIsTooLongIsBadInput) {
  const ProgramResult result = run_program({"check", std::string(300, 'x') + ".csv"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(lines_of(result.err).size(), 1) << result.err;
}

// ---- fit ----

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

TEST(Program, JsonHasTheKeysOfItsSchema) {
  const TemporaryFolder folder;
  const std::string path = folder.write(
      "a.csv",
      "P,T,A,include\n1,0,19.6,1\n1,5,19.2,1\n1,7,18.9,0\n1,10,18,1\n1,-1,18,1\n5,0,23.9,1\n5,8,23,1\n5,12,22,1\n");
  const ProgramResult result = run_program({"fit", path, "--models=a,b,c", "--format=json"});
  const Json document = Json::parse(result.out);
  EXPECT_TRUE(document["schema"].is_string());
  ASSERT_EQ(document["datasets"].size(), 1);
  const Json& data = document["datasets"][0];
  EXPECT_EQ(data["path"], path);
  EXPECT_EQ(data["provenance"], "unstated");
  EXPECT_EQ(data["points"], 8);
  EXPECT_EQ(data["used"], 6);
  EXPECT_EQ(data["excluded"], Json::parse(R"([{"line": 4, "reason": "include = 0"}, {"line": 6, "reason": "T < 0"}])"));
  ASSERT_EQ(data["fits"].size(), 3);
  for (const Json& fit : data["fits"]) {
    for (const char* key : {"model", "objective", "status", "message", "parameters", "r2", "rmse", "max_abs_residual",
                            "area", "published"})
      EXPECT_TRUE(fit.contains(key)) << key;
    for (const char* key : {"value", "stderr", "lower", "upper", "at_bound"})
      EXPECT_TRUE(fit["parameters"]["lambda"].contains(key)) << key;
    for (const char* key : {"r2", "rmse", "unpredicted"}) EXPECT_TRUE(fit["area"].contains(key)) << key;
    EXPECT_EQ(fit["objective"], "toughness");
  }
  EXPECT_EQ(data["fits"][1]["model"], "b");
  EXPECT_EQ(data["fits"][1]["parameters"]["lambda"]["upper"], 2);
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
  EXPECT_EQ(names, (Words{"a_curves.csv", "a_residuals.csv", "fits.csv", "fits.json", "fits.txt"}));
}

// ---- predict ----

Words predict(const std::string& model, const std::string& lambda, const std::string& load, const std::string& shear) {
  return {"predict", "--model=" + model, "--lambda=" + lambda, "--load=" + load, "--shear=" + shear};
}

TEST(Program, PredictPrintsTheStateOfTheContact) {
  const ProgramResult result = run_program(predict("c", "0.15", "3", "0,5,10"));
  EXPECT_EQ(result.exit_code, 0);
  const auto lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 4);
  EXPECT_EQ(lines[0], "P,T,y,a,A,u,psi,f,status");
  // 40-digit values of y = 3 pi + sqrt(S0^2 - lambda T^2) and what follows from it: P,T,y,a,A,u,psi,f
  const double expected[3][8] = {{3, 0, 21.481937965282072001, 2.6381674166806312105, 21.865256533115421488, 0, 0, 1},
                                 {3, 5, 21.325412707471780121, 2.6325330177151248652, 21.771959936421260852,
                                  1.4244835581415677977, 0.23030210374310519908, 1.0463444352260184483},
                                 {3, 10, 20.842969909340769267, 2.6150131152775343643, 21.483132915089906459,
                                  2.8680544492045564107, 0.44733959213407412308, 1.1891287063405536673}};
  for (std::size_t row = 0; row < 3; ++row) {
    const auto fields = fields_of(lines[row + 1]);
    ASSERT_EQ(fields.size(), 9);
    // 2e-15: 4e-15 is promised for the area near folds; far from one each number is within a few roundings
    for (std::size_t i = 0; i < 8; ++i)
      EXPECT_NEAR(std::strtod(fields[i].c_str(), nullptr), expected[row][i], 2e-15 * expected[row][i])
          << lines[row + 1];
    EXPECT_EQ(fields[8], "ok");
  }
}

TEST(Program, PredictWithUnitsIsTheSameContact) {
  Words words = predict("c", "0.1", "1 mN", "1e-6 kN");
  for (const char* word : {"--radius=9.42 mm", "--modulus=2.133 MPa", "--toughness=27 mJ/m^2"}) words.push_back(word);
  const auto lines = lines_of(run_program(words).out);
  ASSERT_EQ(lines.size(), 2);
  EXPECT_EQ(lines[0], "P [mN],T [mN],y [mN],a [mm],A [mm^2],u [mm],psi [rad],f,status");
  const auto fields = fields_of(lines[1]);
  // From 40-digit arithmetic. 1e-14: as above, and some roundings of the units.
  const double expected[8] = {1,
                              1,
                              5.6282394660238226479,
                              0.28000975849390140791,
                              0.24631803237974844134,
                              0.0012557328077288897912,
                              0.17584043438146653771,
                              1.0283223006812439148};
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_NEAR(std::strtod(fields[i].c_str(), nullptr), expected[i], 1e-14 * expected[i]) << lines[1];
}

TEST(Program, BeyondTheLastEquilibriumAreEmptyFields) {
  // Model c at P = 3, lambda = 0.15 ends at T = sqrt(3 pi (3 pi + 6)/0.15) = 31.1314532666905; at P < -3 pi/2 = -4.712
  // there is no contact at all.
  const auto lines = lines_of(run_program(predict("c", "0.15", "3", "31.1314,31.1315,1e100")).out);
  ASSERT_EQ(lines.size(), 4);
  EXPECT_TRUE(lines[1].ends_with(",ok")) << lines[1];
  EXPECT_EQ(lines[2], "3,31.1315,,,,,,,no_equilibrium");
  EXPECT_EQ(lines[3], "3,1e+100,,,,,,,no_equilibrium");
  EXPECT_EQ(lines_of(run_program(predict("a", "0.5", "-4.713", "0")).out).at(1), "-4.713,0,,,,,,,no_equilibrium");
}

TEST(Program, PredictNeverPrintsNan) {
  for (const char* model : {"a", "b", "c"})
    for (const char* lambda : {"0", "1e-300", "1e-6", "0.5", "1"})
      for (const char* load : {"-4.71238898038469", "-4.7", "0", "1e4", "1e149"}) {
        const ProgramResult result = run_program(predict(model, lambda, load, "0,1e-300,1e-3,1,30,1e6,1e150"));
        const std::string what = joined({model, lambda, load}) + result.out + result.err;
        EXPECT_EQ(result.exit_code, 0) << what;
        EXPECT_EQ(lines_of(result.out).size(), 8) << what;
        EXPECT_EQ(result.out.find("nan"), std::string::npos) << what;
        EXPECT_EQ(result.out.find("inf"), std::string::npos) << what;
      }
}

// ---- check and import ----

TEST(Program, CheckSaysWhatItUnderstood) {
  const TemporaryFolder folder;
  const ProgramResult result = run_program({"check", folder.write("a.csv", "P,T,A\n1,0,19.6\n1,1,19.5\n1,-1,19\n")});
  EXPECT_EQ(result.exit_code, 0);
  for (const char* words : {"dimensionless", "3 rows, 2 usable, 1 excluded", "line 4: T < 0", "provenance"})
    EXPECT_NE(result.out.find(words), std::string::npos) << words << "\n" << result.out;
}

TEST(Program, AnImportCanBeFitted) {
  const TemporaryFolder folder;
  const std::string plot =
      folder.write("plot.csv", "run 1,,run 2,\nX,Y,X,Y\n0,19.6,0,23.9\n5,19.2,8,23\n10,18,12,22\n");
  const Words words{"import", plot, "--x=T", "--y=A", "--loads=1,5"};
  const ProgramResult shown = run_program(words);
  EXPECT_EQ(shown.exit_code, 0);
  EXPECT_EQ(
      shown.out,
      "curve,P,T,A\nrun 1,1,0,19.6\nrun 1,1,5,19.2\nrun 1,1,10,18\nrun 2,5,0,23.9\nrun 2,5,8,23\nrun 2,5,12,22\n");
  const std::string data = folder.path("data.csv");
  EXPECT_EQ(run_program({"import", plot, "--x=T", "--y=A", "--loads=1,5", "--out", data}).out, "");
  EXPECT_EQ(content_of(data), shown.out);
  EXPECT_EQ(run_program({"fit", data, "--models=c"}).exit_code, 0);
}

}  // namespace
}  // namespace mixity::cli
