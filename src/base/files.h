// Whole files: read at once, and written completely or not at all.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace mixity {

/// Limit in bytes of a file that is read whole, and of one row of a table.
inline constexpr std::size_t kMostText = std::size_t{1} << 28;

/// The file's bytes. Throws InputError if it cannot be read or holds more than kMostText bytes.
std::string read_file(const std::string& path);

/// A file that could not be written; what() reads "path: reason".
class OutputError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file name without a special meaning for the system, a shell or gnuplot: keeps letters, digits, blanks and
/// "._-+=,()", and replaces the rest by '_', as well as a first character that is neither a letter nor a digit.
std::string plain_file_name(std::string_view name);

struct OutputFile {
  std::string path, content;
};

/// Writes all of the files or none. Each is written under a temporary name in its folder and flushed to disk; then all
/// are renamed. A reader finds old files or new ones, and if one file cannot be written, all old ones stay. Pipes and
/// devices are written before the renames. Signals that end the process wait for the renames; only SIGKILL or a power
/// cut between two renames leaves files of two runs side by side, each of them whole. Files keep their permissions,
/// links stay links. Creates missing folders, and removes temporary files of killed processes from those that it can
/// lock. Waits for other programs that write to the same folders, up to a minute each. Throws OutputError, and leaves
/// nothing behind, also if one of the files is one of `inputs` under any name, or if two of them are the same.
void write_files(const std::vector<OutputFile>& files, const std::vector<std::string>& inputs = {});
void write_file(const std::string& path, const std::string& content);

/// Adds NAME.old, with the present content, for each TOML file that would change, as a user may have edited it;
/// NAME.old.2 and so on where others have these names. Returns the names.
std::vector<std::string> keep_former(std::vector<OutputFile>& files);

}  // namespace mixity
