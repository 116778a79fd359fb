// The program as a whole: help, version, and usage that is refused.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "cli/run_program.h"
#include "dataset/temporary_folder.h"

namespace mixity::cli {
namespace program_test {

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

TEST(Program, ItsManualPageAndCompletionHaveEveryCommandAndFlag) {
  const std::string page = run_program({"help", "man"}).out, completion = run_program({"help", "completion"}).out;
  const std::string help = run_program({"help"}).out;
  EXPECT_TRUE(page.starts_with(".TH MIXITY 1"));
  for (const std::string command : {"fit", "report", "predict", "curve", "instability", "map", "sahli", "figures",
                                    "check", "runs", "design", "simulate", "merge", "import", "help"}) {
    ASSERT_NE(help.find("\n  " + command + " "), std::string::npos) << command;
    EXPECT_NE(page.find("\n.SS " + command + "\n"), std::string::npos) << command;
    EXPECT_NE(completion.find("\n    " + command + ") flags="), std::string::npos) << command;
  }
  EXPECT_NE(page.find("\n.B \\-\\-lambda_prior\n"), std::string::npos);
  EXPECT_NE(completion.find(" --lambda_prior= "), std::string::npos);
  EXPECT_NE(completion.find(" --pool "), std::string::npos);  // takes no value
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

TEST(Program, BadUsageIsOneLineAndExitTwo) {
  for (const auto& [words, complaint] : std::vector<std::pair<Words, std::string>>{
           {{"fitt"}, "unknown command 'fitt': did you mean fit? (see mixity help)"},
           {{"help", "Simulat"}, "unknown command 'Simulat': did you mean simulate? (see mixity help)"},
           {{"--foo", "fit"}, "flag '--foo' stands before the command: the command comes first (see mixity help)"},
           {{"fit", MIXITY_ROOT "/data/mergel2018.csv", "--hold=lamda=1"},
            "flag '--hold' names 'lamda', which no fitted model has: did you mean lambda? (known: lambda)"},
           {{"help", "foo"}, "unknown command 'foo' (see mixity help)"},
           {{"fit", "--foo=1", "a.csv"}, "unknown flag '--foo' (see mixity help fit)"},
           {{"fit", "--modles=c", "a.csv"}, "unknown flag '--modles': did you mean --models? (see mixity help fit)"},
           {{"fit", "-model", "c"}, "unknown flag '-model': did you mean --models? (see mixity help fit)"},
           {{"check", "a.csv", "--models=c"}, "unknown flag '--models' (see mixity help check)"},
           {{"fit", "a.csv", "--flagfile=x"}, "unknown flag '--flagfile' (see mixity help fit)"},
           {{"fit"}, "fit needs a data CSV or a fit definition (see mixity help fit)"},
           {{"fit", "a.csv", "--models"}, "flag '--models' needs a value"},
           {{"fit", "a.csv", "--models=c,z"},
            "flag '--models' names the unknown model 'z' (known: a, b, c, bk, hutchinson_suo, linear, power, "
            "quadratic)"},
           {{"fit", "a.csv", "--models=c,b,c"}, "flag '--models' names 'c' twice"},
           {{"fit", "a.csv", "--hold=lambda=0.1,lambda=0.2"}, "flag '--hold' names 'lambda' twice"},
           {{"predict", "--model=c", "--lambda=0.1", "--load=0", "--shear=0", "--radius=1e-300 m", "--modulus=1 Pa",
             "--toughness=1e300 J/m^2"},
            "--radius, --modulus and --toughness together are out of range"},
           {{"fit", "a.csv", "--format=xml"}, "flag '--format' is 'xml'; it must be text, json or csv"},
           {{"sahli", "a.csv", "--format=json"}, "flag '--format' is 'json'; it must be text or csv"},
           {{"instability", "--format=csv"}, "flag '--format' is 'csv'; it must be text or json"},
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
            "flag '--model': unknown model 'z' (known: a, b, c, bk, hutchinson_suo, linear, power, quadratic)"},
           {{"predict", "--model=C", "--lambda=0", "--load=1", "--shear=0"},
            "flag '--model': unknown model 'C': did you mean c? (known: a, b, c, bk, hutchinson_suo, linear, power, "
            "quadratic)"},
           {{"predict", "--model=c", "--lambda=0.1", "--load=1 mN", "--shear=0"},
            "flag '--load' has a unit; that needs --radius, --modulus and --toughness"},
           {{"predict", "--model=c", "--lambda=0.1", "--load=1", "--shear=0,x"},
            "flag '--shear': 'x' is not a number, or its unit is unknown"},
           {{"predict", "--model=c", "--lambda=0.1", "--load=1", "--shear=0", "--radius=1 mm"},
            "a dimensional prediction needs all of --radius, --modulus and --toughness"},
       })
    expect_refused(words, 2, complaint);
}

TEST(Program, HelpOffersTheFormatsThatACommandHas) {
  for (const auto& [command, formats] : std::vector<std::pair<std::string, std::string>>{
           {"fit", "text, json or csv"}, {"sahli", "text or csv"}, {"instability", "text or json"}}) {
    const std::string help = run_program({"help", command}).out;
    EXPECT_NE(help.find("output format: " + formats + " (default text)"), std::string::npos) << help;
  }
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

}  // namespace program_test
}  // namespace mixity::cli
