// Whole files: read at once (files.cc), and written completely or not at all (write_files.cc).
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"

namespace mixity {

/// The size limit in bytes of a file read as a whole, and of one row of a table.
inline constexpr std::size_t kMostText = std::size_t{1} << 28;

/// The file's bytes. Throws InputError if it cannot be read or holds more than kMostText bytes.
std::string read_file(const std::string& path);

/// A file that could not be written, or must not be; the message reads "path: reason", what() in neutral words.
class OutputError : public std::runtime_error {
 public:
  explicit OutputError(const Message& message) : std::runtime_error(message.text()), message_(message) {}

  std::string text(Wording words) const { return message_.text(words); }

 private:
  Message message_;
};

/// A file name without special meaning to the system, a shell or gnuplot: keeps letters, digits, blanks and "._-+=,()",
/// and replaces all else, and a first character that is neither a letter nor a digit, by '_'.
std::string plain_file_name(std::string_view name);

/// The path of a file relative to the folder of `from`, a file that names it.
std::string relative_to(const std::string& from, const std::string& file);

/// The first path that names the same regular file as an earlier one, or is spelled alike; null if there is none.
std::optional<std::string> named_twice(const std::vector<std::string>& paths);

struct OutputFile {
  std::string path, content;
};

struct OutputRules {
  std::vector<std::string> inputs{};   // never overwritten, under any name; nor are files_remembered()
  bool force = false;                  // also replace files that this program did not write, or that were edited since
  std::vector<std::string> renewed{};  // folders: files of earlier runs that this run does not write are removed
};

/// Writes all of the files or none. Each is written under a temporary name in its folder and flushed to disk; then all
/// are renamed. If one file cannot be written, all old ones remain. Pipes and devices are written before the renames.
/// Signals that end the process wait for the renames. After SIGKILL between two renames, files of two runs stand side
/// by side, each of them complete, until this program next reads or writes in one of the folders: it then completes the
/// run first (unfinished_run.h). Files keep their permissions, and links remain links. Creates missing folders, and
/// removes temporary files of killed processes from those that it can lock. Waits up to a minute for folders that
/// another program is writing to.
///
/// The record of each folder (output_record.h) lists what this program wrote. Another file is replaced only if it is
/// empty or the same, or if its edited version is kept under another name (keep_former). Throws OutputError, and leaves
/// nothing behind, for any other file, if one of the files is an input, and if two are the same.
void write_files(const std::vector<OutputFile>& files, const OutputRules& rules = {});

/// Writes a file in a temporary folder. Throws OutputError.
void write_scratch_file(const std::string& path, const std::string& content);

/// Adds NAME.old, with the present content, for each TOML file that would change, since a user may have edited it;
/// NAME.old.2 and so on if those names exist. Returns the names.
std::vector<std::string> keep_former(std::vector<OutputFile>& files);

}  // namespace mixity
