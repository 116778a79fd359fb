// The section on one data set in the report's page.
#pragma once

#include <string>

#include "report/report.h"

namespace mixity {

/// Returns markup. If the figures are in separate files, the section is folded until a reader opens it.
std::string data_set_section(const ReportContent& content, const ReportEntry& entry);

}  // namespace mixity
