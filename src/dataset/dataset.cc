#include "dataset/dataset.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <utility>

#include "dataset/energies.h"
#include "dataset/input_error.h"
#include "dataset/large_pages.h"
#include "dataset/nominal_loads.h"
#include "dataset/number_text.h"
#include "dataset/pipeline.h"
#include "dataset/point_reader.h"
#include "dataset/printable.h"
#include "dataset/runs.h"
#include "dataset/shear_sign.h"
#include "dataset/side_by_side.h"
#include "dataset/table/csv.h"
#include "dataset/table/table.h"
#include "dataset/table/vocabulary.h"

namespace mixity {
namespace {

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// How far from circles elliptic contacts are: the longest axis over the shorter one, and where.
struct EllipseAxes {
  double ratio = 1;
  std::size_t line = 0;
  void add(const EllipseAxes& other) {
    if (other.ratio > ratio) *this = other;
  }
};

/// A block of rows, and what they hold.
struct Part {
  CsvBlock block;
  std::size_t rows = 0, commented = 0, first_commented = 0;  // rows; those behind '#', and the line of the first
  std::vector<Point> points;
  std::vector<ToughnessPoint> converted;
  std::vector<PointErrors> errors;
  std::vector<PointEnergies> energies;
  std::vector<Excluded> excluded;
  Runs runs;
  std::vector<ShearRange> shear;  // of each run
  PointBatch batch;
  EllipseAxes axes;

  void clear() {
    rows = commented = 0;
    points.clear();
    points.reserve(block.lines());
    converted.clear();
    errors.clear();
    energies.clear();
    excluded.clear();
    runs = {};
    axes = {};
  }
  void row(const PointReader& reader, const Dataset& data, const CsvRow& row) {
    ++rows;
    ReadPoint read;
    const std::string_view unusable = reader.read(row, read);
    if (!unusable.empty()) {
      excluded.push_back({row.line(), unusable});
      return;
    }
    axes.add({read.axes, row.line()});
    read.point.curve = runs.of(reader.run_name(row), read.point, data);
    points.push_back(read.point);
    if (!data.has_loads) converted.push_back(read.converted);
    if (reader.has_errors()) errors.push_back(read.errors);
    if (data.has_energies) energies.push_back(read.energies);
  }
  void leave_out(const CsvRow& row) {
    ++rows;
    excluded.push_back({row.line(), "a summary of the rows above: words where they have numbers"});
  }
  void comment(const PointReader& reader, const CsvRow& row) {
    if (reader.resembles_data(row) && commented++ == 0) first_commented = row.line();
  }
  void numbers(const PointReader& reader, const Dataset& data, const CsvNumbers& numbers) {
    reader.read(numbers, batch);
    const bool has_errors = reader.has_errors();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (!batch.usable[i]) {
        row(reader, data, numbers.row(i));
        continue;
      }
      ++rows;
      Point& point = points.emplace_back();
      point.line = numbers.line(i);
      point.P = batch.P[i];
      point.T = batch.T[i];
      point.A = batch.A[i];
      point.curve = runs.of(reader.run_name(numbers, i), point, data);
      if (has_errors) errors.push_back({batch.sigma_T[i], batch.sigma_A[i], 0});
    }
  }
};

/// Reads a file into a data set.
class Loader {
 public:
  Loader(std::string metadata_path, Dataset& data)
      : metadata_path_(std::move(metadata_path)), data_(data), file_(data.path) {}

  void read() {
    begin();
    // What is small is read here: threads cost more than they save.
    std::size_t bytes = 0;
    for (Part part; bytes < kAlone || !reader_; bytes += part.block.bytes()) {
      if (!file_.next(part.block)) return finish();
      understand(part);
      if (data_.points.empty() && !part.points.empty()) reserve(part);
      take(part);
    }
    pipeline<Part>(
        processors(), [&](Part& part) { return file_.next(part.block); }, [&](Part& part) { understand(part); },
        [&](const Part& part) { take(part); });
    finish();
  }

 private:
  static constexpr std::size_t kAlone = std::size_t{1} << 18;
  static constexpr std::size_t kNoLine = std::numeric_limits<std::size_t>::max();

  /// Finds the table. Where there is none the first row is taken for its headings, and what is wrong with it is told.
  void begin() {
    const Metadata& metadata = data_.metadata;
    const auto table = find_table(data_.path, file_.start(), file_.line_end(), rules_of(metadata), metadata.decimal);
    if (file_.encoding() != Encoding::utf8) data_.reading = to_string(file_.encoding());
    if (!table) return;
    reader_.emplace(metadata_path_, table->headings, data_);
    data_.taken = reader_->taken();
    const std::string how = describe(*table);
    if (how != "commas") data_.reading += (data_.reading.empty() ? "" : ", ") + how;
    if (table->summary_line > 0 && file_.at_end()) summary_line_ = table->summary_line;
    file_.begin_at(table->offset, table->line, table->format);
  }

  void understand(Part& part) {
    part.clear();
    const auto one = [&](const CsvRow& row) {
      if (row.line() >= summary_line_)
        part.leave_out(row);
      else if (reader_)
        part.row(*reader_, data_, row);
      else
        reader_.emplace(metadata_path_, headings_of(row), data_);
    };
    const auto comment = [&](const CsvRow& row) {
      if (reader_) part.comment(*reader_, row);
    };
    const CsvWanted* wanted = reader_ && summary_line_ == kNoLine ? reader_->wanted() : nullptr;
    if (wanted)
      part.block.rows(
          *wanted, [&](const CsvNumbers& numbers) { part.numbers(*reader_, data_, numbers); }, one, comment);
    else
      part.block.rows(one, comment);
    part.shear = shear_ranges(part.points, part.runs.keys().size());
  }

  void take(const Part& part) {
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

  /// Room for as many points as the file may hold if it goes on as this part of it: to move them takes twice their
  /// memory, while what is never touched takes none.
  void reserve(const Part& part) {
    const double times = static_cast<double>(file_.bytes().value_or(0)) / static_cast<double>(part.block.bytes());
    data_.points.reserve(static_cast<std::size_t>(1.25 * times * static_cast<double>(part.points.size())));
    prefer_large_pages(data_.points.data(), data_.points.capacity() * sizeof(Point));
  }

  void finish() {
    if (!reader_) throw InputError(data_.path, 1, 1, "is empty: a header row is missing");
    const std::string passed_over = std::to_string(commented_) +
                                    (commented_ == 1 ? " row that begins" : " rows that begin") +
                                    " with '#', the first in line " + std::to_string(first_commented_);
    if (data_.rows == 0)
      throw InputError(data_.path, 2, 1,
                       "has a header but no data rows" + (commented_ > 0 ? ", only " + passed_over : ""));
    if (commented_ > 0) data_.notes.push_back("passed over as comments: " + passed_over);
    if (data_.has_energies) finish_energies(metadata_path_, data_);
    // Names go into figures, pages and tables: what would break these is shown as '?'.
    for (std::size_t i = 0; i < runs_.keys().size(); ++i)
      data_.curves.push_back(printable(runs_.shown(i), std::string::npos));
    if (!data_.has_loads) return;
    data_.curve_loads = runs_.loads();
    if (2 * data_.excluded.size() > data_.rows && has_times())
      data_.notes.emplace_back(
          "the file has a column of times, and most of its rows are no points: if it is a log, mixity runs makes "
          "loading "
          "runs of it");
    if (!reader_->names_runs() && data_.curves.size() > 1) {
      join_noisy_loads(data_);
      shear_ = shear_ranges(data_.points, data_.curves.size());
    }
    finish_shear(shear_, data_);
    if (reader_->has_axes()) finish_axes();
  }

  bool has_times() const {
    return std::any_of(data_.ignored_columns.begin(), data_.ignored_columns.end(), [](const std::string& name) {
      return name == "time" || Vocabulary::shipped().find(name) == ColumnId::time;
    });
  }

  /// Of the singular part of an elliptic punch's pressure K_I^2 at the end of a semi-axis goes with its length (Johnson
  /// & Greenwood 2005): the axes' ratio is that of the energy release rates around the edge, which the circle averages.
  void finish_axes() {
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

  std::string metadata_path_;
  Dataset& data_;
  CsvFile file_;
  std::optional<PointReader> reader_;  // made of the first row, before any thread
  Runs runs_;
  std::vector<ShearRange> shear_;  // of each run
  EllipseAxes axes_;
  std::size_t commented_ = 0, first_commented_ = 0, summary_line_ = kNoLine;
};

}  // namespace

void refuse_value(const Dataset& data, const Point& point, std::string_view column, const std::string& message) {
  const std::string& path = data.file_of(point.line);
  FilePlace place{data.line_in_file(point.line), 0};
  std::error_code none;
  std::optional<std::size_t> index;
  try {
    if (std::filesystem::is_regular_file(path, none))  // a pipe is read once
      read_csv(path, [&](const CsvRow& row) {
        const auto headings = headings_of(row);
        for (std::size_t i = 0; i < headings.size() && !index; ++i)
          if (headings[i].name == column) index = i;
        if (row.line() == place.line && index) place = row.place(*index);
      });
  } catch (const InputError&) {
  }
  throw InputError(path, place, message);
}

std::vector<std::vector<std::size_t>> points_by_curve(const Dataset& data) {
  std::vector<std::vector<std::size_t>> runs(data.curves.size());
  for (std::size_t i = 0; i < data.points.size(); ++i) runs[data.points[i].curve].push_back(i);
  return runs;
}

Dataset load_dataset(const std::string& path, const Overrides& overrides) {
  return load_dataset(path, read_metadata(metadata_path(path)), overrides);
}

Dataset load_dataset(const std::string& path, const Metadata& metadata, const Overrides& overrides) {
  Dataset data;
  data.path = path;
  data.name = data_name(path);
  data.metadata = metadata;
  apply_overrides(overrides, data.metadata);
  require_whole_modulus(data.metadata, metadata_path(path), overrides);
  Loader(metadata_path(path), data).read();
  return data;
}

}  // namespace mixity
