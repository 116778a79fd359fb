// Numbers and clock times in the fields of a table.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace mixity {

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// How a number was written.
struct NumberStyle {
  bool grouped = false;   // in groups of three digits, as "1,234.5", "1.234,5", "1 234" or "1'234"
  bool doubtful = false;  // its only group may be decimals, as in "1,234"
};

/// Reads a field, ignoring blanks around it, as one number; false if it is not one. `decimal`: '.' or ','; the other
/// sign, an apostrophe or a blank (also no-break and thin) may separate groups of three digits. `style` may be null.
bool parse_number(std::string_view text, char decimal, double& value, NumberStyle* style = nullptr);

/// Reads a value with its standard error: "0.61 +/- 0.05", "0.61±0.05", "0.61 ± 8%", or "0.61(5)", where 5 counts in
/// the last digit. False for anything else.
bool parse_with_error(std::string_view text, char decimal, double& value, double& error);

/// Whether a field is a number in either decimal sign, with or without a standard error.
bool is_number(std::string_view field);

/// Whether a text marks a missing number, as in spreadsheets, statistics programs and instruments: "NA", "#N/A", "-",
/// "OVL".
bool is_missing(std::string_view text);

/// Whether a number marks a missing one: -9999 and -99999 in archives of data; 9.9e37, -9.9e37 and 9.91e37, the
/// infinities and no number of instruments (SCPI 1999, volume 1, 7.2.1).
bool is_placeholder(double value);

struct ClockTime {
  bool dated = false;
  std::int64_t seconds = 0;  // since midnight, or since 1970 (UTC) if there is a date
  double fraction = 0;       // of a second
};

/// Reads "10:05:00.000", "10:05:00:250" or "1:05:00 PM", alone or behind a date: "2026-05-01T10:05:00,5Z" and
/// "2026-05-01 10:05:00+02:00" as in ISO 8601, "2026/05/01 ...", "01.05.2026 ...". The date of "5/1/2026 10:05:00",
/// whose month is uncertain, is not used. Null for anything else.
std::optional<ClockTime> parse_clock(std::string_view text);

}  // namespace mixity
