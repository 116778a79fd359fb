#include "growth/programs.h"

#include <fcntl.h>
#include <sys/resource.h>

#include <filesystem>
#include <random>

namespace mixity::growth {
namespace {

/// Processor time and largest memory of the program. Null if it could not do its work: a fit may be in doubt, and ends
/// with 1.
std::optional<Cost> cost_of(std::vector<std::string> words) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  int status = 0;
  rusage used{};
  if (child < 0 || wait4(child, &status, 0, &used) != child) return std::nullopt;
  if (!WIFEXITED(status) || WEXITSTATUS(status) > 1) return std::nullopt;
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return Cost{seconds(used.ru_utime) + seconds(used.ru_stime), 1024.0 * static_cast<double>(used.ru_maxrss)};
}

/// One row for each program. `words`: its arguments at a size.
void program_table(const char* unit, const std::vector<std::size_t>& sizes, const Programs& programs,
                   const std::function<std::vector<std::string>(std::size_t)>& words) {
  std::vector<Row> rows;
  for (const std::string& program : programs)
    rows.push_back({programs.size() > 1 ? program : "processor time", [&words, program](std::size_t n) {
                      std::vector<std::string> command = words(n);
                      command.insert(command.begin(), program);
                      return cost_of(std::move(command));
                    }});
  table(unit, sizes, rows);
}

std::FILE* opened(const std::string& path) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (!file) std::exit(2);
  return file;
}

void write_wide_csv(const std::string& path, std::size_t columns) {
  std::FILE* file = opened(path);
  std::fputs("P,T,A", file);
  for (std::size_t i = 0; i < columns; ++i) std::fprintf(file, ",x%zu", i);
  for (const Measured& point : measurements(50, 5)) {
    std::fprintf(file, "\n%.6g,%.6g,%.6g", point.P, point.T, point.A);
    for (std::size_t i = 0; i < columns; ++i) std::fprintf(file, ",%zu", i);
  }
  std::fputc('\n', file);
  std::fclose(file);
}

/// Contacts one after the other, 50 frames a second: approach, hold, shear until the contact slips, and off again.
void write_log(const std::string& path, std::size_t contacts) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise;
  std::FILE* file = opened(path);
  std::fputs("time [s],P [mN],T [mN],A [mm^2]\n", file);
  std::size_t frame = 0;
  const auto add = [&](double P, double T, double A) {
    std::fprintf(file, "%.6g,%.6g,%.6g,%.6g\n", 0.02 * static_cast<double>(frame++), P + 0.03 * noise(random),
                 T + 0.5 * noise(random), A > 0 ? A * (1 + 0.01 * noise(random)) : 0);
  };
  for (std::size_t i = 0; i < contacts; ++i) {
    const double P = 0.5 + 7.5 * static_cast<double>(random() % 1000) / 1000, A = 0.12 + 0.08 * std::pow(P, 2.0 / 3),
                 most = 40 + 12 * P;
    const auto phase = [&](int frames, double P_from, double P_to, double T_from, double T_to, double share) {
      for (int k = 0; k < frames; ++k) {
        const double s = k / static_cast<double>(frames), load = P_from + (P_to - P_from) * s,
                     T = T_from + (T_to - T_from) * s, fall = T / most;
        add(load, T, load > 0 ? share * A * load / P * (1 - 0.3 * fall * fall) : 0);
      }
    };
    phase(40, 0, 0, 0, 0, 1);
    phase(50, 0, P, 0, 0, 1);
    phase(60, P, P, 0, 0, 1);
    phase(200, P, P, 0, most, 1);
    phase(25, P, P, 0.6 * most, 0.8 * most, 0.85);
    phase(15, P, P, 0.6 * most, 0, 0.85);
    phase(20, P, 0, 0, 0, 0.85);
  }
  std::fclose(file);
}

}  // namespace

void columns(const Folder& folder, const Programs& programs) {
  program_table("columns of a file, checked", {1000, 2000, 4000, 8000, 16000}, programs, [&](std::size_t n) {
    const std::string path = folder.path("columns_" + std::to_string(n) + ".csv");
    write_wide_csv(path, n);
    return std::vector<std::string>{"check", path};
  });
}

void fits(const Folder& folder, const Programs& programs, const std::vector<std::size_t>& sizes) {
  program_table("rows of model c, read and fitted", sizes, programs, [&](std::size_t n) {
    const std::string path = folder.path("fits_" + std::to_string(n) + ".csv");
    write_csv(path, n, 10, 1, {"c", 0.02, 0.8, true});
    return std::vector<std::string>{"fit", path, "--models=c"};
  });
}

void laws(const Folder& folder, const Programs& programs) {
  program_table("laws of one's own, fitted and compared", {10, 20, 40, 80}, programs, [&](std::size_t n) {
    std::string texts, keys;
    for (std::size_t i = 0; i < n; ++i) {
      const std::string key = "law" + std::to_string(i), separator = i ? "|" : "";
      texts +=
          separator + key + ": 1 + (1-l)*" + std::to_string(1 + 0.001 * static_cast<double>(i)) + "*tan(psi)^2; l=0..1";
      keys += (i ? "," : "") + key;
    }
    return std::vector<std::string>{"fit", folder.file(50, 5), "--law=" + texts, "--models=" + keys,
                                    "--objective=toughness"};
  });
}

void files(const Folder& folder, const Programs& programs) {
  program_table("files of one data set, pooled and checked", {5000, 10000, 20000}, programs, [&](std::size_t n) {
    const std::filesystem::path here = folder.path("files_" + std::to_string(n));
    std::filesystem::create_directory(here);
    for (std::size_t i = 0; i < n; ++i) {
      std::FILE* file = opened(here / (std::to_string(i) + ".csv"));
      std::fprintf(file, "P,T,A\n%zu,0,20\n%zu,1,19\n", i + 1, i + 1);
      std::fclose(file);
    }
    return std::vector<std::string>{"check", "--pool", here / "*.csv"};
  });
}

void sets(const Folder& folder, const Programs& programs) {
  program_table("data sets of 200 points, reported", {15, 30, 60}, programs, [&](std::size_t n) {
    std::vector<std::string> words{"report", "--out=" + folder.path("report")};
    for (std::size_t i = 0; i < n; ++i) words.push_back(folder.file(200, 8, static_cast<unsigned>(i + 1)));
    return words;
  });
}

void runs(const Folder& folder, const Programs& programs) {
  program_table("contacts of a log, made runs", {125, 250, 501}, programs, [&](std::size_t n) {
    const std::string path = folder.path("log_" + std::to_string(n) + ".csv");
    write_log(path, n);
    return std::vector<std::string>{"runs", path, "--out=" + folder.path("runs_" + std::to_string(n))};
  });
}

}  // namespace mixity::growth
