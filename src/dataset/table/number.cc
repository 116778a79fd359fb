#include "dataset/table/number.h"

#include <algorithm>

#include "base/text.h"
#include "base/units.h"

namespace mixity {
namespace {

/// The bytes of a separator of groups at the front of a text; 0 if there is none.
std::size_t group_sign(std::string_view text, char decimal) {
  const std::string_view other = decimal == '.' ? "," : ".";
  for (const std::string_view sign :
       {other, std::string_view("'"), std::string_view(" "), std::string_view("\xC2\xA0"),
        std::string_view("\xE2\x80\xAF"), std::string_view("\xE2\x80\x89"), std::string_view("\xE2\x80\x99")})
    if (text.starts_with(sign)) return sign.size();
  return 0;
}

/// Joins the groups of digits before the decimal sign; false if there are none.
bool join_groups(std::string_view& rest, char decimal, std::string& plain, NumberStyle& style) {
  std::size_t digits = 0;
  while (digits < rest.size() && is_digit(rest[digits])) ++digits;
  if (digits == 0 || digits > 3 || rest[0] == '0') return false;
  plain += rest.substr(0, digits);
  rest.remove_prefix(digits);
  const std::size_t size = group_sign(rest, decimal);
  const std::string_view sign = rest.substr(0, size);
  std::size_t groups = 0;
  for (; size > 0 && rest.starts_with(sign); ++groups) {
    const std::string_view group = rest.substr(size, 3);
    if (group.size() < 3 || !std::all_of(group.begin(), group.end(), is_digit)) return false;
    plain += group;
    rest.remove_prefix(size + 3);
  }
  if (groups == 0 || (!rest.empty() && is_digit(rest[0]))) return false;
  style.grouped = true;
  style.doubtful = groups == 1 && (sign == "," || sign == ".") && !rest.starts_with(decimal);
  return true;
}

}  // namespace

bool parse_number(std::string_view text, char decimal, double& value, NumberStyle* style) {
  text = trim(text);
  if (decimal == '.' && parse_number(text, value)) {
    if (style) *style = {};
    return true;
  }
  NumberStyle found;
  std::string plain;
  std::string_view rest = text;
  constexpr std::string_view kMinus = "\xE2\x88\x92";  // U+2212, as typesetters have it
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
  }
  if (decimal != '.' && rest.find('.') != std::string_view::npos) return false;
  const std::size_t before = plain.size();
  plain += rest;
  const std::size_t at = plain.find(decimal, before);
  if (at != std::string::npos) plain[at] = '.';
  // Fortran's exponents
  if (const std::size_t exponent = plain.find_first_of("Dd"); exponent != std::string::npos) plain[exponent] = 'e';
  if (!rest.empty() && (rest[0] == '-' || rest[0] == '+')) return false;
  if (!parse_number(std::string_view(plain), value)) return false;
  if (style) *style = found;
  return true;
}

bool is_missing(std::string_view text) {
  constexpr std::string_view kTexts[] = {"NA",      "N/A",    "n/a",     "#N/A",   "#NV",  "#NUM!", "#DIV/0!",
                                         "#VALUE!", "-",      "--",      "null",   "NULL", "None",  "missing",
                                         "1.#QNAN", "1.#IND", "-1.#IND", "1.#INF", "1.#J"};
  return std::find(std::begin(kTexts), std::end(kTexts), trim(text)) != std::end(kTexts);
}

}  // namespace mixity
