#include "base/unfinished_run.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "base/content_hash.h"
#include "base/output_folders.h"

namespace mixity {
namespace {

namespace fs = std::filesystem;

constexpr const char* kName = kUnfinishedName;

// What the lines of a hidden file begin with.
constexpr std::string_view kRun = "run ", kFirst = "first ", kWith = "with ", kRename = "rename ", kRemove = "remove ";

struct HiddenFile {
  std::string run;
  FolderChanges changes;
  fs::path first;               // the folder whose hidden file decides
  std::vector<fs::path> other;  // all other folders, stated by the first
};

std::string line_of(std::string_view kind, const FolderChanges::Change& change) {
  return std::string(kind) + (change.before.empty() ? "-" : change.before) + " " + in_one_line(change.name) + "\n";
}

/// Null if there is none, or something that this program did not write.
std::optional<HiddenFile> hidden_file_of(const fs::path& folder) {
  std::error_code none;
  if (fs::symlink_status(folder / kName, none).type() != fs::file_type::regular) return std::nullopt;
  HiddenFile hidden;
  hidden.changes.folder = folder;
  const auto beside = [&](std::string_view path) { return fs::weakly_canonical(folder / name_in(path), none); };
  std::ifstream file(folder / kName, std::ios::binary);
  for (std::string line; std::getline(file, line);) {
    std::string_view rest = line;
    const auto is = [&](std::string_view kind) {
      if (!rest.starts_with(kind)) return false;
      rest.remove_prefix(kind.size());
      return true;
    };
    const auto change = [&]() -> FolderChanges::Change {
      const std::size_t blank = std::min(rest.find(' '), rest.size());
      const std::string_view hash = rest.substr(0, blank);
      return {name_in(rest.substr(std::min(blank + 1, rest.size()))), std::string(hash == "-" ? "" : hash)};
    };
    if (is(kRun))
      hidden.run = rest;
    else if (is(kFirst))
      hidden.first = beside(rest);
    else if (is(kWith))
      hidden.other.push_back(beside(rest));
    else if (is(kRename))
      hidden.changes.renamed.push_back(change());
    else if (is(kRemove))
      hidden.changes.removed.push_back(change());
  }
  for (const auto* list : {&hidden.changes.renamed, &hidden.changes.removed})
    for (const FolderChanges::Change& one : *list)
      if (one.name.find('/') != std::string::npos) return std::nullopt;
  return hidden;
}

std::string present_hash(const fs::path& file) {
  std::error_code none;
  return fs::symlink_status(file, none).type() == fs::file_type::regular ? file_hash(file.string()) : std::string();
}

/// Without the right to complete a run, its files cannot be read as those of one run.
void check(int result, const fs::path& path) {
  if (result != 0 && (errno == EACCES || errno == EPERM || errno == EROFS))
    throw OutputError(path.string() + ": a run was killed while it wrote to this folder, and it cannot be completed: " +
                      std::strerror(errno));
}

void carry_out(const FolderChanges& changes) {
  for (const auto& [temporary, before] : changes.renamed) {
    const fs::path from = changes.folder / temporary, to = changes.folder / name_of_temporary(temporary);
    if (to.filename().empty()) continue;
    const bool unchanged = present_hash(to) == before;
    check(unchanged ? ::rename(from.c_str(), to.c_str()) : 0, changes.folder);
    check(::unlink(from.c_str()), changes.folder);  // if it was not renamed
  }
  for (const auto& [name, before] : changes.removed)
    if (const fs::path file = changes.folder / name; !before.empty() && present_hash(file) == before)
      check(::unlink(file.c_str()), changes.folder);
}

void remove_hidden_file(const fs::path& folder) {
  const fs::path file = folder / kName;
  if (::unlink(file.c_str()) == 0 || errno == ENOENT) return;
  check(-1, folder);
  throw OutputError(file.string() + ": is no file, as that of a run that was killed is: remove it");
}

/// All folders of the run that is unfinished in one of them, the first of them first; that one alone if the run has
/// done nothing.
std::vector<fs::path> folders_of_run(const fs::path& folder) {
  const auto own = hidden_file_of(folder);
  const auto first = own ? hidden_file_of(own->first) : std::nullopt;
  if (!first || first->run != own->run || first->first != own->first) return {folder};
  std::vector<fs::path> folders{own->first};
  std::error_code none;
  for (const fs::path& other : first->other)
    if (fs::exists(other / kName, none)) folders.push_back(other);
  return folders;
}

}  // namespace

std::vector<OutputFile> unfinished_files(const std::vector<FolderChanges>& changes) {
  std::vector<OutputFile> files;
  std::vector<fs::path> folders;
  for (const FolderChanges& one : changes) folders.push_back(fs::canonical(one.folder));
  const std::string run = temporary_name("");  // random
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const auto seen_from_here = [&](const fs::path& other) {
      return in_one_line(other.lexically_relative(folders[i]).string()) + "\n";
    };
    std::string text = std::string(kRun) + run + "\n" + std::string(kFirst) + seen_from_here(folders[0]);
    for (std::size_t k = 1; i == 0 && k < changes.size(); ++k) text += std::string(kWith) + seen_from_here(folders[k]);
    for (const FolderChanges::Change& one : changes[i].renamed) text += line_of(kRename, one);
    for (const FolderChanges::Change& one : changes[i].removed) text += line_of(kRemove, one);
    files.push_back({(changes[i].folder / kName).string(), std::move(text)});
  }
  return files;
}

bool has_unfinished_run(const fs::path& folder) {
  std::error_code none;
  return fs::exists(fs::symlink_status(folder / kName, none));
}

void complete_unfinished_run(const fs::path& folder) {
  while (has_unfinished_run(folder)) {
    std::error_code none;
    if (fs::symlink_status(folder / kName, none).type() != fs::file_type::regular) return remove_hidden_file(folder);
    const fs::path here = fs::canonical(folder, none);
    const std::vector<fs::path> folders = folders_of_run(here);
    const FolderLocks locks({folders.begin(), folders.end()});
    if (!locks.has_all()) return;
    if (folders_of_run(here) != folders) continue;  // it is over, or another one by now
    const auto first = hidden_file_of(folders[0]);
    // The first is carried out and removed last.
    for (std::size_t i = folders.size(); i-- > 0;) {
      const auto hidden = hidden_file_of(folders[i]);
      if (i > 0 && !(hidden && first && hidden->run == first->run)) continue;
      if (hidden && hidden->first == folders[0]) carry_out(hidden->changes);
      remove_hidden_file(folders[i]);
    }
    return;
  }
}

}  // namespace mixity
