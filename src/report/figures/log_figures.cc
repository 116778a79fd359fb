#include "report/figures/log_figures.h"

#include <algorithm>

#include "analysis/readable.h"
#include "base/number_text.h"
#include "base/phrases.h"
#include "base/toml_file.h"
#include "base/units.h"

namespace mixity {
namespace {

/// Frames shown beside a run, as a share of its length.
constexpr double kBeside = 0.25;
constexpr std::size_t kMostShown = 1500;

/// The first frame shown and the one after the last.
std::pair<std::size_t, std::size_t> shown_frames(const LoadingRuns& found, const LoadingRun& run) {
  const auto margin = static_cast<std::size_t>(kBeside * static_cast<double>(run.end - run.begin)) + 5;
  return {std::max(run.contact, run.begin > margin ? run.begin - margin : 0),
          std::min({run.last, run.end + 3 * margin, found.frames.time.size()})};
}

/// `value`: of a frame.
template <class Value>
Figure figure_of(const LoadingRuns& found, const LoadingRun& run, std::size_t number, const Value& value,
                 const std::string& quantity, const std::string& unit) {
  const auto [begin, end] = shown_frames(found, run);
  const Frames& frames = found.frames;
  std::vector<double> values;  // only of the frames shown, since a log may have many runs
  for (std::size_t i = begin; i < end; ++i) values.push_back(value(i));
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double room = 0.06 * (*most - *least), low = *least - room, high = *most + room;
  const double first = frames.time[begin], last = frames.time[end - 1];
  Figure figure{.name = "run_" + std::to_string(number) + "_" + quantity,
                .title = plain(run.name),
                .x = {"t [s]", first, last},
                .y = {quantity + " [" + (parse_unit(unit) ? unit : plain(unit)) + "]", low, high},
                .caption = "Points are frames. Kept are " + std::to_string(run.end - run.begin) + " of them."};
  const auto shade = [&](double from, double to, const std::string& label, const std::string& tint) {
    from = std::max(from, first);
    to = std::min(to, last);
    if (to > from)
      figure.series.push_back(
          {label, Look::band, tint, {{from, low}, {to, low}, {to, high}, {from, high}, {from, low}}});
  };
  const double kept_from = frames.time[run.begin], kept_to = run.onset ? run.onset->time : frames.time[run.end - 1];
  shade(first, kept_from, "hold, not kept", color(7));
  shade(kept_from, kept_to, "kept", color(2));
  shade(kept_to, last, run.onset ? "sliding, not kept" : "not kept", color(5));
  Series course{"", Look::circles, color(0)};
  const std::size_t step = std::max<std::size_t>(1, (end - begin) / kMostShown);
  for (std::size_t i = begin; i < end; i += step) course.points.emplace_back(frames.time[i], values[i - begin]);
  figure.series.push_back(std::move(course));
  const auto mark = [&](const CutTime& cut, const std::string& label) {
    if (!cut.stated && cut.high > cut.low) shade(cut.low, cut.high, "", color(0));
    figure.series.push_back({label, Look::dashed, color(0), {{cut.time, low}, {cut.time, high}}});
  };
  mark(run.shear, "cuts, 95% shaded");
  if (run.onset) mark(*run.onset, "");
  return figure;
}

}  // namespace

namespace {

void add_figures(const ReducedLog& log, std::vector<Figure>& figures) {
  const Frames& frames = log.runs.frames;
  for (const LoadingRun& run : log.runs.runs) {
    const std::size_t number = figures.size() / 2 + 1;
    const auto T = [&](std::size_t i) { return (run.direction * frames.T[i] - run.baseline) / log.force_factor; };
    const auto A = [&](std::size_t i) { return frames.A[i] / log.area_factor; };
    Series peaks{"maximum of T", Look::squares, color(1)}, minima{"minimum behind it", Look::circles, color(2)};
    for (const Cycle& cycle : run.cycles) {
      peaks.points.emplace_back(cycle.time, cycle.T_peak / log.force_factor);
      if (cycle.T_min) minima.points.emplace_back(cycle.time_min, *cycle.T_min / log.force_factor);
    }
    figures.push_back(figure_of(log.runs, run, number, T, "T", log.force_unit));
    for (Series* marks : {&peaks, &minima})
      if (!marks->points.empty()) figures.back().series.push_back(std::move(*marks));
    figures.back().title = "T(t) at " + figures.back().title;
    if (!run.cycles.empty()) figures.back().caption += " Squares: maxima of T, circles: the minima behind them.";
    figures.push_back(figure_of(log.runs, run, number, A, "A", log.area_unit));
  }
}

}  // namespace

std::vector<Figure> log_figures(const ReducedLogs& logs) {
  std::vector<Figure> figures;
  for (const ReducedLog& log : logs) add_figures(log, figures);
  return figures;
}

std::string runs_definition(const std::vector<Figure>& figures) {
  std::vector<std::string> list;
  for (const Figure& figure : figures)
    if (figure.name.ends_with("_T")) list.push_back(toml_text("figures/" + figure.name + ".svg"));
  return "data = \"runs.csv\"\npeaks = \"peaks.csv\"\n" +
         (list.empty() ? "" : joined(list, ", ", "log_figures = [") + "]\n");
}

}  // namespace mixity
