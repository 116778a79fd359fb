// What curve, instability and map have in common: finite numbers only, and refusals in one line.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cli/run_program.h"

namespace mixity::cli {
namespace curve_commands_test {

/// No output at any input holds anything that is no finite number.
TEST(CurveCommands, NeverPrintNanOrInfinity) {
  const Words loads{"-4.71238898038469", "-4.7", "-1", "-1e-300", "0", "1e-300", "1", "30.4", "1e8"};
  const Words models{"--model=a", "--model=b", "--model=c", "--model=bk"};
  const Words lambdas{"--lambda=0",     "--lambda=1e-300", "--lambda=1e-120",
                      "--lambda=1e-12", "--lambda=0.15",   "--lambda=0.9999999999999999",
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
      // their folds lie beyond 1e150: refused (command_curve_test.cc)
      const bool too_far = parameter == "--lambda=1e-300" && model != "--model=a";
      for (const std::string& load : loads) {
        if (!too_far) {
          check({"curve", model, parameter, "--load=" + load, "--points=33"});
          check({"curve", model, parameter, "--load=" + load, "--chord=1e-3"});
        }
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
           {"curve", "--model=c", "--lambda=0.15", "--loads=1,2"},
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

}  // namespace curve_commands_test
}  // namespace mixity::cli
