// docs/*.schema.json are what the descriptions of the outputs say; MIXITY_UPDATE_GOLDEN=1 writes them anew.
#include <gtest/gtest.h>

#include "report/fit_json.h"
#include "report/golden_file.h"
#include "report/report_json.h"

namespace mixity {
namespace {

/// On one line what fits there: a field of a schema is read as a row of a table.
std::string laid_out(const Json& json, const std::string& indent = "") {
  std::string line, block, separator;
  const bool object = json.is_object();
  if (!object && !json.is_array()) return json.dump();
  for (const auto& [key, value] : json.items()) {
    const std::string name = object ? Json(key).dump() + ": " : "";
    line += (separator.empty() ? "" : ", ") + name + laid_out(value);
    block += separator + "\n" + indent + "  " + name + laid_out(value, indent + "  ");
    separator = ",";
  }
  const std::string open = object ? "{" : "[", close = object ? "}" : "]";
  constexpr std::size_t kLine = 160;
  const bool nested = object && (json.contains("properties") || json.contains("items"));
  return indent.size() + line.size() < kLine && !nested ? open + line + close : open + block + "\n" + indent + close;
}

void expect_schema(const std::string& title, const Json& fields, const std::string& name) {
  Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", title}};
  schema.update(fields);
  expect_text_of_file(laid_out(schema) + "\n", "docs/" + name);
}

TEST(Schema, OfFitsIsWhatItsDescriptionSays) {
  expect_schema("JSON of mixity fit, schema mixity-fit-1", fits_schema(), "fits.schema.json");
}

TEST(Schema, OfReportsIsWhatItsDescriptionSays) {
  expect_schema("results.json of mixity report, schema mixity-report-1", report_schema(), "results.schema.json");
}

}  // namespace
}  // namespace mixity
