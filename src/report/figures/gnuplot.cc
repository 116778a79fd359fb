#include "report/figures/gnuplot.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <thread>

#include "base/files.h"
#include "base/threads.h"

namespace mixity {
namespace {

/// gnuplot on these scripts, in the folder. Null if it cannot be started.
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

/// Calls `meanwhile`, unless it is null, every 20 ms.
void wait_for(pid_t child, const std::function<void()>& meanwhile) {
  int status = 0;
  for (pid_t ended = 0; ended == 0 || (ended < 0 && errno == EINTR);) {
    ended = waitpid(child, &status, meanwhile ? WNOHANG : 0);
    if (ended != 0) continue;
    meanwhile();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

/// As many programs as the machine has processors. False if gnuplot is not installed.
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

/// A folder of its own, gone at the end of the scope.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
    if (error) throw OutputError("TMPDIR names no folder for temporary files: " + error.message());
    std::string pattern = (folder / "mixity-figures-XXXXXX").string();
    if (!mkdtemp(pattern.data())) throw OutputError(pattern + ": a temporary folder cannot be made");
    path_ = pattern;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// What gnuplot drew, or nothing if the file does not end as one does: gnuplot does not report a full disk.
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
    // A script that fails takes with it those that the same program would have drawn next.
    if (is_drawn() || (run_gnuplot({scripts[i]}, scratch.path()) && is_drawn())) continue;
    files.clear();
    drawn.missing += (drawn.missing.empty() ? "gnuplot failed at " : ", ") + figures[i]->name;
  }
  return drawn;
}

}  // namespace mixity
