// How many digits a reader is shown.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "dataset/number_text.h"

namespace mixity {

/// So many significant digits that a change of `resolution` shows in the last but one.
inline std::string resolved(double value, double resolution) {
  if (!(resolution > 0) || value == 0) return rounded(value, 4);
  const double digits = std::floor(std::log10(std::abs(value))) - std::floor(std::log10(resolution)) + 2;
  return rounded(value, static_cast<int>(std::clamp(digits, 2.0, 15.0)));
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
