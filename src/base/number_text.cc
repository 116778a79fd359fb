#include "base/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace mixity {
namespace {

template <class... Form>
std::string written(double value, Form... form) {
  char text[64];
  return {text, std::to_chars(text, text + sizeof text, value, form...).ptr};
}

}  // namespace

std::string shortest(double value) { return written(value); }

double as_decimal(double value) {
  constexpr int kDigits = 12;
  constexpr double kRoundings = 8 * std::numeric_limits<double>::epsilon();  // of to and fro: some six operations
  if (!std::isfinite(value)) return value;
  const std::string brief = significant(value, kDigits);
  double shown = value;
  std::from_chars(brief.data(), brief.data() + brief.size(), shown);
  return std::abs(shown - value) <= kRoundings * std::abs(value) ? shown : value;
}

std::string significant(double value, int digits) { return written(value, std::chars_format::general, digits); }

std::string rounded(double value, int digits) {
  const std::string general = significant(value == 0 ? 0.0 : value, digits);  // never -0
  if (general.find("e+") == std::string::npos) return general;
  double shown = 0;
  std::from_chars(general.data(), general.data() + general.size(), shown);
  return shown < 1e7 && shown > -1e7 ? written(shown, std::chars_format::fixed, 0) : general;
}

std::string rounded_difference(double value, double size, int digits) {
  return rounded(std::abs(value) < 1e-12 * size ? 0 : value, digits);
}

std::string chi_squared_text(double chi_squared, int digits) { return rounded_difference(chi_squared, 1, digits); }

std::string resolved(double value, double resolution) {
  if (!(resolution > 0) || value == 0) return rounded(value, 4);
  const double digits = std::floor(std::log10(std::abs(value))) - std::floor(std::log10(resolution)) + 2;
  return rounded(value, static_cast<int>(std::clamp(digits, 2.0, 15.0)));
}

RoundedToError rounded_to_error(double value, double error) {
  if (!(error > 0) || !std::isfinite(error) || !std::isfinite(value)) return {rounded(value, 7), rounded(error, 2)};
  int place = static_cast<int>(std::floor(std::log10(error)));
  error = std::nextafter(error, 2 * error);              // 0.00095 is written as the double just below it
  if (error / std::pow(10.0, place - 2) < 355) --place;  // its first three digits
  if (place < -12 || std::max(std::abs(value), error) >= 1e12) return {rounded(value, 7), rounded(error, 2)};
  const auto at_place = [&](double number) {
    const double unit = std::pow(10.0, std::max(place, 0));
    const std::string shown = place < 0 ? written(number, std::chars_format::fixed, -place)
                                        : written(std::round(number / unit) * unit, std::chars_format::fixed, 0);
    return shown.find_first_not_of("-0.") == std::string::npos && shown[0] == '-' ? shown.substr(1) : shown;
  };
  return {at_place(value), at_place(error)};
}

std::string r2_text(double r2) {
  const int digits = std::clamp(static_cast<int>(std::ceil(-std::log10(std::max(1 - r2, 1e-12)))) + 2, 4, 12);
  return rounded(r2, digits);
}

std::string bracketed(const std::string& quantity, const std::string& unit) {
  return unit.empty() ? quantity : quantity + " [" + unit + "]";
}

std::string unit_text(const std::string& unit) { return unit.empty() ? "" : " " + unit; }

}  // namespace mixity
