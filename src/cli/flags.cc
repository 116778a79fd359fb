#include "cli/flags.h"

#include <algorithm>
#include <array>

#include "analysis/laws.h"
#include "base/number_text.h"
#include "base/units.h"
#include "cli/usage_error.h"
#include "fitting/fit.h"

DEFINE_string(models, "a,b,c", "models to fit, comma-separated (mixity help lists them)");
DEFINE_string(
    objective, "",
    "what is fitted: curve (distance from the curve in T and A; the default where there are loads) or toughness "
    "(Gc/GIc against psi, as the paper does)");
DEFINE_bool(weighted, false, "objective toughness: weight each point by its standard error");
DEFINE_string(sigma_T, "", "standard error of T for all points: \"0.5%\", or \"0.2 mN\"");
DEFINE_string(sigma_A, "", "standard error of A for all points: \"1%\", or \"0.002 mm^2\"");
DEFINE_string(loss, "none", "none, or a loss that outliers move less: huber or cauchy");
DEFINE_string(loss_scale, "", "where the loss begins to bend, in standard errors (default 1.345 huber, 2.385 cauchy)");
DEFINE_string(free, "",
              "fit these, too, for all loads together: toughness, modulus, radius, area_scale, load_offset, "
              "shear_offset, area_offset");
DEFINE_string(exclude, "", "lines of the data file to leave out: \"17,40-58\"");
DEFINE_string(leave_out, "", "runs to leave out, by name or load: \"4.68 mN\"");
DEFINE_bool(checks, true, "tests of consistency and evidence; without them no fit is called suspect");
DEFINE_string(interval, "profile", "confidence intervals: profile or none");
DEFINE_int32(bootstrap, 0, "refits of resampled points for bootstrap intervals");
DEFINE_string(resample, "points", "what the bootstrap draws: points within their runs, or whole runs (curves)");
DEFINE_int32(seed, 1, "seed of the bootstrap");
DEFINE_int32(threads, 0, "threads for bootstrap and influence (0: as many as the machine has)");
DEFINE_bool(influence, false, "how much each point and each run moves the fit: jackknife, leverage, Cook's distance");
DEFINE_bool(compare, true, "compare the models: AICc, weights, error on loads left out of the fit");
DEFINE_string(per, "", "curve: fit each loading run by itself, too, and test one value against many");
DEFINE_string(lambda_prior, "uniform", "prior of lambda for evidence and credible interval: uniform or log_uniform");
DEFINE_string(confidence, "0.95", "confidence of intervals, above 0 and below 1");
DEFINE_string(scale, "log", "toughness is compared as ln(Gc/GIc) (log) or as Gc/GIc (linear)");
DEFINE_string(hold, "", "parameters to hold, comma-separated: NAME=VALUE, or NAME for the data set's own value");
DEFINE_string(format, "text", "output format");
DEFINE_string(out, "", "where to write: a folder (fit, figures), a file (import)");
DEFINE_string(
    lag, "", "what the clock of the areas is ahead of that of the forces: \"0.12 s\"; else from events that both show");
DEFINE_bool(drift, false, "take a line through the zeros of T of all runs off T; left out, where it is sure");
DEFINE_string(cuts, "", "a TOML that states cuts of runs (cuts.toml, which runs writes)");
DEFINE_string(
    law, "",
    "a law of one's own: \"mine: 1 + (1-l)*tan(psi)^2; l=0..1\", of psi, B = sin^2 psi, t = tan psi, or an equation "
    "in K_I and K_II; several are parted by |, or the flag is given again");
DEFINE_string(laws, "", "a TOML of laws in the form of data/laws.toml");
DEFINE_string(axis, "", "the parameter that the map is over beside the load; empty: the model's first");
DEFINE_bool(pool, false, "the files are the runs of one data set");
DEFINE_string(reach, "0.9", "the longest T of a run, as a share of that at which the contact jumps");
DEFINE_string(runs, "", "how many more runs to find the best loads for");
DEFINE_string(goal, "error", "what these are to serve: error (of lambda) or model (telling models apart)");
DEFINE_string(wanted, "",
              "an error of lambda, 2% or 0.0001: how many runs it takes, and how many 95% odds between models");
DEFINE_string(experiments, "", "so many experiments are simulated and fitted, as a check of what is expected");
DEFINE_string(index, "0", "number of the experiment in the stream of the seed");
DEFINE_string(shard, "",
              "fit a part of the files only: i/n, every n-th from the i-th on (mixity merge puts parts together)");
DEFINE_string(save, "", "write what was just run to this fit definition (TOML)");
DEFINE_string(model, "", "model (mixity help lists them)");
DEFINE_string(lambda, "", "mode-mixity parameter lambda");
DEFINE_string(parameters, "", "all parameters of the model, such as r=1.77,eta=2.28");
DEFINE_string(
    load, "",
    "normal load P, compression positive: a number, or with a unit if dimensional; of a data file without one");
DEFINE_string(shear, "", "tangential loads T: \"0,5,10\", or \"0,5,10 mN\" if dimensional");
DEFINE_string(units, "mN,mm", "force and length unit of dimensional output, and of numbers without a unit");
DEFINE_string(x, "", "header of the column on the x axis, with its unit: \"T [mN]\"");
DEFINE_string(y, "", "header of the column on the y axis, with its unit: \"A [mm^2]\"");
DEFINE_string(loads, "", "normal load of each data set, in order: \"7.7,3.8 mN\"");

DEFINE_int32(points, 201, "number of points, uniform in phi; of a planned run, from T = 0 at even steps (there 25)");
DEFINE_string(
    chord, "",
    "instead of --points: as few points as keep straight lines within this fraction of the ranges of T and A");
DEFINE_string(stiffness, "",
              "stiffness k of the loading apparatus, such as \"1200 N/m\", or dimensionless; adds the folds it sees");
DEFINE_string(tau0, "",
              "shear strength of the interface, such as \"0.43 MPa\", or dimensionless (tau0 xi/E*): sliding at T = "
              "tau0 A competes");
DEFINE_string(load_range, "-4,40", "smallest and largest normal load: \"0.5, 10 mN\", or dimensionless");
DEFINE_string(lambda_range, "0,1", "smallest and largest lambda of the map");
DEFINE_int32(grid, 41, "points of the map along each axis");
DEFINE_bool(boundaries, false, "print the exact boundaries between regimes instead of the grid");
DEFINE_bool(paper, false, "the figures of Papangelo & Ciavarella (2019)");
DEFINE_string(upto, "0.5", "use points up to this fraction of the largest T of each run");

DEFINE_string(radius, "", "radius of the sphere, such as \"9.42 mm\"");
DEFINE_string(modulus, "", "plane-strain modulus E*, such as \"2.133 MPa\"");
DEFINE_string(youngs_modulus, "", "Young's modulus of the soft half-space; needs poisson_ratio");
DEFINE_string(poisson_ratio, "", "Poisson's ratio of the soft half-space, 0..0.5");
DEFINE_string(toughness, "", "mode-I toughness G_Ic, such as \"27 mJ/m^2\"");
DEFINE_string(toughness_II, "", "mode-II toughness G_IIc, such as \"1.7 N/mm\"");
DEFINE_string(shear_strength, "", "shear strength tau0 of the interface, such as \"0.43 MPa\"");
DEFINE_string(provenance, "", "measured, digitised or reconstructed");
DEFINE_string(load_offset, "", "to be added to readings of P, such as \"0 +/- 0.5 mN\"");
DEFINE_string(shear_offset, "", "to be added to readings of T, such as \"0 +/- 0.5 mN\"");
DEFINE_string(area_offset, "", "to be added to readings of A, such as \"0 +/- 0.01 mm^2\"");
DEFINE_string(area_scale, "", "what readings of A are to be multiplied by, such as \"1 +/- 2%\"");
DEFINE_string(columns, "", "which column is which: \"P=Kanal 3 (mN),T=Kanal 4 (N)\", by heading or number");
DEFINE_string(headings, "", "a TOML that adds to the names of columns that are known (data/headings.toml)");
DEFINE_string(decimal, "", "the decimal sign, where a file can be read in two ways: , or .");
DEFINE_string(pixel, "", "the side of a camera's pixel, for areas in pixels: \"1.7 um\"");
DEFINE_string(load_from, "", "where a file's name states the normal load: \"run_{P}mN\"");
DEFINE_string(source, "", "where the data come from");
DEFINE_string(note, "", "a note on the data");

namespace mixity::cli {
namespace {

constexpr std::array<std::string_view, 14> kMetadataFlags{
    "radius",      "modulus",      "youngs_modulus", "poisson_ratio", "toughness",  "toughness_II", "shear_strength",
    "load_offset", "shear_offset", "area_offset",    "area_scale",    "provenance", "source",       "note"};

/// How a data file is to be read.
constexpr std::array<std::string_view, 6> kReadingFlags{"columns", "headings", "decimal", "pixel", "load", "load_from"};

std::string given_command;  // NOLINT(cert-err58-cpp): an empty string does not throw

/// As a shell reads it as one word.
std::string shell_word(const std::string& word) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./=,:%+@";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace

const std::string& command_line() { return given_command; }

std::vector<std::string_view> with_metadata_flags(std::vector<std::string_view> flags) {
  flags.insert(flags.end(), kMetadataFlags.begin(), kMetadataFlags.end());
  flags.insert(flags.end(), kReadingFlags.begin(), kReadingFlags.end());
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
    // most often a variable of a script that is not set
    if (value.empty()) throw UsageError("flag '--" + name + "' needs a value");
    if (name == "law" && !FLAGS_law.empty()) value = FLAGS_law + kNextLaw + value;
    if (gflags::SetCommandLineOption(name.c_str(), value.c_str()).empty())
      throw UsageError("flag '--" + name + "' cannot take the value '" + value + "'");
  }
  const auto& formats = command.formats;
  if (!formats.empty() && std::find(formats.begin(), formats.end(), FLAGS_format) == formats.end())
    throw UsageError("flag '--format' is '" + FLAGS_format + "'; it must be " + formats_text(command));
  return arguments;
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

namespace {

template <std::size_t n>
void add_set(const std::array<std::string_view, n>& flags, Overrides& overrides) {
  Metadata scratch;
  for (const std::string_view flag : flags) {
    if (!is_set(flag)) continue;
    const std::string value = value_of(flag);
    const std::string problem = set_field(scratch, flag, value);
    if (!problem.empty()) throw UsageError("flag '--" + std::string(flag) + "': " + problem);
    overrides.emplace_back(flag, value);
  }
}

}  // namespace

Overrides data_overrides() {
  Overrides overrides = metadata_overrides();
  add_set(kReadingFlags, overrides);
  return overrides;
}

Overrides metadata_overrides() {
  Overrides overrides;
  add_set(kMetadataFlags, overrides);
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

double number_from(const std::string& flag, const std::string& text, double low, double high) {
  const auto value = parse_number(text);
  if (!value || !(*value >= low && *value <= high))
    throw UsageError("flag '--" + flag + "' is '" + text + "'; it must be a number from " + shortest(low) + " to " +
                     shortest(high));
  return *value;
}

std::vector<std::string> split_list(const std::string& flag, std::string_view text) {
  std::vector<std::string> items;
  for (bool more = !text.empty(); more;) {
    const std::size_t comma = text.find(',');
    const std::string_view item = trim(text.substr(0, comma));
    if (item.empty())
      throw UsageError("flag '--" + flag + "': entry " + std::to_string(items.size() + 1) + " is empty");
    items.emplace_back(item);
    more = comma != std::string_view::npos;
    if (more) text.remove_prefix(comma + 1);
  }
  return items;
}

}  // namespace mixity::cli
