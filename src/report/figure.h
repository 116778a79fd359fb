// Figures as data: what is drawn, in which look, with which axes. Drawn by gnuplot from a script and a data file that
// are kept, so that a reader can restyle them.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mixity {

/// Lines as the paper has them, a dash-dot, b dashed, c solid; dotted for what is unstable.
enum class Look { solid, dashed, dash_dot, dotted, points };

struct Series {
  std::string label;  // in the key; empty: not there
  Look look = Look::solid;
  std::string color;  // "#rrggbb"
  std::vector<std::pair<double, double>> points;
};

struct Axis {
  std::string label;  // quantity and unit; _{} and ^{} as gnuplot has them
  std::optional<double> low, high;
  bool logarithmic = false;
};

struct Figure {
  std::string name;   // of its files, without ending
  std::string title;  // one line
  Axis x, y;
  std::vector<Series> series;
  std::vector<std::pair<std::string, Look>> key;  // further entries: what the looks mean
  bool key_inside = false;                        // at the upper left; else beside the axes
};

/// Colours that colour-blind readers tell apart (Okabe & Ito 2008), by number.
std::string color(std::size_t i);

/// Blocks of "x y", one for each series, under its name; gnuplot counts them by `index`.
std::string figure_data(const Figure& figure);
/// Draws NAME.svg and NAME.pdf from NAME.dat, all in the folder gnuplot is started in.
std::string figure_script(const Figure& figure);

struct DrawnFigures {
  std::vector<std::string> files;  // names within the folder
  std::string missing;             // why there are no SVG and PDF; empty if there are
};

/// Writes NAME.dat and NAME.gp of each figure, and with gnuplot installed NAME.svg and NAME.pdf. Each file is there
/// whole or not at all. Throws OutputError if the folder cannot be written.
DrawnFigures draw_figures(const std::vector<Figure>& figures, const std::string& folder);

}  // namespace mixity
