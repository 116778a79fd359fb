// Numbers as text that reads back to the same double.
#pragma once

#include <charconv>
#include <string>

namespace mixity {

/// Shortest decimal text that reads back to exactly this (finite) double.
inline std::string shortest(double value) {
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof text, value).ptr);
}

/// Rounded to so many significant digits, for a reader's eye.
inline std::string rounded(double value, int digits) {
  char text[48];
  return std::string(text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr);
}

}  // namespace mixity
