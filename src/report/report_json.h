// results.json of a report: what `mixity fit --format=json` says, and what the report adds. Schema: README.md and
// results.schema.json beside this file.
#pragma once

#include <string>

#include "report/report.h"

namespace mixity {

std::string report_json(const ReportContent& content);

}  // namespace mixity
