#include "dataset/collector.h"

#include <algorithm>
#include <cmath>

#include "base/input_error.h"
#include "base/number_text.h"
#include "base/printable.h"
#include "dataset/energies.h"
#include "dataset/load_sign.h"
#include "dataset/nominal_loads.h"
#include "dataset/repeated_shear.h"
#include "dataset/table/vocabulary.h"

namespace mixity {
namespace {

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

void Collector::take(const Part& part) {
  std::vector<std::size_t> run(part.runs.keys().size());
  for (std::size_t i = 0; i < run.size(); ++i) run[i] = runs_.index(part.runs.keys()[i], part.runs.loads()[i]);
  shear_.resize(runs_.keys().size());
  for (std::size_t i = 0; i < run.size(); ++i) shear_[run[i]].add(part.shear[i]);
  for (const Point& point : part.points) data_.points.emplace_back(point).curve = run[point.curve];
  append(data_.converted, part.converted);
  append(data_.errors, part.errors);
  append(data_.energies, part.energies);
  append(data_.excluded, part.excluded);
  data_.rows += part.rows;
  axes_.add(part.axes);
  if (commented_ == 0) first_commented_ = part.first_commented;
  commented_ += part.commented;
}

void Collector::finish(const PointReader& reader, const std::string& metadata_path) {
  const std::string passed_over = std::to_string(commented_) +
                                  (commented_ == 1 ? " row that begins" : " rows that begin") +
                                  " with '#', the first in line " + std::to_string(first_commented_);
  if (data_.rows == 0)
    throw InputError(data_.path, 2, 1,
                     "has a header but no data rows" + (commented_ > 0 ? ", only " + passed_over : ""));
  if (commented_ > 0) data_.notes.push_back("passed over as comments: " + passed_over);
  if (data_.has_energies) finish_energies(metadata_path, data_);
  const bool turned = reader.columns().has(ColumnId::P) && compression_is_negative(data_);
  if (turned) runs_.turn_loads(data_);
  // Names go into figures, pages and tables: what would break these is shown as '?'.
  for (std::size_t i = 0; i < runs_.keys().size(); ++i)
    data_.curves.push_back(printable(runs_.shown(i), std::string::npos));
  if (!data_.has_loads) return;
  data_.curve_loads = runs_.loads();
  if (turned) turn_loads(data_);
  // before contact and after it a log has frames that are no points
  data_.like_a_log = data_.excluded.size() > std::max<std::size_t>(data_.rows / 20, 2) && has_times();
  if (data_.like_a_log)
    data_.notes.push_back("the file has a column of times, and " + std::to_string(data_.excluded.size()) + " of " +
                          std::to_string(data_.rows) +
                          " rows are no points: if it is a log, mixity runs makes loading runs of it");
  if (!reader.names_runs() && reader.columns().has(ColumnId::P)) {
    const bool several = data_.curves.size() > 1;
    if (several) join_noisy_loads(data_);
    if (part_where_shear_begins_anew(data_) || several) shear_ = shear_ranges(data_.points, data_.curves.size());
  }
  take_mean_loads(data_);
  finish_shear(shear_, data_);
  if (reader.has_axes()) finish_axes();
}

bool Collector::has_times() const {
  return std::any_of(data_.ignored_columns.begin(), data_.ignored_columns.end(), [](const std::string& name) {
    return name == "time" || Vocabulary::shipped().find(name) == ColumnId::time;
  });
}

/// Of the singular part of an elliptic punch's pressure K_I^2 at the end of a semi-axis goes with its length (Johnson
/// & Greenwood 2005): the axes' ratio is that of the energy release rates around the edge, which the circle averages.
void Collector::finish_axes() {
  constexpr double kNearlyRound = 1.1;
  const double eccentricity = std::sqrt(1 - 1 / (axes_.ratio * axes_.ratio));
  std::string note = "areas are those of ellipses, axes as " + rounded(axes_.ratio, 4) + " to 1 (eccentricity " +
                     rounded(eccentricity, 3) + ") at most";
  if (axes_.ratio > 1) note += ", in line " + std::to_string(axes_.line);
  if (axes_.ratio > kNearlyRound)
    note += "; the models are of a circle, and around such an edge the energy release rate varies by about " +
            rounded(100 * (axes_.ratio - 1), 2) + "%";
  data_.notes.push_back(note);
}

}  // namespace mixity
