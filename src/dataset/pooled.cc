#include "dataset/pooled.h"

#include <glob.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "base/files.h"
#include "base/number_text.h"
#include "base/phrases.h"
#include "dataset/signs.h"
#include "dataset/table/number.h"

namespace mixity {
namespace {

/// "run_9" before "run_10".
bool by_number(const std::string& one, const std::string& other) {
  std::size_t i = 0, j = 0;
  while (i < one.size() && j < other.size()) {
    if (is_digit(one[i]) && is_digit(other[j])) {
      std::size_t first = 0, second = 0;
      const auto left = std::from_chars(one.data() + i, one.data() + one.size(), first).ptr;
      const auto right = std::from_chars(other.data() + j, other.data() + other.size(), second).ptr;
      if (first != second) return first < second;
      i = static_cast<std::size_t>(left - one.data());
      j = static_cast<std::size_t>(right - other.data());
    } else {
      if (one[i] != other[j]) return one[i] < other[j];
      ++i;
      ++j;
    }
  }
  return one.size() - i < other.size() - j;
}

/// The common beginning of the files' names, without numbers and signs at its end. If empty, the folder's name.
std::string common_name(const std::vector<RunFile>& files) {
  std::string name = data_name(files.front().path);
  for (const RunFile& file : files) {
    const std::string other = data_name(file.path);
    name.resize(static_cast<std::size_t>(std::mismatch(name.begin(), name.end(), other.begin(), other.end()).first -
                                         name.begin()));
  }
  const std::size_t last = name.find_last_not_of("0123456789_-.+ ");
  name.resize(last == std::string::npos ? 0 : last + 1);
  if (!name.empty()) return name;
  const std::string folder =
      std::filesystem::absolute(files.front().path).lexically_normal().parent_path().filename().string();
  return folder.empty() ? "runs" : printable(folder, std::string::npos);
}

/// Appends a list for `more_size` items to another. Either may be empty, which means default values for its items.
template <class T>
void append(const std::vector<T>& more, std::size_t more_size, std::vector<T>& all, std::size_t size) {
  if (all.empty() && more.empty()) return;
  all.resize(size);
  all.insert(all.end(), more.begin(), more.end());
  all.resize(size + more_size);
}

/// Adds a note on the scale factors of a run on another sphere.
void note_sphere(const Dataset& part, const std::string& name, Dataset& whole) {
  if (!part.contact || part.contact->radius == whole.contact->radius) return;
  whole.several_spheres = true;
  const double times = whole.contact->radius / part.contact->radius;
  whole.notes.push_back(name + ": on a sphere of " + rounded(part.contact->radius * 1e3, 6) +
                        " mm; shown as the equivalent contact on " + rounded(whole.contact->radius * 1e3, 6) +
                        " mm, with " + rounded(times, 4) + " times the load and shear and " +
                        rounded(std::cbrt(times * times * times * times), 4) + " times the area");
}

/// Adds the runs of a file.
void add(Dataset part, const RunFile& file, DistinctNames& names, Dataset& whole) {
  if (!part.has_loads) throw InputError(part.path, "holds no loads; only runs with P, T and A make one data set");
  if (whole.contact.has_value() != part.contact.has_value())
    throw InputError(part.path, "is dimensionless where others have units, or the other way round");
  const std::size_t first_line = whole.files.back().first_line, first_run = whole.curves.size(),
                    runs = part.curves.size(), points = part.points.size();
  if (whole.holds_approach() && part.contact && part.contact->radius != whole.contact->radius)
    throw InputError(part.path, "is on another sphere: runs under a held approach are of one sphere");
  const std::string name = file.name.empty() ? part.name : printable(file.name, std::string::npos);
  note_sphere(part, name, whole);
  for (const std::string& run : part.curves) {
    whole.curves.push_back(names.free_name(runs == 1 ? name : name + ": " + run));
    names.take(whole.curves.back());
  }
  append(part.curve_loads, runs, whole.curve_loads, first_run);
  append(part.shear_reversed, runs, whole.shear_reversed, first_run);
  append(part.errors, points, whole.errors, whole.points.size());
  append(part.axes, points, whole.axes, whole.points.size());
  append(part.loads_beside, points, whole.loads_beside, whole.points.size());
  for (Point& point : part.points) {
    point.line = line_of_point(part.path, first_line + point.line);
    point.curve += static_cast<Point::Index>(first_run);
  }
  append(part.points, points, whole.points, whole.points.size());
  if (!part.pull_off.empty() && part.contact && part.contact->radius != whole.contact->radius)
    throw InputError(part.path, "holds pull-off loads of another sphere; fit them with the runs on that sphere");
  for (PullOffReading& one : part.pull_off) one.line = line_of_point(part.path, first_line + one.line);
  append(part.pull_off, part.pull_off.size(), whole.pull_off, whole.pull_off.size());
  if (whole.display.length.empty()) {
    whole.display.length = part.display.length;
    whole.display.length_scale = part.display.length_scale;
  }
  for (Excluded& excluded : part.excluded) excluded.line += first_line;
  append(part.excluded, part.excluded.size(), whole.excluded, whole.excluded.size());
  whole.rows += part.rows;
  for (const Message& note : part.notes) whole.notes.push_back(name + ": " + note);
  if (part.reading != whole.reading)
    whole.notes.push_back(name + ": read as " + (part.reading.empty() ? "plain CSV" : part.reading));
  if (part.taken != whole.taken)
    whole.notes.push_back(name + ": " + (part.taken.empty() ? "columns by their own names" : joined(part.taken)));
  std::erase_if(whole.mapping, [&](const auto& one) {
    const auto found = part.mapping.find(one.first);
    return found == part.mapping.end() || found->second != one.second;
  });
  for (const std::string& column : part.ignored_columns)
    if (std::find(whole.ignored_columns.begin(), whole.ignored_columns.end(), column) == whole.ignored_columns.end())
      whole.ignored_columns.push_back(column);
}

}  // namespace

std::vector<std::string> files_of(const std::string& pattern) {
  if (pattern.find_first_of("*?[") == std::string::npos || std::filesystem::exists(pattern)) return {pattern};
  glob_t found{};
  const int problem = glob(pattern.c_str(), 0, nullptr, &found);
  std::vector<std::string> files(found.gl_pathv, found.gl_pathv + (problem == 0 ? found.gl_pathc : 0));
  globfree(&found);
  if (files.empty()) throw InputError(pattern, "no file has such a name");
  std::sort(files.begin(), files.end(), by_number);
  return files;
}

Dataset load_pooled(const std::vector<RunFile>& files, const Overrides& overrides) {
  Inputs inputs;
  return load_pooled(files, overrides, inputs);
}

Dataset load_pooled(const std::vector<RunFile>& files, const Overrides& overrides, Inputs& inputs) {
  if (files.empty()) throw InputError("files", "are none: a data set needs one at least");
  Metadata constants;
  std::vector<Metadata> stated;
  std::vector<std::string> paths;
  for (const RunFile& file : files) paths.push_back(file.path);
  if (const auto again = named_twice(paths)) throw InputError(*again, "is named twice: its points would count twice");
  for (const RunFile& file : files) {
    stated.push_back(metadata_of(file.path, overrides, inputs));
    if (const std::string problem = add_constants(stated.back(), constants); !problem.empty())
      throw InputError(metadata_path(file.path), problem);
  }
  Metadata common = constants;
  apply_overrides(overrides, common);
  // the relative error of the radius applies to every sphere
  const double radius_error = common.radius ? common.standard_error("radius") / *common.radius : 0;
  Dataset whole;
  std::size_t lines = 0;
  std::vector<Dataset> parts;
  for (std::size_t k = 0; k < files.size(); ++k) {
    add_constants(constants, stated[k]);
    Overrides own = overrides;
    if (!files[k].load.empty()) own.emplace_back("load", files[k].load);
    if (!files[k].sphere.empty()) own.emplace_back("radius", files[k].sphere);
    parts.push_back(load_part(files[k].path, stated[k], own, inputs));
  }
  reverse_loads_alike(parts);
  DistinctNames names;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const RunFile& file = files[k];
    Dataset& part = parts[k];
    if (!file.sphere.empty() && radius_error > 0)
      part.metadata.standard_errors["radius"] = radius_error * *part.metadata.radius;
    if (whole.files.empty()) {
      whole.path = part.path;
      whole.has_loads = part.has_loads;
      whole.contact = part.contact;
      whole.display = part.display;
      whole.metadata = part.metadata;
      whole.reading = part.reading;
      whole.taken = part.taken;
      whole.mapping = part.mapping;
      whole.compliance = part.compliance;
    }
    std::size_t last = 0;
    for (const Point& point : part.points) last = std::max<std::size_t>(last, point.line);
    for (const PullOffReading& one : part.pull_off) last = std::max<std::size_t>(last, one.line);
    for (const Excluded& excluded : part.excluded) last = std::max(last, excluded.line);
    whole.files.push_back({file.path, lines});
    add(std::move(part), file, names, whole);
    lines += last;
  }
  whole.name = common_name(files);
  whole.inputs = inputs.files();
  const Metadata& of = whole.metadata;
  if (whole.several_spheres && (of.load_offset || of.shear_offset || of.area_offset))
    throw InputError(whole.path, kNoOffsets);
  return whole;
}

}  // namespace mixity
