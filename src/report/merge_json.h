// Documents of fits put together.
#pragma once

#include <string>
#include <vector>

namespace mixity {

/// Of files with the schema of fits.json, the i-th with every n-th data set from the i-th on, the document of all.
/// Throws InputError for a file that is none, of another version, or with more data sets than its place can have.
std::string merge_json(const std::vector<std::string>& paths);

}  // namespace mixity
