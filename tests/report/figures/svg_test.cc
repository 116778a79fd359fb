// What a drawing shows, read back from its SVG.
#include "report/figures/svg.h"

#include <gtest/gtest.h>

#include <pugixml.hpp>

#include "report/figures/layout.h"

namespace mixity {
namespace svg_test {

Figure example() {
  return {
      "one",
      "Areas & loads",
      {"T [mN]", 0.0, 2.0},
      {"A [mm^2]", 0.0, 10.0},
      {{"data", Look::circles, "#d55e00", {{0, 1}, {1, 5}, {2, 3}}, {}, {"line 2", "line 3: T < 1 & 'A'", "line 4"}},
       {"model", Look::dashed, "#000000", {{0, 1}, {2, 4}}}},
      {},
      KeyPlace::above,
      {},
      false,
      "Caption with < and &."};
}

pugi::xml_document parsed(const Figure& figure, Medium medium = Medium::file, bool narrow = false) {
  pugi::xml_document document;
  EXPECT_TRUE(document.load_string(svg(figure, medium, narrow).c_str()));
  return document;
}

/// The series drawn as lines and areas, in order; a key follows them.
std::vector<std::string> paths_of(const Figure& figure) {
  std::vector<std::string> paths;
  const pugi::xml_document document = parsed(figure);  // its nodes live as long as it does
  for (const pugi::xpath_node& node : document.select_nodes("/svg/g/path"))
    paths.emplace_back(node.node().attribute("d").value());
  paths.erase(paths.begin(), paths.begin() + 2);  // grid and axes
  return paths;
}

TEST(Svg, SaysAtEachPointWhatItIsAndAsAWholeWhatItShows) {
  const pugi::xml_document document = parsed(example());
  std::vector<std::string> texts;
  for (const pugi::xpath_node& node : document.select_nodes("//path/title"))
    texts.emplace_back(node.node().text().get());
  EXPECT_EQ(texts, (std::vector<std::string>{"line 2", "line 3: T < 1 & 'A'", "line 4"}));
  const pugi::xml_node drawing = document.child("svg");
  EXPECT_STREQ(drawing.child_value("title"), "Areas & loads");
  EXPECT_STREQ(drawing.child_value("desc"), "Caption with < and &.");
  EXPECT_STREQ(drawing.attribute("role").value(), "img");
  EXPECT_STREQ(drawing.attribute("aria-label").value(), "Areas & loads. Caption with < and &.");
}

/// On a page with many others.
TEST(Svg, HasNoIdsAndNothingThatRuns) {
  const pugi::xml_document document = parsed(example());
  EXPECT_TRUE(document.select_nodes("//*/@id").empty());
  EXPECT_TRUE(document.select_nodes("//script | //*/@onmousemove").empty());
}

TEST(Svg, OfAFileHasItsColoursAndOfAPageThoseOfThePagesStyle) {
  const std::string file = svg(example(), Medium::file), page = svg(example(), Medium::page);
  EXPECT_NE(file.find("<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>"), std::string::npos);
  EXPECT_NE(file.find("stroke=\"#d55e00\""), std::string::npos);
  EXPECT_EQ(file.find("var("), std::string::npos);
  EXPECT_NE(page.find("stroke=\"var(--color-1)\""), std::string::npos);
  EXPECT_NE(page.find("fill=\"var(--ink)\""), std::string::npos);
  EXPECT_EQ(page.find("<rect"), std::string::npos);
  EXPECT_EQ(page.find("\"#"), std::string::npos);
}

TEST(Svg, DrawsPointsAndLinesAtTheirPlacesOnTheAxes) {
  const Layout at = lay_out(example(), false);
  const pugi::xml_document document = parsed(example());
  std::size_t i = 0;
  for (const pugi::xpath_node& node : document.select_nodes("//path[title]")) {
    double left = 0, middle = 0, radius = 0;
    ASSERT_EQ(std::sscanf(node.node().attribute("d").value(), "M%lf %lfa%lf", &left, &middle, &radius), 3);
    EXPECT_NEAR(left + radius, at.x.of(example().series[0].points[i].first), 0.011);
    EXPECT_NEAR(middle, at.y.of(example().series[0].points[i++].second), 0.011);
  }
  EXPECT_EQ(i, 3u);
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  ASSERT_EQ(std::sscanf(paths_of(example()).at(0).c_str(), "M%lf %lfL%lf %lf", &x0, &y0, &x1, &y1), 4);
  EXPECT_NEAR(x0, at.left, 0.011);
  EXPECT_NEAR(x1, at.right, 0.011);
  EXPECT_NEAR(y0, at.y.of(1), 0.011);
  EXPECT_NEAR(y1, at.y.of(4), 0.011);
  EXPECT_NE(svg(example(), Medium::file).find("stroke-dasharray=\"9 4\""), std::string::npos);
}

/// Numbers of a path.
std::vector<double> numbers(std::string path) {
  for (char& c : path)
    if (std::isalpha(static_cast<unsigned char>(c))) c = ' ';
  std::istringstream in(path);
  return {std::istream_iterator<double>(in), {}};
}

TEST(Svg, CutsWhatLeavesTheFrame) {
  Figure figure = example();
  const double infinite = std::numeric_limits<double>::infinity();
  figure.series = {{"", Look::solid, "#000000", {{0, 5}, {0.5, 30}, {1, 5}, {1.5, -40}, {5, 1e300}, {1, infinite}}},
                   {"", Look::band, "#0072b2", {{-1, -1}, {3, -1}, {3, 4}, {-1, 4}}},
                   {"", Look::dotted, "#000000", {{3, 1}, {4, 1}}},
                   {"", Look::squares, "#000000", {{1, 1}, {3, 1}}, {{0.5, 1.5, 1, 1}, {2.5, 3.5, 1, 1}}}};
  const Layout at = lay_out(figure, false);
  const std::vector<std::string> paths = paths_of(figure);
  ASSERT_EQ(paths.size(), 4u);  // the line, the band, a bar and its square
  EXPECT_EQ(std::count(paths[0].begin(), paths[0].end(), 'M'), 3);
  const std::vector<double> line = numbers(paths[0]), band = numbers(paths[1]);
  for (const auto* all : {&line, &band})
    for (std::size_t i = 0; i < all->size(); i += 2) {
      EXPECT_GE((*all)[i], at.left - 0.01);
      EXPECT_LE((*all)[i], at.right + 0.01);
      EXPECT_GE((*all)[i + 1], at.top - 0.01);
      EXPECT_LE((*all)[i + 1], at.bottom + 0.01);
    }
  EXPECT_EQ(band.size(), 8u);
  EXPECT_EQ(std::count(paths[2].begin(), paths[2].end(), 'M'), 1);
  EXPECT_EQ(std::count(paths[3].begin(), paths[3].end(), 'M'), 1);
}

TEST(Svg, LeavesOutPointsOfALineThatNobodyWouldSee) {
  Figure figure = example();
  figure.series = {{"", Look::solid, "#000000", {}}};
  for (int i = 0; i <= 1000; ++i) figure.series[0].points.emplace_back(0.002 * i, 9 * std::pow(i / 1000.0, 2));
  const std::size_t shown = numbers(paths_of(figure).at(0)).size() / 2;
  EXPECT_LT(shown, 60u);
  EXPECT_GT(shown, 15u);
}

TEST(Svg, OfManyFramesIsOfDots) {
  Figure figure = example();
  figure.series = {{"", Look::circles, "#000000", {}}};
  for (int i = 0; i < 1000; ++i) figure.series[0].points.emplace_back(0.002 * i, 5);
  EXPECT_LT(svg(figure, Medium::file).size(), 25000u);
}

TEST(Svg, OfWhatHasNoExtentOrIsEmptyIsDrawn) {
  for (const bool logarithmic : {false, true}) {
    Figure figure = example();
    figure.x = {"x", 0.0, 0.0};
    figure.y = {"y", {}, {}, logarithmic};
    figure.series = {{"one point", Look::circles, "#000000", {{0, 5}}}};
    EXPECT_EQ(paths_of(figure).size(), 2u);  // the point, and it in the key
    figure.series.clear();
    EXPECT_EQ(paths_of(figure).size(), 0u);
  }
}

}  // namespace svg_test
}  // namespace mixity
