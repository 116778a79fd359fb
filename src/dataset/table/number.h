// Numbers as tables have them: with a decimal point or comma, and groups of three digits.
#pragma once

#include <string>
#include <string_view>

namespace mixity {

/// How a number was written.
struct NumberStyle {
  bool grouped = false;   // with groups of three digits, as "1,234.5", "1.234,5", "1 234" or "1'234"
  bool doubtful = false;  // the one group could as well be decimals: "1,234"
};

/// The whole field, blanks around it allowed, as one number; false if it is none. `decimal`: '.' or ','; the other one,
/// an apostrophe, or a blank (no-break and thin ones, too) may part groups of three digits. Null `style`: not wanted.
bool parse_number(std::string_view text, char decimal, double& value, NumberStyle* style = nullptr);

/// Whether a text says that there is no number, as spreadsheets and statistics programs have it: "NA", "#N/A", "-".
bool is_missing(std::string_view text);

}  // namespace mixity
