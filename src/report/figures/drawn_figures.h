// The files of figures: SVG, and on request PDF, PNG, and gnuplot's scripts and data.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/request.h"
#include "base/files.h"
#include "report/figures/figure.h"

namespace mixity {

struct DrawnFigures {
  std::vector<OutputFile> files;                            // files to write
  std::map<std::string, std::vector<std::string>> endings;  // of each figure's files, by its name: ".svg", ".pdf"
  std::string missing;                                      // what could not be drawn and why; empty if everything was
};

/// FOLDER/NAME.svg of each figure, and in the requested formats NAME.pdf, NAME.png, and gnuplot's NAME.gp with
/// NAME.dat. Writes no file yet, and starts gnuplot for PDF and PNG only. Throws OutputError if there is no folder for
/// temporary files.
DrawnFigures draw_figures(const std::vector<Figure>& figures, const std::string& folder, const FigureFormats& formats,
                          const Progress& progress = {});

/// Narrow versions of wide figures, for phones, needed by a page that refers to files.
std::vector<OutputFile> draw_for_phones(const std::vector<Figure>& figures, const std::string& folder);
/// The name of that file.
std::string narrow_file(const Figure& figure);

}  // namespace mixity
