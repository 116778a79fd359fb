// Draws figures with gnuplot. Script and data are kept, so that a reader can restyle them.
#pragma once

#include <string>
#include <vector>

#include "report/figures/figure.h"

namespace mixity {

struct DrawnFigures {
  std::vector<std::string> files;  // names within the folder
  std::vector<std::string> svg;    // each figure's SVG; an empty text where it could not be drawn
  std::string missing;             // why there are figures without SVG and PDF; empty if there are none
};

/// Writes NAME.dat and NAME.gp of each figure, and with gnuplot installed NAME.svg and NAME.pdf. Each file is there
/// whole or not at all. Throws OutputError if the folder cannot be written.
DrawnFigures draw_figures(const std::vector<Figure>& figures, const std::string& folder);

}  // namespace mixity
