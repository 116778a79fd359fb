// Figures as data: what is drawn, in which look, with which axes. svg.h and gnuplot.h draw them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mixity {

/// Lines as the paper has them: a dash-dot, b dashed, c solid; dotted for what is unstable or a reference.
/// band: the area within the points as a polygon, tinted.
enum class Look { solid, dashed, dash_dot, dash_dots, dotted, circles, squares, triangles, diamonds, band };

struct Bars {
  double x_low, x_high, y_low, y_high;
};

using Points = std::vector<std::pair<double, double>>;  // (x, y)

struct Series {
  std::string label{};  // in the key; empty: not there
  Look look = Look::solid;
  std::string color{};  // "#rrggbb"
  Points points{};
  std::vector<Bars> bars{};          // one for each point, or none
  std::vector<std::string> hover{};  // one for each point, or none: what a reader sees who points at it
};

struct Axis {
  std::string label{};                  // quantity and unit; _{} and ^{} as gnuplot has them
  std::optional<double> low{}, high{};  // null: as the points need
  bool logarithmic = false;
};

enum class KeyPlace { above, beside, top_left };

struct Figure {
  std::string name{};   // of its files, without ending
  std::string title{};  // one line
  Axis x{}, y{};
  std::vector<Series> series{};
  std::vector<std::pair<std::string, Look>> key{};  // further entries: what the looks mean
  KeyPlace key_place = KeyPlace::above;
  std::string key_title{};
  bool wide = false;      // over the page instead of a column
  std::string caption{};  // one to three sentences: what is drawn and what it says
  std::string drawn{};    // SVG that is there already, shown as it is; empty: drawn from the above
};

/// The area between two lines with the same direction.
Series band(const std::string& label, const std::string& color, Points low, const Points& high);

/// Colours that colour-blind readers tell apart (Okabe & Ito 2008), by number.
std::string color(std::size_t i);

/// A model's line, symbol and colour, the same in every figure.
Look model_line(std::string_view key);
Look model_symbol(std::string_view key);
std::string model_color(std::string_view key);

}  // namespace mixity
