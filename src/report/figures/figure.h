// Figures as data: series, axes and a key. svg.h and gnuplot.h draw them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mixity {

/// Lines as in the paper: model a dash-dot, b dashed, c solid; dotted for unstable branches and references. band: a
/// tinted area, whose outline is the polygon of the points.
enum class Look { solid, dashed, dash_dot, dash_dots, dotted, circles, squares, triangles, diamonds, band };

struct Bars {
  double x_low, x_high, y_low, y_high;
};

using Points = std::vector<std::pair<double, double>>;  // (x, y)

struct Series {
  std::string label{};  // shown in the key; empty: not in the key
  Look look = Look::solid;
  std::string color{};  // "#rrggbb"
  Points points{};
  std::vector<Bars> bars{};          // one per point, or empty
  std::vector<std::string> hover{};  // tooltip of each point, or empty
};

struct Axis {
  std::string label{};                  // quantity and unit; _{} and ^{} as in gnuplot
  std::optional<double> low{}, high{};  // null: fitted to the points
  bool logarithmic = false;
};

enum class KeyPlace { above, beside, top_left };

struct Figure {
  std::string name{};   // of its files, without extension
  std::string title{};  // one line
  Axis x{}, y{};
  std::vector<Series> series{};
  std::vector<std::pair<std::string, Look>> key{};  // additional entries that explain the looks
  KeyPlace key_place = KeyPlace::above;
  std::string key_title{};
  bool wide = false;      // as wide as the page instead of a column
  std::string caption{};  // one to three sentences: what is drawn and what it shows
  std::string drawn{};    // a finished SVG, shown unchanged; empty: drawn from the members above
};

/// The area between two lines that run in the same direction.
Series band(const std::string& label, const std::string& color, Points low, const Points& high);

/// Colours that colour-blind readers can distinguish (Okabe & Ito 2008), by number.
std::string color(std::size_t i);

/// A model's line, symbol and colour, the same in every figure.
Look model_line(std::string_view key);
Look model_symbol(std::string_view key);
std::string model_color(std::string_view key);

}  // namespace mixity
