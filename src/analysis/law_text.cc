// Laws as text: in the syntax of the flag --law, and as a table of a fit definition.
#include <algorithm>
#include <cmath>

#include "analysis/laws.h"
#include "base/input_error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "base/toml_file.h"
#include "base/units.h"

namespace mixity {

double usual_start(double lower, double upper) {
  return lower > 0 && upper > 20 * lower ? std::sqrt(lower * upper) : 0.5 * (lower + upper);
}

LawDefinition read_law_text(const std::string& what, std::string_view text, std::size_t* expression_at) {
  const auto fail = [&](std::size_t at, const std::string& message) { throw InputError(what, 1, at + 1, message); };
  const std::size_t colon = text.find(':');
  std::size_t begin = colon == std::string_view::npos ? 0 : colon + 1;
  LawDefinition law;
  law.key = trim(text.substr(0, begin == 0 ? 0 : colon));
  const std::size_t end = std::min(text.find(';', begin), text.size());
  // also accepts laws as they are shown: f = ...
  if (const std::string_view shown = trim(text.substr(begin, end - begin));
      shown.starts_with('f') && trim(shown.substr(1)).starts_with('='))
    begin = text.find('=', begin) + 1;
  while (begin < end && text[begin] == ' ') ++begin;
  law.text = trim(text.substr(begin, end - begin));
  for (std::size_t at = end; at < text.size();) {
    const std::size_t from = at + 1, next = std::min(text.find_first_of(",;", from), text.size());
    const std::string_view item = trim(text.substr(from, next - from));
    at = next;
    if (item.empty() && next == text.size()) break;
    const std::size_t equals = item.find('='), dots = item.find("..");
    if (item == "normalised" ||
        (trim(item.substr(0, equals)) == "normalised" && trim(item.substr(equals + 1)) == "true")) {
      law.normalised = true;
      continue;
    }
    const std::size_t word = item.find(" start");
    if (equals == std::string_view::npos || dots == std::string_view::npos || dots < equals)
      fail(from, "'" + std::string(item) +
                     "' is not a parameter; write name=least..greatest, optionally followed by start VALUE");
    const auto lower = parse_number(trim(item.substr(equals + 1, dots - equals - 1)));
    const std::string_view last = trim(item.substr(dots + 2, word == std::string_view::npos ? word : word - dots - 2));
    const auto upper = parse_number(last);
    std::string_view begins = word == std::string_view::npos ? "" : trim(item.substr(word + 6));
    if (begins.starts_with('=')) begins = trim(begins.substr(1));
    const auto start = parse_number(begins);
    const std::string name(trim(item.substr(0, equals)));
    const bool three_dots = item.substr(dots).starts_with("...");
    if (three_dots || !lower || !upper || !std::isfinite(*lower) || !std::isfinite(*upper))
      fail(from, "the range of '" + name + "' must be two numbers: least..greatest");
    if (word != std::string_view::npos && !start)
      fail(from, "the start of '" + name + "' must be a number: least..greatest start VALUE");
    law.parameters.push_back({name, *lower, *upper, start.value_or(usual_start(*lower, *upper))});
  }
  if (colon != std::string_view::npos && law.key.empty()) fail(0, "there is no key before the colon");
  if (expression_at) *expression_at = begin;
  return law;
}

std::string law_toml(const LawDefinition& law) {
  if (law.sampler)
    throw InputError("law " + law.key,
                     "is a function, " + law.text + ", which a file cannot store; state it as an expression");
  std::string text = "[laws." + law.key + "]\n";
  if (!law.name.empty()) text += "name = " + toml_text(law.name) + '\n';
  text += (law.text.find('=') == std::string::npos ? "f = " : "criterion = ") + toml_text(law.text) + '\n';
  for (const LawParameter& one : law.parameters)
    text += one.name + " = { range = [" + shortest(one.lower) + ", " + shortest(one.upper) +
            "], start = " + shortest(one.start) + " }\n";
  return text + (law.normalised ? "normalised = true\n" : "");
}

std::string law_text(const LawDefinition& law) {
  std::string text = law.text;
  for (const LawParameter& one : law.parameters) {
    text += "; " + one.name + "=" + shortest(one.lower) + ".." + shortest(one.upper);
    if (one.start != usual_start(one.lower, one.upper)) text += " start " + shortest(one.start);
  }
  return text + (law.normalised ? "; normalised" : "");
}

}  // namespace mixity
