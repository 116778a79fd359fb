#include <gtest/gtest.h>

#include <sstream>

#include "report/figures/gnuplot.h"
#include "report/figures/read_back.h"

namespace mixity {
namespace gnuplot_script_test {

Figure example() {
  return {"example",
          "A line and its end",
          {"T [mN]", 0.0, 2.0},
          {"A [mm^2]", {}, 10.0, true},
          {{"the \"line\"", Look::dashed, "#0072b2", {{0, 1}, {1, 1.0 / 3}}},
           {"nothing", Look::solid, "#000000", {}},
           {"", Look::circles, "#000000", {{1, 1.0 / 3}}, {{1, 1, 0.25, 0.5}}, {"line 5: \"A\""}}},
          {{"unstable", Look::dotted}}};
}

TEST(GnuplotScript, DataReadBackToTheSameNumbers) {
  const auto blocks = blocks_of(figure_data(example()));
  ASSERT_EQ(blocks.size(), 2u);  // a series without points has none
  EXPECT_EQ(blocks[0], (DataBlock{{{0, 1}, {1, 1.0 / 3}}, {}}));
  EXPECT_EQ(blocks[1], (DataBlock{{{1, 1.0 / 3, 1, 1, 0.25, 0.5}}, {"line 5: ’A’"}}));
}

TEST(GnuplotScript, ScriptNamesFilesAxesLooksAndKey) {
  const std::string script = figure_script(example());
  for (const char* part :
       {"set xlabel \"T [mN]\"", "set xrange [0:2]", "set xtics 0.5", "set ylabel \"A [mm^2]\"", ":10]",
        "set logscale y",
        "\"example.dat\" index 0 using 1:2 with lines lw 1.6 dt (14,6) lc rgb \"#0072b2\" title \"the \\\"line\\\"\"",
        "\"example.dat\" index 1 using 1:2:3:4:5:6 with xyerrorbars pt 6 ps 0.6 lc rgb \"#000000\" notitle",
        "\"example.dat\" index 1 using 1:2:7 with labels hypertext",
        "keyentry with lines lw 1.1 dt (2,4) lc rgb \"#000000\" title \"unstable\"", "set output \"example.svg\"",
        "set output \"example.pdf\""})
    EXPECT_NE(script.find(part), std::string::npos) << part << "\nin\n" << script;
  EXPECT_EQ(script.find("set logscale x"), std::string::npos);
}

TEST(GnuplotScript, DrawsTheFilesThatAreWanted) {
  const std::string script = figure_script(example(), {".png"});
  EXPECT_NE(script.find("set output \"example.png\"\nplot "), std::string::npos) << script;
  for (const char* other : {".svg", ".pdf", "replot"}) EXPECT_EQ(script.find(other), std::string::npos) << script;
}

TEST(GnuplotScript, AxesWithoutStatedEndsHoldEveryPointAndItsBars) {
  Figure figure = example();
  figure.x = {"x"};
  figure.y = {"y"};
  figure.series = {{"", Look::circles, "#000000", {{1, 10}, {3, 20}}, {{0.5, 1.5, 10, 10}, {3, 3, 15, 30}}}};
  const std::string script = figure_script(figure);
  double low = 0, high = 0;
  ASSERT_EQ(std::sscanf(script.c_str() + script.find("set xrange"), "set xrange [%lf:%lf]", &low, &high), 2);
  EXPECT_LT(low, 0.5);
  EXPECT_GT(high, 3);
  ASSERT_EQ(std::sscanf(script.c_str() + script.find("set yrange"), "set yrange [%lf:%lf]", &low, &high), 2);
  EXPECT_LT(low, 10);
  EXPECT_GT(high, 30);
}

TEST(GnuplotScript, LogarithmicAxesOfLessThanTwoDecadesAreLabelledWithinThem) {
  Figure figure = example();
  figure.x = {"x", 0.17, 0.57, true};
  EXPECT_NE(figure_script(figure).find("set xtics (\"0.2\" 0.2, \"0.3\" 0.3"), std::string::npos)
      << figure_script(figure);
  figure.x = {"x", 1.0, 1e4, true};
  EXPECT_NE(figure_script(figure).find("set format x \"10^{%T}\""), std::string::npos);
}

}  // namespace gnuplot_script_test
}  // namespace mixity
