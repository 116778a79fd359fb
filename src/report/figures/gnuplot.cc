#include "report/figures/gnuplot.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <functional>
#include <optional>
#include <thread>

#include "base/files.h"
#include "base/threads.h"

namespace mixity {
namespace {

/// Starts gnuplot with these scripts in the folder. Null if it cannot be started.
std::optional<pid_t> start_gnuplot(const std::vector<std::string>& scripts, const std::string& folder) {
  std::vector<std::string> words{"gnuplot"};
  words.insert(words.end(), scripts.begin(), scripts.end());
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", 1, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", 1, 0);
  pid_t child = 0;
  const int failure = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return failure == 0 ? std::optional(child) : std::nullopt;
}

/// Calls `meanwhile`, unless it is null, every 20 ms until the child ends.
void wait_for(pid_t child, const std::function<void()>& meanwhile) {
  int status = 0;
  for (pid_t ended = 0; ended == 0 || (ended < 0 && errno == EINTR);) {
    ended = waitpid(child, &status, meanwhile ? WNOHANG : 0);
    if (ended != 0) continue;
    meanwhile();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

/// Runs as many processes as the machine has processors. False if gnuplot is not installed.
bool run_gnuplot(const std::vector<std::string>& scripts, const std::string& folder,
                 const std::function<void()>& meanwhile = {}) {
  const std::size_t programs = std::min(processors(), std::max<std::size_t>(scripts.size(), 1));
  std::vector<std::vector<std::string>> shares(programs);
  for (std::size_t i = 0; i < scripts.size(); ++i) shares[i % programs].push_back(scripts[i]);
  std::vector<pid_t> children;
  for (const auto& share : shares)
    if (const auto child = start_gnuplot(share, folder)) children.push_back(*child);
  for (const pid_t child : children) wait_for(child, meanwhile);
  return children.size() == shares.size();
}

constexpr std::string_view kScratch = "mixity-figures-";

/// Locks a folder while the descriptor is open; negative if another program holds the lock.
int locked(const std::filesystem::path& folder) {
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (file >= 0 && ::flock(file, LOCK_EX | LOCK_NB) == 0) return file;
  if (file >= 0) ::close(file);
  return -1;
}

/// Removes folders left by killed programs of this user: they are not locked, and are older than one that is just about
/// to be.
void remove_left_behind(const std::filesystem::path& temporary) {
  constexpr std::time_t kYoung = 60;  // s
  std::error_code error;
  for (std::filesystem::directory_iterator entry(temporary, error), end; !error && entry != end;
       entry.increment(error)) {
    struct stat about {};
    const std::filesystem::path& path = entry->path();
    if (!path.filename().string().starts_with(kScratch) || ::lstat(path.c_str(), &about) != 0) continue;
    if (!S_ISDIR(about.st_mode) || about.st_uid != ::geteuid() || std::time(nullptr) - about.st_mtime < kYoung)
      continue;
    if (const int file = locked(path); file >= 0) {
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
      ::close(file);
    }
  }
}

/// A temporary folder that is removed at the end of the scope.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
    if (error) throw OutputError("TMPDIR names no folder for temporary files: " + error.message());
    remove_left_behind(folder);
    std::string pattern = (folder / (std::string(kScratch) + "XXXXXX")).string();
    if (!mkdtemp(pattern.data())) throw OutputError(pattern + ": a temporary folder cannot be made");
    path_ = pattern;
    lock_ = locked(path_);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
    if (lock_ >= 0) ::close(lock_);
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  int lock_ = -1;
};

/// The file that gnuplot drew, or nothing if it has no proper end: gnuplot does not report a full disk.
std::string whole(const std::string& path) {
  if (!std::filesystem::exists(path)) return {};
  std::string text = read_file(path);
  const std::string_view end = path.ends_with(".pdf") ? "%%EOF" : "IEND\xae\x42\x60\x82";
  const bool is_whole = std::string_view(text).substr(0, text.find_last_not_of("\r\n") + 1).ends_with(end);
  return is_whole ? text : std::string();
}

}  // namespace

GnuplotFigures draw_by_gnuplot(const std::vector<const Figure*>& figures, const std::vector<std::string>& endings,
                               const Progress& progress) {
  const ScratchFolder scratch;
  GnuplotFigures drawn{std::vector<std::vector<std::string>>(figures.size()), {}};
  std::vector<std::string> scripts;
  const auto path = [&](const Figure& figure, const std::string& ending) {
    return scratch.path() + '/' + figure.name + ending;
  };
  for (const Figure* figure : figures) {
    write_scratch_file(path(*figure, ".dat"), figure_data(*figure));
    write_scratch_file(path(*figure, ".gp"), figure_script(*figure, endings));
    scripts.push_back(figure->name + ".gp");
  }
  const auto count = [&] {
    const auto begun = std::count_if(figures.begin(), figures.end(), [&](const Figure* figure) {
      return std::filesystem::exists(path(*figure, endings.front()));
    });
    progress(static_cast<double>(begun) / static_cast<double>(figures.size()));
  };
  if (!run_gnuplot(scripts, scratch.path(), progress ? count : std::function<void()>())) {
    drawn.missing = "gnuplot is not installed: no PDF and PNG";
    return drawn;
  }
  for (std::size_t i = 0; i < figures.size(); ++i) {
    std::vector<std::string>& files = drawn.files[i];
    const auto is_drawn = [&] {
      files.clear();
      for (const std::string& ending : endings)
        if (std::string file = whole(path(*figures[i], ending)); !file.empty()) files.push_back(std::move(file));
      return files.size() == endings.size();
    };
    // If a script fails, those after it in the same process are not drawn either.
    if (is_drawn() || (run_gnuplot({scripts[i]}, scratch.path()) && is_drawn())) continue;
    files.clear();
    drawn.missing += (drawn.missing.empty() ? "gnuplot failed at " : ", ") + figures[i]->name;
  }
  return drawn;
}

}  // namespace mixity
