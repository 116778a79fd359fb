// Figures as data and scripts for gnuplot, and drawn by the program gnuplot.
#pragma once

#include <string>
#include <vector>

#include "report/figures/figure.h"
#include "solver/options.h"

namespace mixity {

/// Blocks of "x y [x_low x_high y_low y_high] ["hover"]", one per series, under its name; gnuplot selects them by
/// `index`.
std::string figure_data(const Figure& figure);

/// A script that draws NAME.svg, NAME.pdf and NAME.png (300 dots an inch), or those with these extensions, from
/// NAME.dat, all in the folder where gnuplot runs.
std::string figure_script(const Figure& figure, const std::vector<std::string>& endings = {".svg", ".pdf", ".png"});

struct GnuplotFigures {
  std::vector<std::vector<std::string>> files;  // contents by [figure][extension]; empty for a figure that is not drawn
  std::string missing;                          // why some are not drawn; empty if all are
};

/// Draws figures as files with these extensions, ".pdf" and ".png", by as many processes as there are processors.
/// Passes the fraction begun to `progress`. Throws OutputError if there is no folder for temporary files.
GnuplotFigures draw_by_gnuplot(const std::vector<const Figure*>& figures, const std::vector<std::string>& endings,
                               const Progress& progress = {});

}  // namespace mixity
