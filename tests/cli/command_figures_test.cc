#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "cli/run_program.h"
#include "dataset/temporary_folder.h"

namespace mixity::cli {
namespace command_figures_test {

TEST(Figures, OfThePaperAreListedAndThere) {
  const TemporaryFolder folder;
  const ProgramResult result =
      run_program({"figures", "--paper", "--formats=pdf,png,gnuplot", "--out", folder.path("new/paper")});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  std::istringstream lines(result.out);
  std::size_t files = 0;
  for (std::string file; std::getline(lines, file); ++files) EXPECT_NE(content_of(file), "") << file;
  EXPECT_EQ(files, 71u);  // fourteen figures: data, script, SVG, PDF, PNG; and their page
}

TEST(Figures, StandOnOnePageWithTheirEquationsAndWhereThePrintDiffers) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_program({"figures", "--paper", "--formats=pdf", "--out", folder.path()}).exit_code, 0);
  const std::string page = content_of(folder.path("figures.html"));
  std::size_t figures = 0;
  for (std::size_t at = 0; (at = page.find("<figcaption>", at)) != std::string::npos; ++at) {
    ++figures;
    EXPECT_NE(page.substr(at, page.find("</figure>", at) - at).find("Equations"), std::string::npos);
  }
  EXPECT_EQ(figures, 14u);
  for (const char* text :
       {"href=\"fig6_A_u.pdf\"",
        "u<sub>u</sub> = (3/4)^(2/3) T<sub>u</sub>/(3π + P − √(S<sub>0</sub>² − λ T<sub>u</sub>²))^(1/3)",
        "The paper prints u<sub>u</sub> and A<sub>u</sub> with +", "for every λ &gt; 8/9", "Johnson (1996)"})
    EXPECT_NE(page.find(text), std::string::npos) << text;
}

TEST(Figures, HaveThePointsOfDataThatAreNamed) {
  const TemporaryFolder folder;
  const ProgramResult result =
      run_program({"figures", "--paper", MIXITY_ROOT "/data/mergel2018.csv", MIXITY_ROOT "/data/waters_guduru2010.csv",
                   "--formats=gnuplot", "--out", folder.path()});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  for (const char* name : {"fig7", "fig8a", "fig8c", "fig9"})
    EXPECT_NE(content_of(folder.path(std::string(name) + ".dat")).find("data, reconstructed"), std::string::npos)
        << name;
  EXPECT_EQ(content_of(folder.path("fig3.dat")).find("reconstructed"), std::string::npos);
}

TEST(Figures, WithoutAPlaceToGoAreBadUsage) {
  for (const Words& words : {Words{"figures"}, Words{"figures", "--paper"}, Words{"figures", "--out=x"}})
    EXPECT_EQ(run_program(words).exit_code, 2);
}

TEST(Figures, InAFolderThatCannotBeWrittenEndWithFour) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "");
  EXPECT_EQ(run_program({"figures", "--paper", "--out", file + "/below"}).exit_code, 4);
}

}  // namespace command_figures_test
}  // namespace mixity::cli
