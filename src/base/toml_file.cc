#include "base/toml_file.h"

#include <sstream>

namespace mixity {

toml::table read_toml(const std::string& path, Inputs& inputs) {
  constexpr std::size_t kLongestLine = 10000;
  const std::string text = inputs.read(path);
  std::size_t line = 1, begin = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    if (i - begin > kLongestLine) throw InputError(path, line, kLongestLine, "the line is too long");
    if (i < text.size() && text[i] != '\n') continue;
    begin = i + 1;
    ++line;
  }
  try {
    return toml::parse(text, path);
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    throw InputError(path, at.line, at.column, std::string(error.description()));
  }
}

std::string mapping_text(const std::string& path, const toml::table& table) {
  std::string text;
  for (const auto& [key, heading] : table) {
    if (!heading.is_string()) fail_at(path, heading, "a column's heading must be a string");
    text += (text.empty() ? "" : ",") + std::string(key.str()) + "=" + heading.as_string()->get();
  }
  return text;
}

std::string toml_text(const std::string& text) {
  std::ostringstream out;
  out << toml::value<std::string>(text);
  return out.str();
}

}  // namespace mixity
