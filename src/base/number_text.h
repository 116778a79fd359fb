// Numbers as text that reads back to the same double.
#pragma once

#include <charconv>
#include <string>
#include <string_view>

namespace mixity {

/// Shortest decimal text that reads back to exactly this (finite) double.
inline std::string shortest(double value) {
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof text, value).ptr);
}

/// Rounded to so many significant digits, for a reader's eye: 1700 rather than 1.7e+03, up to ten million.
inline std::string rounded(double value, int digits) {
  char text[48];
  const char* end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr;
  const std::string_view general(text, static_cast<std::size_t>(end - text));
  if (general.find("e+") == std::string_view::npos) return std::string(general);
  double shown = 0;
  std::from_chars(text, end, shown);
  if (!(shown < 1e7 && shown > -1e7)) return std::string(general);
  end = std::to_chars(text, text + sizeof text, shown, std::chars_format::fixed, 0).ptr;
  return std::string(text, static_cast<std::size_t>(end - text));
}

}  // namespace mixity
