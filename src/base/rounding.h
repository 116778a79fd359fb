// How many digits a reader is shown.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "base/number_text.h"

namespace mixity {

/// So many significant digits that a change of `resolution` shows in the last but one.
inline std::string resolved(double value, double resolution) {
  if (!(resolution > 0) || value == 0) return rounded(value, 4);
  const double digits = std::floor(std::log10(std::abs(value))) - std::floor(std::log10(resolution)) + 2;
  return rounded(value, static_cast<int>(std::clamp(digits, 2.0, 15.0)));
}

/// A value and its standard error as the Particle Data Group rounds them: the error to two digits if its first three
/// are 100..354, else to one (950..999 becomes 1000), the value to the same place.
struct RoundedToError {
  std::string value, error;
};
inline RoundedToError rounded_to_error(double value, double error) {
  if (!(error > 0) || !std::isfinite(error) || !std::isfinite(value)) return {rounded(value, 7), rounded(error, 2)};
  int place = static_cast<int>(std::floor(std::log10(error)));
  error = std::nextafter(error, 2 * error);              // 0.00095 is written as the double just below it
  if (error / std::pow(10.0, place - 2) < 355) --place;  // its first three digits
  if (place < -12 || std::max(std::abs(value), error) >= 1e12) return {rounded(value, 7), rounded(error, 2)};
  const auto at_place = [&](double number) {
    const double unit = std::pow(10.0, std::max(place, 0));
    char text[64];
    const char* end =
        std::to_chars(text, text + sizeof text, std::round(number / unit) * unit, std::chars_format::fixed, 0).ptr;
    if (place < 0) end = std::to_chars(text, text + sizeof text, number, std::chars_format::fixed, -place).ptr;
    const std::string shown(text, static_cast<std::size_t>(end - text));
    return shown.find_first_not_of("-0.") == std::string::npos && shown[0] == '-' ? shown.substr(1) : shown;
  };
  return {at_place(value), at_place(error)};
}

/// As many nines as say something: 0.9999 and 0.99994 must not both read 1.000.
inline std::string r2_text(double r2) {
  const int digits = std::clamp(static_cast<int>(std::ceil(-std::log10(std::max(1 - r2, 1e-12)))) + 2, 4, 12);
  return rounded(r2, digits);
}

/// Filled up to a column's width, with at least one blank after it.
inline std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size() + 1), ' ');
  return text;
}

/// "T [mN]", or "T" for a dimensionless quantity.
inline std::string bracketed(const std::string& quantity, const std::string& unit) {
  return unit.empty() ? quantity : quantity + " [" + unit + "]";
}

/// " mN", or nothing for a dimensionless quantity.
inline std::string unit_text(const std::string& unit) { return unit.empty() ? "" : " " + unit; }

}  // namespace mixity
