#include "dataset/exclusion.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <span>

#include "base/phrases.h"
#include "base/units.h"

namespace mixity {
namespace {

std::string file_name(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

/// The runs with this name or load. The name has no blanks around its commas.
std::vector<std::size_t> runs_named(const Dataset& data, const std::string& name) {
  std::vector<std::size_t> runs;
  for (std::size_t i = 0; i < data.curves.size(); ++i)
    if (joined(split(data.curves[i]), ",") == name) runs.push_back(i);
  if (!runs.empty() || !data.has_loads) return runs;
  const auto load = parse_quantity(name);
  const auto force = parse_unit(data.display.force);
  if (!load || load->unit.dimension != (force ? force->dimension : Dimension{})) return runs;
  const double wanted = load->si() / (force ? force->factor : 1) / data.display.force_scale;
  constexpr double kRounding = 1e-3;
  double largest = 0;
  for (const double one : data.curve_loads) largest = std::max(largest, std::abs(one));
  for (std::size_t i = 0; i < data.curves.size(); ++i)
    if (std::abs(data.curve_loads[i] - wanted) <= kRounding * (wanted == 0 ? largest : std::abs(wanted)))
      runs.push_back(i);
  return runs;
}

/// Runs that the first of these texts name, and how many texts: a name or load with commas, such as "0,5 mN", takes
/// several.
std::pair<std::vector<std::size_t>, std::size_t> first_named(const Dataset& data, std::span<const std::string> names) {
  std::size_t most = std::min<std::size_t>(2, names.size());  // "7,73 mN" may be one load
  for (const std::string& name : data.curves) most = std::max(most, split(name).size());
  for (std::size_t n = std::min(most, names.size()); n > 0; --n)
    if (auto runs = runs_named(data, joined(names.first(n), ",")); !runs.empty()) return {std::move(runs), n};
  return {};
}

/// Removes all elements that are not kept; a list may also be empty.
template <class T>
void keep(const std::vector<bool>& kept, std::vector<T>& list) {
  std::size_t to = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!kept[i]) continue;
    if (to != i) list[to] = std::move(list[i]);
    ++to;
  }
  list.resize(to);
}

/// Removes runs without points.
void remove_empty_runs(Dataset& data) {
  std::vector<bool> used(data.curves.size());
  for (const Point& point : data.points) used[point.curve] = true;
  std::vector<std::size_t> number(used.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < used.size(); ++i) number[i] = used[i] ? next++ : 0;
  for (Point& point : data.points) point.curve = static_cast<Point::Index>(number[point.curve]);
  keep(used, data.curves);
  keep(used, data.curve_loads);
  keep(used, data.shear_reversed);
}

}  // namespace

std::optional<LineRange> parse_lines(std::string_view text) {
  const auto number = [](std::string_view digits) -> std::optional<std::size_t> {
    std::size_t value = 0;
    digits = trim(digits);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (digits.empty() || error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
    return value;
  };
  const std::size_t colon = text.rfind(':');
  const std::string file(colon == std::string_view::npos ? "" : trim(text.substr(0, colon)));
  if (colon != std::string_view::npos) text.remove_prefix(colon + 1);
  const std::size_t dash = text.find('-');
  const auto first = number(text.substr(0, dash)),
             last = dash == std::string_view::npos ? first : number(text.substr(dash + 1));
  if (!first || !last || *first < 1 || *last < *first) return std::nullopt;
  return LineRange{*first, *last, file};
}

std::string lines_text(const Dataset& data, const std::vector<std::size_t>& points) {
  constexpr std::size_t kMost = 40;
  std::vector<std::size_t> lines;
  for (const std::size_t i : points) lines.push_back(data.points[i].line);
  std::sort(lines.begin(), lines.end());
  // Runs side by side share lines: excluding one would exclude points that are not listed.
  const auto is_listed = [&](const Point& point) { return std::binary_search(lines.begin(), lines.end(), point.line); };
  if (std::count_if(data.points.begin(), data.points.end(), is_listed) != std::ssize(lines)) return {};
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  std::vector<std::string> ranges;
  for (std::size_t from = 0, to; from < lines.size(); from = to) {
    to = from + 1;
    while (to < lines.size() && lines[to] == lines[to - 1] + 1 && data.file_of(lines[to]) == data.file_of(lines[from]))
      ++to;
    const std::string file = data.files.size() > 1 ? file_name(data.file_of(lines[from])) + ":" : "";
    if (file.find(',') != std::string::npos) return {};
    ranges.push_back(file + std::to_string(data.line_in_file(lines[from])) +
                     (to > from + 1 ? "-" + std::to_string(data.line_in_file(lines[to - 1])) : ""));
  }
  return ranges.size() > kMost ? std::string() : joined(ranges, ",");
}

void exclude(Dataset& data, const Exclusion& which) {
  if (which.lines.empty() && which.runs.empty() && which.unsheared != Unsheared::out) return;
  std::vector<std::string_view> reasons(data.points.size());
  for (const LineRange& range : which.lines) {
    bool any = false;
    if (range.file.empty() && data.files.size() > 1)
      throw InputError(data.path, "is one of several files; lines to exclude need the name of theirs, such as " +
                                      file_name(data.path) + ":" + std::to_string(range.first));
    for (std::size_t i = 0; i < data.points.size(); ++i) {
      const std::size_t line = data.points[i].line, in_file = data.line_in_file(line);
      if (in_file < range.first || in_file > range.last) continue;
      if (!range.file.empty() && range.file != file_name(data.file_of(line))) continue;
      any = true;
      reasons[i] = "named in exclude";
    }
    if (!any)
      throw InputError(data.path, "has no point to exclude in line " + std::to_string(range.first) +
                                      (range.last > range.first ? " to " + std::to_string(range.last) : "") +
                                      " (the header is line 1)");
  }
  if (!which.runs.empty() && joined(data.curves, "").empty())
    throw InputError(data.path, "has no run with a name to leave out (a column 'curve' names the run of each point)");
  for (std::span<const std::string> names = which.runs; !names.empty();) {
    const auto [runs, taken] = first_named(data, names);
    if (runs.empty())
      throw InputError(data.path, "has no run '" + printable(names.front(), std::string::npos) +
                                      "' to leave out (it has " + printable(joined(data.curves), 200) + ")");
    names = names.subspan(taken);
    for (std::size_t i = 0; i < data.points.size(); ++i)
      if (std::find(runs.begin(), runs.end(), data.points[i].curve) != runs.end())
        reasons[i] = "its run is named in leave_out";
  }
  if (which.unsheared == Unsheared::out && data.has_loads) {
    const PointPlaces places(data);
    for (std::size_t i = 0; i < data.points.size(); ++i)
      if (places.at(i).unsheared) reasons[i] = "it is without shear (unsheared=out)";
  }
  exclude_points(reasons, data);
  if (data.points.empty()) throw InputError(data.path, "has no point left after exclude and leave_out");
  remove_empty_runs(data);
}

void exclude_points(const std::vector<std::string_view>& reasons, Dataset& data) {
  std::vector<bool> kept(reasons.size());
  for (std::size_t i = 0; i < reasons.size(); ++i) {
    kept[i] = reasons[i].empty();
    if (!kept[i]) data.excluded.push_back({data.points[i].line, reasons[i]});
  }
  std::sort(data.excluded.begin(), data.excluded.end(),
            [](const Excluded& one, const Excluded& other) { return one.line < other.line; });
  keep(kept, data.points);
  keep(kept, data.converted);
  keep(kept, data.errors);
  keep(kept, data.energies);
  keep(kept, data.axes);
}

}  // namespace mixity
