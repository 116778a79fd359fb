// Distinct names for several analyses and for their files.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "analysis/result.h"

namespace mixity {

/// Prefixes the folder to names shared by different files: "a/run", "b/run".
void make_names_unique(std::vector<Analysis>& results);

/// A file name made from the data set's name, distinct from those in `taken`.
std::string file_stem(const Analysis& result, std::set<std::string>& taken);

}  // namespace mixity
