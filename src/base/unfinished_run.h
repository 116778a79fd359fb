// Runs that were killed while their files took their names: the next program that reads or writes there completes them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/files.h"

namespace mixity {

inline constexpr const char* kUnfinishedName = ".mixity-unfinished";

/// What a run does to the files of one folder at its end.
struct FolderChanges {
  struct Change {
    std::string name;    // of the temporary file, or of the file to be removed
    std::string before;  // hash of the file that is replaced or removed; empty if there is none
  };
  std::filesystem::path folder;
  std::vector<Change> renamed, removed;
};

/// A hidden file for each of the folders, in their order, which says what the run does there. Before the first one has
/// its name, the run has done nothing; from then on it is to be completed. It is put in place last and removed last.
std::vector<OutputFile> unfinished_files(const std::vector<FolderChanges>& changes);

bool has_unfinished_run(const std::filesystem::path& folder);

/// Completes a run that was killed after its first hidden file had its name, in all of its folders, and waits for one
/// that is at work. Files that were changed since it was killed are left as they are. Hidden files that do not belong
/// to such a run are removed. Changes only files in the folders of hidden files that name the same run. Does nothing
/// where the file system has no locks. Throws OutputError if it has no right to.
void complete_unfinished_run(const std::filesystem::path& folder);

}  // namespace mixity
