// Parts of the text for readers: lists, counts, values with their errors, aligned columns.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mixity {

/// `before` and then the texts with separators between them; empty without texts.
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

/// text_of(item) of each item; a member of the items serves, too.
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

/// A value and its standard error as rounded_to_error rounds them: "2.13 +/- 0.11".
std::string with_error(double value, double error, const char* sign = " +/- ");

/// The rows as lines with aligned columns, two blanks apart, after `indent`. Widths are in characters.
std::string aligned(const std::vector<std::vector<std::string>>& rows, std::string_view indent = "");

}  // namespace mixity
