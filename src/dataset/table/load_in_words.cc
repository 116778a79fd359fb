#include "dataset/table/load_in_words.h"

#include <algorithm>
#include <string>
#include <vector>

#include "base/text.h"
#include "base/units.h"
#include "dataset/table/heading.h"
#include "dataset/table/number.h"

namespace mixity {
namespace {

bool names_load(std::string_view text, const Vocabulary& names) {
  text = text.substr(std::min(text.find_last_of(",;(|") + 1, text.size()));
  while (!text.empty() && std::string_view(" =:#%").find(text.back()) != std::string_view::npos) text.remove_suffix(1);
  while (!text.empty() && std::string_view(" #%").find(text.front()) != std::string_view::npos) text.remove_prefix(1);
  if (column_named(text) == ColumnId::P) return true;
  const auto column = text.empty() ? std::nullopt : names.read(split_heading(text, {}), 0);
  return column && column->id == ColumnId::P && !column->heading.unit;
}

/// The loads of the lines that state one.
std::vector<double> loads_in_lines(std::string_view text, const Vocabulary& names) {
  std::vector<double> loads;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    std::string line(text.substr(0, end));
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\t' || c == ';' || c == '"' || c == '|'; }, ' ');
    // a title is short, and most lines are rows
    if (line.size() <= 80)
      if (const auto load = load_in(line, names)) loads.push_back(*load);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return loads;
}

}  // namespace

std::optional<double> load_in(std::string_view text, const Vocabulary& names) {
  for (std::size_t at = 1; at < text.size(); ++at) {
    const bool begins = is_digit(text[at]) && std::string_view(" =:").find(text[at - 1]) != std::string_view::npos;
    if (!begins || !names_load(text.substr(0, at), names)) continue;
    std::string_view value = text.substr(at);
    value = trim(value.substr(0, std::min({value.find(')'), value.find(", "), value.find(';'), value.size()})));
    while (value.ends_with(',')) value.remove_suffix(1);
    const auto load = parse_quantity(value);
    if (load && load->unit.dimension == dimension::force) return load->si();
  }
  return std::nullopt;
}

std::size_t count_lines_with_load(std::string_view text, const Vocabulary& names) {
  return loads_in_lines(text, names).size();
}

std::optional<double> last_load_in(std::string_view text, const Vocabulary& names) {
  const std::vector<double> loads = loads_in_lines(text, names);
  return loads.empty() ? std::nullopt : std::optional(loads.back());
}

}  // namespace mixity
