// Folders that a run writes to: locked, cleared of temporary files of killed programs, with the record of files
// written.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "base/output_record.h"

namespace mixity {

/// The name of a file while it is being written: NAME.mixity-tmp and 8 random letters.
std::string temporary_name(const std::string& path);

/// Locks folders against other programs that write to them, on any host: a lock belongs to the folder itself, not to a
/// process number, which programs in two containers may share. No lock where the file system has none.
class OutputFolders {
 public:
  struct Folder {
    int file;  // file descriptor; -1 if it cannot be opened
    std::filesystem::path path;
    OutputRecord record{};
  };

  OutputFolders() = default;
  OutputFolders(const OutputFolders&) = delete;
  OutputFolders& operator=(const OutputFolders&) = delete;
  ~OutputFolders();

  /// Opens and locks an existing folder at the first call. Temporary files in a locked folder are left from killed
  /// programs and are removed. Throws OutputError if another program holds the lock for a minute.
  Folder& at(const std::filesystem::path& folder);

  auto begin() { return folders_.begin(); }
  auto end() { return folders_.end(); }

 private:
  std::map<std::pair<dev_t, ino_t>, Folder> folders_;
};

}  // namespace mixity
