// Draws figures by the program gnuplot.
#pragma once

#include <string>
#include <vector>

#include "report/figures/figure.h"
#include "solver/options.h"

namespace mixity {

struct GnuplotFigures {
  std::vector<std::vector<std::string>> files;  // [figure][ending]: contents; none of a figure that is not drawn
  std::string missing;                          // why some are not drawn; empty if all are
};

/// As files of these endings, ".pdf" and ".png", on as many processes as there are processors. Passes the part that is
/// begun to `progress`. Throws OutputError if there is no folder for temporary files.
GnuplotFigures draw_by_gnuplot(const std::vector<const Figure*>& figures, const std::vector<std::string>& endings,
                               const Progress& progress = {});

}  // namespace mixity
