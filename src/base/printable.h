// Foreign text made fit for a one-line message.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace mixity {

/// Length of the UTF-8 character with which a text (not empty) begins; 0 if it begins with none.
constexpr std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned first = byte(0), second = byte(1);
  if (first < 0x80) return 1;
  // Longer than need be, a surrogate, or beyond U+10FFFF: these are no characters either.
  const bool none = first < 0xC2 || (first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
                    (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F) || first > 0xF4;
  const std::size_t length = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  for (std::size_t i = 1; i < length; ++i)
    if (none || (byte(i) & 0xC0) != 0x80) return 0;
  return length;
}

/// Control characters and bytes that are no UTF-8 become '?', and what is longer than `limit` bytes is cut and ends in
/// "...".
inline std::string printable(std::string_view text, std::size_t limit = 4000) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = character_length(text), taken = length == 0 ? 1 : length;
    if (result.size() + taken > limit) return result + "...";
    const auto first = static_cast<unsigned char>(text[0]);
    const bool control =
        first < 0x20 || first == 0x7f || (length == 2 && first == 0xC2 && static_cast<unsigned char>(text[1]) < 0xA0);
    if (length == 0 || control)
      result += '?';
    else
      result += text.substr(0, length);
    text.remove_prefix(taken);
  }
  return result;
}

}  // namespace mixity
