#include "report/merge_json.h"

#include <algorithm>
#include <cstdio>

#include "dataset/input_error.h"
#include "dataset/table/csv.h"
#include "report/fit_statistics_json.h"

namespace mixity {
namespace {

/// A document of mixity fit, and which part of how many it says to be.
struct ShardFile {
  std::string path;
  Json document;
  unsigned part = 0, of = 0;
};

ShardFile read_shard(const std::string& path) {
  ShardFile shard{path, Json::parse(read_file(path), nullptr, false)};
  const Json& document = shard.document;
  if (document.is_discarded() || !document.is_object() || document.value("schema", "") != "mixity-fit-1" ||
      !document.contains("datasets") || !document["datasets"].is_array())
    throw InputError(path, "is no JSON of mixity fit (schema mixity-fit-1)");
  const Json text = document.value("shard", Json());
  if (!text.is_string() || std::sscanf(text.get<std::string>().c_str(), "%u/%u", &shard.part, &shard.of) != 2 ||
      shard.part < 1 || shard.part > shard.of)
    throw InputError(path, "does not say which shard it is: it was not made by `mixity fit --shard=i/n`");
  return shard;
}

}  // namespace

std::string merge_json(const std::vector<std::string>& paths) {
  std::vector<ShardFile> parts;
  for (const std::string& path : paths) {
    parts.push_back(read_shard(path));
    if (parts.back().document["version"] != parts[0].document["version"])
      throw InputError(path, "was made by another version of mixity than " + paths[0]);
    if (parts.back().of != parts[0].of)
      throw InputError(path, "is one of " + std::to_string(parts.back().of) + " shards, " + paths[0] + " one of " +
                                 std::to_string(parts[0].of));
  }
  std::sort(parts.begin(), parts.end(),
            [](const ShardFile& one, const ShardFile& other) { return one.part < other.part; });
  std::size_t most = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0 && parts[i].part == parts[i - 1].part)
      throw InputError(parts[i].path,
                       "is shard " + std::to_string(parts[i].part) + ", as " + parts[i - 1].path + " is");
    most = std::max(most, parts[i].document["datasets"].size());
  }
  for (unsigned part = 1; part <= parts[0].of; ++part)
    if (part > parts.size() || parts[part - 1].part != part)
      throw InputError("shard " + std::to_string(part) + "/" + std::to_string(parts[0].of), "is missing");
  Json whole = parts[0].document;
  whole.erase("shard");
  whole["datasets"] = Json::array();
  // data sets were dealt out in turn
  for (std::size_t row = 0; row < most; ++row)
    for (const ShardFile& part : parts)
      if (row < part.document["datasets"].size()) whole["datasets"].push_back(part.document["datasets"][row]);
  return json_text(whole);
}

}  // namespace mixity
