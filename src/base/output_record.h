// What this program has written into a folder, in a hidden file of that folder.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace mixity {

/// Names and hashes (content_hash.h) of the files that were written into one folder. A file that is not there was
/// written by somebody else; one of another hash was edited since.
class OutputRecord {
 public:
  static constexpr const char* kName = ".mixity-files";

  /// Of a folder; empty if it has none.
  static OutputRecord of(const std::filesystem::path& folder);

  bool knows(const std::string& name) const { return hashes_.count(name) > 0; }
  /// Whether this program wrote this content under this name.
  bool wrote(const std::string& name, const std::string& hash) const;
  std::vector<std::string> names() const;

  /// Keeps the last hash, too: a program that is killed between two renames leaves the former file.
  void add(const std::string& name, const std::string& hash);
  /// Forgets files that are no longer there.
  void forget_missing(const std::filesystem::path& folder);

  /// A line for each hash: the hash, two blanks, the name with backslashes and line feeds as \\\\ and \\n.
  std::string text() const;

 private:
  std::map<std::string, std::vector<std::string>> hashes_;  // of each name, the newest last
};

}  // namespace mixity
