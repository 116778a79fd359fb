// results.json of a report: what `mixity fit --format=json` writes, and what the report adds.
// docs/results.schema.json says what each field means.
#pragma once

#include <string>

#include "report/fields.h"
#include "report/report.h"

namespace mixity {

std::string report_json(const ReportContent& content);

/// The schema of what report_json writes.
Json report_schema();

}  // namespace mixity
