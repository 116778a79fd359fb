#include "dataset/dataset.h"

#include <filesystem>
#include <limits>
#include <utility>

#include "base/input_error.h"
#include "base/side_by_side.h"
#include "dataset/collector.h"
#include "dataset/large_pages.h"
#include "dataset/pipeline.h"
#include "dataset/table/table.h"

namespace mixity {
namespace {

struct FilePart : Part {
  CsvBlock block;
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
    for (FilePart part; bytes < kAlone || !reader_; bytes += part.block.bytes()) {
      if (!file_.next(part.block)) return finish();
      understand(part);
      if (data_.points.empty() && !part.points.empty()) reserve(part);
      collector_.take(part);
    }
    pipeline<FilePart>(
        processors(), [&](FilePart& part) { return file_.next(part.block); }, [&](FilePart& part) { understand(part); },
        [&](const FilePart& part) { collector_.take(part); });
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

  void understand(FilePart& part) {
    part.clear(part.block.lines());
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

  /// Room for as many points as the file may hold if it goes on as this part of it: to move them takes twice their
  /// memory, while what is never touched takes none.
  void reserve(const FilePart& part) {
    const double times = static_cast<double>(file_.bytes().value_or(0)) / static_cast<double>(part.block.bytes());
    data_.points.reserve(static_cast<std::size_t>(1.25 * times * static_cast<double>(part.points.size())));
    prefer_large_pages(data_.points.data(), data_.points.capacity() * sizeof(Point));
  }

  void finish() {
    if (!reader_) throw InputError(data_.path, 1, 1, "is empty: a header row is missing");
    collector_.finish(*reader_, metadata_path_);
  }

  std::string metadata_path_;
  Dataset& data_;
  CsvFile file_;
  std::optional<PointReader> reader_;  // made of the first row, before any thread
  Collector collector_{data_};
  std::size_t summary_line_ = kNoLine;
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
