#include "dataset/logs/rate_unit.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "base/text.h"
#include "dataset/table/heading.h"

namespace mixity {
namespace {

// folded
constexpr std::array kCounted{
    "s",           "sa",           "sample",   "samples",   "smp",     "smpl",    "pt",        "pts",
    "point",       "points",       "frame",    "frames",    "scan",    "scans",   "reading",   "readings",
    "row",         "rows",         "value",    "values",    "image",   "images",  "bild",      "bilder",
    "wert",        "werte",        "messwert", "messwerte", "punkt",   "punkte",  "abtastung", "abtastungen",
    "echantillon", "echantillons", "campione", "campioni",  "muestra", "muestras"};
constexpr std::array<std::pair<const char*, double>, 27> kTimes{
    {{"s", 1},        {"sec", 1},      {"secs", 1},     {"second", 1},         {"seconds", 1},         {"sekunde", 1},
     {"sekunden", 1}, {"seconde", 1},  {"secondes", 1}, {"secondo", 1},        {"secondi", 1},         {"segundo", 1},
     {"segundos", 1}, {"ms", 1e-3},    {"msec", 1e-3},  {"millisecond", 1e-3}, {"milliseconds", 1e-3}, {"min", 60},
     {"minute", 60},  {"minutes", 60}, {"minuten", 60}, {"minuto", 60},        {"minuti", 60},         {"minutos", 60},
     {"h", 3600},     {"hour", 3600},  {"hours", 3600}}};

/// A time in s; 0 if it is none.
double time_in(std::string_view text) {
  const auto unit = parse_unit(text);
  if (unit && unit->dimension == dimension::time) return unit->factor;
  const std::string word = folded(text);
  const auto found = std::find_if(kTimes.begin(), kTimes.end(), [&](const auto& one) { return word == one.first; });
  return found == kTimes.end() ? 0 : found->second;
}

/// How many are counted: 1000 for "kS"; 0 if the word names nothing that is counted.
double count_in(std::string_view text) {
  const auto is_counted = [](std::string_view word) {
    const std::string plain = folded(word);
    return std::find(kCounted.begin(), kCounted.end(), plain) != kCounted.end();
  };
  if (text.empty() || text == "1" || is_counted(text)) return 1;
  const double prefix = text[0] == 'k' ? 1e3 : text[0] == 'M' ? 1e6 : 0;
  return prefix > 0 && is_counted(trim(text.substr(1))) ? prefix : 0;
}

}  // namespace

std::optional<Unit> rate_unit(std::string_view text) {
  text = without_brackets(text);
  if (text.empty()) return std::nullopt;
  const auto unit = parse_unit(text);
  if (unit && (unit->dimension == dimension::frequency || unit->dimension == dimension::time)) return unit;
  const std::string word = folded(text), shown(text);
  const double prefix = text[0] == 'k' ? 1e3 : text[0] == 'M' ? 1e6 : 1;
  for (const std::string_view name : {"fps", "sps", "hz", "hertz", "framespersecond", "samplespersecond"}) {
    if (word == name) return Unit{1, dimension::frequency, shown};
    if (prefix > 1 && word.substr(1) == name) return Unit{prefix, dimension::frequency, shown};
  }
  for (const std::string_view sign : {"/", "per ", "pro ", "par ", "por "}) {
    const std::size_t at = text.find(sign);
    if (at == std::string_view::npos || (sign != "/" && at > 0 && text[at - 1] != ' ')) continue;
    const std::string_view over = trim(text.substr(0, at)), under = trim(text.substr(at + sign.size()));
    if (const double count = count_in(over), time = time_in(under); count > 0 && time > 0)
      return Unit{count / time, dimension::frequency, shown};
    if (const double time = time_in(over), count = under.empty() ? 0 : count_in(under); time > 0 && count > 0)
      return Unit{time / count, dimension::time, shown};
  }
  if (const double time = time_in(text); time > 0) return Unit{time, dimension::time, shown};
  return std::nullopt;
}

}  // namespace mixity
