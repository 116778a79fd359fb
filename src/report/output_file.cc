#include "report/output_file.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>

namespace mixity {
namespace {

/// Removes what runs that were killed left of this file: PATH.tmpPID of processes that are no more.
void remove_leftovers(const std::filesystem::path& path) {
  const std::string beginning = path.filename().string() + ".tmp";
  std::error_code error;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with(beginning)) continue;
    pid_t process = 0;
    const char *begin = name.data() + beginning.size(), *stop = name.data() + name.size();
    const auto [read, failure] = std::from_chars(begin, stop, process);
    if (failure == std::errc() && read == stop && process > 0 && ::kill(process, 0) != 0 && errno == ESRCH)
      ::unlink(entry->path().c_str());
  }
}

}  // namespace

void write_file(const std::string& path, const std::string& content) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code error;
  if (!folder.empty()) std::filesystem::create_directories(folder, error);
  if (error) throw OutputError(folder.string() + ": cannot be created: " + error.message());

  remove_leftovers(path);
  const std::string temporary = path + ".tmp" + std::to_string(::getpid());
  const auto fail = [&](const std::string& what) {
    const std::string reason = std::strerror(errno);
    ::unlink(temporary.c_str());
    throw OutputError(path + ": " + what + ": " + reason);
  };
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) throw OutputError(path + ": cannot be written: " + std::strerror(errno));
  std::size_t done = 0;
  while (done < content.size()) {
    const ssize_t written = ::write(file, content.data() + done, content.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      const int reason = errno;
      ::close(file);
      errno = reason;
      fail("cannot be written");
    }
    done += static_cast<std::size_t>(written);
  }
  const bool flushed = ::fsync(file) == 0;
  if (::close(file) != 0 || !flushed) fail("cannot be written");
  if (::rename(temporary.c_str(), path.c_str()) != 0) fail("cannot be renamed into place");
}

}  // namespace mixity
