// growth [--largest=N] [--program=PATH ...] [TASK...]: time and memory of each task over a range of sizes, with the
// exponent of growth. Tasks: reading, points, loads, replicates, threads, which call the library; columns, fits, laws,
// sets, runs, files, which run the program, that of this build or those at PATH. All by default.
#include <malloc.h>
#include <sched.h>

#include <cstring>
#include <fstream>
#include <functional>
#include <thread>

#include "base/threads.h"
#include "base/units.h"
#include "dataset/check.h"
#include "dataset/table/csv_file.h"
#include "fitting/fit.h"
#include "growth/data.h"
#include "growth/measure.h"
#include "growth/programs.h"
#include "growth/table.h"

namespace {

using namespace mixity;
using namespace mixity::growth;

using Task = std::function<void()>;
using Prepare = std::function<Task(std::size_t n)>;

std::size_t largest = 10000000;

void run_on(std::size_t count) {
  cpu_set_t set;
  CPU_ZERO(&set);
  for (std::size_t k = 0; k < count; ++k) CPU_SET(k, &set);
  sched_setaffinity(0, sizeof set, &set);
}

/// Each task in a process of its own.
void table(const char* unit, const std::vector<std::size_t>& sizes,
           const std::vector<std::pair<std::string, Prepare>>& tasks) {
  std::vector<Row> rows;
  for (const auto& task : tasks)
    rows.push_back(
        {task.first, [&prepare = task.second](std::size_t n) { return measured([&] { return prepare(n); }); }});
  growth::table(unit, sizes, rows);
}

std::vector<std::size_t> powers(std::size_t first, std::size_t last) {
  std::vector<std::size_t> sizes;
  for (std::size_t n = first; n <= std::min(last, largest); n *= 10) sizes.push_back(n);
  return sizes;
}

/// The file in blocks, and where its lines end.
void find_lines(const std::string& path) {
  std::FILE* file = std::fopen(path.c_str(), "rb");
  std::vector<char> block(1 << 18);
  volatile std::size_t lines = 0;
  while (const std::size_t got = std::fread(block.data(), 1, block.size(), file)) {
    const char *at = block.data(), *end = at + got;
    std::size_t here = 0;
    for (; (at = static_cast<const char*>(std::memchr(at, '\n', static_cast<std::size_t>(end - at)))); ++at) ++here;
    lines = lines + here;
  }
  std::fclose(file);
}

void reading(const Folder& folder) {
  const auto of_file = [&](const std::function<void(const std::string&)>& read) {
    return [&folder, read](std::size_t n) { return Task([path = folder.file(n), read] { read(path); }); };
  };
  const auto on_one = [](const std::function<void(const std::string&)>& read) {
    return [read](const std::string& path) {
      run_on(1);
      read(path);
    };
  };
  const auto load = [](const std::string& path) { load_dataset(path); };
  // What is freed stays with the process and is used again, as two readings beforehand see to: what the system takes to
  // hand out a page, which between machines differs a hundredfold, is none of the time of those that are measured.
  const auto with_memory_at_hand = [&](std::size_t count) {
    return [&folder, load, count](std::size_t n) {
      mallopt(M_MMAP_MAX, 0);
      mallopt(M_TRIM_THRESHOLD, -1);
      run_on(count);
      const std::string path = folder.file(n);
      for (int i = 0; i < 2; ++i) load(path);
      return Task([path, load] { load(path); });
    };
  };
  table("rows read", powers(100, 10000000),
        {{"file read, line ends found (memchr)", of_file(find_lines)},
         {"lines by std::getline", of_file([](const std::string& path) {
            std::ifstream file(path);
            for (std::string line; std::getline(file, line);) {
            }
          })},
         {"rows and fields", of_file([](const std::string& path) { read_csv(path, [](const CsvRow&) {}); })},
         {"rows and numbers", of_file([](const std::string& path) {
            volatile double last = 0;
            read_csv(path, [&](const CsvRow& row) {
              for (std::size_t i = 0; i < row.size(); ++i) last = parse_number(row[i]).value_or(0);
            });
          })},
         {"data set, one processor", of_file(on_one(load))},
         {"data set", of_file(load)},
         {"data set, one processor, memory at hand", with_memory_at_hand(1)},
         {"data set, memory at hand", with_memory_at_hand(processors())}});
}

Prepare fit_task(const Folder& folder, const std::string& model, const FitOptions& options, std::size_t runs = 10) {
  return [&folder, model, options, runs](std::size_t n) {
    return Task([data = load_dataset(folder.file(n, runs)), model, options] { fit_model(data, model, options); });
  };
}

FitOptions with_objective(Objective objective) {
  FitOptions options;
  options.objective = objective;
  return options;
}

void points(const Folder& folder) {
  std::vector<std::pair<std::string, Prepare>> tasks;
  for (const std::string model : {"a", "b", "c"})
    tasks.emplace_back("toughness, model " + model, fit_task(folder, model, with_objective(Objective::toughness)));
  tasks.emplace_back(
      "check", [&](std::size_t n) { return Task([data = load_dataset(folder.file(n))] { find_oddities(data); }); });
  table("points fitted", powers(100, 10000000), tasks);
  tasks.clear();
  for (const std::string model : {"b", "c"})
    tasks.emplace_back("curve, model " + model, fit_task(folder, model, with_objective(Objective::curve)));
  FitOptions unchecked = with_objective(Objective::curve);
  unchecked.checks = false;
  tasks.emplace_back("curve, model b, without checks", fit_task(folder, "b", unchecked));
  table("points fitted", powers(100, 10000000), tasks);
}

void loads(const Folder& folder) {
  const std::size_t n = std::min<std::size_t>(100000, largest);
  std::printf("\n%zu points, spread over so many loads\n", n);
  const auto fit = [&](const std::string& model, const FitOptions& options) {
    return [&folder, model, options, n](std::size_t runs) { return fit_task(folder, model, options, runs)(n); };
  };
  table("loads", powers(1, 10000),
        {{"reading",
          [&folder, n](std::size_t runs) { return Task([path = folder.file(n, runs)] { load_dataset(path); }); }},
         {"toughness, model b", fit("b", with_objective(Objective::toughness))},
         {"curve, model b", fit("b", with_objective(Objective::curve))},
         {"curve, model c", fit("c", with_objective(Objective::curve))}});
}

Dataset mergel() { return load_dataset(MIXITY_ROOT "/data/mergel2018.csv"); }

FitOptions with_bootstrap(std::size_t replicates, unsigned threads) {
  FitOptions options = with_objective(Objective::toughness);
  options.intervals = false;
  options.bootstrap.replicates = replicates;
  options.bootstrap.threads = threads;
  return options;
}

void replicates(const Folder&) {
  std::vector<std::pair<std::string, Prepare>> tasks;
  for (const std::string model : {"a", "b", "c"})
    tasks.emplace_back("bootstrap of 200 points, model " + model, [model](std::size_t n) {
      return Task([data = mergel(), model, n] { fit_model(data, model, with_bootstrap(n, 0)); });
    });
  table("replicates", powers(100, 100000), tasks);
}

void threads(const Folder& folder) {
  std::vector<std::size_t> counts;
  for (std::size_t k = 1; k <= std::max(std::size_t{2}, processors()); k *= 2) counts.push_back(k);
  const std::size_t rows = std::min<std::size_t>(1000000, largest);
  table(
      "threads", counts,
      {{"bootstrap, 10000 replicates, model b",
        [](std::size_t k) {
          return Task([data = mergel(), k] { fit_model(data, "b", with_bootstrap(10000, static_cast<unsigned>(k))); });
        }},
       {"reading " + std::to_string(rows) + " rows", [&folder, rows](std::size_t k) {
          return Task([path = folder.file(rows), k] {
            run_on(k);
            load_dataset(path);
          });
        }}});
}

}  // namespace

int main(int argc, char** argv) {
  using Run = std::function<void(const Folder&)>;
  Programs programs;
  const auto of_programs = [&](void (*run)(const Folder&, const Programs&)) {
    return [&programs, run](const Folder& folder) { run(folder, programs); };
  };
  const std::vector<std::pair<std::string, Run>> known{
      {"reading", reading},
      {"points", points},
      {"loads", loads},
      {"replicates", replicates},
      {"threads", threads},
      {"columns", of_programs(columns)},
      {"fits", [&](const Folder& folder) { fits(folder, programs, powers(100000, 10000000)); }},
      {"laws", of_programs(laws)},
      {"sets", of_programs(sets)},
      {"runs", of_programs(runs)},
      {"files", of_programs(files)}};
  std::vector<std::string> wanted;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word.starts_with("--largest="))
      largest = static_cast<std::size_t>(std::atof(word.c_str() + 10));
    else if (word.starts_with("--program="))
      programs.push_back(word.substr(10));
    else
      wanted.push_back(word);
  }
  if (programs.empty()) programs.emplace_back(MIXITY_PROGRAM);
  const auto is_known = [&](const std::string& word) {
    return std::any_of(known.begin(), known.end(), [&](const auto& task) { return task.first == word; });
  };
  if (largest < 1000 || !std::all_of(wanted.begin(), wanted.end(), is_known)) {
    std::string names;
    for (const auto& task : known) names += (names.empty() ? "" : "|") + task.first;
    std::fprintf(stderr, "growth [--largest=N] [--program=PATH ...] [%s ...], N at least 1000\n", names.c_str());
    return 2;
  }
  const Folder folder;
  for (const auto& [name, run] : known)
    if (wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end()) run(folder);
}
