// Suggestions for misspelt names: "did you mean sigma_T?"
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mixity {

/// The one of the names that needs the fewest edits from the given one, without regard to case, '-' and '_'. An edit
/// inserts, removes or replaces a letter, or swaps two neighbours. The edits are at most a third of the name's letters,
/// at least 1 and at most `most`. Null if no name is as near, if several are equally near, if nothing of the given one
/// remains, and if it is one of the names.
std::optional<std::string> nearest_name(std::string_view given, const std::vector<std::string>& names,
                                        std::size_t most = 3);

/// ": did you mean sigma_T?"; empty without a nearest name.
std::string did_you_mean(std::string_view given, const std::vector<std::string>& names);

/// The suggestion and all names, to be appended to what is wrong with the given one: ": did you mean radius? (known:
/// radius, modulus)". `more`: what else is known and has no fixed names.
std::string known_names(std::string_view given, const std::vector<std::string>& names, std::string_view more = "");

/// "unknown key "raduis": did you mean radius? (known: radius, modulus)".
std::string unknown_key(std::string_view key, const std::vector<std::string>& names);

}  // namespace mixity
