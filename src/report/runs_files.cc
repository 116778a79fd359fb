#include "report/runs_files.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <optional>
#include <sstream>

#include "base/number_text.h"
#include "base/phrases.h"
#include "base/text.h"
#include "base/toml_file.h"
#include "report/csv_table.h"
#include "report/figures/drawn_figures.h"
#include "report/figures/log_figures.h"
#include "report/json.h"

namespace mixity {
namespace {

/// Enough digits to distinguish readings: 1e-6 of the largest is far below any noise.
constexpr int kDigits = 7;
std::string reading(double value) { return rounded(value, kDigits); }

/// A time to a hundredth of a frame.
std::string time_text(double seconds, double interval) {
  const int digits =
      std::max(1, 2 + static_cast<int>(std::ceil(std::log10(std::max(std::abs(seconds), interval) / interval))));
  return rounded(seconds, digits);
}

std::string cut_text(const CutTime& cut, double interval) {
  const std::string at = time_text(cut.time, interval) + " s";
  return cut.stated ? at + " as stated"
                    : at + " (95% " + time_text(cut.low, interval) + " .. " + time_text(cut.high, interval) + ")";
}

std::string lag_text(double lag, double error) {
  const RoundedToError text = rounded_to_error(lag, error);
  return text.value + " s +/- " + text.error + " s";
}

std::string lag_text(const Frames& frames) {
  return frames.lag_parts.empty() ? rounded(frames.lag, 4) + " s" : lag_text(frames.lag, frames.lag_error);
}

/// The file, and the line of the log if it is one of several.
std::string name_of(const Recording& log) {
  return log.path + (log.line > 0 ? " from line " + std::to_string(log.line) : "");
}

std::string force_text(const ReducedLog& log, double value, int digits) {
  return rounded(value / log.force_factor, digits) + " " + log.force_unit;
}

/// How a clock coarser than its rows was handled; `file` is empty if there is only one.
std::string clock_text(const TimeBase& clock, const std::string& file) {
  const std::string whose = file.empty() ? "" : " of " + printable(file, std::string::npos);
  std::string text;
  if (clock.repeated > 0)
    text += "    times" + whose + ": " + counted(clock.repeated, "row") + " the same as the row before, left out\n";
  if (clock.shared > 0)
    text += "    times" + whose + ": " + std::to_string(clock.shared) + " rows share a stamp of " +
            rounded(clock.stamp, 3) + " s: spread evenly\n";
  return text;
}

}  // namespace

std::string runs_csv(const ReducedLogs& logs) {
  struct Row {
    const Frames& frames;
    const LoadingRun& run;
    std::size_t k;  // index among its frames
    std::size_t frame() const { return run.begin + k; }
  };
  const ReducedLog& first = logs.front();
  const std::string &force = first.force_unit, &area = first.area_unit;
  CsvTable<Row> column;
  column("curve", [](auto& row) { return row.run.name; });
  column("time [s]", [&](auto& row) { return reading(row.frames.time[row.frame()]); });
  column.quantity("P", force, kDigits, [&](auto& row) { return row.run.smooth_P[row.k] / first.force_factor; });
  column.quantity("T", force, kDigits, [&](auto& row) { return row.run.T[row.k] / first.force_factor; });
  column.quantity("A", area, kDigits, [&](auto& row) { return row.frames.A[row.frame()] / first.area_factor; });
  column.quantity("sigma_T", force, 3, [&](auto& row) { return row.run.sigma_T[row.k] / first.force_factor; });
  column.quantity("sigma_A", area, 3, [&](auto& row) { return row.run.sigma_A[row.k] / first.area_factor; });
  // beside the areas, of which they have the size
  const bool axes = std::any_of(logs.begin(), logs.end(), [](const auto& log) { return !log.runs.frames.q.empty(); });
  for (const double side : {0.5, -0.5})
    if (axes)
      column.quantity(side > 0 ? "a_par" : "a_perp", "mm", kDigits, [side](auto& row) {
        const Frames& frames = row.frames;
        const double mean = std::sqrt(frames.A[row.frame()] / std::numbers::pi) / 1e-3;
        const bool known = !frames.q.empty() && std::isfinite(frames.q[row.frame()]);
        return known ? std::optional(mean * std::exp(side * frames.q[row.frame()])) : std::nullopt;
      });
  for (const ReducedLog& log : logs)
    for (const LoadingRun& run : log.runs.runs)
      for (std::size_t k = 0; k < run.T.size(); ++k) column.add({log.runs.frames, run, k});
  return column.text();
}

std::string runs_toml(const ReducedLogs& logs) {
  std::ostringstream out;
  const ReducedLog& log = logs.front();
  for (const auto& [name, text] : constants_as_stated(log.metadata)) out << name << " = " << toml_text(text) << '\n';
  // a common offset takes the errors of independent zeros as one: intervals are rather too wide
  const auto root_mean_square = [&](double LoadingRuns::*error) {
    double squares = 0;
    for (const ReducedLog& one : logs) squares += std::pow(one.runs.*error, 2);
    return std::sqrt(squares / static_cast<double>(logs.size()));
  };
  // offsets of 0 with the standard errors of the subtracted zeros
  const auto write_offset = [&](const char* name, bool stated, double error) {
    if (!stated && error > 0)
      out << name << " = \"0 +/- " << rounded(error / log.force_factor, 2) << ' ' << log.force_unit << "\"\n";
  };
  write_offset("load_offset", log.metadata.load_offset.has_value(), root_mean_square(&LoadingRuns::zero_P_error));
  write_offset("shear_offset", log.metadata.shear_offset.has_value(), root_mean_square(&LoadingRuns::zero_T_error));
  if (log.metadata.provenance != Provenance::unstated)
    out << "provenance = \"" << to_string(log.metadata.provenance) << "\"\n";
  for (const ReducedLog& one : logs)
    if (!one.runs.frames.lag_parts.empty())
      out << "# lag of the clocks " << lag_text(one.runs.frames) << " (" << one.runs.frames.lag_source << ")\n";
  std::vector<std::string> paths;
  for (const ReducedLog& one : logs)
    if (paths.empty() || paths.back() != one.forces.path) paths.push_back(one.forces.path);
  const std::string name = data_name(paths.front());
  out << "title = " << toml_text(log.metadata.title.empty() ? "runs of " + name : log.metadata.title) << '\n';
  const std::string made = "runs of " + joined(paths, ", ") + ", made by mixity runs";
  out << "source = " << toml_text(log.metadata.source.empty() ? made : log.metadata.source + "; " + made) << '\n';
  if (!log.metadata.note.empty()) out << "note = " << toml_text(log.metadata.note) << '\n';
  return out.str();
}

std::string log_json(const ReducedLogs& logs) {
  Json times = Json::array(), lags = times;
  for (const ReducedLog& log : logs) {
    const auto add_times = [&](const std::string& file, const TimeBase& clock) {
      times.push_back({{"file", file},
                       {"stamp_s", clock.stamp},
                       {"rows_sharing_a_stamp", clock.shared},
                       {"rows_repeated", clock.repeated}});
    };
    add_times(log.forces.path, log.forces.clock);
    if (log.areas_path != log.forces.path) add_times(log.areas_path, log.areas_clock);
    const Frames& frames = log.runs.frames;
    Json lag{{"value_s", frames.lag}, {"stderr_s", frames.lag_error}, {"source", frames.lag_source}};
    if (!frames.lag_parts.empty()) {
      lag["interval_s"] = {{"low", frames.lag_low}, {"high", frames.lag_high}};
      lag["disagree"] = frames.lags_disagree;
      for (const LagPart& part : frames.lag_parts)
        lag["parts"].push_back(
            {{"by", part.by}, {"events", part.events}, {"value_s", part.lag}, {"stderr_s", part.error}});
    }
    lags.push_back(std::move(lag));
  }
  Json json{{"times", times}, {"lag", lags.front()}};
  for (const InputFile& file : logs.front().inputs)
    json["inputs"].push_back({{"path", file.path}, {"bytes", file.bytes}, {"xxh128", file.hash}});
  if (logs.size() > 1) json["lags"] = lags;  // of each log
  return json.dump(2) + "\n";
}

std::string peaks_csv(const ReducedLogs& logs) {
  const ReducedLog& first = logs.front();
  struct Row {
    const LoadingRun& run;
    std::size_t k;  // index among its cycles
    const Cycle& cycle() const { return run.cycles[k]; }
  };
  const auto if_minimum = [&](const Row& row, double value) {
    return row.cycle().T_min ? std::optional(value / first.force_factor) : std::nullopt;
  };
  const std::string& force = first.force_unit;
  CsvTable<Row> column;
  column("run", [](auto& row) { return row.run.name; });
  column.quantity("P", force, kDigits, [&](auto& row) { return row.run.P / first.force_factor; });
  column("cycle", [](auto& row) { return row.k + 1; });
  column("time [s]", [](auto& row) { return reading(row.cycle().time); });
  column.quantity("T_peak", force, kDigits, [&](auto& row) { return row.cycle().T_peak / first.force_factor; });
  column.quantity("T_min", force, kDigits, [&](auto& row) { return if_minimum(row, row.cycle().T_min.value_or(0)); });
  column.quantity("sigma_T_peak", force, 3, [&](auto& row) { return row.cycle().error_peak / first.force_factor; });
  column.quantity("sigma_T_min", force, 3, [&](auto& row) { return if_minimum(row, row.cycle().error_min); });
  for (const ReducedLog& log : logs)
    for (const LoadingRun& run : log.runs.runs)
      for (std::size_t k = 0; k < run.cycles.size(); ++k) column.add({run, k});
  return column.text();
}

std::string phases_csv(const ReducedLogs& logs) {
  struct Row {
    const ReducedLog& log;
    const Phase& phase;
    double time(std::size_t frame) const { return log.runs.frames.time[frame]; }
  };
  CsvTable<Row> column;
  column("phase", [](auto& row) { return row.phase.name; });
  column("from [s]", [](auto& row) { return reading(row.time(row.phase.begin)); });
  column("to [s]", [](auto& row) { return reading(row.time(row.phase.end - 1)); });
  column("frames", [](auto& row) { return row.phase.end - row.phase.begin; });
  column("kept", [](auto& row) { return row.phase.reason.empty(); });
  column("reason", [](auto& row) { return row.phase.reason; });
  if (logs.size() > 1) column("log", [](auto& row) { return name_of(row.log.forces); });
  for (const ReducedLog& log : logs)
    for (const Phase& phase : log.runs.phases) column.add({log, phase});
  return column.text();
}

std::string cuts_toml(const ReducedLogs& logs, Wording words) {
  std::ostringstream out;
  std::vector<std::string> names;
  for (const ReducedLog& log : logs) names.push_back(printable(name_of(log.forces), std::string::npos));
  out << "# The cuts of " << joined(names, ", ") << ". Change a time and run again with "
      << words(Remedy::fill_in("cuts", "THIS FILE")) << "; leave_out = true drops a run.\n";
  for (const ReducedLog& log : logs) {
    if (log.areas_path != log.forces.path || logs.size() > 1)
      out << (&log == logs.data() ? "" : "\n") << "# Times are those of the clock of "
          << printable(log.areas_path, std::string::npos) << ".\n";
    const double interval = log.runs.frames.interval;
    const auto write_cut = [&](const char* name, const CutTime& cut) {
      out << name << " = \"" << time_text(cut.time, interval) << " s\"";
      if (!cut.stated) out << "  # " << cut_text(cut, interval);
      out << '\n';
    };
    for (const LoadingRun& run : log.runs.runs) {
      out << "\n[[cuts]]\nrun = " << toml_text(run.name) << '\n';
      write_cut("shear", run.shear);
      if (run.onset)
        write_cut("onset", *run.onset);
      else
        out << "# onset: none was seen; the run goes on to its largest T\n";
    }
  }
  return out.str();
}

namespace {

/// How a log was read.
std::string log_text(const ReducedLog& log, Wording words) {
  std::ostringstream out;
  const LoadingRuns& found = log.runs;
  const Frames& frames = found.frames;
  const auto force = [&](double value, int digits) { return force_text(log, value, digits); };
  out << "[[Log]]\n    " << printable(name_of(log.forces), std::string::npos);
  if (log.areas_path != log.forces.path) out << " and " << printable(log.areas_path, std::string::npos);
  out << "\n    read as: " << log.forces.reading << '\n';
  if (!log.forces.taken.empty()) out << joined(log.forces.taken, ", ", "    columns: ") << '\n';
  const bool two = log.areas_path != log.forces.path;
  out << clock_text(log.forces.clock, two ? log.forces.path : "") << clock_text(log.areas_clock, log.areas_path);
  out << "    " << frames.time.size() << " frames, " << rounded(1 / frames.interval, 3) << " a second, "
      << rounded(frames.samples, 3) << " samples of the force in each; lag of the clocks " << lag_text(frames) << " ("
      << frames.lag_source << ")\n";
  if (frames.lags_disagree) {
    out << "    warning: the clocks of " << printable(log.forces.path, std::string::npos) << " and "
        << printable(log.areas_path, std::string::npos) << " have two lags:";
    for (const LagPart& part : frames.lag_parts)
      out << (&part == frames.lag_parts.data() ? " " : ", ") << lag_text(part.lag, part.error) << " by " << part.by;
    out << "; " << words(Remedy::fill_in("lag")) << " states it\n";
  }
  if (frames.spikes > 0)
    out << "    " << frames.spikes
        << (frames.spikes == 1 ? " force sample was an outlier and was" : " force samples were outliers and were")
        << " replaced by the median of " << (frames.spikes == 1 ? "its" : "their") << " neighbours\n";
  if (found.zero_P_error > 0)
    out << "    P reads " << force(log.load_turned ? 0 - found.zero_P : found.zero_P, 3)
        << " out of contact; subtracted\n";
  else if (!frames.load_is_stated)
    out << "    there are too few readings out of contact to find the zero of P: no zero was subtracted\n";
  if (found.drift_removed || found.drifts) {
    const std::string other = words(Remedy::set("zero_drift", found.drift_removed ? "false" : "true"));
    out << "    the zero of T drifts by " << force(found.drift_T, 2) << " a second from run to run; "
        << (found.drift_removed ? "this drift was also subtracted within runs (" + other + " leaves it)"
                                : other + " also subtracts this drift within runs")
        << '\n';
  }
  if (log.load_turned) out << "    P is negative in compression there and was reversed (P -> -P)\n";
  return out.str();
}

/// Its runs, each with its cuts.
std::string loading_runs_text(const ReducedLog& log, bool several) {
  std::ostringstream out;
  const LoadingRuns& found = log.runs;
  const Frames& frames = found.frames;
  const auto force = [&](double value, int digits) { return force_text(log, value, digits); };
  out << "[[Loading runs]]";
  if (several || log.areas_path != log.forces.path)
    out << "  times on the clock of " << printable(log.areas_path, std::string::npos);
  out << '\n';
  if (found.runs.empty()) out << "    none\n";
  for (const LoadingRun& run : found.runs) {
    out << "    " << run.name << ": " << run.T.size() << " frames, P = " << force(run.P, 4) << " +/- "
        << force(run.scatter_P, 2) << ", T to " << force(*std::max_element(run.T.begin(), run.T.end()), 4)
        << (run.direction < 0 ? " (reversed)" : "") << "\n        zero of T " << force(run.baseline, 3) << ", noise "
        << force(run.sigma_T.front(), 2) << " in T, " << rounded(run.sigma_A.front() / log.area_factor, 2) << " "
        << log.area_unit << " in A\n        shear from " << cut_text(run.shear, frames.interval) << "; "
        << (run.onset ? "sliding from " + cut_text(*run.onset, frames.interval)
                      : std::string("no onset of sliding seen, kept to the largest T"))
        << '\n';
    if (!run.cycles.empty())
      out << "        " << counted(run.cycles.size(), "fall") << " of T, the first from "
          << force(run.cycles.front().T_peak, 4)
          << (run.cycles.front().T_min ? " to " + force(*run.cycles.front().T_min, 4) : std::string()) << '\n';
  }
  return out.str();
}

}  // namespace

std::string runs_text(const ReducedLogs& logs, Wording words) {
  std::string text;
  std::map<std::string_view, std::size_t> left;
  for (const ReducedLog& log : logs) {
    text += log_text(log, words) + loading_runs_text(log, logs.size() > 1);
    for (const Phase& phase : log.runs.phases)
      if (!phase.reason.empty()) left[phase.reason] += phase.end - phase.begin;
  }
  text += "[[Frames left out]]\n";
  for (const auto& [reason, count] : left) text += "    " + std::to_string(count) + ": " + std::string(reason) + '\n';
  return text;
}

bool has_no_run(const ReducedLogs& logs) {
  return std::all_of(logs.begin(), logs.end(), [](const ReducedLog& log) { return log.runs.runs.empty(); });
}

RunsOutput runs_output(const ReducedLogs& logs, const std::string& folder, const FigureFormats& formats,
                       const std::string& cuts_path, Wording words, const Progress& progress) {
  const std::vector<Figure> figures = log_figures(logs);
  DrawnFigures drawn = draw_figures(figures, folder + "/figures", formats, progress);
  std::vector<OutputFile> files = std::move(drawn.files);
  const std::string in = folder + "/";
  files.insert(files.end(), {{in + "runs.csv", runs_csv(logs)},
                             {in + "runs.toml", runs_toml(logs)},
                             {in + "peaks.csv", peaks_csv(logs)},
                             {in + "peaks.toml", runs_toml(logs)},
                             {in + "phases.csv", phases_csv(logs)},
                             {in + "log.json", log_json(logs)},
                             {in + "cuts.toml", cuts_toml(logs, words)},
                             {in + "fit.toml", runs_definition(figures)}});
  std::error_code unread;
  std::erase_if(files, [&](const OutputFile& file) {
    return !cuts_path.empty() && std::filesystem::equivalent(file.path, cuts_path, unread);
  });
  return {std::move(files), std::move(drawn.missing)};
}

void refuse_without_runs(const std::string& path) {
  throw InputError(path, "holds no loading run: no contact under one load in which T rises");
}

}  // namespace mixity
