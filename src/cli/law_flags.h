// Flags that state laws of one's own: --law and --laws.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mixity::cli {

/// These flags and those two.
std::vector<std::string_view> with_law_flags(std::vector<std::string_view> flags);

/// Makes what they state models, and prints to standard error what is to be said of them. Throws InputError.
void define_laws_of_flags();

/// Keys of these laws.
const std::vector<std::string>& laws_of_flags();

}  // namespace mixity::cli
