#include "report/merge_json.h"

#include "dataset/input_error.h"
#include "dataset/table/csv.h"
#include "report/fit_statistics_json.h"

namespace mixity {

std::string merge_json(const std::vector<std::string>& paths) {
  std::vector<Json> parts;
  for (const std::string& path : paths) {
    parts.push_back(Json::parse(read_file(path), nullptr, false));
    const Json& part = parts.back();
    if (part.is_discarded() || !part.is_object() || part.value("schema", "") != "mixity-fit-1" ||
        !part.contains("datasets") || !part["datasets"].is_array())
      throw InputError(path, "is no JSON of mixity fit (schema mixity-fit-1)");
    if (part["version"] != parts[0]["version"])
      throw InputError(path, "was made by another version of mixity than " + paths[0]);
  }
  // what is dealt out in turn is as many for each, or one less for the later ones
  const std::size_t most = parts[0]["datasets"].size();
  for (std::size_t i = 1; i < parts.size(); ++i)
    if (const std::size_t n = parts[i]["datasets"].size(); n > parts[i - 1]["datasets"].size() || n + 1 < most)
      throw InputError(paths[i], "holds " + std::to_string(n) +
                                     " data sets, which no shard in this place does; name all "
                                     "shards in their order");
  Json whole = parts[0];
  whole["datasets"] = Json::array();
  for (std::size_t row = 0; row < most; ++row)
    for (const Json& part : parts)
      if (row < part["datasets"].size()) whole["datasets"].push_back(part["datasets"][row]);
  return json_text(whole);
}

}  // namespace mixity
