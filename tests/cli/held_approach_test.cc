// Data whose approach is held, from simulation to report.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "cli/run_program.h"
#include "dataset/temporary_folder.h"

namespace mixity::cli {
namespace held_approach_program_test {

/// A folder with a simulated experiment, of its constants known to 1 and 2 % and the zero of the approach to 0.2 um.
struct Experiment {
  Experiment() {
    const ProgramResult made = run_program(
        {"simulate", "--model=c", "--lambda=0.05", "--control=approach", "--normal_stiffness=1.2 kN/m",
         "--loads=3,8,15 um", "--radius=9.42 mm", "--modulus=2.133 MPa +/- 1%", "--toughness=27 mJ/m^2 +/- 2%",
         "--approach_offset=0 +/- 0.2 um", "--seed=5", "--sigma_T=1%", "--sigma_A=0.5%", "--out=" + data});
    EXPECT_EQ(made.exit_code, 0) << made.err;
  }
  TemporaryFolder folder;
  std::string data = folder.path() + "/held.csv";
};

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST(Program, FitsWhatItSimulatesAtHeldApproaches) {
  const Experiment experiment;
  EXPECT_EQ(text_of(experiment.data).substr(0, 34), "curve,delta [um],T [mN],A [mm^2],s");
  EXPECT_NE(text_of(experiment.folder.path() + "/held.toml").find("control = 'approach'"), std::string::npos);
  const ProgramResult fit = run_program({"fit", experiment.data, "--models=c"});
  EXPECT_EQ(fit.exit_code, 0) << fit.err;
  for (const char* words : {"status: ok", "approach_offset", "normal stiffness 1200 N/m", "control approach"})
    EXPECT_NE(fit.out.find(words), std::string::npos) << words << fit.out;
  const ProgramResult csv = run_program({"points", experiment.data});
  EXPECT_EQ(csv.out.substr(0, 29), "line,curve,delta [um],T [mN],") << csv.out.substr(0, 100);
  const ProgramResult folds = run_program({"instability", experiment.data, "--models=c", "--stiffness=1 kN/m"});
  for (const char* words : {"delta [um]", "load", "displacement", "stiffness"})
    EXPECT_NE(folds.out.find(words), std::string::npos) << folds.out << folds.err;
  const ProgramResult areas = run_program({"predict", experiment.data, "--models=c", "--loads=5 um", "--shear=0,5 mN"});
  EXPECT_EQ(areas.out.substr(0, 17), "delta [um],T [mN]") << areas.err;
  EXPECT_EQ(run_program({"predict", experiment.data, "--loads=5 mN", "--shear=5 mN"}).exit_code, 2);
}

TEST(Program, DrawsLoadsAndRadiiOfHeldApproaches) {
  const Experiment experiment;
  const std::string out = experiment.folder.path() + "/page";
  const ProgramResult report = run_program({"report", experiment.data, "--models=c", "--out=" + out});
  EXPECT_EQ(report.exit_code, 0) << report.err;
  std::string figures;
  for (const auto& file : std::filesystem::recursive_directory_iterator(out)) figures += file.path().string() + '\n';
  for (const char* name : {"_P_T.svg", "_a_P.svg"}) EXPECT_NE(figures.find(name), std::string::npos) << figures;
  const std::string json = text_of(out + "/results.json");
  EXPECT_NE(json.find("\"control\": \"approach\""), std::string::npos);
  EXPECT_NE(json.find("\"delta\": "), std::string::npos);
  EXPECT_EQ(json.find(": nan"), std::string::npos);
}

TEST(Program, SaysWhatAHeldApproachNeeds) {
  const Experiment experiment;
  const auto complaint = [&](const Words& more) {
    Words words{"fit", experiment.data, "--models=c"};
    words.insert(words.end(), more.begin(), more.end());
    const ProgramResult result = run_program(words);
    EXPECT_NE(result.exit_code, 0) << joined(words);
    return result.err;
  };
  const auto says = [](const std::string& text, const char* words) {
    EXPECT_NE(text.find(words), std::string::npos) << text;
  };
  says(complaint({"--shape=ellipse"}), "a held approach is known for circles alone");
  says(complaint({"--load=3 mN"}), "one of them is held");
  says(complaint({"--free=load_offset"}), "free approach_offset");
  says(complaint({"--control=load"}), "is stated by --control=approach");
  std::filesystem::remove(experiment.folder.path() + "/held.toml");
  says(complaint({}), "is stated by --control=approach");
  says(run_program({"fit", MIXITY_ROOT "/data/mergel2018.csv", "--normal_stiffness=1 kN/m"}).err,
       "normal_stiffness is about a held approach");
  says(run_program({"fit", MIXITY_ROOT "/data/mergel2018.csv", "--free=approach_offset"}).err, "these data hold loads");
  says(run_program({"fit", MIXITY_ROOT "/data/mergel2018.csv", "--control=approach"}).err, "needs a column 'delta'");
  says(run_program({"curve", "--model=c", "--lambda=0.1", "--load=3", "--control=approach"}).err, "is about data");
}

}  // namespace held_approach_program_test
}  // namespace mixity::cli
