#include "base/units.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace mixity {
namespace {

struct Symbol {
  std::string_view name;
  double factor;
  Dimension dimension;
  bool takes_prefix;
};

constexpr double kPi = 3.141592653589793;
constexpr std::array kSymbols{
    Symbol{"m", 1, dimension::length, true},
    Symbol{"N", 1, dimension::force, true},
    Symbol{"Pa", 1, dimension::stress, true},
    Symbol{"J", 1, {1, 1, 0}, true},
    Symbol{"rad", 1, dimension::angle, true},
    Symbol{"deg", kPi / 180, dimension::angle, false},
    Symbol{"°", kPi / 180, dimension::angle, false},
    Symbol{"gf", 9.80665e-3, dimension::force, true},
    Symbol{"kgf", 9.80665, dimension::force, false},
    Symbol{"dyn", 1e-5, dimension::force, false},
    Symbol{"erg", 1e-7, {1, 1, 0}, false},
    Symbol{"bar", 1e5, dimension::stress, false},
    Symbol{"newton", 1, dimension::force, false},
    Symbol{"newtons", 1, dimension::force, false},
    Symbol{"gF", 9.80665e-3, dimension::force, true},
    Symbol{"micron", 1e-6, dimension::length, false},
    Symbol{"microns", 1e-6, dimension::length, false},
    Symbol{"s", 1, dimension::time, true},
    Symbol{"sec", 1, dimension::time, false},
    Symbol{"secs", 1, dimension::time, false},
    Symbol{"second", 1, dimension::time, false},
    Symbol{"seconds", 1, dimension::time, false},
    Symbol{"msec", 1e-3, dimension::time, false},
    Symbol{"min", 60, dimension::time, false},
    Symbol{"秒", 1, dimension::time, false},
    Symbol{"Hz", 1, dimension::frequency, true},
    Symbol{"px", 1, {0, 0, 0, 0, 1}, false},
    Symbol{"pixel", 1, {0, 0, 0, 0, 1}, false},
    Symbol{"pixels", 1, {0, 0, 0, 0, 1}, false},
    Symbol{"㎜", 1e-3, dimension::length, false},
    Symbol{"㎛", 1e-6, dimension::length, false},
    Symbol{"㎟", 1e-6, dimension::area, false},
    Symbol{"㎠", 1e-4, dimension::area, false},
};

/// A unit's name of three letters or more is the same word in any case: "Sec", "NEWTON"; not "Min", a minimum.
bool is_word(std::string_view text, std::string_view name) {
  const auto lower = [](unsigned char c) { return static_cast<char>(std::tolower(c)); };
  return name.size() > 2 && name != "min" && text.size() == name.size() &&
         std::equal(text.begin(), text.end(), name.begin(), [&](char one, char other) { return lower(one) == other; });
}

struct Prefix {
  std::string_view name;
  int power;  // of ten
};
// micro is u, U+00B5 or U+03BC
constexpr std::array kPrefixes{Prefix{"p", -12},     Prefix{"n", -9}, Prefix{"u", -6}, Prefix{"\u00b5", -6},
                               Prefix{"\u03bc", -6}, Prefix{"m", -3}, Prefix{"c", -2}, Prefix{"d", -1},
                               Prefix{"k", 3},       Prefix{"M", 6},  Prefix{"G", 9}};

bool take(std::string_view& text, std::string_view start) {
  if (!text.starts_with(start)) return false;
  text.remove_prefix(start.size());
  return true;
}

/// One factor of a unit without its power: "mN", "Pa".
std::optional<Unit> parse_symbol(std::string_view text) {
  for (const Symbol& symbol : kSymbols)
    if (symbol.name == text || is_word(text, symbol.name)) return Unit{symbol.factor, symbol.dimension, {}};
  for (const Prefix& prefix : kPrefixes)
    for (const Symbol& symbol : kSymbols)
      if (symbol.takes_prefix && text.starts_with(prefix.name) && text.substr(prefix.name.size()) == symbol.name)
        // dividing by 10^n is exact where multiplying by 10^-n is not
        return Unit{prefix.power < 0 ? symbol.factor / std::pow(10.0, -prefix.power)
                                     : symbol.factor * std::pow(10.0, prefix.power),
                    symbol.dimension,
                    {}};
  return std::nullopt;
}

/// Removes the power from the end of a factor and returns it: "mm^2", "mm2", "mm²", "m^-2", "m**2".
std::optional<int> take_power(std::string_view& factor) {
  for (auto [superscript, power] : {std::pair{"⁻¹", -1}, {"⁻²", -2}, {"²", 2}, {"³", 3}})
    if (factor.ends_with(superscript)) {
      factor.remove_suffix(std::string_view(superscript).size());
      return power;
    }
  // Origin's markup: mm\+(2)
  if (const std::size_t raised = factor.find("\\+("); raised != std::string_view::npos && factor.ends_with(')')) {
    int power = 0;
    const char* const last = factor.data() + factor.size() - 1;
    const auto [end, error] = std::from_chars(factor.data() + raised + 3, last, power);
    if (error != std::errc() || end != last || power == 0 || std::abs(power) > 9) return std::nullopt;
    factor = factor.substr(0, raised);
    return power;
  }
  std::size_t digits = factor.size();
  while (digits > 0 && factor[digits - 1] >= '0' && factor[digits - 1] <= '9') --digits;
  if (digits == factor.size() || digits == 0) return 1;
  int power = 0;
  const auto [end, error] = std::from_chars(factor.data() + digits, factor.data() + factor.size(), power);
  if (error != std::errc() || power == 0 || power > 9) return std::nullopt;
  factor = factor.substr(0, digits);
  if (factor.ends_with('-')) {
    power = -power;
    factor.remove_suffix(1);
  }
  if (factor.ends_with("**"))
    factor.remove_suffix(2);
  else if (factor.ends_with('^'))
    factor.remove_suffix(1);
  return power;
}

}  // namespace

std::optional<Unit> parse_unit(std::string_view text) {
  text = trim(text);
  Unit unit{1, {}, std::string(text)};
  // for one-line messages
  std::replace_if(
      unit.text.begin(), unit.text.end(), [](unsigned char c) { return std::isspace(c); }, ' ');
  if (text.empty()) return std::nullopt;
  // units of a plain number; within a product 1 may only occur as in "1/mm"
  if (text == "1" || text == "-") return unit;
  if (text == "%") return unit.factor = 0.01, unit;
  bool divide = text.starts_with("1/");
  if (divide) text = trim(text.substr(2));
  while (true) {
    std::size_t length = 0;
    const auto at_separator = [&] {
      const std::string_view rest = text.substr(length);
      return rest.starts_with(' ') || rest.starts_with('/') || rest.starts_with("·") ||
             (rest.starts_with('*') && !rest.starts_with("**"));
    };
    while (length < text.size() && !at_separator()) length += text.substr(length).starts_with("**") ? 2 : 1;
    std::string_view factor = text.substr(0, length);
    text.remove_prefix(length);
    const auto power = take_power(factor);
    const auto symbol = parse_symbol(factor);
    if (!power || !symbol) return std::nullopt;
    const int n = divide ? -*power : *power;
    for (int i = 0; i < std::abs(n); ++i) n > 0 ? unit.factor *= symbol->factor : unit.factor /= symbol->factor;
    unit.dimension.force += n * symbol->dimension.force;
    unit.dimension.length += n * symbol->dimension.length;
    unit.dimension.angle += n * symbol->dimension.angle;
    unit.dimension.time += n * symbol->dimension.time;
    unit.dimension.pixel += n * symbol->dimension.pixel;
    text = trim(text);
    // very large powers leave the range of doubles
    if (text.empty()) return std::isfinite(unit.factor) && unit.factor > 0 ? std::optional(unit) : std::nullopt;
    divide = take(text, "/");
    if (!divide && !take(text, "*")) take(text, "·");
    text = trim(text);
  }
}

std::string with_other_capitals(std::string_view unit, const Dimension& wanted) {
  constexpr std::size_t kMost = 8;  // letters
  std::vector<std::size_t> letters;
  for (std::size_t i = 0; i < unit.size(); ++i)
    if (std::isalpha(static_cast<unsigned char>(unit[i]))) letters.push_back(i);
  if (letters.size() > kMost) return {};
  std::string found;
  std::size_t least = kMost + 1;  // letters changed
  for (unsigned choice = 1; choice < 1U << letters.size(); ++choice) {
    std::string other(unit);
    const auto changed = static_cast<std::size_t>(std::popcount(choice));
    for (std::size_t k = 0; k < letters.size(); ++k)
      if (choice >> k & 1U) other[letters[k]] = static_cast<char>(other[letters[k]] ^ ('a' ^ 'A'));
    const auto parsed = changed <= least ? parse_unit(other) : std::nullopt;
    if (!parsed || parsed->dimension != wanted) continue;
    found = changed < least ? other : std::string();
    least = changed;
  }
  return found;
}

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

ReadableUnit readable_unit(double value, const std::string& unit) {
  if (unit != "Pa" && unit != "J/m^2" && unit != "m") return {1, unit};
  for (const auto& [least, prefix] : {std::pair(1e9, "G"), std::pair(1e6, "M"), std::pair(1e3, "k"), std::pair(1.0, ""),
                                      std::pair(1e-3, "m"), std::pair(1e-6, "u")})
    if (std::abs(value) >= least) return {1 / least, prefix + unit};
  return {1, unit};
}

std::string_view example_unit(const Dimension& d) {
  if (d == dimension::force) return "mN";
  if (d == dimension::length) return "mm";
  if (d == dimension::area) return "mm^2";
  if (d == dimension::stress) return "MPa";
  if (d == dimension::energy_per_area) return "mJ/m^2";
  if (d == dimension::time) return "s";
  if (d == dimension::frequency) return "Hz";
  return {};
}

std::string describe(const Dimension& d) {
  const auto such_as = [&](std::string_view kind) {
    return std::string(kind) + " such as " + std::string(example_unit(d));
  };
  if (d == dimension::none) return "a plain number";
  if (d == dimension::force) return such_as("a force");
  if (d == dimension::length) return such_as("a length");
  if (d == dimension::area) return such_as("an area");
  if (d == dimension::stress) return such_as("a stress");
  if (d == dimension::energy_per_area) return such_as("an energy per area");
  if (d == dimension::angle) return "an angle (rad or deg)";
  if (d == dimension::time) return such_as("a time");
  if (d == dimension::frequency) return such_as("a rate");
  return "N^" + std::to_string(d.force) + " m^" + std::to_string(d.length);
}

}  // namespace mixity
