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
  for (const Prefix& prefix : kPrefixes) {
    std::string_view rest = text;
    if (!take(rest, prefix.name)) continue;
    for (const Symbol& symbol : kSymbols)
      if (symbol.takes_prefix && symbol.name == rest)
        // dividing by 10^n is exact where multiplying by 10^-n is not
        return Unit{prefix.power < 0 ? symbol.factor / std::pow(10.0, -prefix.power)
                                     : symbol.factor * std::pow(10.0, prefix.power),
                    symbol.dimension,
                    {}};
  }
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

/// Removes "10^-3 ", "1e-3 " or "10⁻³ " from the beginning of a unit and returns it; 1 if there is none.
double take_power_of_ten(std::string_view& text) {
  constexpr int kMost = 15;
  std::string_view rest = text;
  int power = 0;
  if (take(rest, "10^") || take(rest, "10**") || take(rest, "1e") || take(rest, "1E")) {
    if (rest.starts_with('+')) rest.remove_prefix(1);
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), power);
    if (error != std::errc()) return 1;
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  } else if (take(rest, "10⁻")) {
    for (const auto& [sign, n] : {std::pair("³", 3), {"⁶", 6}, {"⁹", 9}})
      if (power == 0 && take(rest, sign)) power = -n;
  }
  if (power == 0 || std::abs(power) > kMost || !(rest.starts_with(' ') || rest.starts_with("·"))) return 1;
  take(rest, "·");
  text = trim(rest);
  return power < 0 ? 1 / std::pow(10.0, -power) : std::pow(10.0, power);
}

}  // namespace

bool is_form_of_clock(std::string_view text) {
  std::string parts;  // "h:m:s": each letter once
  for (const char c : text.substr(0, text.find_first_of(".,"))) {
    const char lower = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (parts.empty() || parts.back() != lower) parts += lower;
  }
  return parts == "h:m:s";
}

std::optional<Unit> parse_unit(std::string_view text) {
  text = trim(text);
  if (is_form_of_clock(text)) return Unit{1, dimension::time, std::string(text)};
  Unit unit{1, {}, std::string(text)};
  // for one-line messages
  std::replace_if(
      unit.text.begin(), unit.text.end(), [](unsigned char c) { return std::isspace(c); }, ' ');
  for (std::size_t at = 0; (at = unit.text.find("\\+(", at)) != std::string::npos;) {  // Origin's markup
    const std::size_t end = unit.text.find(')', at);
    if (end == std::string::npos) break;
    unit.text = unit.text.substr(0, at) + '^' + unit.text.substr(at + 3, end - at - 3) + unit.text.substr(end + 1);
  }
  if (text.empty()) return std::nullopt;
  // units of a plain number; within a product 1 may only occur as in "1/mm"
  if (text == "1" || text == "-") return unit;
  if (text == "%") return unit.factor = 0.01, unit;
  if (const double power = take_power_of_ten(text); power != 1) {
    const auto scaled = parse_unit(text);
    if (!scaled || scaled->dimension == Dimension{}) return std::nullopt;
    return unit.factor = power * scaled->factor, unit.dimension = scaled->dimension, unit;
  }
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

ReadableUnit readable_unit(double value, const std::string& unit) {
  if (unit == "m^2" && std::abs(value) < 1e-3) return {1e6, "mm^2"};
  if (unit != "Pa" && unit != "J/m^2" && unit != "m" && unit != "N") return {1, unit};
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
