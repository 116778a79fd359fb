// T(t) and A(t) of the runs of a log, with their phases shaded and the cuts marked.
#pragma once

#include <vector>

#include "report/figures/figure.h"
#include "report/runs_files.h"

namespace mixity {

/// Two for each run: run_1_T, run_1_A, ...
std::vector<Figure> log_figures(const ReducedLog& log);

}  // namespace mixity
