#include "report/figure.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <sstream>

#include "dataset/csv.h"
#include "dataset/number_text.h"
#include "report/output_file.h"

namespace mixity {
namespace {

/// As a gnuplot string in double quotes.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

std::string style(Look look, const std::string& color) {
  const std::string paint = " lc rgb " + quoted(color);
  switch (look) {
    case Look::solid:
      return "with lines lw 1.6 dt 1" + paint;
    case Look::dashed:
      return "with lines lw 1.6 dt (14,6)" + paint;
    case Look::dash_dot:
      return "with lines lw 1.6 dt (14,5,2,5)" + paint;
    case Look::dotted:
      return "with lines lw 1.1 dt (2,4)" + paint;
    case Look::points:
      break;
  }
  return "with points pt 6 ps 0.5" + paint;
}

std::string axis_commands(char name, const Axis& axis) {
  const auto end = [](const std::optional<double>& value) { return value ? shortest(*value) : std::string("*"); };
  std::string text = std::string("set ") + name + "label " + quoted(axis.label) + '\n' + "set " + name + "range [" +
                     end(axis.low) + ':' + end(axis.high) + "]\n";
  if (axis.logarithmic) text += std::string("set logscale ") + name + '\n';
  return text;
}

/// gnuplot on these scripts, in the folder. False if it is not installed or fails.
bool run_gnuplot(const std::vector<std::string>& scripts, const std::string& folder) {
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
  if (failure != 0) return false;
  int status = 0;
  return waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
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

std::string color(std::size_t i) {
  static constexpr std::array kColors{"#000000", "#d55e00", "#0072b2", "#009e73",
                                      "#cc79a7", "#e69f00", "#56b4e9", "#7f7f7f"};
  return kColors[i % kColors.size()];
}

std::string figure_data(const Figure& figure) {
  std::ostringstream out;
  out << "# " << figure.title << '\n';
  for (std::size_t i = 0; i < figure.series.size(); ++i) {
    const Series& series = figure.series[i];
    out << (i ? "\n\n" : "") << "# index " << i << (series.label.empty() ? "" : ": " + series.label) << '\n';
    for (const auto& [x, y] : series.points) out << shortest(x) << ' ' << shortest(y) << '\n';
  }
  return out.str();
}

std::string figure_script(const Figure& figure) {
  std::ostringstream out;
  out << "# " << figure.title << "\n# Draws " << figure.name << ".svg and " << figure.name << ".pdf: gnuplot "
      << figure.name << ".gp\nreset\nset encoding utf8\nset border 3\nset tics nomirror\nset key "
      << (figure.key_inside ? "left" : "outside right") << " top Left reverse samplen 3\n"
      << axis_commands('x', figure.x) << axis_commands('y', figure.y);
  std::string plot;
  for (std::size_t i = 0; i < figure.series.size(); ++i) {
    const Series& series = figure.series[i];
    if (series.points.empty()) continue;
    plot += (plot.empty() ? "plot " : ", \\\n     ") + quoted(figure.name + ".dat") + " index " + std::to_string(i) +
            " using 1:2 " + style(series.look, series.color) +
            (series.label.empty() ? " notitle" : " title " + quoted(series.label));
  }
  for (const auto& [label, look] : figure.key)
    plot += ", \\\n     keyentry " + style(look, "#000000") + " title " + quoted(label);
  out << "set terminal svg size 540,360 dynamic font \"Helvetica,12\" background \"#ffffff\"\nset output "
      << quoted(figure.name + ".svg") << '\n'
      << plot << "\nset terminal pdfcairo size 13.5cm,9cm font \"Helvetica,11\"\nset output "
      << quoted(figure.name + ".pdf") << "\nreplot\nset output\n";
  return out.str();
}

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
  for (const Figure& figure : figures)
    for (const char* ending : {".svg", ".pdf"}) {
      const std::string file = figure.name + ending;
      write_file(folder + '/' + file, read_file(scratch.path() + '/' + file));
      drawn.files.push_back(file);
    }
  return drawn;
}

}  // namespace mixity
