#include "dataset/collector.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/input_error.h"
#include "base/number_text.h"
#include "base/phrases.h"
#include "base/text.h"
#include "dataset/energies.h"
#include "dataset/pull_off.h"
#include "dataset/signs.h"
#include "dataset/table/load_in_words.h"
#include "dataset/table/vocabulary.h"
#include "dataset/unnamed_runs.h"

namespace mixity {
namespace {

constexpr std::string_view kNegativeAngle = "psi < 0 beside positive phase angles";

std::string name_by_load(double load, const Dataset& data) {
  return std::string(data.held_name()) + "=" + rounded(load * data.held_scale(), 6) + unit_text(data.held_unit());
}

/// Sets the load of each run to the mean over its points, exactly if all are equal.
void take_mean_loads(Dataset& data) {
  struct Loads {
    double first = 0, sum = 0, count = 0;
    bool vary = false;
  };
  std::vector<Loads> runs(data.curves.size());
  for (const Point& point : data.points) {
    Loads& loads = runs[point.curve];
    if (loads.count == 0) loads.first = point.P;
    loads.vary |= point.P != loads.first;
    loads.sum += point.P;
    ++loads.count;
  }
  for (std::size_t run = 0; run < runs.size(); ++run)
    if (runs[run].vary) data.curve_loads[run] = runs[run].sum / runs[run].count;
}

}  // namespace

std::size_t Runs::of(const std::optional<std::string_view>& name, const Point& point, const Dataset& data) {
  const double load = data.has_loads ? point.P : 0;
  if (!keys_.empty() && keys_[last_].second == name.has_value() &&
      (name ? *name == keys_[last_].first : load == last_load_))
    return last_;
  last_load_ = load;
  const Key key = name ? Key{*name, true} : data.has_loads ? Key{name_by_load(load, data), false} : Key{};
  const auto [found, is_new] = index_.try_emplace(key, keys_.size());
  if (is_new) {
    keys_.push_back(key);
    loads_.push_back(load);
  }
  return last_ = found->second;
}

void Runs::reverse_loads_in_names(const Dataset& data) {
  for (std::size_t i = 0; i < keys_.size(); ++i)
    if (!keys_[i].second) keys_[i].first = name_by_load(0 - loads_[i], data);
}

std::vector<std::string> Runs::names() const {
  std::vector<std::string> names;
  for (const auto& [name, given] : keys_)
    // Names appear in figures, pages and tables, so characters that would break these are shown as '?'.
    names.push_back(
        printable(name + (!given && index_.contains({name, true}) ? " (not named)" : ""), std::string::npos));
  return names;
}

Collector::Collector(const std::string& metadata_path, const std::vector<Heading>& headings, const ColumnRules& rules,
                     const std::optional<double>& load, Dataset& data)
    : metadata_path_(metadata_path),
      data_(data),
      titles_(load ? &rules.known_names() : nullptr),
      reader_(metadata_path, headings, rules, load, data) {
  using enum ColumnId;
  has_errors_ = false;
  for (const ColumnId id : {sigma_T, sigma_A, sigma_a_par, sigma_Gc, sigma_GI, sigma_GII})
    has_errors_ |= columns().has(id);
  has_axes_ = columns().lengths() && !columns().lengths()->round();
  data.taken = columns().taken;
  data.mapping = columns().mapped;
}

void Collector::row(const CsvRow& row, const std::optional<std::string_view>& run) {
  ReadPoint read;
  const std::string_view unusable = reader_.read(row, read);
  ++data_.rows;
  if (!unusable.empty()) {
    data_.excluded.push_back({row.line(), unusable});
    return;
  }
  if (const double ratio = std::exp(std::sqrt(std::abs(read.direction))); ratio > largest_axes_) {
    largest_axes_ = ratio;
    line_of_largest_ = row.line();
    along_ = read.axes.q > 0;
  }
  if (std::abs(read.beside_axes) > std::abs(beside_axes_)) {
    beside_axes_ = read.beside_axes;
    line_beside_axes_ = row.line();
  }
  largest_turn_ = std::max(largest_turn_, std::abs(read.turn));
  direction_ += read.direction;
  weight_ += std::abs(read.direction);
  squares_ += std::norm(read.direction);
  if (columns().holds_pull_off()) {
    data_.pull_off.push_back(read.pull_off);
    return;
  }
  const Column* const name = columns().find(ColumnId::curve);
  named_ |= run.has_value();
  const bool is_named = name && !row[name->index].empty();
  read.point.curve =
      static_cast<Point::Index>(runs_.of(is_named ? std::optional(row[name->index]) : run, read.point, data_));
  if (read.states_errors && !errors_in_fields_) {
    has_errors_ = errors_in_fields_ = true;
    data_.errors.resize(data_.points.size());
  }
  if (read.negative_angle) negative_angles_.push_back(data_.points.size());
  data_.points.push_back(read.point);
  if (!data_.has_loads) data_.converted.push_back(read.converted);
  if (has_errors_) data_.errors.push_back(read.errors);
  if (data_.has_energies) data_.energies.push_back(read.energies);
  if (has_axes_) data_.axes.push_back(read.axes);
  if (data_.holds_approach() && columns().has(ColumnId::P)) data_.loads_beside.push_back(read.load);
}

void Collector::leave_out(std::size_t line, std::string_view reason) {
  ++data_.rows;
  data_.excluded.push_back({line, reason});
}

void Collector::comment(const CsvRow& row) {
  if (const auto load = titles_ ? last_load_in(row.raw(), *titles_) : std::nullopt)
    return begin_run_at(std::string(trim(row.raw().substr(row.raw().find_first_not_of("# ")))), *load);
  if (row.size() >= columns().count && holds_a_number(row) && comments_++ == 0) first_comment_ = row.line();
}

void Collector::begin_table(const std::string& title) {
  if (!titles_ || tables_.empty()) return tables_.push_back({data_.points.size(), title});
  const auto load = load_in(title, *titles_);
  const bool by_comment = tables_.size() > 1 && tables_.back().point == data_.points.size();
  if (!load && by_comment) return;
  if (!load) throw InputError(data_.path, "the title '" + title + "' states no load, which titles above it do");
  begin_run_at(title, *load);
}

void Collector::begin_run_at(const std::string& title, double load) {
  reader_.set_load(load);
  tables_.push_back({data_.points.size(), title});
}

/// Names the runs by the titles of the tables, or by numbers if these are not all different.
void Collector::take_tables_as_runs() {
  std::set<std::string> titles;
  for (const TableBegin& one : tables_) titles.insert(one.title);
  const bool by_title = titles.size() == tables_.size() && !titles.contains("");
  std::set<double> loads;
  for (const TableBegin& one : tables_)
    if (titles_ && one.point < data_.points.size()) loads.insert(data_.points[one.point].P);
  const bool by_load = loads.size() == tables_.size();
  runs_ = {};
  std::size_t k = 0;
  for (std::size_t i = 0; i < data_.points.size(); ++i) {
    while (k + 1 < tables_.size() && i >= tables_[k + 1].point) ++k;
    const std::string name = by_title  ? tables_[k].title
                             : by_load ? name_by_load(data_.points[i].P, data_)
                                       : "table " + std::to_string(k + 1);
    data_.points[i].curve = static_cast<Point::Index>(runs_.of(name, data_.points[i], data_));
  }
}

/// Phase angles below 0 are those of another convention if there are no others. Beside positive ones they are left out:
/// an interface may have another toughness for K_II of the other sign.
void Collector::finish_angles() {
  const std::size_t count = negative_angles_.size();
  if (count == 0) return;
  std::vector<bool> negative(data_.points.size());
  for (const std::size_t i : negative_angles_) negative[i] = true;
  bool beside = false;
  for (std::size_t i = 0; i < data_.points.size(); ++i) beside |= !negative[i] && data_.converted[i].psi() > 0;
  if (!beside) {
    data_.notes.push_back(
        "all phase angles are negative: read without their sign, as the sign of K_II does not matter");
    return;
  }
  data_.notes.push_back(counted(count, "phase angle") + (count == 1 ? " lies" : " lie") + " below 0 and " +
                        (count == 1 ? "is" : "are") +
                        " left out, as others lie above: whether the toughness is the same for K_II of the other sign "
                        "is not known; written without their sign they are used");
  std::vector<std::size_t> runs(data_.curves.size(), data_.curves.size());  // their new numbers
  std::vector<std::string> names;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < data_.points.size(); ++i) {
    if (negative[i]) {
      data_.excluded.push_back({data_.points[i].line, kNegativeAngle});
      continue;
    }
    std::size_t& run = runs[data_.points[i].curve];
    if (run == data_.curves.size()) {
      run = names.size();
      names.push_back(data_.curves[data_.points[i].curve]);
    }
    data_.points[kept] = data_.points[i];
    data_.points[kept].curve = static_cast<Point::Index>(run);
    data_.converted[kept] = data_.converted[i];
    if (!data_.errors.empty()) data_.errors[kept] = data_.errors[i];
    ++kept;
  }
  data_.points.resize(kept);
  data_.converted.resize(kept);
  if (!data_.errors.empty()) data_.errors.resize(kept);
  data_.curves = names;
  std::stable_sort(data_.excluded.begin(), data_.excluded.end(),
                   [](const Excluded& one, const Excluded& other) { return one.line < other.line; });
}

void Collector::finish() {
  const std::string passed_over = std::to_string(comments_) +
                                  (comments_ == 1 ? " row that begins" : " rows that begin") +
                                  " with '#', the first in line " + std::to_string(first_comment_);
  if (data_.rows == 0)
    throw InputError(data_.path, 2, 1,
                     "has a header but no data rows" + (comments_ > 0 ? ", only " + passed_over : ""));
  if (errors_in_fields_) data_.notes.push_back("standard errors: stated in the fields of the values");
  if (comments_ > 0) data_.notes.push_back("passed over as comments: " + passed_over);
  if (tables_are_runs()) take_tables_as_runs();
  const bool reads_loads = columns().has(ColumnId::P) && !data_.holds_approach(),
             is_negative = reads_loads && compression_is_negative(data_);
  if (is_negative) runs_.reverse_loads_in_names(data_);
  data_.curves = runs_.names();
  finish_angles();
  if (columns().holds_pull_off()) return finish_pull_off(data_);
  if (data_.has_energies) finish_energies(metadata_path_, data_);
  if (!data_.has_loads) return;
  data_.curve_loads = runs_.loads();
  if (is_negative) reverse_loads(data_);
  // frames of a log before and after contact are not points
  data_.like_a_log = data_.excluded.size() > std::max<std::size_t>(data_.rows / 20, 2) && has_times();
  if (data_.like_a_log)
    data_.notes.push_back("the file has a column of times, and " + std::to_string(data_.excluded.size()) + " of " +
                          std::to_string(data_.rows) +
                          " rows are no points: if it is a log, mixity runs makes loading runs of it");
  if (reads_loads && !columns().has(ColumnId::curve) && !tables_are_runs() && !named_) {
    if (data_.curves.size() > 1) join_noisy_loads(data_);
    split_repeated_shear(data_);
  }
  take_mean_loads(data_);
  finish_shear(data_);
  if (has_axes_) {
    add_note_on_axes();
    add_note_on_areas();
  }
}

bool Collector::has_times() const {
  return std::any_of(data_.ignored_columns.begin(), data_.ignored_columns.end(), [](const std::string& name) {
    return name == "time" || Vocabulary::shipped().find(name) == ColumnId::time;
  });
}

/// In the singular part of the pressure of an elliptic punch, K_I^2 at the end of a semi-axis is proportional to its
/// length (Johnson & Greenwood 2005): the energy release rates around the edge have the ratio of the axes.
void Collector::add_note_on_axes() {
  constexpr double kNearlyRound = 1.1;
  const double eccentricity = std::sqrt(1 - 1 / (largest_axes_ * largest_axes_));
  std::string note = "areas are those of ellipses, axes as " + rounded(largest_axes_, 4) + " to 1 (eccentricity " +
                     rounded(eccentricity, 3) + ") at most";
  if (largest_axes_ > 1)
    note += ", in line " + std::to_string(line_of_largest_) + ", the longer one " + (along_ ? "along" : "across") +
            " the shear";
  if (largest_axes_ > kNearlyRound)
    note += "; the models are of a circle, and around such an edge the energy release rate varies by about " +
            rounded(100 * (largest_axes_ - 1), 2) + "%";
  if (columns().has(ColumnId::major) && !columns().has(ColumnId::angle))
    note += "; without the column 'angle' the major axis is taken to lie across the shear";
  // scikit-image's orientation is in radians, from the vertical of the image
  constexpr std::size_t kSome = 4;
  constexpr double kRadians = std::numbers::pi * std::numbers::pi / 180;  // of pi radians, read as degrees
  if (const Column* const angle = columns().find(ColumnId::angle); angle && angle->unit.dimension == dimension::none &&
                                                                   data_.points.size() >= kSome && largest_turn_ > 0 &&
                                                                   largest_turn_ <= kRadians) {
    data_.axes.clear();
    data_.notes.push_back(note + "; no angle exceeds " + rounded(largest_turn_ * 180 / std::numbers::pi, 3) +
                          ": say whether they are in rad or deg by the heading, such as 'Angle (rad)', measured from "
                          "the shear; until then only the areas are used");
    return;
  }
  // Shear stretches a contact along or across itself. Noise has no direction, but few axes may share one by chance: of
  // n alike in 1 of exp(kSurely) as closely as here (Rayleigh's test).
  constexpr double kOblique = 10, kCommon = 0.5, kSurely = 7;
  const double degrees = std::arg(direction_) / 4 * 180 / std::numbers::pi;
  if (std::abs(degrees) > kOblique && std::abs(direction_) > kCommon * weight_) {
    note += "; they lie " + rounded(std::abs(degrees), 2) +
            " degrees from the shear and the direction across it: 'angle' is to be measured from the shear, so turn it "
            "if the image is turned";
    if (std::norm(direction_) > kSurely * squares_) {
      data_.axes.clear();
      note += "; until then only the areas are used";
    }
  }
  data_.notes.push_back(note);
}

/// Two measurements of one contact scatter by some percent. More is a unit, a diameter or an outline of another kind.
void Collector::add_note_on_areas() {
  constexpr double kScatter = 0.05;
  if (std::abs(beside_axes_) <= kScatter) return;
  const bool larger = beside_axes_ > 0;
  data_.notes.push_back("the area A is up to " + rounded(100 * std::abs(beside_axes_), 2) + "% " +
                        (larger ? "larger" : "smaller") + " than pi a b of the axes (line " +
                        std::to_string(line_beside_axes_) + "); A is used, and of the axes only their ratio");
}

}  // namespace mixity
