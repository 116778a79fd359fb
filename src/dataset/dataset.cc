#include "dataset/dataset.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/input_error.h"
#include "dataset/collector.h"
#include "dataset/table/csv_file.h"
#include "dataset/table/header_lines.h"
#include "dataset/table/table.h"

namespace mixity {
namespace {

constexpr std::string_view kSummaryRow = "summary row (text where the rows above have numbers)",
                           kWordsBelow = "words below the table";

/// Reads the table of a file into a data set. If no table is found, reads the first row as headings; its error message
/// then says what is wrong.
void read_table(const std::string& metadata_path, Inputs& inputs, Dataset& data) {
  constexpr std::size_t kSample = 1000;  // points
  const Metadata& metadata = data.metadata;
  const ColumnRules rules = rules_of(metadata, inputs);
  CsvFile file(data.path, inputs, {metadata.sheet, metadata.decimal, &rules});
  const auto table = find_table(data.path, file.start(), file.line_end(), rules, metadata.decimal);
  CsvRow row;
  std::vector<Heading> headings;
  std::size_t summary_line = 0;
  if (file.encoding() != Encoding::utf8) data.reading = to_string(file.encoding());
  if (table) {
    headings = table->headings;
    const std::string how = file.sheet() ? describe(*file.sheet(), describe(*table)) : describe(*table);
    if (how != "commas") data.reading += (data.reading.empty() ? "" : ", ") + how;
    if (file.at_end()) summary_line = table->summary_line;
    file.begin_at(table->offset, table->line, table->format);
  } else {
    if (!file.next(row)) throw InputError(data.path, 1, 1, "is empty: a header row is missing");
    headings = headings_of(row);
  }
  if (file.sheet()) data.notes = file.sheet()->notes;
  Collector collector(metadata_path, headings, rules, data);
  std::vector<std::size_t> words;  // lines without a number, which at the end of the table are not rows
  std::optional<InputError> refusal;
  while (file.next(row)) {
    if (row.is_comment()) {
      collector.comment(row);
      continue;
    }
    if (refusal && has_a_number(row)) throw *refusal;
    try {
      if (summary_line > 0 && row.line() >= summary_line)
        collector.leave_out(row.line(), kSummaryRow);
      else
        collector.row(row);
    } catch (const InputError& error) {
      if (has_a_number(row) || data.rows == 0) throw;
      if (!refusal) refusal = error;
      words.push_back(row.line());
    }
    // Reserves memory for all points, estimated from the first ones: a growing vector takes up to three times as much.
    if (data.points.size() == kSample) data.points.reserve(static_cast<std::size_t>(1.25 * kSample / file.progress()));
  }
  for (const std::size_t line : words) collector.leave_out(line, kWordsBelow);
  collector.finish();
}

}  // namespace

double Dataset::offset_unit(Constant offset) const {
  if (!contact) return 0;
  return offset == kAreaOffset ? contact->area_unit() : contact->force_unit();
}

Constants Dataset::stated_constants() const {
  Constants stated{};
  if (!has_loads) return stated;
  if (metadata.area_scale) stated[kAreaScale] = std::log(*metadata.area_scale);
  if (metadata.force_gain) stated[kForceGain] = std::log(*metadata.force_gain);
  for (const auto& [constant, value] :
       {std::pair(kLoadOffset, metadata.load_offset), std::pair(kShearOffset, metadata.shear_offset),
        std::pair(kAreaOffset, metadata.area_offset)})
    if (value && contact) stated[constant] = *value / offset_unit(constant);
  return stated;
}

void refuse_value(const Dataset& data, const Point& point, std::string_view column, const std::string& message) {
  const std::string& path = data.file_of(point.line);
  FilePlace place{data.line_in_file(point.line), 0};
  std::optional<std::size_t> index;
  try {
    Inputs as_read(data.inputs);
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

std::string distinct_name(const std::string& wanted, const std::vector<std::string>& others) {
  std::string name = wanted;
  for (int same = 2; std::find(others.begin(), others.end(), name) != others.end(); ++same)
    name = wanted + " (" + std::to_string(same) + ")";
  return name;
}

std::vector<std::vector<std::size_t>> points_by_curve(const Dataset& data) {
  std::vector<std::vector<std::size_t>> runs(data.curves.size());
  for (std::size_t i = 0; i < data.points.size(); ++i) runs[data.points[i].curve].push_back(i);
  return runs;
}

PointPlaces::PointPlaces(const Dataset& data) : data_(data), largest_(data.curves.size()) {
  for (const Point& point : data.points) largest_[point.curve] = std::max(largest_[point.curve], point.shear());
}

PointPlace PointPlaces::at(std::size_t i, double T) const {
  constexpr double kNoShear = 0.01;
  const Point& point = data_.points[i];
  const double last = static_cast<double>(data_.curves.size()) - 1, most = largest_[point.curve],
               order = last > 0 ? static_cast<double>(point.curve) / last - 0.5 : 0;
  return {order, most > 0 ? std::pow(std::abs(T) / most, 2) : 0, !(point.shear() > kNoShear * most)};
}

std::vector<PointPlace> places(const Dataset& data) {
  const PointPlaces of(data);
  std::vector<PointPlace> list;
  list.reserve(data.points.size());
  for (std::size_t i = 0; i < data.points.size(); ++i) list.push_back(of.at(i));
  return list;
}

Dataset corrected(Dataset data) {
  const ConstantsScale by(data.stated_constants());
  for (std::size_t i = 0; i < data.points.size(); ++i) data.points[i] = data.corrected(i, by);
  for (double& load : data.curve_loads) load = by.load(load);
  Metadata& metadata = data.metadata;
  for (std::optional<double>* const constant : {&metadata.area_scale, &metadata.force_gain, &metadata.load_offset,
                                                &metadata.shear_offset, &metadata.area_offset})
    constant->reset();
  return data;
}

Dataset load_dataset(const std::string& path, const Overrides& overrides) {
  Inputs inputs;
  return load_dataset(path, overrides, inputs);
}

Dataset load_dataset(const std::string& path, const Overrides& overrides, Inputs& inputs) {
  return load_dataset(path, read_metadata(metadata_path(path), inputs), overrides, inputs);
}

Dataset load_dataset(const std::string& path, const Metadata& metadata, const Overrides& overrides, Inputs& inputs) {
  Dataset data;
  data.path = path;
  data.name = data_name(path);
  data.metadata = metadata;
  apply_overrides(overrides, data.metadata);
  require_whole_modulus(data.metadata, metadata_path(path), overrides);
  read_table(metadata_path(path), inputs, data);
  data.inputs = inputs.files();
  return data;
}

}  // namespace mixity
