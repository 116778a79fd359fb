#include "dataset/table/decimal_sign.h"

#include <cmath>

#include "base/input_error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "dataset/table/clock_time.h"
#include "dataset/table/number.h"

namespace mixity {
namespace {

/// A number in a field, or at the beginning of it; NaN if there is none.
struct FieldNumber {
  double value = std::nan("");
  NumberStyle style{};
  bool is_whole;

  FieldNumber(const Line& line, std::size_t k, char decimal)
      : is_whole(k < line.fields.size() && parse_number(line.fields[k], decimal, value, &style)) {}
};

}  // namespace

Reading read_numbers(const std::vector<Line>& lines, std::size_t first_row, const std::vector<std::size_t>& columns,
                     char decimal) {
  Reading reading;
  reading.decimal = decimal;
  for (std::size_t i = first_row; i < lines.size(); ++i) {
    const Line& line = lines[i];
    if (line.comment) continue;
    bool valid = true;
    for (const std::size_t k : columns) {
      const FieldNumber number(line, k, decimal);
      const std::string_view field = k < line.fields.size() ? std::string_view(line.fields[k]) : std::string_view();
      valid &= number.is_whole || (k < line.fields.size() && (trim(field).empty() || parse_clock(field)));
      reading.grouped |= number.style.grouped && !number.style.doubtful;
      reading.in_threes += number.style.doubtful;
      const bool has_sign = field.find_first_of(".,") != std::string::npos;
      reading.signs += has_sign;
      reading.bare += !has_sign && !std::isnan(number.value);
    }
    reading.valid_rows += valid;
  }
  return reading;
}

Reading read_numbers(const std::string& path, const std::vector<Line>& lines, std::size_t first_row,
                     const std::vector<std::size_t>& columns, const CsvFormat& format) {
  const Reading point = read_numbers(lines, first_row, columns, '.'),
                comma = read_numbers(lines, first_row, columns, ',');
  if (point.valid_rows != comma.valid_rows) return point.valid_rows > comma.valid_rows ? point : comma;
  const auto all_in_threes = [](const Reading& groups) { return groups.in_threes == groups.signs && groups.bare > 0; };
  for (std::size_t i = first_row; i < lines.size(); ++i)
    for (const std::size_t k : columns) {
      const double one = FieldNumber(lines[i], k, '.').value, other = FieldNumber(lines[i], k, ',').value;
      if (lines[i].comment || one == other || (std::isnan(one) && std::isnan(other))) continue;
      // "1.234" without any comma has a decimal point; where semicolons separate columns, "1,234" has a decimal comma:
      // unless all have three digits there, and others none, as integers in groups would
      if (comma.in_threes > 0 && !comma.grouped && !all_in_threes(comma)) return point;
      if (point.in_threes > 0 && !point.grouped && format.delimiter == ';' && !all_in_threes(point)) return comma;
      const std::string& text = lines[i].fields[k];
      throw InputError(path, places_of(lines[i], format)[k],
                       "'" + printable(text, 40) + "' may be " + shortest(other) + " (decimal comma) or " +
                           shortest(one) +
                           (text.find('.') == std::string::npos ? " (comma between thousands)" : " (decimal point)") +
                           "; say which: " + Remedy::set("decimal", ",") + " or " + Remedy::set("decimal", "."));
    }
  return point;
}

}  // namespace mixity
