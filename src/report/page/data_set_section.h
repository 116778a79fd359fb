// What the report's page says of one data set.
#pragma once

#include <string>

#include "report/report.h"

namespace mixity {

/// Markup. Where the figures are not inside the page, the set is closed until a reader opens it.
std::string data_set_section(const ReportContent& content, const ReportEntry& entry);

}  // namespace mixity
