// Lists of quantities on the command line: "0, 5, 10 mN".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/units.h"
#include "cli/flags.h"
#include "cli/usage_error.h"

namespace mixity::cli {

/// Comma-separated quantities; the unit of the last applies to those without one. Throws UsageError naming the flag.
inline std::vector<Quantity> quantity_list(const std::string& flag, const std::string& text) {
  std::vector<Quantity> list;
  for (const std::string& item : split_list(flag, text)) {
    const auto quantity = parse_quantity(item);
    if (!quantity) throw UsageError("flag '--" + flag + "': '" + item + "' is not a number, or its unit is unknown");
    list.push_back(*quantity);
  }
  if (list.empty()) throw UsageError("flag '--" + flag + "' is missing or empty");
  for (Quantity& quantity : list)
    if (quantity.unit.text.empty()) quantity.unit = list.back().unit;
  return list;
}

/// A quantity above 0 of the dimension of `unit`, in parts of `size` [SI]; without a size a bare number.
inline double positive_quantity(const std::string& flag, const std::string& text, const std::string& unit,
                                std::optional<double> size) {
  const std::string is = "flag '--" + flag + "' is '" + text + "'; it must be ";
  const auto given = parse_quantity(text);
  const bool bare = given && given->unit.text.empty();
  if (!given || (size ? bare || given->unit.dimension != parse_unit(unit)->dimension : !bare))
    throw UsageError(is + (size ? "a quantity with its unit, such as " + unit
                                : "a number; a unit needs --radius, --modulus and --toughness"));
  const double value = size ? given->si() / *size : given->value;
  if (!(value >= 1e-150 && value <= 1e150)) throw UsageError("flag '--" + flag + "' must be above 0");
  return value;
}

}  // namespace mixity::cli
