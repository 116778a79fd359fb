// The report as one HTML file that needs no other: styles and figures are within it.
#pragma once

#include <string>

#include "report/report.h"

namespace mixity {

/// HTML5, well-formed as XML below its first line. The same input gives the same bytes.
std::string report_page(const ReportContent& content);

}  // namespace mixity
