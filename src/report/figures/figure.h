// Figures as data: series, axes and a key. svg.h and gnuplot.h draw them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mixity {

/// Lines as in the paper: model a dash-dot, b dashed, c solid; dotted for unstable branches and references.
/// band: the area within the points as a polygon, tinted.
enum class Look { solid, dashed, dash_dot, dash_dots, dotted, circles, squares, triangles, diamonds, band };

struct Bars {
  double x_low, x_high, y_low, y_high;
};

using Points = std::vector<std::pair<double, double>>;  // (x, y)

struct Series {
  std::string label{};  // in the key; empty: not in the key
  Look look = Look::solid;
  std::string color{};  // "#rrggbb"
  Points points{};
  std::vector<Bars> bars{};          // one for each point, or none
  std::vector<std::string> hover{};  // the tooltip of each point, or none
};

struct Axis {
  std::string label{};                  // quantity and unit; _{} and ^{} as gnuplot has them
  std::optional<double> low{}, high{};  // null: fits the points
  bool logarithmic = false;
};

enum class KeyPlace { above, beside, top_left };

struct Figure {
  std::string name{};   // of its files, without ending
  std::string title{};  // one line
  Axis x{}, y{};
  std::vector<Series> series{};
  std::vector<std::pair<std::string, Look>> key{};  // further entries that explain the looks
  KeyPlace key_place = KeyPlace::above;
  std::string key_title{};
  bool wide = false;      // over the page instead of a column
  std::string caption{};  // one to three sentences: what is drawn and what it shows
  std::string drawn{};    // a finished SVG, shown as it is; empty: drawn from the members above
};

/// The area between two lines with the same direction.
Series band(const std::string& label, const std::string& color, Points low, const Points& high);

/// Colours that colour-blind readers can distinguish (Okabe & Ito 2008), by number.
std::string color(std::size_t i);

/// A model's line, symbol and colour, the same in every figure.
Look model_line(std::string_view key);
Look model_symbol(std::string_view key);
std::string model_color(std::string_view key);

}  // namespace mixity
