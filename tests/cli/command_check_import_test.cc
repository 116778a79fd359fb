// mixity check and mixity import as their users run them, and input that no command can read.
#include <gtest/gtest.h>

#include <string>

#include "cli/run_program.h"
#include "dataset/temporary_folder.h"

namespace mixity::cli {
namespace command_check_import_test {

TEST(Program, CheckSaysWhatItUnderstood) {
  const TemporaryFolder folder;
  const ProgramResult result =
      run_program({"check", folder.write("a.csv", "P,T,A\n1,0,19.6\n1,1,19.5\n1,-0.1,19\n1,,19\n")});
  EXPECT_EQ(result.exit_code, 0);
  for (const char* words : {"dimensionless", "4 rows, 3 usable, 1 excluded", "line 5: T is empty",
                            "1 of 3 points has T < 0, used as it is", "provenance"})
    EXPECT_NE(result.out.find(words), std::string::npos) << words << "\n" << result.out;
}

TEST(Program, HowAFileIsReadIsShownBeforeItsConstantsAreKnown) {
  const TemporaryFolder folder;
  const std::string data = folder.write("a.csv",
                                        "Normalkraft (mN);Tangentialkraft (mN);Kontaktfl\xc3\xa4"
                                        "che (mm\xc2\xb2)\n"
                                        "0,7;0,05;0,232\n0,7;1,52;0,231\n4,7;0,03;0,376\n4,7;3,1;0,375\n");
  folder.write("a.toml", "youngs_modulus = \"1.6 MPa\"\npoisson_ratio = 0.5\n");
  const ProgramResult check = run_program({"check", data});
  EXPECT_EQ(check.exit_code, 0) << check.err;  // the file is fine
  EXPECT_NE(check.out.find("[[To fit it]]\n    " + data + ": the constants radius, toughness are missing"),
            std::string::npos)
      << check.out;
  // nor do missing constants hide the next file
  const ProgramResult two = run_program({"check", data, folder.write("b.csv", "P,T,A\n1,0,19.6\n1,1,19.5\n")});
  EXPECT_EQ(two.exit_code, 0) << two.err;
  EXPECT_NE(two.out.find("dimensionless\n    2 rows, 2 usable"), std::string::npos) << two.out;
  for (const char* words : {"4 rows, 4 usable", "read as: semicolons, decimal commas", "T from 'Tangentialkraft (mN)'",
                            "P = 4.7 ", "T = 0.03 .. 3.1 ", "A = 0.375 .. 0.376"})
    EXPECT_NE(check.out.find(words), std::string::npos) << words << "\n" << check.out;
}

TEST(Program, EnergiesAreCheckedWithoutAToughnessAndFittedWithOne) {
  const TemporaryFolder folder;
  const std::string data = folder.write("a.csv",
                                        "G_I [J/m^2],G_II [J/m^2]\n250,-3\n200,60\n150,140\n100,300\n"
                                        "-2,800\n-5,1\n"),
                    other = folder.write("b.csv",
                                         "mode_ratio,Gc [J/m^2]\n0,247\n0.23076923076923077,260\n"
                                         "0.48275862068965519,290\n0.75,400\n1,798\n");
  const ProgramResult check = run_program({"check", data});
  EXPECT_EQ(check.exit_code, 0) << check.err;
  for (const char* words :
       {"energies (G_I, G_II)", "6 rows, 5 usable, 1 excluded", "line 7: G_I + G_II <= 0",
        "toughness is not stated and has to be fitted (--free=toughness); where it is not, the largest G_I, 250 J/m^2, "
        "stands for it",
        "2 of 5 points have G_I or G_II < 0"})
    EXPECT_NE(check.out.find(words), std::string::npos) << words << "\n" << check.out;
  const auto values = [](const std::string& path) {
    return fields_of(
        lines_of(run_program({"fit", path, "--models=c", "--toughness=247 J/m^2", "--format=csv"}).out)[1]);
  };
  const auto one = values(data), same = values(other);
  ASSERT_GT(one.size(), 8);
  EXPECT_EQ(one[6], "lambda");
  // the files hold 17 digits of what is converted, and the minimum is found to some 1e-10
  EXPECT_NEAR(std::stod(one[7]), std::stod(same[7]), 1e-8 * std::stod(same[7]));
  EXPECT_NEAR(std::stod(one[8]), std::stod(same[8]), 1e-6 * std::stod(same[8]));
}

TEST(Program, AnImportCanBeFitted) {
  const TemporaryFolder folder;
  const std::string plot =
      folder.write("plot.csv", "run 1,,run 2,\nX,Y,X,Y\n0,19.6,0,23.9\n5,19.3,8,23.3\n10,18.2,12,22.5\n");
  const Words words{"import", plot, "--x=T", "--y=A", "--loads=1,5"};
  const ProgramResult shown = run_program(words);
  EXPECT_EQ(shown.exit_code, 0);
  EXPECT_EQ(shown.out,
            "curve,P,T,A\nrun 1,1,0,19.6\nrun 1,1,5,19.3\nrun 1,1,10,18.2\nrun 2,5,0,23.9\nrun 2,5,8,23.3\nrun "
            "2,5,12,22.5\n");
  const std::string data = folder.path("data.csv");
  EXPECT_EQ(run_program({"import", plot, "--x=T", "--y=A", "--loads=1,5", "--out", data}).out, "");
  EXPECT_EQ(content_of(data), shown.out);
  EXPECT_EQ(run_program({"fit", data, "--models=c"}).exit_code, 0);
  EXPECT_NE(run_program({"check", data}).out.find("provenance: digitised"), std::string::npos);
  EXPECT_NE(content_of(folder.path("data.toml")).find("plot.csv"), std::string::npos);
}

TEST(Program, AnImportLeavesTheConstantsBesideIt) {
  const TemporaryFolder folder;
  const std::string plot = folder.write("plot.csv", "a,\nX,Y\n0,19.6\n5,19.3\n10,18.2\n"),
                    constants = folder.write("data.toml", "note = \"mine\"\n");
  ASSERT_EQ(run_program({"import", plot, "--x=T", "--y=A", "--loads=1", "--out", folder.path("data.csv")}).exit_code,
            0);
  EXPECT_EQ(content_of(constants), "note = \"mine\"\n");
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

}  // namespace command_check_import_test
}  // namespace mixity::cli
