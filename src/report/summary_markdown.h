// The report's tables as Markdown, to be pasted into a lab book.
#pragma once

#include <string>

#include "report/report.h"

namespace mixity {

std::string summary_markdown(const ReportContent& content);

}  // namespace mixity
