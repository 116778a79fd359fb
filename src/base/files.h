// Whole files: read at once, and written so that each is there completely or not at all.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace mixity {

/// The most bytes that are held at once: of a file that is read whole, or of one row of a table.
inline constexpr std::size_t kMostText = std::size_t{1} << 28;

/// The file's bytes. Throws InputError if it cannot be read or holds more than kMostText bytes.
std::string read_file(const std::string& path);

/// A file that could not be written; what() reads "path: reason".
class OutputError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file name without a special meaning for the system, a shell or gnuplot: letters, digits, blanks and "._-+=,()"
/// stay, and the first character is a letter, a digit or '_'; all else becomes '_'.
std::string plain_file_name(std::string_view name);

struct OutputFile {
  std::string path, content;
};

/// Writes all of the files or none. Each is written to a temporary name in its folder and flushed to disk; when all are
/// there, they are renamed: a reader finds old files or new ones, and if one file cannot be written all old ones stay.
/// Pipes and devices are written before the renames, during which signals to end wait: only a kill (SIGKILL, a power
/// cut) between two renames leaves files of two runs side by side, each of them whole. Files keep their permissions,
/// links stay links. Creates missing folders, and removes temporary files that killed processes left of these. Throws
/// OutputError, with nothing left behind; so, too, if one of the files is, by whatever name, one of `inputs`, or if two
/// of them are one.
void write_files(const std::vector<OutputFile>& files, const std::vector<std::string>& inputs = {});
void write_file(const std::string& path, const std::string& content);

/// Adds NAME.old, with the present content, for each TOML file of these that would change: somebody may have edited it.
/// Returns the names.
std::vector<std::string> keep_former(std::vector<OutputFile>& files);

}  // namespace mixity
