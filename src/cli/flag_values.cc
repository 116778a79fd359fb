#include "cli/flag_values.h"

#include <gflags/gflags.h>

#include <algorithm>

#include "base/number_text.h"
#include "base/text.h"

namespace mixity::cli {

bool is_set(std::string_view flag) {
  gflags::CommandLineFlagInfo info;
  return gflags::GetCommandLineFlagInfo(std::string(flag).c_str(), &info) && !info.is_default;
}

std::string value_of(std::string_view flag) {
  std::string value;
  gflags::GetCommandLineOption(std::string(flag).c_str(), &value);
  return value;
}

UsageError refused(std::string_view flag, const std::string& problem) {
  return UsageError("flag '--" + std::string(flag) + "': " + problem);
}

UsageError must(const std::string& flag, const std::string& be) {
  if (const std::string meant = two_readings(value_of(flag)); !meant.empty())
    return UsageError("flag '--" + flag + "' is '" + value_of(flag) + "'; write " + meant);
  return UsageError("flag '--" + flag + "' is '" + value_of(flag) + "'; it must " + be);
}

UsageError not_one_number(const std::string& flag) {
  std::string point = value_of(flag);
  if (!parse_quantity(point)) return must(flag, "be one number");
  std::replace(point.begin(), point.end(), ',', '.');
  return UsageError("flag '--" + flag + "' is '" + value_of(flag) + "'; it must be one number: write \"" + point +
                    "\" if the comma is a decimal comma");
}

double number_from(const std::string& flag, double low, double high) {
  const auto value = parse_number(value_of(flag));
  if (!value || !(*value >= low && *value <= high))
    throw must(flag, "be a number from " + shortest(low) + " to " + shortest(high));
  return *value;
}

std::size_t count_from(const std::string& flag, std::size_t least, std::size_t most) {
  const auto number = parse_number(value_of(flag));
  if (!number || !(*number >= static_cast<double>(least)) || !(*number <= static_cast<double>(most)) ||
      *number != static_cast<double>(static_cast<std::size_t>(*number)))
    throw must(flag, "be a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  return static_cast<std::size_t>(*number);
}

std::string flag_of_loads(const std::string& usual) {
  if (is_set("load") && is_set("loads")) throw UsageError("flags '--load' and '--loads': give one of them");
  return is_set("load") ? "load" : is_set("loads") ? "loads" : usual;
}

std::vector<std::string> list_from(const std::string& flag) {
  const std::string value = value_of(flag);
  std::vector<std::string> items;
  if (value.empty()) return items;
  if (value.find(';') == std::string::npos)
    items = split_assignments(value);
  else
    for (const std::string_view item : split(value, ';')) items.emplace_back(item);
  const auto empty = std::find(items.begin(), items.end(), "");
  if (empty != items.end()) throw refused(flag, "entry " + std::to_string(empty - items.begin() + 1) + " is empty");
  return items;
}

Quantity quantity_from(const std::string& flag, const std::string& be,
                       const std::function<bool(const Quantity&)>& suits) {
  const auto quantity = parse_quantity(value_of(flag));
  if (!quantity || !suits(*quantity)) throw must(flag, be);
  return *quantity;
}

namespace {

/// The error for "0,5 mN,1,2 mN", where only some numbers have a unit: two loads with decimal commas, or four.
UsageError some_have_units(const std::string& flag, const std::vector<Quantity>& list) {
  std::string fewer, more;
  for (std::size_t i = 0, bare = 0; i < list.size(); ++i) {
    const std::string& unit = list[i].unit.text;
    if (unit.empty() && ++bare) continue;
    for (std::size_t j = i - bare; j <= i; ++j) {
      fewer += (j == 0 ? "" : j > i - bare ? "." : ",") + shortest(list[j].value);
      more += (j == 0 ? "" : ",") + shortest(list[j].value) + " " + unit;
    }
    fewer += " " + unit;
    bare = 0;
  }
  return UsageError("flag '--" + flag + "' is '" + value_of(flag) + "'; write \"" + fewer + "\" or \"" + more + '"');
}

}  // namespace

std::vector<Quantity> quantities_from(const std::string& flag) {
  if (flag == "load")  // one number, whose comma cannot separate two
    if (auto one = parse_quantity(value_of(flag))) return {std::move(*one)};
  std::vector<Quantity> list;
  for (const std::string& item : list_from(flag)) {
    const auto quantity = parse_quantity(item);
    if (!quantity) throw refused(flag, "'" + item + "' is not a number, or its unit is unknown");
    list.push_back(*quantity);
  }
  if (list.empty()) throw UsageError("flag '--" + flag + "' is missing or empty");
  const auto with_unit =
      std::count_if(list.begin(), list.end(), [](const Quantity& one) { return !one.unit.text.empty(); });
  if (with_unit > 1 && with_unit < std::ssize(list) && !list.back().unit.text.empty())
    throw some_have_units(flag, list);
  for (Quantity& quantity : list)
    if (quantity.unit.text.empty()) quantity.unit = list.back().unit;
  return list;
}

double positive_quantity(const std::string& flag, const std::string& unit, std::optional<double> size) {
  const auto suits = [&](const Quantity& one) {
    const bool bare = one.unit.text.empty();
    return size ? !bare && one.unit.dimension == parse_unit(unit)->dimension : bare;
  };
  const std::string be = size ? "be a quantity with its unit, such as " + unit
                              : "be a number; a unit needs --radius, --modulus and --toughness";
  const Quantity given = quantity_from(flag, be, suits);
  const double value = size ? given.si() / *size : given.value;
  if (!(value >= 1e-150 && value <= 1e150)) throw UsageError("flag '--" + flag + "' must be above 0");
  return value;
}

}  // namespace mixity::cli
