#include "base/phrases.h"

#include <algorithm>
#include <span>

#include "base/number_text.h"

namespace mixity {

std::string alternatives(const std::vector<std::string_view>& texts) {
  if (texts.empty()) return {};
  const std::string others = joined(std::span(texts).first(texts.size() - 1));
  return others + (others.empty() ? "" : " or ") + std::string(texts.back());
}

std::string aligned(const std::vector<std::vector<std::string>>& rows, std::string_view indent) {
  const auto width_of = [](const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
  };
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], width_of(row[k]));
  }
  std::string text;
  for (const auto& row : rows) {
    text += indent;
    for (std::size_t k = 0; k < row.size(); ++k) text += row[k] + std::string(widths[k] - width_of(row[k]) + 2, ' ');
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

std::string counted(std::size_t n, const std::string& noun) {
  return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
}

std::string with_error(double value, double error, const char* sign) {
  const RoundedToError shown = rounded_to_error(value, error);
  return shown.value + sign + shown.error;
}

}  // namespace mixity
