// Lists of quantities on the command line: "0, 5, 10 mN".
#pragma once

#include <string>
#include <vector>

#include "cli/flags.h"
#include "cli/usage_error.h"
#include "dataset/units.h"

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

}  // namespace mixity::cli
