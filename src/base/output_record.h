// A record of the files that this program has written to a folder, in a hidden file there.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace mixity {

/// A name in one line of a hidden file, with backslashes and line feeds as \\\\ and \\n, and back.
std::string in_one_line(const std::string& name);
std::string name_in(std::string_view line);

/// Names and hashes (content_hash.h) of the files written to one folder. A file that is not listed is not from this
/// program; one with another hash was edited since.
class OutputRecord {
 public:
  static constexpr const char* kName = ".mixity-files";

  /// The record of a folder; empty if it has none.
  static OutputRecord of(const std::filesystem::path& folder);

  bool knows(const std::string& name) const { return hashes_.count(name) > 0; }
  /// Whether this program wrote this content under this name.
  bool wrote(const std::string& name, const std::string& hash) const;
  std::vector<std::string> names() const;

  /// Keeps the previous hash, too: if the program is killed between two renames, the former file remains.
  void add(const std::string& name, const std::string& hash);
  /// Forgets files that are no longer there.
  void forget_missing(const std::filesystem::path& folder);

  /// One line per hash: the hash, two blanks, the name in one line.
  std::string text() const;

 private:
  std::map<std::string, std::vector<std::string>> hashes_;  // per name, the newest last
};

}  // namespace mixity
