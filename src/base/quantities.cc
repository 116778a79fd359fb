// Numbers with a unit, and with a standard error.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>

#include "base/units.h"

namespace mixity {
namespace {

/// A number at the beginning of a text.
struct Beginning {
  double value = 0;
  std::size_t length = 0;  // of its text; 0 if there is no number
  std::errc error{};
};

Beginning with_point(std::string_view text) {
  Beginning number;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number.value);
  number.length = static_cast<std::size_t>(end - text.data());
  number.error = error;
  return number;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The position of a comma between digits without a point or another comma; else 0.
std::size_t decimal_comma(std::string_view text) {
  const std::size_t sign = text.starts_with('-') ? 1 : 0;
  std::size_t comma = sign;
  while (comma < text.size() && is_digit(text[comma])) ++comma;
  if (comma == sign || comma + 1 >= text.size() || text[comma] != ',' || !is_digit(text[comma + 1])) return 0;
  const std::size_t end = text.find_first_not_of("0123456789", comma + 1);
  return end != std::string_view::npos && (text[end] == ',' || text[end] == '.') ? 0 : comma;
}

/// Whether the digits around a comma may be groups of thousands: "2,133", but not "0,133" and "2,13".
bool may_be_thousands(std::string_view text, std::size_t comma) {
  const std::size_t sign = text.starts_with('-') ? 1 : 0, end = text.find_first_not_of("0123456789", comma + 1),
                    behind = std::min(end, text.size()) - comma - 1;
  return behind == 3 && comma - sign <= 3 && text[sign] != '0';
}

/// Reads a number with a decimal point or comma.
Beginning beginning_of(std::string_view text) {
  const std::size_t comma = decimal_comma(text);
  if (comma == 0) return with_point(text);
  if (may_be_thousands(text, comma)) return {0, 0, std::errc::invalid_argument};
  std::string pointed(text);
  pointed[comma] = '.';
  return with_point(pointed);
}

std::string_view without_plus(std::string_view text) {
  text = trim(text);
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  return text;
}

}  // namespace

std::string two_readings(std::string_view text) {
  text = without_plus(text);
  const std::size_t comma = decimal_comma(text);
  if (comma == 0 || !may_be_thousands(text, comma)) return {};
  std::string point(text), none(text);
  point[comma] = '.';
  none.erase(comma, 1);
  return "\"" + point + "\" or \"" + none + "\"";
}

std::vector<std::string> split_assignments(std::string_view text) {
  std::vector<std::string> parts;
  for (const std::string_view part : split(text)) {
    const std::size_t equals = parts.empty() ? std::string::npos : parts.back().find('=');
    const bool behind_digits = equals != std::string::npos && is_digit(parts.back().back()) &&
                               parts.back().find_first_of(".,", equals) == std::string::npos;
    double fraction = 0;
    if (behind_digits && !part.empty() && is_digit(part.front()) && part.find('.') == std::string::npos &&
        parse_number(part, fraction))
      parts.back().append(",").append(part);
    else
      parts.emplace_back(part);
  }
  return parts;
}

bool parse_number(std::string_view text, double& value) {
  text = without_plus(text);
  const Beginning number = with_point(text);
  if (number.length != text.size() || text.empty()) return false;
  value = number.value;
  if (number.error == std::errc()) return true;
  // from_chars gives no value out of range; here too small becomes zero, and too large infinite
  if (number.error != std::errc::result_out_of_range) return false;
  const double sized = std::strtod(std::string(text).c_str(), nullptr);
  value = std::abs(sized) < 1 ? 0.0 : sized;
  return true;
}

std::optional<double> parse_number(std::string_view text) {
  double value = 0;
  if (parse_number(text, value)) return value;
  text = without_plus(text);
  const Beginning number = beginning_of(text);
  const bool whole = number.length == text.size() && !text.empty() && number.error == std::errc();
  return whole ? std::optional(number.value) : std::nullopt;
}

std::optional<Quantity> parse_quantity(std::string_view text) {
  text = without_plus(text);
  const Beginning number = beginning_of(text);
  if (number.length == 0 || number.error != std::errc() || !std::isfinite(number.value)) return std::nullopt;
  Quantity quantity;
  quantity.value = number.value;
  const std::string_view rest = trim(text.substr(number.length));
  if (rest.empty()) return quantity;
  const auto unit = parse_unit(rest);
  if (!unit) return std::nullopt;
  quantity.unit = *unit;
  return std::isfinite(quantity.si()) ? std::optional(quantity) : std::nullopt;
}

namespace {

/// The sign that precedes a standard error in a text; empty if there is none.
std::string_view sign_of_error(std::string_view text) {
  for (const std::string_view sign : {"+/-", "+-", "±"})
    if (text.find(sign) != std::string_view::npos) return sign;
  return {};
}

}  // namespace

bool states_error(std::string_view text) { return !sign_of_error(text).empty(); }

std::optional<UncertainQuantity> parse_uncertain(std::string_view text) {
  text = trim(text);
  const std::string_view sign = sign_of_error(text);
  if (sign.empty()) {
    const auto exact = parse_quantity(text);
    return exact ? std::optional(UncertainQuantity{*exact}) : std::nullopt;
  }
  const std::size_t at = text.find(sign);
  std::string value(trim(text.substr(0, at))), error(trim(text.substr(at + sign.size())));
  if (value.starts_with('(')) {  // (value +/- error) unit
    const std::size_t end = error.find(')');
    if (end == std::string::npos) return std::nullopt;
    value.erase(0, 1);
    error.erase(end, 1);
  }
  auto one = parse_quantity(value), other = parse_quantity(error);
  if (!one || !other || !(other->value >= 0)) return std::nullopt;
  UncertainQuantity result{*one};
  if (other->unit.text == "%") {
    result.standard_error = std::abs(one->si()) * other->si();
    if (one->value == 0) return std::nullopt;
    return result;
  }
  // a single unit applies to the value and the error
  if (one->unit.text.empty()) result.quantity.unit = other->unit;
  if (other->unit.text.empty()) other->unit = one->unit;
  if (other->unit.dimension != result.quantity.unit.dimension) return std::nullopt;
  result.standard_error = other->si();
  const bool finite = std::isfinite(result.quantity.si()) && std::isfinite(result.standard_error);
  return finite ? std::optional(result) : std::nullopt;
}

std::string_view unknown_unit(std::string_view text) {
  const std::string_view sign = sign_of_error(text);
  const std::size_t end = sign.empty() ? text.size() : text.find(sign);
  for (std::string_view part : {text.substr(0, end), text.substr(std::min(end + sign.size(), text.size()))}) {
    part = trim(part);
    const Beginning number = beginning_of(part);
    part.remove_prefix(number.length);
    part = trim(part.substr(part.starts_with(')')));
    if (number.error == std::errc() && !part.empty() && part.find_first_of(".,:;+-0123456789") != 0 &&
        !parse_unit(part))
      return part;
  }
  return {};
}

}  // namespace mixity
