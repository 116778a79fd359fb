#include "dataset/table/number.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <string>

#include "base/text.h"
#include "base/units.h"

namespace mixity {
namespace {

/// The separator of groups at the front of a text; empty if there is none.
std::string_view group_sign(std::string_view text, char decimal) {
  for (const std::string_view sign :
       {decimal == '.' ? "," : ".", "'", " ", "\xC2\xA0", "\xE2\x80\xAF", "\xE2\x80\x89", "\xE2\x80\x99"})
    if (text.starts_with(sign)) return sign;
  return {};
}

/// Joins the groups of digits before the decimal sign; false if there are none.
bool join_groups(std::string_view& rest, char decimal, std::string& plain, NumberStyle& style) {
  std::size_t digits = 0;
  while (digits < rest.size() && is_digit(rest[digits])) ++digits;
  if (digits == 0 || digits > 3 || rest[0] == '0') return false;
  plain += rest.substr(0, digits);
  rest.remove_prefix(digits);
  const std::string_view sign = group_sign(rest, decimal);
  std::size_t groups = 0;
  for (; !sign.empty() && rest.starts_with(sign); ++groups) {
    const std::string_view group = rest.substr(sign.size(), 3);
    if (group.size() < 3 || !std::all_of(group.begin(), group.end(), is_digit)) return false;
    plain += group;
    rest.remove_prefix(sign.size() + 3);
  }
  if (groups == 0 || (!rest.empty() && is_digit(rest[0]))) return false;
  style.grouped = true;
  style.doubtful = groups == 1 && (sign == "," || sign == ".") && !rest.starts_with(decimal);
  return true;
}

/// A quick look at its first byte, which is beyond ASCII for a typographic minus.
bool may_be_a_number(std::string_view text) {
  return !text.empty() && (is_digit(text[0]) || std::string_view("+-.,iInN").find(text[0]) != std::string_view::npos ||
                           static_cast<unsigned char>(text[0]) >= 0x80);
}

/// Reads a number with a decimal comma and without groups, as most are.
bool parse_plain_comma(std::string_view text, double& value) {
  std::array<char, 32> pointed;
  if (text.size() > pointed.size()) return false;
  bool comma = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '.') return false;
    pointed[i] = text[i] == ',' && !comma ? '.' : text[i];
    comma |= text[i] == ',';
  }
  return parse_number(std::string_view(pointed.data(), text.size()), value);
}

/// Removes a pattern from the front of a text: each run of 'd' matches the digits of a number, other characters match
/// themselves. False, and nothing is changed, if the text does not match.
bool take(std::string_view& text, std::string_view pattern, std::initializer_list<int*> numbers) {
  if (text.size() < pattern.size()) return false;
  for (std::size_t i = 0; i < pattern.size(); ++i)
    if (pattern[i] != 'd' ? text[i] != pattern[i] : !is_digit(text[i])) return false;
  for (int* number : numbers) *number = 0;
  auto number = numbers.begin();
  for (std::size_t i = 0; i < pattern.size(); ++i)
    if (pattern[i] != 'd')
      ++number;
    else
      **number = 10 * **number + (text[i] - '0');
  text.remove_prefix(pattern.size());
  return true;
}

bool take_one_of(std::string_view& text, std::string_view signs) {
  if (text.empty() || signs.find(text[0]) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

/// Takes a date and what parts it from the time. 4/3/2026 may be in March or April: such a date only keeps its place.
/// False if there is one that does not exist.
bool take_date(std::string_view& text, ClockTime& time) {
  int year = 0, month = 0, day = 0;
  if (take(text, "dddd-dd-dd", {&year, &month, &day}) || take(text, "dddd/dd/dd", {&year, &month, &day}) ||
      take(text, "dddd.dd.dd", {&year, &month, &day}) || take(text, "dd.dd.dddd", {&day, &month, &year})) {
    using namespace std::chrono;
    const year_month_day date{std::chrono::year{year}, std::chrono::month{static_cast<unsigned>(month)},
                              std::chrono::day{static_cast<unsigned>(day)}};
    time.dated = true;
    time.seconds = std::int64_t{86400} * sys_days{date}.time_since_epoch().count();
    return date.ok() && take_one_of(text, "T ");
  }
  for (const std::string_view either : {"dd/dd/dddd", "d/dd/dddd", "dd/d/dddd", "d/d/dddd"})
    if (take(text, either, {&day, &month, &year}))
      return std::max(day, month) < 32 && std::min(day, month) < 13 && take_one_of(text, " ");
  return true;
}

/// Hours as a clock of 24 hours has them, where "AM" or "PM" stands behind the time.
bool take_half_of_day(std::string_view& text, int& hours) {
  for (const std::string_view half : {" AM", " PM", " am", " pm", " a.m.", " p.m."}) {
    if (!text.ends_with(half)) continue;
    text.remove_suffix(half.size());
    if (hours < 1 || hours > 12) return false;
    hours = hours % 12 + (half[1] == 'P' || half[1] == 'p' ? 12 : 0);
  }
  return true;
}

/// "1.23(4)e-3" is (1.23 +/- 0.04) 1e-3, as is "1.23(0.04)e-3".
bool parse_with_digits(std::string_view text, char decimal, double& value, double& error) {
  const std::size_t open = text.find('('), close = text.find(')');
  if (open == 0 || open == std::string_view::npos || close == std::string_view::npos || close < open + 2) return false;
  const std::string before(text.substr(0, open)), digits(text.substr(open + 1, close - open - 1)),
      exponent(text.substr(close + 1));
  if (!exponent.empty() && exponent[0] != 'e' && exponent[0] != 'E') return false;
  if (!parse_number(before + exponent, decimal, value) || !std::isfinite(value)) return false;
  if (digits.find(decimal) != std::string::npos) return parse_number(digits + exponent, decimal, error) && error >= 0;
  if (!std::all_of(digits.begin(), digits.end(), is_digit)) return false;
  const std::size_t point = before.find(decimal), last = point == std::string::npos ? 0 : before.size() - point - 1;
  const int power = exponent.empty() ? 0 : std::atoi(exponent.c_str() + 1);
  return parse_number(digits + "e" + std::to_string(power - static_cast<int>(last)), error);
}

}  // namespace

bool parse_number(std::string_view text, char decimal, double& value, NumberStyle* style) {
  text = trim(text);
  if (!may_be_a_number(text)) return false;
  if (decimal == '.' ? parse_number(text, value) : parse_plain_comma(text, value)) {
    if (style) *style = {};
    return true;
  }
  NumberStyle found;
  std::string plain;
  std::string_view rest = text;
  constexpr std::string_view kMinus = "\xE2\x88\x92";  // U+2212, the typographic minus sign
  if (rest.starts_with('-') || rest.starts_with('+')) {
    if (rest[0] == '-') plain = "-";
    rest.remove_prefix(1);
  } else if (rest.starts_with(kMinus)) {
    plain = "-";
    rest.remove_prefix(kMinus.size());
  }
  const std::string sign = plain;
  const std::string_view unsigned_text = rest;
  if (!join_groups(rest, decimal, plain, found)) {
    plain = sign;
    rest = unsigned_text;
    found = {};
    if (decimal == '.' && sign.size() + rest.size() == text.size() && rest.find_first_of("Dd*") == std::string::npos)
      return false;  // nothing differs from what was tried
  }
  if (decimal != '.' && rest.find('.') != std::string_view::npos) return false;
  const std::size_t before = plain.size();
  plain += rest;
  if (const std::size_t at = plain.find(decimal, before); at != std::string::npos) plain[at] = '.';
  // Mathematica writes exponents with *^, Fortran with D.
  if (const std::size_t at = plain.find("*^"); at != std::string::npos) plain.replace(at, 2, "e");
  if (const std::size_t at = plain.find_first_of("Dd"); at != std::string::npos) plain[at] = 'e';
  if (!rest.empty() && (rest[0] == '-' || rest[0] == '+')) return false;
  if (!parse_number(std::string_view(plain), value)) return false;
  if (style) *style = found;
  return true;
}

bool is_number(std::string_view field) {
  double value = 0, error = 0;
  if (!may_be_a_number(trim(field))) return false;
  return parse_number(field, '.', value) || parse_number(field, ',', value) ||
         parse_with_error(field, '.', value, error) || parse_with_error(field, ',', value, error);
}

bool parse_with_error(std::string_view text, char decimal, double& value, double& error) {
  text = trim(text);
  const auto number = [&](std::string_view part, double& read) {
    NumberStyle style;
    return parse_number(part, decimal, read, &style) && !style.grouped && std::isfinite(read);
  };
  for (const std::string_view sign : {"\xC2\xB1", "+/-", "+-"}) {
    const std::size_t at = text.find(sign);
    if (at == std::string_view::npos) continue;
    std::string_view behind = trim(text.substr(at + sign.size()));
    const bool percent = behind.ends_with('%');
    if (percent) behind.remove_suffix(1);
    if (!number(text.substr(0, at), value) || !number(behind, error) || error < 0) return false;
    if (percent) error *= std::abs(value) / 100;
    return true;
  }
  return parse_with_digits(text, decimal, value, error);
}

bool is_missing(std::string_view text) {
  constexpr std::string_view kTexts[] = {"NA",      "N/A",    "n/a",     "#N/A",     "#NV",      "#NUM!", "#DIV/0!",
                                         "#VALUE!", "-",      "--",      "null",     "NULL",     "None",  "missing",
                                         "1.#QNAN", "1.#IND", "-1.#IND", "1.#INF",   "1.#J",     "---",   "OVL",
                                         "OVLD",    "OL",     "O.L",     "OVERLOAD", "OVERFLOW", "OVRNG"};
  return std::find(std::begin(kTexts), std::end(kTexts), trim(text)) != std::end(kTexts);
}

bool is_placeholder(double value) {
  constexpr double kScpi = 9.9e37;  // infinity; 9.91e37 is no number
  return value == -9999 || value == -99999 || std::abs(value) == kScpi || value == 9.91e37;
}

std::optional<ClockTime> parse_clock(std::string_view text) {
  text = trim(text);
  ClockTime time;
  if (!take_date(text, time)) return std::nullopt;
  int hours = 0, minutes = 0, seconds = 0;
  if (!take(text, text.find(':') == 1 ? "d:dd:dd" : "dd:dd:dd", {&hours, &minutes, &seconds}) ||
      !take_half_of_day(text, hours) || hours > 23 || minutes > 59 || seconds > 59)
    return std::nullopt;
  time.seconds += 3600 * hours + 60 * minutes + seconds;
  const bool thousandths = text.size() == 4 && text[0] == ':';  // "10:05:00:250"
  if (take_one_of(text, thousandths ? ":" : ".,")) {
    std::string digits = "0.";
    for (; !text.empty() && is_digit(text[0]); text.remove_prefix(1)) digits += text[0];
    if (digits.size() == 2 || !parse_number(digits, time.fraction)) return std::nullopt;
  }
  if (time.dated && !text.empty() && !take_one_of(text, "Z")) {
    const int direction = text[0] == '-' ? 1 : -1;
    int zone_hours = 0, zone_minutes = 0;
    if (!take_one_of(text, "+-") || !take(text, "dd", {&zone_hours})) return std::nullopt;
    take_one_of(text, ":");
    if (!text.empty() && !take(text, "dd", {&zone_minutes})) return std::nullopt;
    time.seconds += direction * (3600 * zone_hours + 60 * zone_minutes);
  }
  return text.empty() ? std::optional(time) : std::nullopt;
}

}  // namespace mixity
