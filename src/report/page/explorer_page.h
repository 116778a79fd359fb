// The explorer (src/explorer) with a report's data sets in it.
#pragma once

#include <string>

#include "report/report.h"

namespace mixity {

/// `shell`: the page as tools/explorer makes it. Each data set goes in as its file, byte for byte, with what stands
/// beside it; one of several files as its points. Empty if the shell has no place for them.
std::string explorer_page(std::string shell, const ReportContent& content);

}  // namespace mixity
