#include "dataset/dataset.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/input_error.h"
#include "dataset/collector.h"
#include "dataset/table/csv_file.h"
#include "dataset/table/header_lines.h"
#include "dataset/table/load_in_words.h"
#include "dataset/table/table_rows.h"

namespace mixity {
namespace {

/// Makes points of the rows of a file.
class PointsOfRows : public UseOfRows {
 public:
  /// `loads`: of runs side by side, in N, if their names state them.
  PointsOfRows(Collector& collector, const CsvFile& file, RunsBeside beside, std::vector<double> loads, Dataset& data)
      : collector_(collector), file_(file), beside_(std::move(beside)), loads_(std::move(loads)), data_(data) {}

  void row(const CsvRow& row) override {
    constexpr std::size_t kSample = 1000;  // points
    if (beside_.width > 0)
      row_of_runs(row);
    else
      collector_.row(row);
    // Memory for all points, estimated from the first: a growing vector takes up to three times as much.
    if (data_.points.size() >= kSample && !reserved_) {
      reserved_ = true;
      data_.points.reserve(static_cast<std::size_t>(1.25 * kSample / file_.progress()));
    }
  }
  void comment(const CsvRow& row) override { collector_.comment(row); }
  void left_out(std::size_t line, std::string_view reason) override { collector_.leave_out(line, reason); }
  void begin_table(const std::string& title) override {
    if (beside_.width > 0)
      throw InputError(data_.path, "has runs side by side in several tables; put each table into a file of its own");
    collector_.begin_table(title);
  }

 private:
  void row_of_runs(const CsvRow& row) {
    const std::size_t runs = beside_.names.size();
    require_width(data_.path, row, runs * beside_.width, 0);
    for (std::size_t k = 0; k < runs; ++k) {
      const CsvRow part = row.part(k * beside_.width, beside_.width);
      if (count_filled(part) == 0) continue;  // this run has ended
      if (!loads_.empty()) collector_.set_load(loads_[k]);
      collector_.row(part, beside_.names[k]);
    }
  }

  Collector& collector_;
  const CsvFile& file_;
  RunsBeside beside_;
  std::vector<double> loads_;
  bool reserved_ = false;
  Dataset& data_;
};

/// Whether neither a column nor an option states loads.
bool lacks_loads(const TableRows& rows, const ColumnRules& rules) {
  if (!rows.table() || rules.load_stated || rules.approach_held) return false;
  const auto columns = number_columns({}, rows.table()->headings, rules);
  return std::none_of(columns.begin(), columns.end(),
                      [](const NamedColumn& column) { return column.id == ColumnId::P || column.id >= ColumnId::psi; });
}

/// The load of the first rows if the titles of tables or comments above the rows of two runs state loads.
std::optional<double> load_above_rows(const TableRows& rows, CsvFile& file, const ColumnRules& rules) {
  const Vocabulary& names = rules.known_names();
  if (count_lines_with_load(rows.head(), names) + count_lines_with_load(file.start(), names) < 2) return std::nullopt;
  return last_load_in(rows.head(), names);
}

/// Reads the table of a file into a data set. If no table is found, reads the first row as headings; its error message
/// then says what is wrong.
void read_table(const std::string& metadata_path, Inputs& inputs, Dataset& data) {
  ColumnRules rules = rules_of(data.metadata, inputs);
  CsvFile file(data.path, inputs, {data.metadata.sheet, data.metadata.decimal, &rules});
  const auto makes_points = [&](const Table& table) {
    try {
      return Columns(data.path, table.headings, rules).count > 0;
    } catch (const InputError&) {
      return false;
    }
  };
  TableRows rows(data.path, file, {rules, data.metadata.decimal, number_of_table(data.metadata), makes_points});
  std::vector<Heading> headings;
  if (rows.table()) {
    headings = rows.table()->headings;
  } else {
    CsvRow row;
    if (!file.next(row)) throw InputError(data.path, 1, 1, "is empty: a header row is missing");
    headings = headings_of(row);
  }
  data.notes = file.notes();
  const RunsBeside beside = rows.table() ? rows.table()->beside : RunsBeside{};
  const bool lacking = lacks_loads(rows, rules);
  std::vector<double> loads;
  if (lacking)
    for (const std::string& name : beside.names)
      if (const auto one = load_in(name, rules.known_names())) loads.push_back(*one);
  if (loads.size() < beside.names.size()) loads.clear();
  const std::optional<double> load = !loads.empty() ? std::optional(loads[0])
                                     : lacking      ? load_above_rows(rows, file, rules)
                                                    : std::nullopt;
  if (load) rules.load_stated = true;
  Collector collector(metadata_path, headings, rules, load, data);
  collector.begin_table(rows.title());
  PointsOfRows use(collector, file, beside, loads, data);
  rows.read(use);
  if (file.encoding() != Encoding::utf8) data.reading = to_string(file.encoding());
  if (rows.table())
    if (const std::string how = file.sheet() ? describe(*file.sheet(), describe(rows)) : describe(rows);
        how != "commas")
      data.reading += (data.reading.empty() ? "" : ", ") + how + (collector.tables_are_runs() ? ", each a run" : "");
  for (const auto& [line, names] : rows.other_tables())
    data.notes.push_back("the table in line " + std::to_string(line) + " is not read: " + names);
  collector.finish();
}

}  // namespace

Point::Index line_of_point(const std::string& path, std::size_t line) {
  if (line > std::numeric_limits<Point::Index>::max())
    throw InputError(path, "has more than " + std::to_string(std::numeric_limits<Point::Index>::max()) +
                               " lines, with those of the files before it; split it");
  return static_cast<Point::Index>(line);
}

double Dataset::offset_unit(Constant offset) const {
  if (!contact) return 0;
  if (offset == kApproachOffset) return contact->displacement_unit();
  return offset == kAreaOffset ? contact->area_unit() : contact->force_unit();
}

Constants Dataset::stated_constants() const {
  Constants stated{};
  if (!has_loads) return stated;
  stated.shear_weight = metadata.shear_weight();
  stated.approach_held = holds_approach();
  if (metadata.area_scale) stated[kAreaScale] = std::log(*metadata.area_scale);
  if (metadata.force_gain) stated[kForceGain] = std::log(*metadata.force_gain);
  for (const auto& [constant, value] :
       {std::pair(kLoadOffset, metadata.load_offset), std::pair(kShearOffset, metadata.shear_offset),
        std::pair(kAreaOffset, metadata.area_offset), std::pair(kApproachOffset, metadata.approach_offset)})
    if (value && contact) stated[constant] = *value / offset_unit(constant);
  return stated;
}

void refuse_value(const Dataset& data, const Point& point, std::string_view column, const std::string& message) {
  const std::string& path = data.file_of(point.line);
  FilePlace place{data.line_in_file(point.line), 0};
  std::optional<std::size_t> index;
  try {
    std::vector<InputFile> files = data.inputs;
    for (InputFile& file : files)
      if (!file.content && file.bytes <= Inputs::kMostKept)
        file.content = std::make_shared<const std::string>(content_of(file));
    Inputs as_read(files);
    const ColumnRules rules = rules_of(data.metadata, as_read);
    read_csv(path, as_read,
             [&](const CsvRow& row) {
               const auto headings = headings_of(row);
               for (std::size_t i = 0; i < headings.size() && !index; ++i)
                 if (headings[i].name == column) index = i;
               if (row.line() == place.line && index) place = row.place(*index);
             },
             {data.metadata.sheet, data.metadata.decimal, &rules});
  } catch (const InputError&) {  // too large to be stored
  }
  throw InputError(path, place, message);
}

std::string DistinctNames::free_name(const std::string& wanted) {
  if (taken_.count(wanted) == 0) return wanted;
  int& number = numbers_.try_emplace(wanted, 2).first->second;
  for (;; ++number)
    if (std::string name = wanted + " (" + std::to_string(number) + ")"; taken_.count(name) == 0) return name;
}

std::vector<std::vector<std::size_t>> points_by_curve(const Dataset& data) {
  std::vector<std::vector<std::size_t>> runs(data.curves.size());
  std::vector<std::size_t> sizes(runs.size());
  for (const Point& point : data.points) ++sizes[point.curve];
  for (std::size_t run = 0; run < runs.size(); ++run) runs[run].reserve(sizes[run]);
  for (std::size_t i = 0; i < data.points.size(); ++i) runs[data.points[i].curve].push_back(i);
  return runs;
}

PointPlaces::PointPlaces(const Dataset& data) : data_(data), largest_(data.curves.size()) {
  for (auto point = data.points.begin(); point != data.points.end();) {  // stretches of one run
    const std::size_t run = point->curve;
    double most = largest_[run];
    for (; point != data.points.end() && point->curve == run; ++point) most = std::max(most, point->shear());
    largest_[run] = most;
  }
}

PointPlace PointPlaces::at(std::size_t i, double T) const {
  constexpr double kNoShear = 0.01;
  const Point& point = data_.points[i];
  const double last = static_cast<double>(data_.curves.size()) - 1, most = largest_[point.curve],
               order = last > 0 ? static_cast<double>(point.curve) / last - 0.5 : 0;
  return {order, most > 0 ? std::pow(std::abs(T) / most, 2) : 0, !(point.shear() > kNoShear * most)};
}

Dataset part_of(const Dataset& data, const std::vector<std::size_t>& points) {
  Dataset part;
  static_cast<DatasetFacts&>(part) = data;
  const auto take = [&](const auto& all, auto& some) {
    if (all.empty()) return;
    some.reserve(points.size());
    for (const std::size_t i : points) some.push_back(all[i]);
  };
  take(data.points, part.points);
  take(data.converted, part.converted);
  take(data.errors, part.errors);
  take(data.energies, part.energies);
  take(data.axes, part.axes);
  take(data.loads_beside, part.loads_beside);
  return part;
}

Dataset corrected(Dataset data) {
  Constants readings = data.stated_constants();
  readings.shear_weight = 1;  // of the models, not of the readings
  const ConstantsScale by(readings);
  for (std::size_t i = 0; i < data.points.size(); ++i) data.points[i] = data.corrected(i, by);
  for (double& load : data.curve_loads) load = by.load(load);
  for (PointAxes& load : data.loads_beside) load.q = by.load_beside(load.q);
  Metadata& metadata = data.metadata;
  for (std::optional<double>* const constant :
       {&metadata.area_scale, &metadata.force_gain, &metadata.load_offset, &metadata.shear_offset,
        &metadata.area_offset, &metadata.approach_offset})
    constant->reset();
  return data;
}

Dataset load_dataset(const std::string& path, const Overrides& overrides) {
  Inputs inputs;
  return load_dataset(path, overrides, inputs);
}

Dataset load_dataset(const std::string& path, const Overrides& overrides, Inputs& inputs) {
  return load_dataset(path, metadata_of(path, overrides, inputs), overrides, inputs);
}

Dataset load_dataset(const std::string& path, const Metadata& metadata, const Overrides& overrides, Inputs& inputs) {
  Dataset data = load_part(path, metadata, overrides, inputs);
  data.inputs = inputs.files();
  return data;
}

Dataset load_part(const std::string& path, const Metadata& metadata, const Overrides& overrides, Inputs& inputs) {
  Dataset data;
  data.path = path;
  data.name = data_name(path);
  data.metadata = metadata;
  apply_overrides(overrides, data.metadata);
  require_whole_modulus(data.metadata, metadata_path(path), overrides);
  read_table(metadata_path(path), inputs, data);
  return data;
}

}  // namespace mixity
