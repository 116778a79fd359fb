// Names of enumerators.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace mixity {

/// The name of an enumerator, which counts from 0. Beyond the enumerators it is the last name: a list of all names ends
/// where one is repeated (report/fields.h).
template <class Enum, std::size_t N>
constexpr std::string_view name_among(const std::string_view (&names)[N], Enum value) {
  return names[std::min(static_cast<std::size_t>(value), N - 1)];
}

}  // namespace mixity
