// The files of figures: SVG, and on request PDF, PNG, scripts and data by gnuplot.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/request.h"
#include "base/files.h"
#include "report/figures/figure.h"

namespace mixity {

struct DrawnFigures {
  std::vector<OutputFile> files;                            // to be written
  std::map<std::string, std::vector<std::string>> endings;  // of a figure's files, by its name: ".svg", ".pdf"
  std::string missing;                                      // what could not be drawn, and why; empty if all was
};

/// FOLDER/NAME.svg of each figure, and in the formats that are asked for NAME.pdf, NAME.png, and gnuplot's NAME.gp with
/// NAME.dat. Nothing is written yet, and gnuplot is started for PDF and PNG only. Throws OutputError if there is no
/// folder for temporary files.
DrawnFigures draw_figures(const std::vector<Figure>& figures, const std::string& folder, const FigureFormats& formats,
                          const Progress& progress = {});

/// The files of wide figures as they are drawn for phones, which a page needs that shows files.
std::vector<OutputFile> draw_for_phones(const std::vector<Figure>& figures, const std::string& folder);
/// The name of such a file.
std::string narrow_file(const Figure& figure);

}  // namespace mixity
