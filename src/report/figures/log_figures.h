// T(t) and A(t) of the runs of a log, with their phases shaded and the cuts marked.
#pragma once

#include <vector>

#include "dataset/logs/reduced_log.h"
#include "report/figures/figure.h"

namespace mixity {

/// Two figures per run: run_1_T, run_1_A, ...
std::vector<Figure> log_figures(const ReducedLogs& logs);

/// The fit definition that `mixity runs` writes: points, peaks, and figures of T(t) for the report.
std::string runs_definition(const std::vector<Figure>& figures);

}  // namespace mixity
