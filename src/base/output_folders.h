// Folders that a run writes to: locked, cleared of temporary files of killed programs, with the record of files
// written.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "base/output_record.h"

namespace mixity {

/// The name of a file while it is being written: NAME.mixity-tmp and 8 random letters.
std::string temporary_name(const std::string& path);

/// The name that a temporary file is to take; empty if the file is none.
std::string name_of_temporary(const std::string& temporary);

/// Locks existing folders against other programs that write to them, on any host: a lock belongs to the folder itself,
/// not to a process number, which programs in two containers may share. All programs lock folders in the same order, so
/// that two never wait for each other.
class FolderLocks {
 public:
  using Key = std::pair<dev_t, ino_t>;
  /// Throws OutputError if another program holds one of the locks for a minute.
  explicit FolderLocks(const std::set<std::filesystem::path>& folders);
  FolderLocks(FolderLocks&& other) noexcept : files_(std::exchange(other.files_, {})) {}
  FolderLocks& operator=(FolderLocks&&) = delete;
  ~FolderLocks();

  bool has(const Key& folder) const { return files_.count(folder) > 0; }
  /// False if the file system has no locks.
  bool has_all() const { return has_all_; }

 private:
  std::map<Key, int> files_;  // descriptors of what is locked
  bool has_all_ = true;
};

/// The folders that a run writes to.
class OutputFolders {
 public:
  struct Folder {
    std::filesystem::path path;
    OutputRecord record{};
  };

  /// Completes runs that were killed in these folders (unfinished_run.h) and locks them. Temporary files in a locked
  /// folder are left from killed programs and are removed. Throws OutputError as FolderLocks does.
  explicit OutputFolders(const std::set<std::filesystem::path>& folders);

  /// One of these folders, under any name.
  Folder& at(const std::filesystem::path& folder);

  auto begin() { return folders_.begin(); }
  auto end() { return folders_.end(); }

 private:
  FolderLocks locks_;
  std::map<FolderLocks::Key, Folder> folders_;
};

}  // namespace mixity
