#include "report/figures/gnuplot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <pugixml.hpp>
#include <set>

#include "dataset/temporary_folder.h"
#include "report/without_programs.h"

namespace mixity {
namespace {

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

TEST(Gnuplot, DrawsSvgAndPdfBesideTheScript) {
  const DrawnFigures drawn = draw_figures({example("one"), example("two")}, "f");
  EXPECT_EQ(drawn.missing, "");
  EXPECT_EQ(paths(drawn), (std::set<std::string>{"f/one.dat", "f/one.gp", "f/one.svg", "f/one.pdf", "f/one.png",
                                                 "f/two.dat", "f/two.gp", "f/two.svg", "f/two.pdf", "f/two.png"}));
  EXPECT_FALSE(std::filesystem::exists("f"));  // writing them is for others
  ASSERT_EQ(drawn.svg.size(), 2u);
  EXPECT_EQ(contents(drawn)["f/two.svg"], drawn.svg[1]);
  EXPECT_NE(drawn.svg[0].find("T [mN]"), std::string::npos);
  EXPECT_EQ(contents(drawn)["f/one.pdf"].substr(0, 5), "%PDF-");
  EXPECT_EQ(contents(drawn)["f/one.png"].substr(1, 3), "PNG");
}

TEST(Gnuplot, TellsHowManyFiguresItHasBegun) {
  std::vector<double> told;
  draw_figures({example("one"), example("two"), example("three")}, "f", [&](double share) { told.push_back(share); });
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  for (const double share : told) EXPECT_EQ(std::round(3 * share), 3 * share);
}

TEST(Gnuplot, WithoutItDataAndScriptAreThereAndItSaysSo) {
  const WithoutPrograms nothing;
  const DrawnFigures drawn = draw_figures({example("one")}, "f");
  EXPECT_NE(drawn.missing.find("gnuplot"), std::string::npos);
  EXPECT_EQ(drawn.svg, std::vector<std::string>{""});
  EXPECT_EQ(paths(drawn), (std::set<std::string>{"f/one.dat", "f/one.gp"}));
}

TEST(Gnuplot, AFigureThatIsCutShortIsNotDelivered) {
  const TemporaryFolder programs;
  // as on a full disk: a file is there, and nobody complained
  const std::string gnuplot = programs.write(
      "gnuplot", "#!/bin/sh\nfor s; do echo '<svg></svg>' > ${s%.gp}.svg; echo '%PDF-1.5' > ${s%.gp}.pdf; done\n");
  std::filesystem::permissions(gnuplot, std::filesystem::perms::owner_all);
  const WithoutPrograms others(programs.path());
  const DrawnFigures drawn = draw_figures({example("one")}, "f");
  EXPECT_EQ(drawn.missing, "gnuplot failed at one");
  EXPECT_EQ(paths(drawn), (std::set<std::string>{"f/one.dat", "f/one.gp"}));
}

TEST(Gnuplot, AFigureThatCannotBeDrawnDoesNotTakeOthersAlong) {
  Figure broken = example("broken");
  broken.series.clear();  // nothing to plot: an error of the script
  const DrawnFigures drawn = draw_figures({example("one"), broken, example("two"), example("three")}, "f");
  EXPECT_EQ(drawn.missing, "gnuplot failed at broken");
  EXPECT_EQ(drawn.svg.at(1), "");
  for (const std::size_t i : {0, 2, 3}) EXPECT_NE(drawn.svg.at(i), "") << i;
}

TEST(Gnuplot, DrawsWhatHasNoExtent) {
  for (const bool logarithmic : {false, true}) {
    Figure figure = example("point");
    figure.x = {"x", 0.0, 0.0};
    figure.y = {"y", {}, {}, logarithmic};
    figure.series = {{"one point", Look::circles, "#000000", {{0, 5}}}};
    EXPECT_EQ(draw_figures({figure}, "f").missing, "");
  }
}

/// Texts that a browser shows at a point: titles other than the figure's own.
std::vector<std::string> hover_texts(const pugi::xml_document& svg) {
  std::vector<std::string> texts;
  for (const pugi::xpath_node& node : svg.select_nodes("//g/title")) texts.emplace_back(node.node().text().get());
  return texts;
}

TEST(Svg, SaysAtEachPointWhatItIsAndAsAWholeWhatItShows) {
  const std::string text = draw_figures({example("one")}, "f").svg.at(0);
  pugi::xml_document svg;
  ASSERT_TRUE(svg.load_string(text.c_str()));
  EXPECT_EQ(hover_texts(svg), (std::vector<std::string>{"line 2", "line 3: T < 1 & ’A’", "line 4"}));
  EXPECT_STREQ(svg.child("svg").child_value("title"), "Areas & loads");
  EXPECT_STREQ(svg.child("svg").child_value("desc"), "Caption with < and &.");
  EXPECT_STREQ(svg.child("svg").attribute("role").value(), "img");
  EXPECT_EQ(text.find("onmousemove"), std::string::npos);
}

TEST(Svg, HasIdsOfItsOwnAndEveryReferenceFindsOne) {
  pugi::xml_document svg;
  ASSERT_TRUE(svg.load_string(draw_figures({example("one")}, "f").svg.at(0).c_str()));
  std::set<std::string> ids;
  for (const pugi::xpath_node& node : svg.select_nodes("//*/@id")) {
    EXPECT_TRUE(std::string_view(node.attribute().value()).starts_with("one-"));
    EXPECT_TRUE(ids.insert(node.attribute().value()).second) << node.attribute().value();
  }
  for (const pugi::xpath_node& node : svg.select_nodes("//*/@xlink:href"))
    EXPECT_TRUE(ids.contains(std::string(node.attribute().value()).substr(1))) << node.attribute().value();
}

}  // namespace
}  // namespace mixity
