// mixity figures: the figures of the paper, with or without data.
#include <iostream>

#include "cli/commands.h"
#include "cli/flags.h"
#include "cli/progress.h"
#include "report/figures/drawn_figures.h"
#include "report/figures/paper_figures.h"
#include "report/page/paper_page.h"

DEFINE_bool(paper, false, "the figures of Papangelo & Ciavarella (2019)");

namespace mixity::cli {

int run_figures(const Arguments& arguments) {
  if (!FLAGS_paper || FLAGS_out.empty())
    throw UsageError("figures needs --paper and --out=DIR (see mixity help figures)");
  std::vector<Dataset> data;
  for (const std::string& path : arguments) data.push_back(load_dataset(path));
  const std::vector<Figure> figures = paper_figures(data);
  const DrawnFigures drawn = draw_figures(figures, FLAGS_out, figure_formats(), progress_line("figures"));
  std::vector<OutputFile> files = drawn.files;
  files.push_back({FLAGS_out + "/figures.html", paper_page(figures, drawn)});
  write_outputs(files);
  for (const OutputFile& file : files) std::cout << file.path << '\n';
  if (!drawn.missing.empty()) warn(drawn.missing);
  return kFine;
}

}  // namespace mixity::cli
