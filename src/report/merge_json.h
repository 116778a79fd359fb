// Documents of fits put together.
#pragma once

#include <string>
#include <vector>

namespace mixity {

/// Of files with the schema of fits.json, the i-th with every n-th data set from the i-th on, the document of all.
/// Throws InputError, saying what differs, for files that are none, of another version, of another list of files or
/// made with other flags, and for those that are missing or there twice.
std::string merge_json(const std::vector<std::string>& paths);

}  // namespace mixity
