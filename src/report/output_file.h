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

/// Writes to a temporary name in the same folder, flushes to disk and renames: whoever looks sees the old file or the
/// new one. Creates the folder if it is missing, and removes the temporary names of this file whose process was killed.
/// A link stays one; a pipe or device is written to.
/// Throws OutputError; then nothing is left behind.
void write_file(const std::string& path, const std::string& content);

/// Throws OutputError if one of the files that are to be written is, by whatever name, one of those that were read.
void spare_inputs(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs);

}  // namespace mixity
