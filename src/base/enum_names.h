// Names of enumerators.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace mixity {

/// The name of an enumerator, counted from 0. Beyond the last it repeats the last name, by which a list of all names
/// ends (report/fields.h).
template <class Enum, std::size_t N>
constexpr std::string_view name_among(const std::string_view (&names)[N], Enum value) {
  return names[std::min(static_cast<std::size_t>(value), N - 1)];
}

}  // namespace mixity
