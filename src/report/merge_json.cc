#include <algorithm>
#include <cmath>

#include "base/files.h"
#include "base/input_error.h"
#include "base/units.h"
#include "report/fit_json.h"

namespace mixity {
namespace {

/// A document of mixity fit: part `part` of `of`.
struct ShardFile {
  std::string path;
  Json document;
  ShardNumber number{};
};

ShardFile read_shard(const std::string& path) {
  ShardFile shard{path, Json::parse(read_file(path), nullptr, false)};
  const Json& document = shard.document;
  if (document.is_discarded() || !document.is_object() || document.value("schema", "") != "mixity-fit-1" ||
      !document.contains("datasets") || !document["datasets"].is_array())
    throw InputError(path, "is no JSON of mixity fit (schema mixity-fit-1)");
  const Json text = document.value("shard", Json());
  const auto number = text.is_string() ? shard_number(text.get<std::string>()) : std::nullopt;
  if (!number)
    throw InputError(path, "does not say which shard it is: it was not made by `mixity fit " +
                               Remedy::fill_in("shard", "i/n") + "`");
  shard.number = *number;
  return shard;
}

Message flag_text(const Json& flags, const std::string& name) {
  return flags.contains(name) ? "with " + Remedy::fill_in(name, flags[name].get<std::string>())
                              : "without " + Remedy::set(name);
}

/// The first difference between two campaigns, as the end of a sentence that begins with the file of the first; empty
/// if there is none.
Message difference(const Json& one, const Json& other, const std::string& other_path) {
  const Json &files = one["files"], &others = other["files"];
  if (files.size() != others.size())
    return "is of a list of " + std::to_string(files.size()) + " files, " + other_path + " of one of " +
           std::to_string(others.size());
  for (std::size_t i = 0; i < files.size(); ++i)
    if (files[i] != others[i])
      return "is of another list of files than " + other_path + ": number " + std::to_string(i + 1) + " is '" +
             files[i].get<std::string>() + "', there '" + others[i].get<std::string>() + "'";
  Json names = one["flags"];
  names.update(other["flags"]);
  for (const auto& [name, text] : names.items())
    if (!(flag_text(one["flags"], name) == flag_text(other["flags"], name)))
      return "was made " + flag_text(one["flags"], name) + ", " + other_path + " " + flag_text(other["flags"], name);
  return "";
}

bool is_campaign(const Json& campaign) {
  const auto texts = [](const Json& all) {
    return std::all_of(all.begin(), all.end(), [](const Json& one) { return one.is_string(); });
  };
  return campaign.is_object() && campaign.value("files", Json()).is_array() && texts(campaign["files"]) &&
         campaign.value("flags", Json()).is_object() && texts(campaign["flags"]);
}

/// Throws InputError unless the parts have the same list of files and the same flags, and each has its part of the data
/// sets.
void require_one_campaign(const std::vector<ShardFile>& parts) {
  for (const ShardFile& part : parts) {
    const Json campaign = part.document.value("campaign", Json());
    if (!is_campaign(campaign))
      throw InputError(part.path, "does not state the files and flags of its campaign: create it again");
    if (const Message other = difference(campaign, parts[0].document["campaign"], parts[0].path); !other.empty())
      throw InputError(part.path, other);
    const std::size_t share = (campaign["files"].size() + part.number.of - part.number.part) / part.number.of,
                      has = part.document["datasets"].size();
    if (has != share)
      throw InputError(part.path,
                       "holds " + std::to_string(has) + " of the " + std::to_string(share) + " data sets of its share");
  }
}

}  // namespace

std::optional<ShardNumber> shard_number(const std::string& text) {
  constexpr double kMost = 1e6;
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return std::nullopt;
  const auto part = parse_number(text.substr(0, slash)), of = parse_number(text.substr(slash + 1));
  const auto whole = [](double value) { return value >= 1 && value <= kMost && value == std::floor(value); };
  if (!part || !of || !whole(*part) || !whole(*of) || *part > *of) return std::nullopt;
  return ShardNumber{static_cast<std::size_t>(*part), static_cast<std::size_t>(*of)};
}

std::string merge_json(const std::vector<std::string>& paths) {
  std::vector<ShardFile> parts;
  for (const std::string& path : paths) {
    parts.push_back(read_shard(path));
    if (parts.back().document["version"] != parts[0].document["version"])
      throw InputError(path, "was made by another version of mixity than " + paths[0]);
    if (parts.back().number.of != parts[0].number.of)
      throw InputError(path, "is one of " + std::to_string(parts.back().number.of) + " shards, " + paths[0] +
                                 " one of " + std::to_string(parts[0].number.of));
  }
  require_one_campaign(parts);
  std::sort(parts.begin(), parts.end(),
            [](const ShardFile& one, const ShardFile& other) { return one.number.part < other.number.part; });
  std::size_t most = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0 && parts[i].number.part == parts[i - 1].number.part)
      throw InputError(parts[i].path,
                       "is shard " + std::to_string(parts[i].number.part) + ", as " + parts[i - 1].path + " is");
    most = std::max(most, parts[i].document["datasets"].size());
  }
  for (std::size_t part = 1; part <= parts[0].number.of; ++part)
    if (part > parts.size() || parts[part - 1].number.part != part)
      throw InputError("shard " + std::to_string(part) + "/" + std::to_string(parts[0].number.of), "is missing");
  Json whole = parts[0].document;
  whole.erase("shard");
  whole.erase("campaign");
  whole["datasets"] = Json::array();
  // part i has every n-th data set
  for (std::size_t row = 0; row < most; ++row)
    for (const ShardFile& part : parts)
      if (row < part.document["datasets"].size()) whole["datasets"].push_back(part.document["datasets"][row]);
  return json_text(whole);
}

}  // namespace mixity
