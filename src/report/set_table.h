// The data sets of a report side by side, for the beginning of the page and of the Markdown summary.
#pragma once

#include "report/fit_table.h"
#include "report/report.h"

namespace mixity {

/// A row for each data set: its name and size, and the model that describes it best. Empty for a single set.
FitTable set_table(const ReportContent& content);

}  // namespace mixity
