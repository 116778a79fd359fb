// Finds a normal load in a line of words, such as the title of a table.
#pragma once

#include <optional>
#include <string_view>

#include "dataset/table/vocabulary.h"

namespace mixity {

/// The load in N that a text states: a name of P and a force, as in "Normal load = 7.73 mN" or "run 2, P: 3,8 mN".
std::optional<double> load_in(std::string_view text, const Vocabulary& names);

/// How many lines of the text state a load. What parts their fields counts as a blank.
std::size_t count_lines_with_load(std::string_view text, const Vocabulary& names);

/// The load that the last of these lines states.
std::optional<double> last_load_in(std::string_view text, const Vocabulary& names);

}  // namespace mixity
