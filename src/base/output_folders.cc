#include "base/output_folders.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <random>
#include <string_view>

#include "base/files.h"
#include "base/unfinished_run.h"

namespace mixity {
namespace {

constexpr std::string_view kTemporary = ".mixity-tmp";
constexpr std::size_t kLetters = 8;

void remove_temporaries(const std::filesystem::path& folder) {
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (!name_of_temporary(entry->path().filename().string()).empty()) ::unlink(entry->path().c_str());
}

FolderLocks::Key key_of(const std::filesystem::path& folder) {
  struct stat about {};
  ::stat(folder.c_str(), &about);
  return {about.st_dev, about.st_ino};
}

/// False if the file system has no locks. Throws OutputError if another program holds the lock for a minute.
bool lock(int file, const std::filesystem::path& folder) {
  constexpr int kTries = 1200;
  constexpr useconds_t kPause = 50000;
  for (int i = 0; ::flock(file, LOCK_EX | LOCK_NB) != 0; ++i) {
    if (errno != EWOULDBLOCK && errno != EINTR) return false;
    if (i == kTries)
      throw OutputError(folder.string() + ": another program writes to this folder; try again when it has ended");
    ::usleep(kPause);
  }
  return true;
}

/// Locks of folders in which no run is unfinished.
FolderLocks locks_of_finished(const std::set<std::filesystem::path>& folders) {
  constexpr int kMost = 10;
  for (int i = 1;; ++i) {
    for (const std::filesystem::path& folder : folders) complete_unfinished_run(folder);
    FolderLocks locks(folders);
    // A program may have been killed before it was locked here. Without locks it cannot be told from one at work.
    if (i == kMost || !locks.has_all() || std::none_of(folders.begin(), folders.end(), has_unfinished_run))
      return locks;
  }
}

}  // namespace

std::string temporary_name(const std::string& path) {
  std::random_device random;
  std::string name = path + std::string(kTemporary);
  for (std::size_t i = 0; i < kLetters; ++i) name += static_cast<char>('a' + random() % 26);
  return name;
}

std::string name_of_temporary(const std::string& temporary) {
  constexpr std::size_t kEnding = kTemporary.size() + kLetters;
  if (temporary.size() <= kEnding) return {};
  const std::string_view ending = std::string_view(temporary).substr(temporary.size() - kEnding),
                         letters = ending.substr(kTemporary.size());
  const bool ours = ending.starts_with(kTemporary) &&
                    std::all_of(letters.begin(), letters.end(), [](char c) { return c >= 'a' && c <= 'z'; });
  return ours ? temporary.substr(0, temporary.size() - kEnding) : std::string();
}

FolderLocks::FolderLocks(const std::set<std::filesystem::path>& folders) {
  std::map<Key, std::filesystem::path> in_order;
  for (const std::filesystem::path& folder : folders) in_order.emplace(key_of(folder), folder);
  try {
    for (const auto& [key, folder] : in_order) {
      const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
      if (file >= 0 && lock(file, folder))
        files_.emplace(key, file);
      else if (file >= 0)
        ::close(file);
      has_all_ &= has(key);
    }
  } catch (...) {
    for (const auto& [key, file] : files_) ::close(file);
    throw;
  }
}

FolderLocks::~FolderLocks() {
  for (const auto& [key, file] : files_) ::close(file);
}

OutputFolders::OutputFolders(const std::set<std::filesystem::path>& folders) : locks_(locks_of_finished(folders)) {
  for (const std::filesystem::path& folder : folders) {
    const FolderLocks::Key key = key_of(folder);
    if (locks_.has(key)) remove_temporaries(folder);
    folders_.try_emplace(key, Folder{folder, OutputRecord::of(folder)});
  }
}

OutputFolders::Folder& OutputFolders::at(const std::filesystem::path& folder) { return folders_.at(key_of(folder)); }

}  // namespace mixity
