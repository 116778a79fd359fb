// Flags that define laws: --law and --laws.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mixity::cli {

/// Adds these flags.
std::vector<std::string_view> with_law_flags(std::vector<std::string_view> flags);

/// Defines the laws of these flags as models, and prints warnings about them to standard error. Throws InputError.
void define_laws_of_flags();

/// Keys of these laws.
const std::vector<std::string>& laws_of_flags();

}  // namespace mixity::cli
