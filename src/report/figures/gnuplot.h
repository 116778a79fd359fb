// Figures as gnuplot's data and scripts, and drawn by the program gnuplot.
#pragma once

#include <string>
#include <vector>

#include "report/figures/figure.h"
#include "solver/options.h"

namespace mixity {

/// Blocks of "x y [x_low x_high y_low y_high] ["hover"]", one for each series, under its name; gnuplot counts them by
/// `index`.
std::string figure_data(const Figure& figure);

/// Draws NAME.svg, NAME.pdf and NAME.png (300 dots an inch), or those of these endings, from NAME.dat, all in the
/// folder in which gnuplot is started.
std::string figure_script(const Figure& figure, const std::vector<std::string>& endings = {".svg", ".pdf", ".png"});

struct GnuplotFigures {
  std::vector<std::vector<std::string>> files;  // [figure][ending]: contents; empty for a figure that is not drawn
  std::string missing;                          // why some are not drawn; empty if all are
};

/// As files of these endings, ".pdf" and ".png", on as many processes as there are processors. Passes the
/// share that is begun to `progress`. Throws OutputError if there is no folder for temporary files.
GnuplotFigures draw_by_gnuplot(const std::vector<const Figure*>& figures, const std::vector<std::string>& endings,
                               const Progress& progress = {});

}  // namespace mixity
