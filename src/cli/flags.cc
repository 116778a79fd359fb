#include "cli/flags.h"

#include <algorithm>
#include <deque>
#include <iostream>

#include "analysis/contact_shape.h"
#include "analysis/laws.h"
#include "analysis/setting_forms.h"
#include "analysis/settings.h"
#include "base/nearest_name.h"
#include "base/toml_file.h"

DEFINE_string(format, "text", "output format");
DEFINE_string(out, "", "output folder (fit, report, runs, figures) or file (import, merge, simulate)");
DEFINE_string(
    save, "",
    "a TOML to be written: by fit, the definition of this fit; by check and runs, how the files are read, for "
    "others of their kind (--definition)");
DEFINE_bool(force, false, "replace files that mixity did not write, or that were edited since");
DEFINE_string(model, "", "model (mixity help lists them)");
DEFINE_string(
    load, "",
    "normal load P, compression positive: a number, or a force such as \"3 mN\" if the contact has dimensions; for a "
    "data file, the load of all points if no column states it; elsewhere the same as --loads");
DEFINE_string(
    loads, "",
    "normal loads, such as \"7.7,3.8 mN\", or with decimal commas \"7,7; 3,8 mN\", or held approaches, \"3,8 um\"; "
    "for import, one for each data set, in order");
DEFINE_string(load_range, "-4,40", "smallest and largest normal load: \"0.5, 10 mN\", or dimensionless");
DEFINE_string(points, "201",
              "number of points of a curve, evenly spaced in phi; for design and simulate, points of a run, at equal "
              "steps of T from 0 (default there 25)");
DEFINE_string(
    law, "",
    "a law of your own: \"mine: 1 + (1-l)*tan(psi)^2; l=0..1\", in terms of psi, B = sin^2 psi, t = tan psi, or an "
    "equation in K_I and K_II; to define several, separate them by | or repeat the flag");
DEFINE_string(laws, "", "a TOML file of laws, in the form of data/laws.toml");

namespace mixity::cli {
namespace {

constexpr char kNextLaw = '\x1f';  // separates the values of a repeated --law

/// The storage of a flag defined from a table: gflags keeps pointers into it.
struct TableFlag {
  std::string name, help, text, initial;
  bool on, initially_on;
};

void define(const std::string& name, const std::string& help, const std::string& initial, bool is_switch) {
  static std::deque<TableFlag>& flags = *new std::deque<TableFlag>;  // never destroyed
  flags.push_back({name, help, initial, initial, initial == "true", initial == "true"});
  TableFlag& flag = flags.back();
  if (is_switch)
    gflags::FlagRegisterer(flag.name.c_str(), flag.help.c_str(), __FILE__, &flag.on, &flag.initially_on);
  else
    gflags::FlagRegisterer(flag.name.c_str(), flag.help.c_str(), __FILE__, &flag.text, &flag.initial);
}

std::string given_command;  // NOLINT(cert-err58-cpp): an empty string does not throw

std::vector<std::string>& keys_of_laws() {
  static std::vector<std::string> keys;
  return keys;
}

/// Quotes a word for a shell if necessary.
std::string shell_word(const std::string& word) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./=,:%+@";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

/// Adds the flags that were given: those about the experiment, or those about reading a file.
void add_set(bool of_experiment, Overrides& overrides, std::span<const std::string_view> except = {}) {
  for (const MetadataField& field : metadata_fields()) {
    if (field.of_experiment != of_experiment || !is_set(field.name)) continue;
    if (std::find(except.begin(), except.end(), field.name) != except.end()) continue;
    const std::string value = value_of(field.name);
    if (const std::string problem = problem_of_constant(field.name, value); !problem.empty())
      throw refused(field.name, problem);
    overrides.emplace_back(field.name, value);
  }
}

/// The flag of the command that was meant. A flag of another command is probably not misspelt, so that only the nearest
/// counts: --models for --model, but not --modulus for --models.
std::string meant_flag(const std::string& name, const Command& command) {
  const bool of_another = std::any_of(commands().begin(), commands().end(), [&](const Command& other) {
    return std::find(other.flags.begin(), other.flags.end(), name) != other.flags.end();
  });
  const auto nearest = nearest_name(name, {command.flags.begin(), command.flags.end()}, of_another ? 1 : 3);
  return nearest ? ": did you mean --" + *nearest + "?" : "";
}

}  // namespace

const std::string& command_line() { return given_command; }

void define_flags_of_tables() {
  for (const Setting& one : settings()) define(one.name, one.help, one.initial(), one.is_switch);
  for (const MetadataField& one : metadata_fields())
    if (one.name != "load") define(std::string(one.name), std::string(one.help), "", false);
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
      throw UsageError("unknown flag '" + word.substr(0, equals) + "'" + meant_flag(name, command) +
                       " (see mixity help " + std::string(command.name) + ")");
    gflags::CommandLineFlagInfo info;
    gflags::GetCommandLineFlagInfo(name.c_str(), &info);
    if (info.type == "bool" && equals == std::string::npos) {
      gflags::SetCommandLineOption(name.c_str(), "true");
      continue;
    }
    if (equals == std::string::npos && (i + 1 == words.size() || words[i + 1].starts_with("--")))
      throw UsageError("flag '" + word + "' needs a value");
    std::string value = equals == std::string::npos ? words[++i] : word.substr(equals + 1);
    // probably from an unset variable in a script
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

std::string formats_text(const Command& command) { return alternatives(command.formats); }

Overrides data_overrides(std::span<const std::string_view> except) {
  Overrides overrides = metadata_overrides(except);
  add_set(false, overrides, except);
  return overrides;
}

Overrides metadata_overrides(std::span<const std::string_view> except) {
  Overrides overrides;
  add_set(true, overrides, except);
  if (is_set("modulus") && is_set("youngs_modulus"))
    throw UsageError("flags '--modulus' and '--youngs_modulus': give one of them");
  return overrides;
}

void require_model(const std::string& flag, const std::string& key) {
  provide_law(key);
  if (is_model(key)) return;
  throw refused(flag, (key.empty() ? "no model" : "unknown model '" + key + "'") + known_names(key, known_models()));
}

void define_laws_of_flags() {
  const auto add = [](const DefinedLaw& defined) {
    const std::string& key = defined.law->definition().key;
    keys_of_laws().push_back(key);
    for (const std::string& warning : defined.warnings) warn("law " + key + ": " + warning);
  };
  const std::string& all = FLAGS_law;
  for (std::size_t line = 0, end; line < all.size(); line = end + 1) {
    end = std::min(all.find(kNextLaw, line), all.size());
    for (std::size_t at = line, next; at < end; at = next + 1) {
      next = std::min(all.find('|', at), end);
      // padded, so that columns in messages count from the beginning of the flag's value
      add(define_law_text("--law", std::string(at - line, ' ') + all.substr(at, next - at)));
    }
  }
  if (FLAGS_laws.empty()) return;
  for (const DefinedLaw& one : define_laws(FLAGS_laws, read_toml(FLAGS_laws, inputs_of_laws()))) add(one);
}

const std::vector<std::string>& laws_of_flags() { return keys_of_laws(); }

Inputs& inputs_of_laws() {
  static Inputs inputs;
  return inputs;
}

const std::string& path_to_save() {
  if (!FLAGS_save.ends_with(".toml")) throw must("save", "end in .toml");
  return FLAGS_save;
}

void write_outputs(std::vector<OutputFile> files, OutputRules rules) {
  rules.force = FLAGS_force;
  const std::vector<std::string> former = keep_former(files);
  write_files(files, rules);
  for (const std::string& kept : former) warn("the previous file was saved as " + kept);
}

void print_or_write(const std::string& text) {
  if (FLAGS_out.empty())
    std::cout << text;
  else
    write_outputs({{FLAGS_out, text}});
}

}  // namespace mixity::cli
