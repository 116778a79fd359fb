// Text formats of options: each reads a value, and writes it so that it can be read back. `read` returns the problem as
// the end of a sentence that begins with the option's name, or an empty string.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/number_text.h"
#include "base/phrases.h"
#include "base/text.h"
#include "base/units.h"

namespace mixity {

using Complaint = std::string;  // empty: none

inline std::string in_quotes(std::string_view text) { return "'" + std::string(text) + "'"; }

inline Complaint must_be(std::string_view text, const std::string& what) {
  const std::string meant = two_readings(text);
  return "is " + in_quotes(text) + (meant.empty() ? "; it must be " + what : "; write " + meant);
}

/// A value of an enumeration, by its to_string(). An empty optional is written as the first.
template <class Enum>
struct Choice {
  std::vector<Enum> values;

  Complaint read(std::string_view text, auto& value) const {
    std::vector<std::string_view> names;
    for (const Enum one : values) {
      names.push_back(to_string(one));
      if (text == names.back()) return value = one, Complaint();
    }
    return must_be(text, alternatives(names));
  }
  std::string write(Enum value) const { return std::string(to_string(value)); }
  std::string write(const std::optional<Enum>& value) const { return write(value.value_or(values.front())); }
};

/// A word for true and one for false; if the latter is empty, only true can be stated.
struct Word {
  std::string if_true, if_false;

  Complaint read(std::string_view text, bool& value) const {
    if (text != if_true && (text != if_false || text.empty()))
      return must_be(text, if_true + (if_false.empty() ? "" : " or " + if_false));
    value = text == if_true;
    return {};
  }
  std::string write(bool value) const { return value ? if_true : if_false; }
};

/// The words true and false.
struct Switch : Word {
  Switch() : Word{"true", "false"} {}
};

/// A whole number from 0 to `most`.
struct Whole {
  std::uint64_t most;

  template <class Integer>
  Complaint read(std::string_view text, Integer& value) const {
    Integer number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number > most)
      return must_be(text, "a whole number from 0 to " + std::to_string(most));
    value = number;
    return {};
  }
  static std::string write(std::uint64_t value) { return std::to_string(value); }
};

/// A number above 0 and below `below`.
struct PositiveNumber {
  double below = std::numeric_limits<double>::infinity();

  Complaint read(std::string_view text, auto& value) const {
    const auto number = parse_number(text);
    if (!number || !(*number > 0 && *number < below))
      return must_be(text, "a number above 0" + (std::isinf(below) ? "" : " and below " + shortest(below)));
    value = *number;
    return {};
  }
  static std::string write(const std::optional<double>& value) { return value ? shortest(*value) : ""; }
};

/// A percentage, or a quantity of 0 or more.
struct ErrorSize {
  static Complaint read(std::string_view text, std::optional<Quantity>& value) {
    auto quantity = parse_quantity(text);
    if (!quantity || !(quantity->value >= 0)) return must_be(text, "a percentage or a quantity of 0 or more");
    if (quantity->value == 0 && quantity->unit.text.empty()) quantity = parse_quantity("0%");  // needs no unit
    value = std::move(quantity);
    return {};
  }
  static std::string write(const std::optional<Quantity>& value) {
    if (!value) return {};
    const std::string& unit = value->unit.text;
    return shortest(value->value) + (unit.empty() || unit == "%" ? "" : " ") + unit;
  }
};

/// Calls use(item) for each part of a list, up to the first with a problem.
Complaint for_each_item(const auto& parts, const auto& use) {
  std::vector<std::string> items;
  if (parts.size() == 1 && parts[0].empty()) return "is empty";
  for (const auto& part : parts) {
    const std::string item(part);
    if (item.empty()) return "has an empty entry at position " + std::to_string(items.size() + 1);
    if (std::find(items.begin(), items.end(), item) != items.end()) return "names " + in_quotes(item) + " twice";
    if (Complaint problem = use(item); !problem.empty()) return problem;
    items.push_back(item);
  }
  return {};
}

/// A comma-separated list. Item reads one item and adds it to the list, and writes one.
template <class Item>
struct ListOf {
  static Complaint read(std::string_view text, auto& list) {
    list.clear();
    return for_each_item(split(text), [&](const std::string& item) { return Item::read(item, list); });
  }
  static std::string write(const auto& list) {
    std::vector<std::string> items;
    for (const auto& one : list) items.push_back(Item::write(one));
    return joined(items, ",");
  }
};

struct Name {
  static Complaint read(const std::string& name, std::vector<std::string>& names) {
    return names.push_back(name), Complaint();
  }
  static std::string write(const std::string& name) { return name; }
};

}  // namespace mixity
