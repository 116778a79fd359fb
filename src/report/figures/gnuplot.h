// Draws figures with gnuplot. Script and data are kept, so that a reader can restyle them.
#pragma once

#include <string>
#include <vector>

#include "base/output_file.h"
#include "report/figures/figure.h"
#include "solver/options.h"

namespace mixity {

struct DrawnFigures {
  std::vector<OutputFile> files;    // of the folder, to be written
  std::vector<std::string> svg;     // each figure's SVG; an empty text where it could not be drawn
  std::vector<std::string> narrow;  // the same for a phone, of wide figures; else an empty text
  std::string missing;              // why there are figures without SVG and PDF; empty if there are none
};

/// FOLDER/NAME.dat and NAME.gp of each figure, and with gnuplot installed NAME.svg, NAME.pdf and NAME.png, whole or not
/// at all. Nothing is written there yet. Tells `progress` how many of them gnuplot has begun. Throws OutputError if the
/// system's folder for temporary files cannot be.
DrawnFigures draw_figures(const std::vector<Figure>& figures, const std::string& folder, const Progress& progress = {});

}  // namespace mixity
