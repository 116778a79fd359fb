// What a result was made with.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace mixity {

/// Name and version of this program and of the libraries that numbers depend on.
std::vector<std::pair<std::string, std::string>> versions();

}  // namespace mixity
