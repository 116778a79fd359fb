#include "report/figures/gnuplot.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <thread>

#include "dataset/csv.h"
#include "report/figures/svg.h"
#include "report/output_file.h"

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

bool ended_well(pid_t child) {
  int status = 0;
  return waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// As many programs as the machine has processors. False if gnuplot is not installed or fails.
bool run_gnuplot(const std::vector<std::string>& scripts, const std::string& folder) {
  const std::size_t programs =
      std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, std::max<std::size_t>(scripts.size(), 1));
  std::vector<std::vector<std::string>> shares(programs);
  for (std::size_t i = 0; i < scripts.size(); ++i) shares[i % programs].push_back(scripts[i]);
  std::vector<pid_t> children;
  bool fine = true;
  for (const auto& share : shares) {
    const auto child = start_gnuplot(share, folder);
    if (child) children.push_back(*child);
    fine &= child.has_value();
  }
  for (const pid_t child : children) fine &= ended_well(child);
  return fine;
}

/// A folder of its own, gone at the end of the scope.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "mixity-figures-XXXXXX").string();
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

}  // namespace

DrawnFigures draw_figures(const std::vector<Figure>& figures, const std::string& folder) {
  const ScratchFolder scratch;
  DrawnFigures drawn;
  std::vector<std::string> scripts;
  for (const Figure& figure : figures) {
    for (const auto& [file, text] : {std::pair(figure.name + ".dat", figure_data(figure)),
                                     std::pair(figure.name + ".gp", figure_script(figure))}) {
      write_file(folder + '/' + file, text);
      write_file(scratch.path() + '/' + file, text);
      drawn.files.push_back(file);
    }
    scripts.push_back(figure.name + ".gp");
  }
  if (figures.empty()) return drawn;
  if (!run_gnuplot(scripts, scratch.path())) {
    drawn.missing = "gnuplot is not installed or failed: no SVG and PDF; the scripts draw them (gnuplot NAME.gp)";
    return drawn;
  }
  for (const Figure& figure : figures) {
    drawn.svg.push_back(readable_svg(read_file(scratch.path() + '/' + figure.name + ".svg"), figure));
    write_file(folder + '/' + figure.name + ".svg", drawn.svg.back());
    write_file(folder + '/' + figure.name + ".pdf", read_file(scratch.path() + '/' + figure.name + ".pdf"));
    for (const char* ending : {".svg", ".pdf"}) drawn.files.push_back(figure.name + ending);
  }
  return drawn;
}

}  // namespace mixity
