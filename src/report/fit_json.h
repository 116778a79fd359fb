// Fits as JSON, schema mixity-fit-1. docs/fits.schema.json says what each field means.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/result.h"
#include "report/fields.h"

namespace mixity {

/// A part of a list of files, and what all parts of one campaign share.
struct Shard {
  std::string part;                            // "2/10"; empty: the whole
  std::vector<std::string> files{};            // the whole list, as it was given
  std::map<std::string, std::string> flags{};  // by name, those that were given and decide what is found
};

/// {schema, version, datasets: [...]}, indented, with a final newline.
std::string to_json(const std::vector<Analysis>& results, const Shard& shard = {});

/// The schema of what to_json writes.
Json fits_schema();

/// All that was found about one data set.
void describe(Fields<Analysis>& field);

/// Names and paths may hold bytes that are not UTF-8; they are replaced.
std::string json_text(const Json& document);

/// What a request states beside its data, as the fields of a page hold it: {"constants": {name: text}, "options":
/// {name: text}, "models": [key], "laws": {key: text of the law as it is typed}}. Options without those that take long:
/// a page fits at once.
Json request_fields(const FitRequest& request, const Overrides& constants);

}  // namespace mixity
