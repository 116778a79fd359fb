// Fits as JSON; the schema stands in README.md beside this file.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/result.h"

namespace mixity {

/// A part of a list of files, and what all parts of one campaign share.
struct Shard {
  std::string part;                            // "2/10"; empty: the whole
  std::vector<std::string> files{};            // the whole list, as it was given
  std::map<std::string, std::string> flags{};  // by name, those that were given and decide what is found
};

/// {schema, version, datasets: [...]}, indented, with a final newline.
std::string to_json(const std::vector<Analysis>& results, const Shard& shard = {});

}  // namespace mixity
