// Numbers in tables: with a decimal point or comma, and groups of three digits.
#pragma once

#include <string_view>

namespace mixity {

/// Of ASCII.
inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// How a number was written.
struct NumberStyle {
  bool grouped = false;   // with groups of three digits, as "1,234.5", "1.234,5", "1 234" or "1'234"
  bool doubtful = false;  // the one group could as well be decimals: "1,234"
};

/// Reads a field, blanks around it allowed, as one number; false if it is none. `decimal`: '.' or ','; the other one,
/// an apostrophe, or a blank (also no-break and thin ones) may separate groups of three digits. `style` may be null.
bool parse_number(std::string_view text, char decimal, double& value, NumberStyle* style = nullptr);

/// Whether a text marks a missing number, as in spreadsheets and statistics programs: "NA", "#N/A", "-".
bool is_missing(std::string_view text);

}  // namespace mixity
