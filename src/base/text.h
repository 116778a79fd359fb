// Text from users: trimmed, split, and made printable.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace mixity {

/// Length of the UTF-8 character at the beginning of a text (not empty); 0 if there is none.
constexpr std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned first = byte(0), second = byte(1);
  if (first < 0x80) return 1;
  // Overlong forms, surrogates and numbers beyond U+10FFFF are no characters either.
  const bool none = first < 0xC2 || (first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
                    (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F) || first > 0xF4;
  const std::size_t length = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  for (std::size_t i = 1; i < length; ++i)
    if (none || (byte(i) & 0xC0) != 0x80) return 0;
  return length;
}

/// A text as one line of a message: control characters, bytes that are not UTF-8 and what XML has no character for
/// become '?', and a text of more than `limit` bytes is cut and ends in "...".
std::string printable(std::string_view text, std::size_t limit = 4000);

/// Removes blanks, tabs and line ends at both ends.
std::string_view trim(std::string_view text);

/// The trimmed parts between separators: one more than there are separators.
std::vector<std::string_view> split(std::string_view text, char separator = ',');

/// The text padded with blanks to the width of a column, with at least one blank.
std::string padded(std::string text, std::size_t width);

}  // namespace mixity
