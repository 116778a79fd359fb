#include "cli/flags.h"

#include <algorithm>
#include <deque>

#include "analysis/laws.h"
#include "analysis/settings.h"
#include "base/number_text.h"
#include "base/text.h"
#include "base/units.h"

DEFINE_string(format, "text", "output format");
DEFINE_string(out, "", "where to write: a folder (fit, figures), a file (import)");
DEFINE_string(model, "", "model (mixity help lists them)");
DEFINE_string(
    load, "",
    "normal load P, compression positive: a number, or with a unit if dimensional; of a data file without one");
DEFINE_string(loads, "", "normal load of each data set, in order: \"7.7,3.8 mN\"");
DEFINE_string(load_range, "-4,40", "smallest and largest normal load: \"0.5, 10 mN\", or dimensionless");
DEFINE_int32(points, 201, "number of points, uniform in phi; of a planned run, from T = 0 at even steps (there 25)");

namespace mixity::cli {
namespace {

/// The storage of a flag that is defined from a table: gflags keeps pointers to it.
struct TableFlag {
  std::string name, help, text, initial;
  bool on, initially_on;
};

void define(const std::string& name, const std::string& help, const std::string& initial, bool is_switch) {
  static std::deque<TableFlag>& flags = *new std::deque<TableFlag>;  // never destroyed
  TableFlag& flag = flags.emplace_back(TableFlag{name, help, initial, initial, initial == "true", initial == "true"});
  if (is_switch)
    gflags::FlagRegisterer(flag.name.c_str(), flag.help.c_str(), __FILE__, &flag.on, &flag.initially_on);
  else
    gflags::FlagRegisterer(flag.name.c_str(), flag.help.c_str(), __FILE__, &flag.text, &flag.initial);
}

std::string given_command;  // NOLINT(cert-err58-cpp): an empty string does not throw

/// Quotes a word for a shell if necessary.
std::string shell_word(const std::string& word) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./=,:%+@";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

/// Adds the flags that were given: those of the experiment, or those of how to read a file.
void add_set(bool of_experiment, Overrides& overrides) {
  Metadata scratch;
  for (const MetadataField& field : metadata_fields()) {
    if (field.of_experiment != of_experiment || !is_set(field.name)) continue;
    const std::string value = value_of(field.name);
    const std::string problem = set_field(scratch, field.name, value);
    if (!problem.empty()) throw UsageError("flag '--" + std::string(field.name) + "': " + problem);
    overrides.emplace_back(field.name, value);
  }
}

}  // namespace

const std::string& command_line() { return given_command; }

void define_flags_of_tables() {
  for (const Setting& one : settings()) define(one.name, one.help, one.initial(), one.is_switch);
  for (const MetadataField& one : metadata_fields())
    if (one.name != "load") define(std::string(one.name), std::string(one.help), "", false);
}

std::vector<std::string_view> with_metadata_flags(std::vector<std::string_view> flags) {
  for (const MetadataField& one : metadata_fields()) flags.push_back(one.name);
  return flags;
}

Arguments parse_flags(const Command& command, const Arguments& words) {
  Arguments arguments;
  given_command = "mixity " + std::string(command.name);
  for (const std::string& word : words) given_command += ' ' + shell_word(word);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word.empty()) throw UsageError("an argument is empty");
    if (word == "--") {
      arguments.insert(arguments.end(), words.begin() + static_cast<std::ptrdiff_t>(i) + 1, words.end());
      break;
    }
    if (word.size() < 2 || word[0] != '-') {
      arguments.push_back(word);
      continue;
    }
    const std::size_t dashes = word[1] == '-' ? 2 : 1, equals = word.find('=');
    std::string name = word.substr(dashes, equals == std::string::npos ? equals : equals - dashes);
    std::replace(name.begin(), name.end(), '-', '_');
    if (std::find(command.flags.begin(), command.flags.end(), name) == command.flags.end())
      throw UsageError("unknown flag '" + word.substr(0, equals) + "' (see mixity help " + std::string(command.name) +
                       ")");
    gflags::CommandLineFlagInfo info;
    gflags::GetCommandLineFlagInfo(name.c_str(), &info);
    if (info.type == "bool" && equals == std::string::npos) {
      gflags::SetCommandLineOption(name.c_str(), "true");
      continue;
    }
    if (equals == std::string::npos && (i + 1 == words.size() || words[i + 1].starts_with("--")))
      throw UsageError("flag '" + word + "' needs a value");
    std::string value = equals == std::string::npos ? words[++i] : word.substr(equals + 1);
    // probably an unset variable of a script
    if (value.empty()) throw UsageError("flag '--" + name + "' needs a value");
    if (name == "law" && is_set("law")) value = value_of("law") + kNextLaw + value;
    if (gflags::SetCommandLineOption(name.c_str(), value.c_str()).empty())
      throw UsageError("flag '--" + name + "' cannot take the value '" + value + "'");
  }
  const auto& formats = command.formats;
  if (!formats.empty() && std::find(formats.begin(), formats.end(), FLAGS_format) == formats.end())
    throw must("format", "be " + formats_text(command));
  return arguments;
}

FigureFormats figure_formats() {
  FitRequest request;
  if (const std::string problem = set_option(request, "formats", value_of("formats")); !problem.empty())
    throw UsageError("flag '--formats' " + problem);
  return request.formats;
}

std::string formats_text(const Command& command) {
  std::string text;
  const std::size_t n = command.formats.size();
  for (std::size_t i = 0; i < n; ++i)
    text += (i == 0 ? "" : i + 1 == n ? " or " : ", ") + std::string(command.formats[i]);
  return text;
}

bool is_set(std::string_view flag) {
  gflags::CommandLineFlagInfo info;
  return gflags::GetCommandLineFlagInfo(std::string(flag).c_str(), &info) && !info.is_default;
}

std::string value_of(std::string_view flag) {
  std::string value;
  gflags::GetCommandLineOption(std::string(flag).c_str(), &value);
  return value;
}

Overrides data_overrides() {
  Overrides overrides = metadata_overrides();
  add_set(false, overrides);
  return overrides;
}

Overrides metadata_overrides() {
  Overrides overrides;
  add_set(true, overrides);
  if (is_set("modulus") && is_set("youngs_modulus"))
    throw UsageError("flags '--modulus' and '--youngs_modulus': give one of them");
  return overrides;
}

void require_model(const std::string& flag, const std::string& key) {
  provide_law(key);
  if (is_model(key)) return;
  std::string known;
  for (const std::string& candidate : known_models()) known += (known.empty() ? "" : ", ") + candidate;
  throw UsageError("flag '--" + flag + "': " + (key.empty() ? "no model" : "unknown model '" + key + "'") +
                   " (known: " + known + ")");
}

void require_flags_only(const std::string& command, const Arguments& arguments) {
  if (!arguments.empty()) throw UsageError(command + " takes flags only, not '" + arguments[0] + "'");
}

UsageError must(const std::string& flag, const std::string& be) {
  return UsageError("flag '--" + flag + "' is '" + value_of(flag) + "'; it must " + be);
}

double number_from(const std::string& flag, double low, double high) {
  const auto value = parse_number(value_of(flag));
  if (!value || !(*value >= low && *value <= high))
    throw must(flag, "be a number from " + shortest(low) + " to " + shortest(high));
  return *value;
}

std::vector<std::string> list_from(const std::string& flag) {
  const std::string value = value_of(flag);
  std::vector<std::string> items;
  if (value.empty()) return items;
  for (const std::string_view item : split(value)) {
    if (item.empty())
      throw UsageError("flag '--" + flag + "': entry " + std::to_string(items.size() + 1) + " is empty");
    items.emplace_back(item);
  }
  return items;
}

}  // namespace mixity::cli
