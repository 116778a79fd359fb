// Foreign text made fit for a one-line message.
#pragma once

#include <string>
#include <string_view>

namespace mixity {

/// Control characters become '?', and what is longer than `limit` bytes is cut and ends in "...".
inline std::string printable(std::string_view text, std::size_t limit = 4000) {
  std::string result(text.substr(0, limit));
  for (char& c : result)
    if ((c >= 0 && c < ' ') || c == 0x7f) c = '?';
  if (text.size() > limit) {
    while (!result.empty() && (result.back() & 0xC0) == 0x80) result.pop_back();  // not inside a UTF-8 character
    result += "...";
  }
  return result;
}

}  // namespace mixity
