#include "dataset/table/decimal_sign.h"

#include <algorithm>
#include <cmath>

#include "base/input_error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "dataset/table/number.h"

namespace mixity {
namespace {

/// Field k of a row.
struct Field {
  std::string_view text{};
  double value = std::nan("");  // of the number in the field or at its beginning
  double error = 0;
  NumberStyle style{};
  bool is_valid = false;  // a number, a time or empty; false if the row lacks the field

  Field(const CsvRow& row, std::size_t k, char decimal) {
    if (k >= row.size()) return;
    text = row[k];
    is_valid = parse_number(text, decimal, value, &style) || text.empty() || parse_clock(text) ||
               parse_with_error(text, decimal, value, error);
  }
};

}  // namespace

Reading read_numbers(const std::vector<CsvRow>& rows, std::size_t first_row, const std::vector<std::size_t>& columns,
                     char decimal) {
  Reading reading;
  reading.decimal = decimal;
  for (std::size_t i = first_row; i < rows.size(); ++i) {
    if (rows[i].is_comment()) continue;
    bool valid = true;
    for (const std::size_t k : columns) {
      const Field field(rows[i], k, decimal);
      valid &= field.is_valid;
      reading.grouped |= field.style.grouped && !field.style.doubtful;
      reading.in_threes += field.style.doubtful;
      const bool has_sign =
          std::any_of(field.text.begin(), field.text.end(), [](char c) { return c == '.' || c == ','; });
      reading.signs += has_sign;
      reading.bare += !has_sign && !std::isnan(field.value);
    }
    reading.valid_rows += valid;
  }
  return reading;
}

Reading read_numbers(const std::string& path, const std::vector<CsvRow>& rows, std::size_t first_row,
                     const std::vector<std::size_t>& columns) {
  const Reading point = read_numbers(rows, first_row, columns, '.'),
                comma = read_numbers(rows, first_row, columns, ',');
  if (point.valid_rows != comma.valid_rows) return point.valid_rows > comma.valid_rows ? point : comma;
  const auto all_in_threes = [](const Reading& groups) { return groups.in_threes == groups.signs && groups.bare > 0; };
  for (std::size_t i = first_row; i < rows.size(); ++i)
    for (const std::size_t k : columns) {
      const double by_point = Field(rows[i], k, '.').value, by_comma = Field(rows[i], k, ',').value;
      if (rows[i].is_comment() || by_point == by_comma || (std::isnan(by_point) && std::isnan(by_comma))) continue;
      // "1.234" without any comma has a decimal point; where semicolons separate columns, "1,234" has a decimal comma:
      // unless all numbers with a sign have three digits behind it, and others have none, as integers in groups would
      if (comma.in_threes > 0 && !comma.grouped && !all_in_threes(comma)) return point;
      if (point.in_threes > 0 && !point.grouped && rows[i].delimiter() == ';' && !all_in_threes(point)) return comma;
      const std::string_view text = rows[i][k];
      throw InputError(path, rows[i].place(k),
                       "'" + printable(text, 40) + "' may be " + shortest(by_comma) + " (decimal comma) or " +
                           shortest(by_point) +
                           (text.find('.') == std::string::npos ? " (comma between thousands)" : " (decimal point)") +
                           "; say which: " + Remedy::set("decimal", ",") + " or " + Remedy::set("decimal", "."));
    }
  return point;
}

}  // namespace mixity
