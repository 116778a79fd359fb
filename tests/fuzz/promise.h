// What every reader promises, and how the promise is checked.
#pragma once

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "base/input_error.h"
#include "base/text.h"

namespace mixity::fuzz {

inline void promise(bool kept, const char* what, std::string_view detail = "") {
  if (kept) return;
  std::fprintf(stderr, "broken promise: %s: %.*s\n", what, static_cast<int>(detail.size()), detail.data());
  std::abort();
}

/// UTF-8 without control characters, so that a terminal shows it as one line.
inline bool is_one_printable_line(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    const auto first = static_cast<unsigned char>(text[0]);
    if (length == 0 || first < 0x20 || first == 0x7f) return false;
    if (first == 0xC2 && static_cast<unsigned char>(text[1]) < 0xA0) return false;  // control characters beyond ASCII
    text.remove_prefix(length);
  }
  return true;
}

/// Calls `read`; true if it accepts the input. The message of a rejection must begin with one of these texts and go on.
template <class Read>
bool accepts(const std::vector<std::string>& beginnings, Read&& read) {
  try {
    read();
    return true;
  } catch (const InputError& error) {
    const std::string_view message = error.what();
    promise(is_one_printable_line(message), "a message is one printable line", message);
    const bool named = std::any_of(beginnings.begin(), beginnings.end(), [&](const std::string& beginning) {
      return message.starts_with(beginning) && message.size() > beginning.size() + 3;
    });
    promise(named, "a message names the file", message);
    return false;
  }
}

}  // namespace mixity::fuzz
