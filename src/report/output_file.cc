#include "report/output_file.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>

#include "dataset/printable.h"

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

/// Writes all of it and closes the file. 0, or the reason as errno has it.
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

}  // namespace

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

void write_file(const std::string& path, const std::string& content) {
  const auto check = [&](int reason) {
    if (reason != 0) throw OutputError(path + ": cannot be written: " + std::strerror(reason));
  };
  std::error_code unknown;
  const auto kind = std::filesystem::status(path, unknown).type();
  if (kind == std::filesystem::file_type::character || kind == std::filesystem::file_type::fifo) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    return check(file < 0 ? errno : write_and_close(file, content, false));
  }
  if (kind == std::filesystem::file_type::regular && ::access(path.c_str(), W_OK) != 0) check(errno);
  std::string target = path;
  if (std::filesystem::is_symlink(path, unknown)) target = std::filesystem::weakly_canonical(path, unknown).string();
  if (target.empty()) target = path;

  const std::filesystem::path folder = std::filesystem::path(target).parent_path();
  std::error_code error;
  if (!folder.empty()) std::filesystem::create_directories(folder, error);
  if (error) throw OutputError(folder.string() + ": cannot be created: " + error.message());

  remove_leftovers(target);
  const std::string temporary = target + ".tmp" + std::to_string(::getpid());
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) check(errno);
  int reason = write_and_close(file, content, true);
  if (reason == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) reason = errno;
  if (reason != 0) ::unlink(temporary.c_str());
  check(reason);
}

void spare_inputs(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs) {
  for (const std::string& output : outputs)
    for (const std::string& input : inputs) {
      std::error_code not_there;
      if (std::filesystem::equivalent(input, output, not_there))
        throw OutputError(output + ": is an input and is not written over");
    }
}

}  // namespace mixity
