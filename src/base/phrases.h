// Parts of text for readers: lists, counts, values with errors, aligned columns.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mixity {

/// `before`, then the texts with separators between them; empty if there are no texts.
template <class Texts>
std::string joined(const Texts& texts, std::string_view separator = ", ", std::string_view before = "") {
  std::string all;
  bool first = true;
  for (const auto& text : texts) {
    all += std::exchange(first, false) ? before : separator;
    all += text;
  }
  return all;
}

/// text_of(item) for each item; text_of may also be a member of the items.
template <class Items, class TextOf>
std::vector<std::string> texts_of(const Items& items, TextOf text_of) {
  std::vector<std::string> texts;
  for (const auto& item : items) texts.emplace_back(std::invoke(text_of, item));
  return texts;
}

/// "a, b or c".
std::string alternatives(const std::vector<std::string_view>& texts);

/// "1 point" or "2 points".
std::string counted(std::size_t n, const std::string& noun);

/// A value and its standard error, rounded by rounded_to_error: "2.13 +/- 0.11".
std::string with_error(double value, double error, const char* sign = " +/- ");

/// The rows as lines with columns aligned two blanks apart, after `indent`. Widths are in characters.
std::string aligned(const std::vector<std::vector<std::string>>& rows, std::string_view indent = "");

}  // namespace mixity
