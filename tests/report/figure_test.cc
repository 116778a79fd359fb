#include "report/figure.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "dataset/csv.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace {

Figure example() {
  return {"example",
          "A line and its end",
          {"T [mN]", 0.0, 2.0},
          {"A [mm^2]", {}, 10.0, true},
          {{"the \"line\"", Look::dashed, "#0072b2", {{0, 1}, {1, 1.0 / 3}}},
           {"", Look::points, "#000000", {{1, 1.0 / 3}}}},
          {{"unstable", Look::dotted}}};
}

/// A program that is started finds gnuplot by PATH; restored at the end of the scope.
class WithoutPrograms {
 public:
  WithoutPrograms() : path_(std::getenv("PATH")) { setenv("PATH", "/nowhere", 1); }
  WithoutPrograms(const WithoutPrograms&) = delete;
  WithoutPrograms& operator=(const WithoutPrograms&) = delete;
  ~WithoutPrograms() { setenv("PATH", path_.c_str(), 1); }

 private:
  std::string path_;
};

TEST(Figure, DataReadBackToTheSameNumbers) {
  std::istringstream in(figure_data(example()));
  std::vector<double> numbers;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream fields(line);
    for (double value; fields >> value;) numbers.push_back(value);
  }
  EXPECT_EQ(numbers, (std::vector<double>{0, 1, 1, 1.0 / 3, 1, 1.0 / 3}));
}

TEST(Figure, ScriptNamesFilesAxesLooksAndKey) {
  const std::string script = figure_script(example());
  for (const char* part :
       {"set xlabel \"T [mN]\"", "set xrange [0:2]", "set ylabel \"A [mm^2]\"", "set yrange [*:10]", "set logscale y",
        "\"example.dat\" index 0 using 1:2 with lines lw 1.6 dt (14,6) lc rgb \"#0072b2\" title \"the \\\"line\\\"\"",
        "\"example.dat\" index 1 using 1:2 with points pt 6 ps 0.5 lc rgb \"#000000\" notitle",
        "keyentry with lines lw 1.1 dt (2,4) lc rgb \"#000000\" title \"unstable\"", "set output \"example.svg\"",
        "set output \"example.pdf\""})
    EXPECT_NE(script.find(part), std::string::npos) << part << "\nin\n" << script;
  EXPECT_EQ(script.find("set logscale x"), std::string::npos);
}

TEST(Figure, IsDrawnAsSvgAndPdfBesideItsScript) {
  const TemporaryFolder folder;
  const DrawnFigures drawn = draw_figures({example()}, folder.path());
  EXPECT_EQ(drawn.missing, "");
  EXPECT_EQ(drawn.files, (std::vector<std::string>{"example.dat", "example.gp", "example.svg", "example.pdf"}));
  const std::string svg = read_file(folder.path() + "/example.svg");
  EXPECT_NE(svg.find("</svg>"), std::string::npos);
  EXPECT_NE(svg.find("T [mN]"), std::string::npos);
  EXPECT_EQ(read_file(folder.path() + "/example.pdf").substr(0, 5), "%PDF-");
}

TEST(Figure, WithoutGnuplotLeavesDataAndScriptAndSaysSo) {
  const TemporaryFolder folder;
  const WithoutPrograms nothing;
  const DrawnFigures drawn = draw_figures({example()}, folder.path());
  EXPECT_NE(drawn.missing.find("gnuplot"), std::string::npos);
  EXPECT_EQ(drawn.files, (std::vector<std::string>{"example.dat", "example.gp"}));
  for (const std::string& file : drawn.files) EXPECT_TRUE(std::filesystem::exists(folder.path() + '/' + file)) << file;
  EXPECT_FALSE(std::filesystem::exists(folder.path() + "/example.svg"));
}

}  // namespace
}  // namespace mixity
