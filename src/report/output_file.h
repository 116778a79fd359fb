// Files that are there whole or not at all.
#pragma once

#include <stdexcept>
#include <string>

namespace mixity {

/// A file that could not be written; what() reads "path: reason".
class OutputError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Writes to a temporary name in the same folder, flushes to disk and renames: whoever looks sees the old file or the
/// new one. Creates the folder if it is missing, and removes the temporary names of this file whose process was killed.
/// Throws OutputError; then nothing is left behind.
void write_file(const std::string& path, const std::string& content);

}  // namespace mixity
