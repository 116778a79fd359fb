// A figure as gnuplot's data and script.
#pragma once

#include <string>
#include <vector>

#include "report/figures/figure.h"

namespace mixity {

/// Blocks of "x y [x_low x_high y_low y_high] ["hover"]", one for each series, under its name; gnuplot counts them by
/// `index`.
std::string figure_data(const Figure& figure);

/// Draws NAME.svg, NAME.pdf and NAME.png (300 dots an inch), or those of these endings, from NAME.dat, all in the
/// folder gnuplot is started in.
std::string figure_script(const Figure& figure, const std::vector<std::string>& endings = {".svg", ".pdf", ".png"});

}  // namespace mixity
