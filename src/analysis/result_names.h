// Names of several analyses, and of files of them, that differ from each other.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "analysis/result.h"

namespace mixity {

/// Prefixes the folder to names shared by different files: "a/run", "b/run".
void make_names_unique(std::vector<Analysis>& results);

/// A file name from the name of the data set, made unique among those in `taken`.
std::string file_stem(const Analysis& result, std::set<std::string>& taken);

}  // namespace mixity
