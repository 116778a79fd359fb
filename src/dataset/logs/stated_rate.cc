#include "dataset/logs/stated_rate.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/input_error.h"
#include "base/number_text.h"
#include "base/units.h"
#include "dataset/table/heading.h"
#include "dataset/table/number.h"

namespace mixity {
namespace {

// folded; part of the words before the number
constexpr std::array kRateNames{
    "samplerate",       "samplingrate",    "samplefrequency", "samplingfrequency", "samplefreq", "samplingfreq",
    "acquisitionrate",  "acquisitionfreq", "acqrate",         "scanrate",          "datarate",   "collectionrate",
    "loggingrate",      "lograte",         "recordingrate",   "recordrate",        "framerate",  "framespersecond",
    "samplespersecond", "pointspersecond", "abtastrate",      "abtastfrequenz",    "messrate",   "messfrequenz",
    "aufnahmerate",     "bildrate",        "datenrate",       "capturerate",       "daqrate",    "dechantillonnage",
    "dicampionamento",  "demuestreo"};
constexpr std::array kIntervalNames{
    "sampleinterval",   "samplinginterval", "sampleperiod",        "samplingperiod",         "scaninterval",
    "scanperiod",       "datainterval",     "acquisitioninterval", "recordinginterval",      "logginginterval",
    "frameinterval",    "timestep",         "timeincrement",       "timebetweensamples",     "timebetweenframes",
    "deltax",           "deltat",           "xincrement",          "horizontalinterval",     "abtastintervall",
    "abtastzeit",       "abtastperiode",    "messintervall",       "aufzeichnungsintervall", "zeitschritt",
    "zeitinkrement",    "pasdetemps",       "passotemporale",      "pasodetiempo",           "loginterval",
    "intervalofsamples"};

template <class Names>
bool names_one(const std::string& words, const Names& names) {
  return std::any_of(names.begin(), names.end(),
                     [&](const char* name) { return words.find(name) != std::string::npos; });
}

/// The unit of a rate, in 1/s, or of an interval, in s.
std::optional<Unit> rate_unit(std::string_view text) {
  text = without_brackets(text);
  const auto unit = parse_unit(text);
  if (unit && (unit->dimension == dimension::frequency || unit->dimension == dimension::time)) return unit;
  const std::string word = folded(text);
  // "kS/s", "MSa/s"
  const double prefix = text.starts_with('k') ? 1e3 : text.starts_with('M') ? 1e6 : 1;
  for (const std::string_view name :
       {"fps", "framespersecond", "framess", "framessec", "samplespersecond", "sampless", "samplessec", "samplessecond",
        "ss", "sas", "sps", "pointss", "pointssec", "pointspersecond", "ptss", "ptssec", "hz", "hertz", "bilders"}) {
    if (word == name) return Unit{1, dimension::frequency, std::string(text)};
    if (prefix > 1 && word.substr(1) == name) return Unit{prefix, dimension::frequency, std::string(text)};
  }
  for (const std::string_view name : {"seconds", "second", "sekunden", "secs", "secondes", "secondi", "segundos"})
    if (word == name) return Unit{1, dimension::time, std::string(text)};
  if (word == "msec" || word == "milliseconds") return Unit{1e-3, dimension::time, std::string(text)};
  return std::nullopt;
}

/// A number of a line, and its unit if one follows.
struct Statement {
  std::string words;  // before it
  double value = 0;
  std::optional<Unit> unit;
};

/// What stands behind a number up to a remark: "Hz" of "Hz (of 4 kHz)" or of "Hz, filtered".
std::string_view without_remark(std::string_view text) { return trim(text.substr(0, text.find_first_of("(,", 1))); }

/// Splits "words: number unit" at the first colon, equals sign or separator of columns, else at the number. Null if
/// what stands behind the number is no unit, such as "samples/min", unless the words have one.
std::optional<Statement> read_statement(std::string_view line) {
  line = line.substr(std::min(line.find_first_not_of("#%;\"' \t"), line.size()));
  std::size_t open = 0, cut = 0;  // of brackets; where the words end
  for (; cut < line.size(); ++cut) {
    open += line[cut] == '(' || line[cut] == '[';
    if (open == 0 && std::string_view(":=\t;,|").find(line[cut]) != std::string_view::npos) break;
    if (open == 0 && cut > 0 && is_digit(line[cut]) && line[cut - 1] == ' ') break;
    open -= open > 0 && (line[cut] == ')' || line[cut] == ']');
  }
  if (cut == line.size()) return std::nullopt;
  const bool at_sign = !is_digit(line[cut]);
  const char sign = at_sign ? line[cut] : ' ';
  std::string_view words = line.substr(0, cut), rest = line.substr(cut + (at_sign ? 1 : 0));
  rest = rest.substr(std::min(rest.find_first_not_of(":=\t;,| \"'"), rest.size()));
  const std::string ends = std::string("\t;|\"") + (sign == ',' ? "," : "");
  std::string_view value = trim(rest.substr(0, rest.find_first_of(ends)));
  while (value.ends_with(',')) value.remove_suffix(1);
  const std::size_t digits = std::min(value.find_first_not_of("+-.,0123456789eE"), value.size());
  Statement made;
  const auto read = [&](std::size_t size) {
    NumberStyle style;
    const std::string_view number = value.substr(0, size);
    return !number.empty() &&
           (parse_number(number, '.', made.value, &style) || parse_number(number, ',', made.value, &style)) &&
           !style.doubtful;
  };
  if (!read(digits) || !(made.value > 0)) return std::nullopt;
  const Heading heading = split_heading(words, {});
  made.words = folded(heading.name);
  std::string_view behind = trim(value.substr(digits));
  const bool beside = behind.empty();
  if (beside) {  // "400\tHz"
    const std::size_t next = rest.find_first_of(ends);
    if (next != std::string_view::npos) {
      std::string_view other = trim(rest.substr(next + 1));
      behind = trim(other.substr(0, other.find_first_of(ends)));
    }
  }
  made.unit = rate_unit(behind);
  if (!made.unit) made.unit = rate_unit(without_remark(behind));
  if (!made.unit && behind.starts_with('/')) made.unit = rate_unit("1" + std::string(behind));  // "400/s"
  if (!made.unit && heading.unit) made.unit = rate_unit(*heading.unit);
  for (const std::string_view part : {" in ", "/", "_", " "})  // "Abtastrate in Hz", "rate/Hz"
    if (const std::size_t at = heading.name.rfind(part);
        !made.unit && at != std::string::npos && made.words.find("persecond") == std::string::npos)
      made.unit = rate_unit(std::string_view(heading.name).substr(at + part.size()));
  // "12,5 Hz" may be split at its decimal comma
  const bool decimals =
      sign == ',' && beside && value.find('.') == std::string_view::npos && !behind.empty() && is_digit(behind[0]);
  if (decimals || (!made.unit && !beside && !behind.starts_with('('))) return std::nullopt;
  return made;
}

std::optional<double> rate_of(const Statement& one) {
  const bool rate = names_one(one.words, kRateNames) || one.words == "fps" || one.words == "rate",
             of_labview = one.words == "deltax" || one.words == "dt" || one.words == "deltat",
             interval = of_labview || names_one(one.words, kIntervalNames);
  if (!rate && !interval) return std::nullopt;
  if (one.unit) {
    const double si = one.value * one.unit->factor;
    return one.unit->dimension == dimension::time ? 1 / si : si;
  }
  if (one.words == "rate" || (!rate && !of_labview)) return std::nullopt;
  return rate ? one.value : 1 / one.value;
}

}  // namespace

std::optional<StatedRate> stated_rate(const std::string& path, std::string_view head) {
  std::optional<StatedRate> found;
  for (std::size_t number = 1; !head.empty(); ++number) {
    const std::size_t end = std::min(head.find_first_of("\r\n"), head.size());
    const std::string_view line = head.substr(0, end);
    head.remove_prefix(std::min(end + (head.substr(end).starts_with("\r\n") ? 2 : 1), head.size()));
    const auto statement = read_statement(line);
    const auto rate = statement ? rate_of(*statement) : std::nullopt;
    if (!rate) continue;
    if (found && std::abs(*rate - found->rate) > 1e-6 * found->rate)
      throw InputError(path, number, 1,
                       "states a rate of " + rounded(*rate, 6) + " Hz, line " + std::to_string(found->line) +
                           " one of " + rounded(found->rate, 6) + " Hz; say which is that of the rows: " +
                           Remedy::set_or_key("rate", rounded(found->rate, 6) + " Hz"));
    if (!found) found = StatedRate{*rate, number};
  }
  return found;
}

}  // namespace mixity
