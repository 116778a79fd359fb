// Flags (gflags): how a command line is parsed, and how values of flags are read.
#pragma once

#include <gflags/gflags.h>

#include <string_view>
#include <vector>

#include "analysis/request.h"
#include "cli/commands.h"
#include "dataset/metadata.h"

// Flags of several commands. Those of one command are defined in its file.
DECLARE_string(format);
DECLARE_string(out);
DECLARE_string(model);
DECLARE_int32(points);

namespace mixity::cli {

/// Separates the values of --law, which may be given more than once.
inline constexpr char kNextLaw = '\x1f';

/// Defines the flags of all options of fits (analysis/settings.h) and of metadata (dataset/metadata.h). To be called
/// once, before any other function.
void define_flags_of_tables();

/// Adds the flags of metadata.
std::vector<std::string_view> with_metadata_flags(std::vector<std::string_view> flags);

/// What --formats says. Throws UsageError.
FigureFormats figure_formats();

/// Sets flags from "--name=value" or "--name value", and returns the other words; all words after "--" are such. Throws
/// UsageError for an unknown flag, a missing value, or a format that the command does not have.
Arguments parse_flags(const Command& command, const Arguments& words);

/// Values of --format: "text, json or csv".
std::string formats_text(const Command& command);

/// The command line, quoted so that it can be pasted into a shell.
const std::string& command_line();

bool is_set(std::string_view flag);
std::string value_of(std::string_view flag);

/// The flags of metadata that were given. Throws UsageError if one cannot be used.
Overrides data_overrides();

/// The same without flags that say how a file is read.
Overrides metadata_overrides();

/// Throws UsageError for an unknown model.
void require_model(const std::string& flag, const std::string& key);

/// Throws UsageError if there are arguments.
void require_flags_only(const std::string& command, const Arguments& arguments);

// Values of flags, by the name of the flag.

/// The error "flag '--goal' is 'x'; it must be error or model", from "be error or model".
UsageError must(const std::string& flag, const std::string& be);

/// A number from low to high, both included. Throws UsageError.
double number_from(const std::string& flag, double low, double high = 1e150);

/// Comma-separated items, trimmed. Throws UsageError for an empty item.
std::vector<std::string> list_from(const std::string& flag);

}  // namespace mixity::cli
