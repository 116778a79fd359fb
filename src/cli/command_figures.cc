// mixity figures: figures that need no data.
#include <iostream>

#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/flags.h"
#include "cli/progress.h"
#include "cli/usage_error.h"
#include "report/figures/gnuplot.h"
#include "report/figures/paper_figures.h"

namespace mixity::cli {

int run_figures(const Arguments& arguments) {
  require_flags_only("figures", arguments);
  if (!FLAGS_paper || FLAGS_out.empty())
    throw UsageError("figures needs --paper and --out=DIR (see mixity help figures)");
  const DrawnFigures drawn = draw_figures(paper_figures(), FLAGS_out, progress_line("figures"));
  write_files(drawn.files);
  for (const OutputFile& file : drawn.files) std::cout << file.path << '\n';
  if (!drawn.missing.empty()) std::cerr << "mixity: " << drawn.missing << '\n';
  return kFine;
}

}  // namespace mixity::cli
