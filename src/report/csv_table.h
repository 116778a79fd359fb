// CSV tables by description: a column is a heading and a function of the row, so that header and rows always agree.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/light_function.h"
#include "base/number_text.h"
#include "dataset/table/csv.h"

namespace mixity {

/// A field: numbers with full precision, bool as 1 or 0, enumerators by name, null as empty.
template <class Value>
std::string csv_cell(const Value& value) {
  if constexpr (std::is_same_v<Value, bool>)
    return value ? "1" : "0";
  else if constexpr (std::is_floating_point_v<Value>)
    return shortest(value);
  else if constexpr (std::is_integral_v<Value>)
    return std::to_string(value);
  else if constexpr (std::is_enum_v<Value>)
    return std::string(to_string(value));
  else if constexpr (std::is_convertible_v<Value, std::string_view>)
    return spreadsheet_field(std::string(value));
  else
    return value ? csv_cell(*value) : std::string();
}

template <class Row>
class CsvTable {
 public:
  /// Adds a column. `get`: a member of Row, or a function of it.
  template <class Get>
  void operator()(const std::string& heading, Get get) {
    text_ += (cells_.empty() ? "" : ",") + heading;
    cells_.push_back([get](const Row& row) { return csv_cell(std::invoke(get, row)); });
  }

  /// Adds a column for a number, which may be null, with its unit in the heading; `digits`: 0 for full precision.
  template <class Get>
  void quantity(const std::string& name, const std::string& unit, int digits, Get get) {
    (*this)(bracketed(name, unit), [get, digits](const Row& row) {
      const std::optional<double> value = std::invoke(get, row);
      return !value ? std::string() : digits > 0 ? rounded(*value, digits) : shortest(*value);
    });
  }
  template <class Get>
  void quantity(const std::string& name, const std::string& unit, Get get) {
    quantity(name, unit, 0, get);
  }

  /// Adds a row. All columns must have been added.
  void add(const Row& row) {
    std::string separator = "\n";
    for (const auto& cell : cells_) {
      text_ += separator + cell(row);
      separator = ",";
    }
  }

  std::string text() const { return text_ + '\n'; }

 private:
  std::vector<LightFunction<std::string(const Row&)>> cells_;
  std::string text_;
};

}  // namespace mixity
