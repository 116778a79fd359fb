#include "dataset/table/column_advice.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "base/phrases.h"
#include "base/text.h"
#include "base/units.h"
#include "dataset/table/number.h"
#include "dataset/table/vocabulary.h"

namespace mixity {
namespace {

/// The heading, with or without its unit; its number if a mapping would not understand the heading.
std::string column_in_mapping(const std::vector<Heading>& headings, std::size_t index, bool with_unit) {
  constexpr std::size_t kLongest = 40;
  const Heading& heading = headings[index];
  const bool is_unique = std::count_if(headings.begin(), headings.end(), [&](const Heading& other) {
                           return other.text == heading.text || folded(other.name) == folded(heading.name);
                         }) == 1;
  const bool plain = is_unique && heading.closed && !heading.name.empty() && heading.text.size() <= kLongest &&
                     heading.text.find_first_of("\",=") == std::string::npos && printable(heading.text) == heading.text;
  return !plain ? std::to_string(index + 1) : with_unit ? heading.text : heading.name;
}

std::string entry_of(ColumnId id, const std::vector<Heading>& headings, std::size_t index) {
  const bool fits = unit_fits(headings[index].unit, id);
  return name_of(id) + "=" + column_in_mapping(headings, index, fits) + (fits ? "" : " (UNIT)");
}

/// "{P}mN" of "pad_12mN.txt", for the key load_from. Empty if the name has not one force, or its number may begin
/// before: "0p5mN", "0_5mN".
std::string place_of_load(std::string_view name) {
  constexpr std::string_view kDigits = "0123456789";
  std::string place;
  for (std::size_t first = name.find_first_of(kDigits), end = 0; first < name.size();
       first = name.find_first_of(kDigits, end)) {
    end = name.find_last_of(kDigits, std::min(name.find_first_not_of("0123456789.,", first), name.size()) - 1) + 1;
    const std::size_t sign = end < name.size() && (name[end] == ' ' || name[end] == '_') ? 1 : 0;
    std::size_t last = end + sign;
    while (last < name.size() && std::isalpha(static_cast<unsigned char>(name[last]))) ++last;
    const auto unit = parse_unit(name.substr(end + sign, last - end - sign));
    const bool goes_on = last < name.size() && kDigits.find(name[last]) != std::string_view::npos;
    if (!unit || unit->dimension != dimension::force || goes_on) continue;
    const bool is_rest = first > 1 && std::string_view("p_-.,").find(name[first - 1]) != std::string_view::npos &&
                         kDigits.find(name[first - 2]) != std::string_view::npos;
    if (!place.empty() || is_rest) return "";
    place = (first > 0 && name[first - 1] == '-' ? "-{P}" : "{P}") + std::string(name.substr(end, last - end));
  }
  return place;
}

}  // namespace

Message advice_on_load(const std::string& path) {
  const std::string place = place_of_load(std::string_view(path).substr(path.find_last_of('/') + 1));
  return place.empty() ? "; one normal load of all points is stated by " + Remedy::set_or_key("load", "5 mN")
                       : "; if the file's name states the normal load: " + Remedy::set_or_key("load_from", place);
}

Remedy mapping(ColumnId id, const std::vector<Heading>& headings, std::size_t index) {
  return Remedy::set("columns", entry_of(id, headings, index));
}

std::string mapping_with(const std::string& unit, ColumnId id, const std::vector<Heading>& headings,
                         std::size_t index) {
  return name_of(id) + "=" + column_in_mapping(headings, index, false) + " (" + unit + ")";
}

Message advice_on_missing(const std::vector<ColumnId>& missing, const std::vector<Heading>& headings,
                          const std::vector<bool>& used) {
  std::vector<std::size_t> left;
  std::string others;
  bool may_be_typed = false;
  for (std::size_t i = 0; i < headings.size(); ++i) {
    if (headings[i].name.empty() || used[i]) continue;
    left.push_back(i);
    others += (others.empty() ? "'" : ", '") + printable(headings[i].text, 40) + "'";
    may_be_typed |= column_in_mapping(headings, i, false) != std::to_string(i + 1);
  }
  if (left.empty() || missing.empty()) return {};
  const std::string unknown = may_be_typed ? "=HEADING (UNIT)" : "=NUMBER (UNIT)";
  const auto is_missing = [&](ColumnId id) { return std::find(missing.begin(), missing.end(), id) != missing.end(); };
  std::vector<std::string> names, entries;
  for (const ColumnId id : missing) {
    std::vector<std::size_t> fitting;  // columns with a unit that fits
    for (const std::size_t i : left)
      if (headings[i].unit && unit_fits(headings[i].unit, id)) fitting.push_back(i);
    // if P and T are both unknown, a force may be either
    const bool either =
        kind_of(id).dimension == dimension::force && is_missing(id == ColumnId::T ? ColumnId::P : ColumnId::T);
    names.push_back(name_of(id));
    entries.push_back(fitting.size() == 1 && !either ? entry_of(id, headings, fitting[0]) : name_of(id) + unknown);
  }
  const std::string last = names.back();
  names.pop_back();
  const std::string which = names.empty() ? "column is " + last : "columns are " + joined(names) + " and " + last;
  return "; not understood: " + others + ". To say which " + which + ": " +
         Remedy::set("columns", joined(entries, ","));
}

}  // namespace mixity
