// Flags (gflags): parsing of a command line, and flags that several commands share.
#pragma once

#include <gflags/gflags.h>

#include <span>
#include <string>
#include <vector>

#include "analysis/request.h"
#include "base/files.h"
#include "cli/flag_values.h"
#include "dataset/metadata.h"

// Flags of several commands. Those of a single command are defined in its file.
DECLARE_string(format);
DECLARE_string(out);
DECLARE_string(save);
DECLARE_bool(force);
DECLARE_string(model);

namespace mixity::cli {

/// Defines a flag for each option of fits (analysis/settings.h) and each metadata field (dataset/metadata.h). Must be
/// called once, before any other function.
void define_flags_of_tables();

/// Sets flags from "--name=value" or "--name value", and returns the other words and everything after "--". Throws
/// UsageError for an unknown flag, a missing value, or a format that the command lacks.
Arguments parse_flags(const Command& command, const Arguments& words);

/// Values of --format: "text, json or csv".
std::string formats_text(const Command& command);

/// The command line, quoted so that it can be pasted into a shell.
const std::string& command_line();

/// The value of --formats. Throws UsageError.
FigureFormats figure_formats();

/// The metadata flags that were given. Throws UsageError if one is unusable.
Overrides data_overrides(std::span<const std::string_view> except = {});

/// The same without flags about reading the file, and without those in `except`.
Overrides metadata_overrides(std::span<const std::string_view> except = {});

/// Throws UsageError for an unknown model.
void require_model(const std::string& flag, const std::string& key);

/// Defines the laws of --law and --laws as models, and prints warnings about them. Throws InputError.
void define_laws_of_flags();

/// Keys of the laws of --law and --laws.
const std::vector<std::string>& laws_of_flags();
/// Contains the file --laws, once it was read.
Inputs& inputs_of_laws();

/// Writes all of the files or none (base/files.h). Refuses to overwrite a file that was read or, without --force, one
/// that this program did not write. Keeps each TOML file that changes as NAME.old, and says so.
void write_outputs(std::vector<OutputFile> files, OutputRules rules = {});
/// The value of --save. Throws UsageError if it does not end in .toml.
const std::string& path_to_save();

/// Writes a text to the file --out; without --out prints it.
void print_or_write(const std::string& text);

}  // namespace mixity::cli
