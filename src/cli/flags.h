// Flags of all commands (gflags), and how a command line becomes flags and arguments.
#pragma once

#include <gflags/gflags.h>

#include <string_view>
#include <vector>

#include "cli/commands.h"
#include "dataset/metadata.h"

DECLARE_string(format);
DECLARE_string(out);
DECLARE_string(save);
DECLARE_string(shard);
DECLARE_string(reach);
DECLARE_string(runs);
DECLARE_string(goal);
DECLARE_string(wanted);
DECLARE_string(experiments);
DECLARE_string(models);
DECLARE_string(law);
DECLARE_string(laws);
DECLARE_string(axis);
DECLARE_bool(pool);
DECLARE_string(lag);
DECLARE_bool(drift);
DECLARE_string(cuts);
DECLARE_string(model);
DECLARE_string(lambda);
DECLARE_string(parameters);
DECLARE_string(load);
DECLARE_string(shear);
DECLARE_string(units);
DECLARE_string(x);
DECLARE_string(y);
DECLARE_string(loads);
DECLARE_int32(points);
DECLARE_string(chord);
DECLARE_string(stiffness);
DECLARE_string(tau0);
DECLARE_string(load_range);
DECLARE_string(lambda_range);
DECLARE_int32(grid);
DECLARE_bool(boundaries);
DECLARE_bool(paper);
DECLARE_string(upto);

namespace mixity::cli {

/// Stands in FLAGS_law between the values of --law, which may be given again.
inline constexpr char kNextLaw = '\x1f';

/// These flags and those that override the metadata of a data set.
std::vector<std::string_view> with_metadata_flags(std::vector<std::string_view> flags);

/// Sets gflags from "--name=value" or "--name value" and returns what is no flag; all after "--" is none. Throws
/// UsageError for a flag that the command does not have or that lacks a value, and for a format it cannot write.
Arguments parse_flags(const Command& command, const Arguments& words);

/// What its --format may be: "text, json or csv".
std::string formats_text(const Command& command);

/// The command as it was given, to be pasted into a shell.
const std::string& command_line();

bool is_set(std::string_view flag);
std::string value_of(std::string_view flag);

/// The metadata flags that were given, and those that say how a file is to be read; throws as metadata_overrides.
Overrides data_overrides();

/// The metadata flags that were given; throws UsageError if one cannot be used.
Overrides metadata_overrides();

/// Throws UsageError, naming the flag and the known models, unless there is a model with this key.
void require_model(const std::string& flag, const std::string& key);

/// Throws UsageError if a command that takes no files was given some.
void require_flags_only(const std::string& command, const Arguments& arguments);

/// A number from low to high, both included, from a flag's text; throws UsageError.
double number_from(const std::string& flag, const std::string& text, double low, double high = 1e150);

/// Comma-separated, without blanks around the items. Throws UsageError for an empty item: those after it would move up.
std::vector<std::string> split_list(const std::string& flag, std::string_view text);

}  // namespace mixity::cli
