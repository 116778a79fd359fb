// Folders that a run writes to: locked, cleared of what killed programs left, with the record of what was written
// there.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "base/output_record.h"

namespace mixity {

/// Name of a file while it is written: NAME.mixity-tmp and 8 letters drawn at random.
std::string temporary_name(const std::string& path);

/// Holds folders against other programs that write to them, wherever these run: a lock belongs to the folder itself,
/// not to a process number, which programs in two containers may share. Given up where the file system has none.
class OutputFolders {
 public:
  struct Folder {
    int file;  // its descriptor; -1 where it cannot be opened
    std::filesystem::path path;
    OutputRecord record{};
  };

  OutputFolders() = default;
  OutputFolders(const OutputFolders&) = delete;
  OutputFolders& operator=(const OutputFolders&) = delete;
  ~OutputFolders();

  /// Opens a folder that exists, at the first call. Once it is locked, temporary files in it are those of killed
  /// programs, and are removed. Throws OutputError if another program holds it for a minute.
  Folder& at(const std::filesystem::path& folder);

  auto begin() { return folders_.begin(); }
  auto end() { return folders_.end(); }

 private:
  std::map<std::pair<dev_t, ino_t>, Folder> folders_;
};

}  // namespace mixity
