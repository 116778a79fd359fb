#include "base/output_folders.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <random>

#include "base/files.h"

namespace mixity {
namespace {

constexpr std::string_view kTemporary = ".mixity-tmp";
constexpr std::size_t kLetters = 8;

bool is_temporary(std::string_view name) {
  if (name.size() <= kTemporary.size() + kLetters) return false;
  const std::string_view letters = name.substr(name.size() - kLetters);
  name.remove_suffix(kLetters);
  return name.ends_with(kTemporary) &&
         std::all_of(letters.begin(), letters.end(), [](char c) { return c >= 'a' && c <= 'z'; });
}

void remove_temporaries(const std::filesystem::path& folder) {
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (is_temporary(entry->path().filename().string())) ::unlink(entry->path().c_str());
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

}  // namespace

std::string temporary_name(const std::string& path) {
  std::random_device random;
  std::string name = path + std::string(kTemporary);
  for (std::size_t i = 0; i < kLetters; ++i) name += static_cast<char>('a' + random() % 26);
  return name;
}

OutputFolders::~OutputFolders() {
  for (const auto& [key, folder] : folders_)
    if (folder.file >= 0) ::close(folder.file);
}

OutputFolders::Folder& OutputFolders::at(const std::filesystem::path& folder) {
  struct stat about {};
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0 || ::fstat(file, &about) != 0) ::stat(folder.c_str(), &about);
  const auto [known, is_new] = folders_.try_emplace({about.st_dev, about.st_ino}, Folder{file, folder});
  if (!is_new) {
    if (file >= 0) ::close(file);
    return known->second;
  }
  if (file >= 0 && lock(file, folder)) remove_temporaries(folder);
  known->second.record = OutputRecord::of(folder);
  return known->second;
}

}  // namespace mixity
