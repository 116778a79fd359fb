// docs/*.schema.json are what the descriptions of the outputs say; MIXITY_UPDATE_GOLDEN=1 writes them anew.
#include <gtest/gtest.h>

#include "report/fit_json.h"
#include "report/golden_file.h"

namespace mixity {
namespace schema_test {

std::string on_one_line(const Json& json) {
  if (!json.is_structured()) return json.dump();
  std::string line;
  for (const auto& [key, value] : json.items())
    line += (line.empty() ? "" : ", ") + (json.is_object() ? Json(key).dump() + ": " : "") + on_one_line(value);
  return json.is_object() ? "{" + line + "}" : "[" + line + "]";
}

/// A field without parts is one line, so that a schema reads as a table.
std::string laid_out(const Json& json, const std::string& indent = "", bool list_of_fields = false) {
  const std::string line = on_one_line(json);
  if (!list_of_fields && line.find("\"properties\": {") == line.npos) return line;
  std::string block;
  for (const auto& [key, value] : json.items())
    block += (block.empty() ? "\n" : ",\n") + indent + "  " + Json(key).dump() + ": " +
             laid_out(value, indent + "  ", key == "properties");
  return "{" + block + "\n" + indent + "}";
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

}  // namespace schema_test
}  // namespace mixity
