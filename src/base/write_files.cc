#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <deque>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/content_hash.h"
#include "base/files.h"
#include "base/inputs.h"
#include "base/output_folders.h"
#include "base/unfinished_run.h"

namespace mixity {
namespace {

/// Whether the file is a pipe or device, which is written directly.
bool is_direct(std::filesystem::file_type kind) {
  return kind == std::filesystem::file_type::character || kind == std::filesystem::file_type::fifo;
}

/// Writes the content and closes the file. Returns 0 or an errno.
int write_and_close(int file, const std::string& content, bool to_disk) {
  int reason = 0;
  for (std::size_t done = 0; reason == 0 && done < content.size();) {
    const ssize_t written = ::write(file, content.data() + done, content.size() - done);
    if (written >= 0)
      done += static_cast<std::size_t>(written);
    else if (errno != EINTR)
      reason = errno;
  }
  if (reason == 0 && to_disk && ::fsync(file) != 0) reason = errno;
  if (::close(file) != 0 && reason == 0) reason = errno;
  return reason;
}

[[noreturn]] void cannot_be_written(const std::string& path, int reason) {
  throw OutputError(path + ": cannot be written: " + std::strerror(reason));
}

/// The end of a chain of links; it need not exist.
std::filesystem::path end_of_links(const std::string& path) {
  constexpr int kMost = 40;  // the same as the system's limit
  std::filesystem::path end = path;
  std::error_code none;
  for (int i = 0; i < kMost; ++i) {
    if (!std::filesystem::is_symlink(end, none)) return end;
    end = end.parent_path() / std::filesystem::read_symlink(end, none);
  }
  cannot_be_written(path, ELOOP);
}

/// Folders that a run creates. Those that are empty at its end, as where it is refused, are removed.
class CreatedFolders {
 public:
  CreatedFolders() = default;
  CreatedFolders(const CreatedFolders&) = delete;
  CreatedFolders& operator=(const CreatedFolders&) = delete;
  ~CreatedFolders() {
    for (auto folder = list_.rbegin(); folder != list_.rend(); ++folder) ::rmdir(folder->c_str());
  }

  /// Creates the folder and those above it. Throws OutputError.
  void create(const std::filesystem::path& folder) {
    std::error_code error;
    std::vector<std::filesystem::path> missing;
    for (std::filesystem::path one = folder; !one.empty() && !std::filesystem::exists(one, error);
         one = one.parent_path())
      missing.push_back(one);
    for (auto one = missing.rbegin(); one != missing.rend(); ++one)
      if (std::filesystem::create_directory(*one, error)) list_.push_back(*one);
    std::filesystem::create_directories(folder, error);
    if (error) throw OutputError(folder.string() + ": cannot be created: " + error.message());
  }

 private:
  std::vector<std::filesystem::path> list_;  // the outer ones first
};

/// A file written under a temporary name, and removed unless it is moved into place.
class StagedFile {
 public:
  /// Creates its folder.
  StagedFile(const OutputFile& file, CreatedFolders& created) : file_(file) {
    const std::string& path = file.path;
    std::error_code unknown;
    const auto kind = std::filesystem::status(path, unknown).type();
    if (is_direct(kind)) return;
    if (kind == std::filesystem::file_type::directory || path.ends_with('/')) check(EISDIR);
    if (kind == std::filesystem::file_type::regular && ::access(path.c_str(), W_OK) != 0) check(errno);
    target_ = end_of_links(path);
    created.create(parent());
    hash_ = content_hash(file.content);
  }
  StagedFile(const StagedFile&) = delete;
  StagedFile& operator=(const StagedFile&) = delete;
  ~StagedFile() { discard(); }

  /// The file's folder; empty for a pipe or device.
  std::filesystem::path parent() const {
    return target_.has_parent_path() || target_.empty() ? target_.parent_path() : ".";
  }
  /// `folders`: locked, so that no other program writes here.
  void enter(OutputFolders& folders) {
    if (target_.empty()) return;
    folder_ = &folders.at(parent());
    before_ = file_hash(target_.string());
  }
  OutputFolders::Folder* folder() const { return folder_; }  // null for a pipe or device
  const std::string& path() const { return file_.path; }
  FolderChanges::Change change() const { return {std::filesystem::path(temporary_).filename().string(), before_}; }
  std::string name() const { return target_.filename().string(); }
  const std::string& hash() const { return hash_; }

  /// Throws OutputError if the path has a file that this program did not write and whose content would be lost. `kept`:
  /// hashes of all contents that are written.
  void spare_others(const std::set<std::string>& kept) const {
    std::error_code not_there;
    if (!folder_ || !std::filesystem::is_regular_file(target_, not_there)) return;
    if (std::filesystem::file_size(target_, not_there) == 0) return;
    const OutputRecord& record = folder_->record;
    if (before_ == hash_ || record.wrote(name(), before_) || (record.knows(name()) && kept.count(before_) > 0)) return;
    throw OutputError(Message(file_.path) +
                      (record.knows(name()) ? ": was edited since mixity wrote it" : ": was not written by mixity") +
                      " and is not replaced: take another name, or " + Remedy::set("force", "true"));
  }
  void write_temporary() {
    constexpr int kTries = 100;
    if (!folder_) return;
    int opened = -1, reason = EEXIST;
    for (int i = 0; i < kTries && opened < 0 && reason == EEXIST; ++i) {
      temporary_ = temporary_name(target_.string());
      opened = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0644);
      reason = errno;
    }
    if (opened < 0) {
      temporary_.clear();
      check(reason);
    }
    struct stat old {};
    if (::stat(target_.c_str(), &old) == 0) ::fchmod(opened, old.st_mode & 0777);  // keeps the permissions
    if (const int failed = write_and_close(opened, file_.content, true); failed != 0) {
      discard();
      check(failed);
    }
  }
  /// Writes a pipe or device; this may take as long as its reader does.
  void write_if_direct() const {
    if (folder_) return;
    const int opened = ::open(file_.path.c_str(), O_WRONLY | O_CLOEXEC);
    check(opened < 0 ? errno : write_and_close(opened, file_.content, false));
  }
  void put_in_place() {
    if (!folder_) return;
    check(::rename(temporary_.c_str(), target_.c_str()) != 0 ? errno : 0);
    temporary_.clear();
  }

 private:
  void check(int reason) const {
    if (reason != 0) cannot_be_written(file_.path, reason);
  }
  void discard() {
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
    temporary_.clear();
  }

  const OutputFile& file_;
  std::filesystem::path target_;
  std::string temporary_, hash_, before_;  // before_: hash of the file that is replaced
  OutputFolders::Folder* folder_ = nullptr;
};

/// While it exists, blocks the signals that end the process, so that all files of a run are moved into place or none.
class Uninterrupted {
 public:
  Uninterrupted() {
    sigset_t asked;
    sigemptyset(&asked);
    for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGQUIT}) sigaddset(&asked, signal);
    pthread_sigmask(SIG_BLOCK, &asked, &before_);
  }
  ~Uninterrupted() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  Uninterrupted(const Uninterrupted&) = delete;
  Uninterrupted& operator=(const Uninterrupted&) = delete;

 private:
  sigset_t before_{};
};

/// Throws OutputError if one of the outputs has the name of a file that this program keeps in each folder.
void spare_own_names(const std::vector<OutputFile>& outputs) {
  for (const OutputFile& output : outputs)
    for (const char* name : {OutputRecord::kName, kUnfinishedName})
      if (std::filesystem::path(output.path).filename() == name)
        throw OutputError(output.path + ": is the name of a file that mixity keeps there; take another name");
}

/// Throws OutputError if two paths lead to the same file, as links can.
void tell_apart(const std::vector<OutputFile>& files) {
  std::map<std::filesystem::path, const OutputFile*> known;
  for (const OutputFile& file : files) {
    std::error_code unknown;
    if (is_direct(std::filesystem::status(file.path, unknown).type())) continue;
    const std::filesystem::path whole = std::filesystem::absolute(end_of_links(file.path), unknown);
    const std::filesystem::path place = std::filesystem::weakly_canonical(whole, unknown);
    if (unknown || place.empty()) continue;  // writing it will report the error
    const auto [same, first] = known.emplace(place, &file);
    if (!first) throw OutputError(file.path + ": leads to the same file as " + same->second->path);
  }
}

/// Throws OutputError if one of the outputs is one of the inputs, under any name.
void spare_inputs(std::vector<std::string> inputs, const std::vector<OutputFile>& outputs) {
  const auto number_of = [](const std::string& path) -> std::optional<std::pair<dev_t, ino_t>> {
    struct stat about {};
    if (::stat(path.c_str(), &about) != 0) return std::nullopt;
    return std::pair(about.st_dev, about.st_ino);
  };
  for (std::string& path : files_remembered()) inputs.push_back(std::move(path));
  std::set<std::pair<dev_t, ino_t>> numbers;
  for (const std::string& input : inputs)
    if (const auto number = number_of(input)) numbers.insert(*number);
  for (const OutputFile& output : outputs)
    if (const auto number = number_of(output.path); number && numbers.count(*number) > 0)
      throw OutputError(output.path + ": is an input and is not written over");
}

/// What is there now. It is read for a comparison, and so is no input.
std::string present_content(const std::string& path) {
  complete_unfinished_run(std::filesystem::absolute(path).parent_path());
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// The name, followed by a number if a file with other content has it, so that no earlier edit is lost.
std::string free_name(const std::string& name, const std::string& content) {
  std::string free = name;
  std::error_code unread;
  for (int number = 2; std::filesystem::exists(free, unread) && present_content(free) != content; ++number)
    free = name + "." + std::to_string(number);
  return free;
}

/// The locked folders of these files and all that are renewed.
OutputFolders folders_of(const std::deque<StagedFile>& staged, const std::vector<std::string>& renewed) {
  std::set<std::filesystem::path> folders;
  for (const StagedFile& file : staged)
    if (!file.parent().empty()) folders.insert(file.parent());
  std::error_code none;
  for (const std::string& path : renewed)
    if (std::filesystem::is_directory(path, none)) folders.insert(path);
  return OutputFolders(folders);
}

/// Files that this program wrote to these folders earlier and does not write now; those edited since are kept.
std::vector<std::filesystem::path> left_from_former_runs(const std::vector<std::string>& renewed,
                                                         const std::deque<StagedFile>& staged, OutputFolders& folders) {
  std::vector<std::filesystem::path> list;
  for (const std::string& path : renewed) {
    std::error_code none;
    if (!std::filesystem::is_directory(path, none)) continue;
    const OutputFolders::Folder& folder = folders.at(path);
    std::set<std::string> again;
    for (const StagedFile& file : staged)
      if (file.folder() == &folder) again.insert(file.name());
    for (const std::string& name : folder.record.names())
      if (again.count(name) == 0 && folder.record.wrote(name, file_hash((folder.path / name).string())))
        list.push_back(folder.path / name);
  }
  return list;
}

/// The records of the folders, updated with what is now written.
std::deque<OutputFile> records(const std::deque<StagedFile>& staged, OutputFolders& folders) {
  std::deque<OutputFile> files;
  for (auto& [key, folder] : folders) {
    folder.record.forget_missing(folder.path);
    for (const StagedFile& file : staged)
      if (file.folder() == &folder) folder.record.add(file.name(), file.hash());
    files.push_back({(folder.path / OutputRecord::kName).string(), folder.record.text()});
  }
  return files;
}

/// What takes place when the files take their names, by folder.
std::vector<FolderChanges> changes_of(const std::deque<StagedFile>& recorded, const std::deque<StagedFile>& staged,
                                      const std::vector<std::filesystem::path>& outdated) {
  std::vector<FolderChanges> changes;
  for (const StagedFile& record : recorded) {
    FolderChanges& here = changes.emplace_back(FolderChanges{record.folder()->path, {record.change()}, {}});
    for (const StagedFile& file : staged)
      if (file.folder() == record.folder()) here.renamed.push_back(file.change());
    for (const std::filesystem::path& path : outdated)
      if (path.parent_path() == here.folder)
        here.removed.push_back({path.filename().string(), file_hash(path.string())});
  }
  return changes;
}

}  // namespace

void write_files(const std::vector<OutputFile>& files, const OutputRules& rules) {
  spare_inputs(rules.inputs, files);
  spare_own_names(files);
  tell_apart(files);
  CreatedFolders created;  // outlives the temporary files in them
  std::deque<StagedFile> staged;
  std::set<std::string> hashes;
  for (const OutputFile& file : files) hashes.insert(staged.emplace_back(file, created).hash());
  OutputFolders folders = folders_of(staged, rules.renewed);
  for (StagedFile& file : staged) file.enter(folders);
  if (!rules.force)
    for (const StagedFile& file : staged) file.spare_others(hashes);
  const std::vector<std::filesystem::path> outdated = left_from_former_runs(rules.renewed, staged, folders);
  const std::deque<OutputFile> of_records = records(staged, folders);
  // Records are put in place first: they accept both the old and the new version of each file.
  std::deque<StagedFile> recorded, announced;
  const auto write_temporaries = [&](const auto& contents, std::deque<StagedFile>& list) {
    for (const OutputFile& file : contents) list.emplace_back(file, created).enter(folders);
    for (StagedFile& file : list) file.write_temporary();
  };
  write_temporaries(of_records, recorded);
  for (StagedFile& file : staged) file.write_temporary();
  const std::vector<OutputFile> unfinished = unfinished_files(changes_of(recorded, staged, outdated));
  write_temporaries(unfinished, announced);
  for (const StagedFile& file : staged) file.write_if_direct();
  const Uninterrupted renaming;
  // From the last of these renames on, whoever comes next completes what is left undone.
  for (auto file = announced.rbegin(); file != announced.rend(); ++file) file->put_in_place();
  std::optional<OutputError> failed;  // the others take their names nevertheless
  for (auto* const list : {&recorded, &staged})
    for (StagedFile& file : *list) {
      try {
        file.put_in_place();
      } catch (const OutputError& error) {
        failed = error;
      }
    }
  for (const std::filesystem::path& path : outdated) ::unlink(path.c_str());
  for (auto file = announced.rbegin(); file != announced.rend(); ++file) ::unlink(file->path().c_str());
  if (failed) throw *failed;
}

std::vector<std::string> keep_former(std::vector<OutputFile>& files) {
  std::vector<std::string> kept;
  for (std::size_t i = 0, n = files.size(); i < n; ++i) {
    std::error_code unread;
    if (!files[i].path.ends_with(".toml") || !std::filesystem::is_regular_file(files[i].path, unread)) continue;
    std::string former = present_content(files[i].path);
    if (former == files[i].content) continue;
    kept.push_back(free_name(files[i].path + ".old", former));
    files.push_back({kept.back(), std::move(former)});
  }
  return kept;
}

void write_scratch_file(const std::string& path, const std::string& content) {
  const int opened = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (const int reason = opened < 0 ? errno : write_and_close(opened, content, false); reason != 0)
    cannot_be_written(path, reason);
}

}  // namespace mixity
