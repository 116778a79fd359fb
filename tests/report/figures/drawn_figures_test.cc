#include "report/figures/drawn_figures.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>

#include "dataset/temporary_folder.h"
#include "report/without_programs.h"

namespace mixity {
namespace drawn_figures_test {

Figure example(const std::string& name) {
  return {
      name,
      "Areas & loads",
      {"T [mN]", 0.0, 2.0},
      {"A [mm^2]", 0.0, 10.0},
      {{"data", Look::circles, "#d55e00", {{0, 1}, {1, 5}, {2, 3}}, {}, {"line 2", "line 3: T < 1 & 'A'", "line 4"}},
       {"model", Look::solid, "#000000", {{0, 1}, {2, 4}}}},
      {},
      KeyPlace::above,
      {},
      false,
      "Caption with < and &."};
}

/// What is to be written, by path.
std::map<std::string, std::string> contents(const DrawnFigures& drawn) {
  std::map<std::string, std::string> files;
  for (const OutputFile& file : drawn.files) files[file.path] = file.content;
  return files;
}

std::set<std::string> paths(const DrawnFigures& drawn) {
  std::set<std::string> names;
  for (const OutputFile& file : drawn.files) names.insert(file.path);
  return names;
}

constexpr FigureFormats kAll{true, true, true};

TEST(DrawnFigures, AreSvgAloneUnlessMoreIsAskedFor) {
  const WithoutPrograms nothing;  // none is started
  const DrawnFigures drawn = draw_figures({example("one"), example("two")}, "f", {});
  EXPECT_EQ(drawn.missing, "");
  EXPECT_EQ(paths(drawn), (std::set<std::string>{"f/one.svg", "f/two.svg"}));
  EXPECT_EQ(drawn.endings.at("two"), std::vector<std::string>{".svg"});
  EXPECT_EQ(draw_figures({example("one")}, "f", {.gnuplot = true}).missing, "");
}

TEST(DrawnFigures, OfEveryFormatAreThere) {
  const DrawnFigures drawn = draw_figures({example("one"), example("two")}, "f", kAll);
  EXPECT_EQ(drawn.missing, "");
  EXPECT_EQ(paths(drawn), (std::set<std::string>{"f/one.dat", "f/one.gp", "f/one.svg", "f/one.pdf", "f/one.png",
                                                 "f/two.dat", "f/two.gp", "f/two.svg", "f/two.pdf", "f/two.png"}));
  EXPECT_EQ(drawn.endings.at("one").size(), 5u);
  EXPECT_FALSE(std::filesystem::exists("f"));  // writing them is for others
  EXPECT_NE(contents(drawn)["f/two.svg"].find("T [mN]"), std::string::npos);
  EXPECT_EQ(contents(drawn)["f/one.pdf"].substr(0, 5), "%PDF-");
  EXPECT_EQ(contents(drawn)["f/one.png"].substr(1, 3), "PNG");
  EXPECT_EQ(paths(draw_figures({example("one")}, "f", {.pdf = true})),
            (std::set<std::string>{"f/one.svg", "f/one.pdf"}));
}

TEST(DrawnFigures, ReportHowManyGnuplotHasBegun) {
  std::vector<double> told;
  draw_figures({example("one"), example("two"), example("three")}, "f", kAll,
               [&](double share) { told.push_back(share); });
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  for (const double share : told) EXPECT_EQ(std::round(3 * share), 3 * share);
}

TEST(DrawnFigures, WithoutGnuplotAreSvgAndScriptAndSaySo) {
  const WithoutPrograms nothing;
  const DrawnFigures drawn = draw_figures({example("one")}, "f", kAll);
  EXPECT_NE(drawn.missing.find("gnuplot"), std::string::npos);
  EXPECT_EQ(paths(drawn), (std::set<std::string>{"f/one.svg", "f/one.dat", "f/one.gp"}));
}

TEST(DrawnFigures, RemoveFoldersThatKilledProgramsLeftAndNoOthers) {
  const TemporaryFolder temporary;
  const auto made = [&](const std::string& name, std::chrono::minutes age) {
    const std::string path = temporary.path(name);
    std::filesystem::create_directory(path);
    temporary.write(name + "/one.dat", "1");
    std::filesystem::last_write_time(path, std::filesystem::file_time_type::clock::now() - age);
    return path;
  };
  using std::chrono::minutes;
  const std::string left = made("mixity-figures-aaaaaa", minutes(5)), young = made("mixity-figures-bbbbbb", minutes(0)),
                    held = made("mixity-figures-cccccc", minutes(5)), theirs = made("figures-dddddd", minutes(5));
  const int lock = ::open(held.c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(::flock(lock, LOCK_EX), 0);
  const char* const before = std::getenv("TMPDIR");
  const std::string kept = before ? before : "";
  ::setenv("TMPDIR", temporary.path().c_str(), 1);
  draw_figures({example("one")}, "f", {.pdf = true});
  before ? ::setenv("TMPDIR", kept.c_str(), 1) : ::unsetenv("TMPDIR");
  ::close(lock);
  EXPECT_FALSE(std::filesystem::exists(left));
  for (const std::string& path : {young, held, theirs}) EXPECT_TRUE(std::filesystem::exists(path + "/one.dat")) << path;
}

TEST(DrawnFigures, AFigureThatIsCutShortIsNotDelivered) {
  const TemporaryFolder programs;
  // as on a full disk: a file is there, and nobody complained
  const std::string gnuplot = programs.write("gnuplot", "#!/bin/sh\nfor s; do echo '%PDF-1.5' > ${s%.gp}.pdf; done\n");
  std::filesystem::permissions(gnuplot, std::filesystem::perms::owner_all);
  const WithoutPrograms others(programs.path());
  const DrawnFigures drawn = draw_figures({example("one")}, "f", kAll);
  EXPECT_EQ(drawn.missing, "gnuplot failed at one");
  EXPECT_EQ(paths(drawn), (std::set<std::string>{"f/one.svg", "f/one.dat", "f/one.gp"}));
}

TEST(DrawnFigures, AFigureThatCannotBeDrawnDoesNotTakeOthersAlong) {
  Figure broken = example("broken");
  broken.series.clear();  // nothing to plot: an error of the script
  const DrawnFigures drawn = draw_figures({example("one"), broken, example("two"), example("three")}, "f", kAll);
  EXPECT_EQ(drawn.missing, "gnuplot failed at broken");
  EXPECT_EQ(contents(drawn).count("f/broken.pdf"), 0u);
  for (const char* name : {"one", "two", "three"}) EXPECT_EQ(drawn.endings.at(name).size(), 5u) << name;
}

TEST(DrawnFigures, DrawsWhatHasNoExtent) {
  for (const bool logarithmic : {false, true}) {
    Figure figure = example("point");
    figure.x = {"x", 0.0, 0.0};
    figure.y = {"y", {}, {}, logarithmic};
    figure.series = {{"one point", Look::circles, "#000000", {{0, 5}}}};
    EXPECT_EQ(draw_figures({figure}, "f", kAll).missing, "");
  }
}

}  // namespace drawn_figures_test
}  // namespace mixity
