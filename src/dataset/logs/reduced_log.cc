#include "dataset/logs/reduced_log.h"

#include <algorithm>
#include <cmath>

#include "base/files.h"
#include "base/input_error.h"
#include "base/phrases.h"
#include "base/text.h"
#include "base/toml_file.h"
#include "base/units.h"
#include "dataset/logs/clocks.h"
#include "dataset/logs/coarse_lag.h"
#include "dataset/logs/contacts.h"
#include "dataset/table/column_names.h"
#include "dataset/table/mapped_columns.h"
#include "dataset/table/several_tables.h"
#include "statistics/noise.h"
#include "statistics/readings.h"

namespace mixity {
namespace {

/// Throws for a quantity of the mapping whose column is in none of the files. `files`: those that were read; the
/// headings of the others are read for the message alone.
void require_mapped(const std::vector<std::string>& paths, const std::vector<std::vector<Recording>>& files,
                    Metadata metadata, Inputs& inputs) {
  ColumnRules rules;
  rules.mapping = metadata.columns;
  std::string there;
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const std::vector<Heading> headings =
        k < files.size() ? files[k].front().headings : headings_of_log(paths[k], metadata, inputs);
    for (const ColumnId id : mapped_in(headings, rules)) metadata.columns.erase(std::string(to_string(id)));
    Table table;
    table.headings = headings;
    there += (there.empty() ? "" : "; ") + headings_text(table);
  }
  for (const auto& [name, heading] : metadata.columns)
    throw InputError(paths[0], "no column '" + heading + "', which is to be " + name + ", and none in " +
                                   (paths.size() == 2 ? paths[1] : "the others") + "; there are " + there);
}

/// The recordings of one log: of forces and areas, or of forces and then of areas.
using Recordings = std::vector<Recording>;

bool is_complete(const Recording& one) { return one.holds_forces() && one.holds_areas(); }

/// The logs of a pair of files. The first with forces provides them.
void add_pair(Recordings& one, Recordings& other, std::vector<Recordings>& logs) {
  Recordings &forces = one[0].holds_forces() ? one : other, &areas = one[0].holds_forces() ? other : one;
  if (!forces[0].holds_forces())
    throw InputError(other[0].path, "holds no forces, and neither does " + one[0].path +
                                        (one[0].advice.empty() ? other[0].advice : one[0].advice));
  if (!areas[0].holds_areas()) throw InputError(areas[0].path, "holds no areas" + areas[0].advice);
  if (forces.size() != areas.size())
    throw InputError(forces[0].path, "has " + std::to_string(forces.size()) + " logs, as its clock starts anew, and " +
                                         areas[0].path + " has " + std::to_string(areas.size()));
  for (std::size_t i = 0; i < forces.size(); ++i) logs.push_back({std::move(forces[i]), std::move(areas[i])});
}

/// The logs of files that hold both, and of files in pairs. A file that holds both is a log of its own, unless the
/// number of those that do not and stand behind it is odd: then it is one of a pair.
std::vector<Recordings> logs_of(std::vector<Recordings> files) {
  std::vector<Recordings> logs;
  const auto part_from = [&](std::size_t k) {
    return static_cast<std::size_t>(std::find_if(files.begin() + static_cast<std::ptrdiff_t>(k), files.end(),
                                                 [](const Recordings& file) { return is_complete(file.front()); }) -
                                    files.begin());
  };
  for (std::size_t k = 0; k < files.size();) {
    if (is_complete(files[k].front()) && (part_from(k + 1) - k) % 2 == 1) {
      for (Recording& one : files[k]) logs.push_back({std::move(one)});
      ++k;
      continue;
    }
    const Recording& first = files[k].front();
    if (k + 1 == files.size())
      throw InputError(first.path, std::string("holds no ") + (first.holds_forces() ? "areas" : "forces") +
                                       first.advice + (first.advice.empty() ? "; " : "; if it is none of these, ") +
                                       "name the file that does, too: mixity runs FORCES.csv AREAS.csv");
    add_pair(files[k], files[k + 1], logs);
    k += 2;
  }
  return logs;
}

std::vector<Recordings> read_logs(const std::vector<std::string>& paths, const Overrides& constants, Inputs& inputs,
                                  Metadata& metadata) {
  if (const auto again = named_twice(paths)) throw InputError(*again, "is named twice: its runs would count twice");
  std::vector<Recordings> files;
  std::vector<Metadata> stated;
  for (const std::string& path : paths) {
    stated.push_back(metadata_of(path, constants, inputs));
    apply_overrides(constants, stated.back());
  }
  // One mapping for all files, as an option, a definition or equal files beside them state it: each has its part of it.
  const Metadata& common = stated.front();
  const bool mapped =
      paths.size() > 1 && !common.columns.empty() &&
      std::all_of(stated.begin(), stated.end(), [&](const Metadata& one) { return one.columns == common.columns; });
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const std::string& path = paths[k];
    const Metadata& own = stated[k];
    try {
      files.push_back(read_recordings(path, own, inputs, mapped));
    } catch (const InputError&) {
      if (mapped) require_mapped(paths, files, common, inputs);
      throw;
    }
    if (files.size() == 1)
      metadata = own;
    else if (const std::string problem = add_constants(own, metadata); !problem.empty())
      throw InputError(metadata_path(path), problem);
  }
  if (mapped) require_mapped(paths, files, common, inputs);
  return logs_of(std::move(files));
}

/// The columns of both recordings of a log. If they find a quantity in columns of different names, as `stated`, if it
/// is.
std::map<std::string, std::string> common_mapping(const Recordings& recordings,
                                                  const std::map<std::string, std::string>& stated) {
  std::map<std::string, std::string> mapping = recordings.front().mapping;
  for (const auto& [quantity, column] : recordings.back().mapping)
    if (const auto [one, is_new] = mapping.emplace(quantity, column); !is_new && one->second != column) {
      mapping.erase(one);
      if (const auto given = stated.find(quantity); given != stated.end()) mapping.insert(*given);
    }
  return mapping;
}

/// Correlation of load and area; 0 if one of them is constant.
double correlation(const std::vector<double>& P, const std::vector<double>& A) {
  if (P.empty()) return 0;
  const double P_mean = mean_of(P, 0, P.size()), A_mean = mean_of(A, 0, A.size());
  double pp = 0, pa = 0, aa = 0;
  for (std::size_t i = 0; i < P.size(); ++i) {
    const double p = P[i] - P_mean, a = A[i] - A_mean;
    pp += p * p;
    pa += p * a;
    aa += a * a;
  }
  return pp > 0 && aa > 0 ? pa / std::sqrt(pp * aa) : 0;
}

/// Whether compression is negative in the log: P is lower in contact than out of it, and the area grows as P falls.
/// False if the data do not show this, for example if the load hardly changes in contact.
bool compression_is_negative(const Recording& forces, const Recording& areas, double lag) {
  constexpr double kOfAll = -0.5, kOfContact = -0.3, kChanges = 0.2;
  Frames frames;
  try {
    frames = make_frames(forces, areas, lag);
  } catch (const InputError&) {  // no overlap in time; reported when frames are needed
    return false;
  }
  std::vector<double> P, A;    // in contact
  double least = 0, most = 0;  // of P in contact, minus its zero
  const auto touching = contacts(frames, noise_of(frames.A));
  const double zero = load_zero(frames, touching).value;
  for (const FrameRange& contact : touching)
    for (std::size_t i = contact.begin; i < contact.end; ++i) {
      P.push_back(frames.P[i]);
      A.push_back(frames.A[i]);
      least = std::min(least, frames.P[i] - zero);
      most = std::max(most, frames.P[i] - zero);
    }
  return -least > most && most - least > kChanges * -least && correlation(frames.P, frames.A) < kOfAll &&
         correlation(P, A) < kOfContact;
}

/// The lag at which areas follow P best, for either sign of compression; 0 if they do not.
double lag_either_way(const Recording& forces, const Recording& areas) {
  const Pictures shown = pictures(areas);
  if (shown.time.size() < 3) return 0;
  const auto positive = lag_by_load(forces, shown), negative = lag_by_load(forces, shown, true);
  const auto& best = negative && (!positive || negative->correlation > positive->correlation) ? negative : positive;
  return best ? best->lag : 0;
}

ReducedLog reduced(Recordings recordings, const Metadata& metadata, std::optional<double> lag,
                   const RunOptions& options) {
  ReducedLog log;
  log.metadata = metadata;
  log.mapping = common_mapping(recordings, metadata.columns);
  Recording& forces = recordings.front();
  const Recording& areas = recordings.back();
  const bool two = recordings.size() > 1;
  log.areas_path = areas.path;
  if (two) log.areas_clock = areas.clock;
  log.force_unit = forces.force_unit;
  log.force_factor = forces.force_factor;
  log.area_unit = areas.area_unit;
  log.area_factor = areas.area_factor;
  log.load_turned = compression_is_negative(forces, areas, lag.value_or(two ? lag_either_way(forces, areas) : 0));
  if (log.load_turned) {
    for (double& P : forces.P) P = 0 - P;
    if (log.metadata.load_offset) *log.metadata.load_offset = 0 - *log.metadata.load_offset;
  }
  log.runs = find_loading_runs(on_one_clock(forces, areas, lag), log.force_unit, log.force_factor, options);
  forces.time = forces.P = forces.T = forces.A = {};
  log.forces = std::move(forces);
  return log;
}

}  // namespace

ReducedLogs reduce_logs(const std::vector<std::string>& paths, const Overrides& constants,
                        const ReductionOptions& options) {
  constexpr std::size_t kShown = 200;
  Inputs inputs = options.inputs;
  RunOptions run_options;
  run_options.drift = options.drift;
  if (!options.cuts_path.empty()) run_options.cuts = read_cuts(options.cuts_path, inputs);
  Metadata metadata;
  ReducedLogs logs;
  std::vector<Recordings> all = read_logs(paths, constants, inputs, metadata);
  const std::vector<InputFile> read = inputs.without_contents();
  inputs = {};
  const bool pairs = std::any_of(all.begin(), all.end(), [](const Recordings& one) { return one.size() > 1; });
  for (Recordings& recordings : all) {
    const auto lag = pairs && recordings.size() == 1 ? std::nullopt : options.lag;  // a lag is between two clocks
    logs.push_back(reduced(std::move(recordings), metadata, lag, run_options));
    if (metadata.load_offset && logs.back().load_turned != logs.front().load_turned)
      throw InputError(logs.back().forces.path,
                       "has the other sign of compression than " + logs.front().forces.path +
                           ", and one load_offset is stated for both: reverse P in one of the files");
    const LoadingRuns& found = logs.back().runs;
    for (const LoadingRun& run : found.runs) run_options.taken.push_back(run.name);
    run_options.taken.insert(run_options.taken.end(), found.left_out.begin(), found.left_out.end());
  }
  const std::vector<std::string>& names = run_options.taken;
  for (const auto& [name, cut] : run_options.cuts)
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw InputError(options.cuts_path, (cut.leave_out ? "leaves out a run '" : "states cuts of a run '") +
                                              printable(name, std::string::npos) +
                                              "', which the log does not have (it has " +
                                              printable(joined(names), kShown) + ")");
  logs.front().inputs = read;
  return logs;
}

std::vector<UnderstoodFile> understood(const ReducedLogs& logs) {
  std::vector<UnderstoodFile> files;
  for (const ReducedLog& log : logs) {
    files.push_back({log.forces.path, log.metadata, log.mapping});
    if (auto& offset = files.back().metadata.load_offset; offset && log.load_turned) *offset = 0 - *offset;
  }
  return files;
}

std::map<std::string, StatedCut> read_cuts(const std::string& path, Inputs& inputs) {
  std::map<std::string, StatedCut> cuts;
  for (const auto& [key, node] : read_toml(path, inputs)) {
    if (key != "cuts" || !node.is_array_of_tables()) fail_at(path, key, "holds tables [[cuts]] and nothing else");
    for (const toml::node& entry : *node.as_array()) {
      std::string name;
      StatedCut cut;
      cut.file = path;
      for (const auto& [item, value] : *entry.as_table()) {
        const auto time = [&, &item = item, &value = value]() -> double {
          const auto quantity = value.is_string() ? parse_quantity(value.as_string()->get()) : std::nullopt;
          if (!quantity || quantity->unit.dimension != dimension::time)
            fail_at(path, value, std::string(item.str()) + " must be a time such as \"4.31 s\"");
          return quantity->si();
        };
        const FilePlace place{value.source().begin.line, value.source().begin.column};
        if (item == "run" && value.is_string())
          name = value.as_string()->get();
        else if (item == "shear") {
          cut.shear = time();
          cut.shear_place = place;
        } else if (item == "onset") {
          cut.onset = time();
          cut.onset_place = place;
        } else if (item == "leave_out" && value.is_boolean())
          cut.leave_out = value.as_boolean()->get();
        else
          fail_at(path, item,
                  "unknown key \"" + std::string(item.str()) + "\" or a wrong kind of value" +
                      did_you_mean(item.str(), {"run", "shear", "onset", "leave_out"}) +
                      " (known: run, a text; shear and onset, times; leave_out, true or false)");
      }
      if (name.empty()) fail_at(path, entry, "a cut needs the name of its run: run = \"P=4.68 mN\"");
      if (cut.shear && cut.onset && !(*cut.onset > *cut.shear))
        fail_at(path, entry, "the onset is not later than the start of the shear");
      if (!cuts.emplace(name, cut).second) fail_at(path, entry, "a second cut of run '" + name + "'");
    }
  }
  return cuts;
}

}  // namespace mixity
