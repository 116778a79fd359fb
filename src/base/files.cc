#include "base/files.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <random>
#include <utility>

#include "base/input_error.h"
#include "base/text.h"

namespace mixity {
namespace {

constexpr const char* kTemporary = ".mixity-tmp";  // then letters drawn at random
constexpr std::size_t kLetters = 8;

std::string random_letters() {
  std::random_device random;
  std::string letters;
  for (std::size_t i = 0; i < kLetters; ++i) letters += static_cast<char>('a' + random() % 26);
  return letters;
}

bool is_temporary_of(const std::string& name, const std::string& file) {
  const std::string beginning = file + kTemporary;
  return name.size() == beginning.size() + kLetters && name.starts_with(beginning) &&
         std::all_of(name.end() - kLetters, name.end(), [](char c) { return c >= 'a' && c <= 'z'; });
}

/// Holds folders against other programs that write to them, wherever these run: a lock belongs to the folder itself,
/// not to a process number, which programs in two containers may share. Given up where the file system has none.
class LockedFolders {
 public:
  LockedFolders() = default;
  LockedFolders(const LockedFolders&) = delete;
  LockedFolders& operator=(const LockedFolders&) = delete;
  ~LockedFolders() {
    for (const auto& [key, folder] : files_) ::close(folder.file);
  }

  /// False where the folder cannot be locked. Throws OutputError if another program holds it for a minute.
  bool add(const std::filesystem::path& folder) {
    constexpr int kTries = 1200;
    constexpr useconds_t kPause = 50000;
    const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    struct stat about {};
    if (file < 0) return false;
    if (::fstat(file, &about) != 0) return ::close(file), false;
    const auto [known, is_new] = files_.try_emplace({about.st_dev, about.st_ino}, Folder{file, false});
    if (!is_new) return ::close(file), known->second.held;
    for (int i = 0; ::flock(file, LOCK_EX | LOCK_NB) != 0; ++i) {
      if (errno != EWOULDBLOCK && errno != EINTR) return false;
      if (i == kTries)
        throw OutputError(folder.string() + ": another program writes to this folder; try again when it has ended");
      ::usleep(kPause);
    }
    return known->second.held = true;
  }

 private:
  struct Folder {
    int file;
    bool held;
  };
  std::map<std::pair<dev_t, ino_t>, Folder> files_;
};

/// Removes temporary files of this file: its folder is locked, so that they are of killed programs.
void remove_leftovers(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (is_temporary_of(entry->path().filename().string(), path.filename().string())) ::unlink(entry->path().c_str());
}

/// A pipe or device, which is written in place.
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

/// The end of a chain of links, which need not exist.
std::filesystem::path end_of_links(const std::string& path) {
  constexpr int kMost = 40;  // as the system's
  std::filesystem::path end = path;
  std::error_code none;
  for (int i = 0; i < kMost; ++i) {
    if (!std::filesystem::is_symlink(end, none)) return end;
    end = end.parent_path() / std::filesystem::read_symlink(end, none);
  }
  cannot_be_written(path, ELOOP);
}

/// A file that is written under a temporary name, and removed unless it is put in place.
class StagedFile {
 public:
  StagedFile(const OutputFile& file, LockedFolders& locked) : file_(file) {
    constexpr int kTries = 100;
    const std::string& path = file.path;
    std::error_code unknown;
    const auto kind = std::filesystem::status(path, unknown).type();
    direct_ = is_direct(kind);
    if (direct_) return;
    if (kind == std::filesystem::file_type::directory || path.ends_with('/')) check(EISDIR);
    if (kind == std::filesystem::file_type::regular && ::access(path.c_str(), W_OK) != 0) check(errno);
    target_ = end_of_links(path).string();
    const std::filesystem::path folder = std::filesystem::path(target_).parent_path();
    std::error_code error;
    if (!folder.empty()) std::filesystem::create_directories(folder, error);
    if (error) throw OutputError(folder.string() + ": cannot be created: " + error.message());

    if (locked.add(folder.empty() ? "." : folder)) remove_leftovers(target_);
    int opened = -1, reason = EEXIST;
    for (int i = 0; i < kTries && opened < 0 && reason == EEXIST; ++i) {
      temporary_ = target_ + kTemporary + random_letters();
      opened = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0644);
      reason = errno;
    }
    if (opened < 0) {
      temporary_.clear();
      check(reason);
    }
    struct stat old {};
    if (::stat(target_.c_str(), &old) == 0) ::fchmod(opened, old.st_mode & 0777);  // the permissions stay
    if (const int failed = write_and_close(opened, file.content, true); failed != 0) {
      discard();
      check(failed);
    }
  }
  StagedFile(const StagedFile&) = delete;
  StagedFile& operator=(const StagedFile&) = delete;
  ~StagedFile() { discard(); }

  /// Writes a pipe or device; may take as long as its reader does.
  void write_if_direct() const {
    if (!direct_) return;
    const int opened = ::open(file_.path.c_str(), O_WRONLY | O_CLOEXEC);
    check(opened < 0 ? errno : write_and_close(opened, file_.content, false));
  }
  void put_in_place() {
    if (direct_) return;
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
  std::string target_, temporary_;
  bool direct_ = false;  // a pipe or device
};

/// Blocks the signals that end the process while it exists, so that all files of a run are put in place or none.
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

/// Throws OutputError if two of the paths lead to the same file, as links can.
void tell_apart(const std::vector<OutputFile>& files) {
  std::map<std::filesystem::path, const OutputFile*> known;
  for (const OutputFile& file : files) {
    std::error_code unknown;
    if (is_direct(std::filesystem::status(file.path, unknown).type())) continue;
    const std::filesystem::path whole = std::filesystem::absolute(end_of_links(file.path), unknown);
    const std::filesystem::path place = std::filesystem::weakly_canonical(whole, unknown);
    if (unknown || place.empty()) continue;  // writing it will tell
    const auto [same, first] = known.emplace(place, &file);
    if (!first) throw OutputError(file.path + ": leads to the same file as " + same->second->path);
  }
}

/// Throws OutputError if one of the outputs is one of the inputs, under any name.
void spare_inputs(const std::vector<std::string>& inputs, const std::vector<OutputFile>& outputs) {
  for (const OutputFile& output : outputs)
    for (const std::string& input : inputs) {
      std::error_code not_there;
      if (std::filesystem::equivalent(input, output.path, not_there))
        throw OutputError(output.path + ": is an input and is not written over");
    }
}

/// The name, with a number behind it if a file of other content has it: no former edit is lost.
std::string free_name(const std::string& name, const std::string& content) {
  std::string free = name;
  std::error_code unread;
  for (int number = 2; std::filesystem::exists(free, unread) && read_file(free) != content; ++number)
    free = name + "." + std::to_string(number);
  return free;
}

}  // namespace

std::string read_file(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) throw InputError(path, std::string("cannot be opened: ") + std::strerror(errno));
  std::string text;
  std::array<char, 1 << 14> part;
  while (const std::size_t got = std::fread(part.data(), 1, part.size(), file.get())) {
    text.append(part.data(), got);
    if (text.size() > kMostText) throw InputError(path, "is larger than 256 MB");
  }
  if (std::ferror(file.get())) throw InputError(path, std::string("cannot be read: ") + std::strerror(errno));
  return text;
}

std::string plain_file_name(std::string_view name) {
  std::string result;
  while (!name.empty()) {
    const std::size_t length = character_length(name);
    const bool letter = length > 1 || std::isalnum(static_cast<unsigned char>(name[0])),
               sign = !result.empty() && std::string_view(" ._-+=,()").find(name[0]) != std::string_view::npos;
    result += length > 0 && (letter || sign) ? name.substr(0, length) : "_";
    name.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

void write_files(const std::vector<OutputFile>& files, const std::vector<std::string>& inputs) {
  spare_inputs(inputs, files);
  tell_apart(files);
  LockedFolders locked;
  std::deque<StagedFile> staged;
  for (const OutputFile& file : files) staged.emplace_back(file, locked);
  for (const StagedFile& file : staged) file.write_if_direct();
  const Uninterrupted renaming;
  for (StagedFile& file : staged) file.put_in_place();
}

std::vector<std::string> keep_former(std::vector<OutputFile>& files) {
  std::vector<std::string> kept;
  for (std::size_t i = 0, n = files.size(); i < n; ++i) {
    std::error_code unread;
    if (!files[i].path.ends_with(".toml") || !std::filesystem::is_regular_file(files[i].path, unread)) continue;
    std::string former = read_file(files[i].path);
    if (former == files[i].content) continue;
    kept.push_back(free_name(files[i].path + ".old", former));
    files.push_back({kept.back(), std::move(former)});
  }
  return kept;
}

void write_file(const std::string& path, const std::string& content) { write_files({{path, content}}); }

}  // namespace mixity
