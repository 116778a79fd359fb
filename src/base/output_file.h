// Files that are there whole or not at all.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace mixity {

/// A file that could not be written; what() reads "path: reason".
class OutputError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A name that is nothing but one, to the system, a shell and gnuplot: letters, digits, blanks and "._-+=,()" stay, and
/// a letter, digit or '_' comes first; all else becomes '_'.
std::string plain_file_name(std::string_view name);

struct OutputFile {
  std::string path, content;
};

/// Writes each to a temporary name in its folder and flushes it to disk; when all are there, renames them: whoever
/// looks sees old files or new ones, and a run that cannot write one of its files leaves all old ones in place. Pipes
/// and devices come before the renames, which signals to end wait for: only a kill (SIGKILL, a power cut) between two
/// renames leaves files of two runs side by side, each of them whole. A file keeps its permissions. Creates folders
/// that are missing, and removes the temporary names of these files whose process was killed. A link stays one; a pipe
/// or device is written to. Throws OutputError, with nothing left behind; so, too, if one of the files is, by whatever
/// name, one of `inputs`, or two of them are one.
void write_files(const std::vector<OutputFile>& files, const std::vector<std::string>& inputs = {});
/// Adds NAME.old with what a TOML of these holds now, where that differs: somebody may have edited it. Returns the
/// names.
std::vector<std::string> keep_former(std::vector<OutputFile>& files);
void write_file(const std::string& path, const std::string& content);

}  // namespace mixity
