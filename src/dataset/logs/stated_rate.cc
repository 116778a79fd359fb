#include "dataset/logs/stated_rate.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/input_error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "base/units.h"
#include "dataset/logs/rate_unit.h"
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

// Words beside such a name that leave it the rate of the rows; "Max." or "camera" do not.
constexpr std::array kPlainWords{
    "data",       "daq",          "acquisition", "acq",       "frequency",  "freq",    "frequence",    "frequenza",
    "frecuencia", "taux",         "tasa",        "rate",      "in",         "of",      "the",          "for",
    "rows",       "row",          "log",         "logging",   "logger",     "signal",  "channel",      "channels",
    "all",        "actual",       "real",        "effective", "current",    "used",    "measurement",  "recording",
    "file",       "per",          "der",         "des",       "daten",      "messung", "aufzeichnung", "kanal",
    "kanale",     "tatsachliche", "value",       "sample",    "sampling",   "time",    "interval",     "de",
    "d",          "di",           "la",          "cadence",   "intervalle", "periode"};

/// The name that the words contain; null if there is none.
template <class Names>
const char* name_in(const std::string& words, const Names& names) {
  const auto found =
      std::find_if(names.begin(), names.end(), [&](const char* name) { return words.find(name) != std::string::npos; });
  return found == names.end() ? nullptr : *found;
}

/// Whether all other words leave this name the rate of the rows.
bool stands_alone(std::string_view name, std::string_view heading) {
  while (!heading.empty()) {
    const std::size_t end = std::min(heading.find_first_of(" _-'/.,"), heading.size());
    std::string word = folded(heading.substr(0, end));
    heading.remove_prefix(std::min(end + 1, heading.size()));
    if (name.find(word) != std::string_view::npos) continue;  // part of the name
    if (const std::size_t at = word.find(name); at != std::string::npos) word.erase(at, name.size());
    const bool plain =
        std::any_of(kPlainWords.begin(), kPlainWords.end(), [&](std::string_view one) { return one == word; });
    if (!word.empty() && !plain && !rate_unit(word)) return false;
  }
  return true;
}

/// A number of a line, and its unit if one follows.
struct Statement {
  std::string heading, words;  // before it: as written, and folded
  double value = 0;
  std::optional<Unit> unit;
  bool clear = true;  // false: the number can be read in two ways, or something follows it that is no known unit
};

/// What stands behind a number up to a remark: "Hz" of "Hz (of 4 kHz)" or of "Hz, filtered".
std::string_view without_remark(std::string_view text) { return trim(text.substr(0, text.find_first_of("(,", 1))); }

/// Splits "words: number unit" at the first colon, equals sign or separator of columns, else at the number. Null if
/// there is no number.
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
    const bool is_number = !number.empty() && (parse_number(number, '.', made.value, &style) ||
                                               parse_number(number, ',', made.value, &style));
    made.clear = !style.doubtful;
    return is_number;
  };
  if (!read(digits) || !(made.value > 0)) return std::nullopt;
  const Heading heading = split_heading(words, {});
  made.heading = heading.name;
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
  if (heading.unit) {
    const auto own = rate_unit(*heading.unit);
    made.clear &= own && (!made.unit || (made.unit->factor == own->factor && made.unit->dimension == own->dimension));
    if (!made.unit) made.unit = own;
  }
  for (const std::string_view part : {" in ", "/", "_", " "})  // "Abtastrate in Hz", "rate/Hz"
    if (const std::size_t at = heading.name.rfind(part);
        !made.unit && at != std::string::npos && made.words.find("persecond") == std::string::npos)
      made.unit = rate_unit(std::string_view(heading.name).substr(at + part.size()));
  // "12,5 Hz" may be split at its decimal comma
  const bool decimals =
      sign == ',' && beside && value.find('.') == std::string_view::npos && !behind.empty() && is_digit(behind[0]);
  made.clear &= !decimals && (made.unit || beside || behind.starts_with('('));
  return made;
}

struct NamedRate {
  double value = 0;    // 1/s; 0: it is not taken
  bool named = false;  // whether the words name a rate or an interval of samples
};
NamedRate rate_of(const Statement& one) {
  const char *const rate_name = name_in(one.words, kRateNames), *const interval_name =
                                                                    name_in(one.words, kIntervalNames);
  const bool rate = rate_name || one.words == "fps" || one.words == "rate",
             of_labview = one.words == "deltax" || one.words == "dt" || one.words == "deltat",
             interval = of_labview || interval_name;
  if (!rate && !interval) return {};
  const char* const name = rate_name ? rate_name : interval_name;
  if (!one.clear || (name && !stands_alone(name, one.heading))) return {0, name != nullptr};
  if (one.unit) {
    const double si = one.value * one.unit->factor;
    return {one.unit->dimension == dimension::time ? 1 / si : si, true};
  }
  if (one.words == "rate" || (!rate && !of_labview)) return {0, name != nullptr};
  return {rate ? one.value : 1 / one.value, true};
}

}  // namespace

std::optional<StatedRate> stated_rate(const std::string& path, std::string_view head, std::string* not_taken) {
  constexpr std::size_t kShown = 60;
  std::optional<StatedRate> found;
  for (std::size_t number = 1; !head.empty(); ++number) {
    const std::size_t end = std::min(head.find_first_of("\r\n"), head.size());
    const std::string_view line = head.substr(0, end);
    head.remove_prefix(std::min(end + (head.substr(end).starts_with("\r\n") ? 2 : 1), head.size()));
    const auto statement = read_statement(line);
    const NamedRate read = statement ? rate_of(*statement) : NamedRate{};
    const double rate = read.value;
    if (!(rate > 0) && read.named && not_taken && not_taken->empty())
      *not_taken = "line " + std::to_string(number) + ", '" + printable(trim(line), kShown) + "'";
    if (!(rate > 0)) continue;
    if (found && std::abs(rate - found->rate) > 1e-6 * found->rate)
      throw InputError(path, number, 1,
                       "states a rate of " + rounded(rate, 6) + " Hz, line " + std::to_string(found->line) +
                           " one of " + rounded(found->rate, 6) + " Hz; say which is that of the rows: " +
                           Remedy::set_or_key("rate", rounded(found->rate, 6) + " Hz"));
    if (!found) found = StatedRate{rate, number};
  }
  return found;
}

}  // namespace mixity
