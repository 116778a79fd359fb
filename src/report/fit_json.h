// Fits as JSON, schema mixity-fit-1. docs/fits.schema.json describes the fields.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/result.h"
#include "report/fields.h"

namespace mixity {

/// A part of a list of files, and what all parts of a campaign share.
struct Shard {
  std::string part;                            // "2/10"; empty: all files
  std::vector<std::string> files{};            // the complete list, as given
  std::map<std::string, std::string> flags{};  // flags that were given and affect the results, by name
};

/// Part i of n, from the text "i/n".
struct ShardNumber {
  std::size_t part, of;  // 1 <= part <= of <= 10^6
};
/// Null for any other text.
std::optional<ShardNumber> shard_number(const std::string& text);

/// {schema, version, datasets: [...]}.
Json fits_document(std::span<const Analysis> results, const Shard& shard = {});
/// The same as text, indented, with a final newline.
std::string to_json(std::span<const Analysis> results, const Shard& shard = {});
std::string to_json(const Analysis& result);

/// The schemas of to_json and of a report's results.json.
Json fits_schema();
Json report_schema();

/// Merges the files with the parts of a campaign into one document, with the data sets in the order of its list of
/// files (part i of n has every n-th one from the i-th on). Throws InputError if schema, version, list of files or
/// flags differ, and for missing or repeated parts.
std::string merge_json(const std::vector<std::string>& paths);

/// Indented, with a final newline. Bytes of names and paths that are not UTF-8 are replaced.
std::string json_text(const Json& document);

/// A request as the fields of a page: {"constants": {name: text}, "options": {name: text}, "models": [key], "laws":
/// {key: law as typed}}. Leaves out options that take long, since a page fits at once.
Json request_fields(const FitRequest& request, const Overrides& constants);

}  // namespace mixity
