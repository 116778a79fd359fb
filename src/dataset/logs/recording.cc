#include "dataset/logs/recording.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/input_error.h"
#include "base/text.h"
#include "dataset/table/columns.h"
#include "dataset/table/csv_file.h"
#include "dataset/table/number.h"
#include "dataset/table/table.h"

namespace mixity {
namespace {

/// A column of the log.
struct Channel {
  ColumnId id;
  std::size_t index;
  double factor;
  std::vector<double> values{};
};

class LogReader {
 public:
  LogReader(const std::string& path, const Metadata& metadata, Inputs& inputs)
      : file_(path, inputs), metadata_(metadata), rules_(rules_of(metadata, inputs)) {
    rules_.log = true;
    recording_.path = path;
  }

  Recording read() {
    find_columns();
    for (CsvRow row; file_.next(row);) {
      if (row.is_comment()) continue;
      require_width(recording_.path, row, width_);
      for (Channel& channel : channels_) channel.values.push_back(value_of(row, channel));
    }
    using enum ColumnId;
    recording_.time = values(ColumnId::time);
    const std::vector<double>& times = recording_.time;
    for (std::size_t i = 1; i < times.size(); ++i)
      if (!(times[i] >= times[i - 1]))
        throw InputError(recording_.path, first_line_ + i, 1, "the time does not rise from row to row");
    if (times.size() < 3) throw InputError(recording_.path, "holds fewer than three rows of a log");
    recording_.T = values(T);
    recording_.A = has(A) ? values(A) : areas();
    recording_.P = has(P) || !has(T) ? values(P) : std::vector<double>(times.size(), metadata_.load.value_or(0));
    return std::move(recording_);
  }

 private:
  /// The value in SI; NaN if the field is empty.
  double value_of(const CsvRow& row, const Channel& channel) {
    double value = 0;
    if (row.number(channel.index, value)) return value * channel.factor;
    if (channel.id == ColumnId::time && !is_missing(row[channel.index]) && !row[channel.index].empty())
      return clock_time(row, channel.index, channel.values.empty());
    const bool given = number_at(recording_.path, row, channel.index, to_string(channel.id), value);
    return given ? value * channel.factor : std::nan("");
  }

  /// The seconds from the time of the first row to this one. Without a date, a clock that goes back by hours has passed
  /// midnight.
  double clock_time(const CsvRow& row, std::size_t i, bool first) {
    constexpr std::int64_t kDay = 86400;
    auto time = parse_clock(row[i]);
    if (!time || (!first && (!began_ || began_->dated != time->dated)))
      throw InputError(recording_.path, row.place(i),
                       "column 'time': '" + printable(row[i], 60) +
                           (!time ? "' is neither a number nor a time such as 10:05:00.25 or 2026-05-01T10:05:00.25"
                                  : "' is of another kind than the times above"));
    if (first) began_ = last_ = time;
    if (!time->dated) {
      time->seconds += days_ * kDay;
      if (time->seconds < last_->seconds - kDay / 2) {
        time->seconds += kDay;
        ++days_;
      }
    }
    last_ = time;
    return static_cast<double>(time->seconds - began_->seconds) + (time->fraction - began_->fraction);
  }

  void find_columns() {
    using enum ColumnId;
    const auto table = find_table(recording_.path, file_.start(), file_.line_end(), rules_, metadata_.decimal);
    if (!table) throw InputError(recording_.path, "holds no table with headings and rows of numbers");
    recording_.reading = describe(*table);
    const Columns columns(recording_.path, table->headings, rules_);
    recording_.taken = columns.taken;
    width_ = columns.count;
    for (const auto& column : columns.by_id) {
      if (!column) continue;
      const Heading& heading = table->headings[column->index];
      if (column->unit.dimension == dimension::none && column->id != ColumnId::time)
        throw InputError(recording_.path, heading.place,
                         "column '" + heading.name + "' needs a unit: a log is not dimensionless");
      channels_.push_back({column->id, column->index, column->unit.factor});
    }
    if (const Column* shear = columns.find(T)) {
      recording_.force_unit = shear->unit.text;
      recording_.force_factor = shear->unit.factor;
    }
    const Column* const area = columns.find(A);
    const bool pixels = area && (area->unit.text.starts_with("p") || area->unit.text.starts_with("P"));
    recording_.area_unit = area && !pixels ? area->unit.text : "mm^2";
    recording_.area_factor = area && !pixels ? area->unit.factor : 1e-6;
    const auto fail = [&](const Message& message) {
      throw InputError(recording_.path, table->header_line, 1, message);
    };
    if (!has(ColumnId::time))
      fail("column 'time' is missing; to say which it is: " + Remedy::set("columns", "time=HEADING (s)"));
    if (!has(T) && !has(A) && !lengths()) fail("neither T nor A is there");
    if (has(T) && !has(P) && !metadata_.load) fail("column 'P' is missing, and no load is stated");
    first_line_ = table->line;
    file_.begin_at(table->offset, table->line, table->format);
  }

  const Channel* channel(ColumnId id) const {
    const auto found =
        std::find_if(channels_.begin(), channels_.end(), [&](const Channel& one) { return one.id == id; });
    return found == channels_.end() ? nullptr : &*found;
  }
  bool has(ColumnId id) const { return channel(id); }
  const ContactLengths* lengths() const {
    return contact_lengths([&](ColumnId id) { return has(id); });
  }
  /// Empty if there is no such column.
  std::vector<double> values(ColumnId id) const { return has(id) ? channel(id)->values : std::vector<double>{}; }

  /// Areas from radii or axes; empty if there are neither.
  std::vector<double> areas() const {
    const ContactLengths* const from = lengths();
    if (!from) return {};
    std::vector<double> areas = values(from->one);
    const std::vector<double> other = values(from->other);
    if (areas.size() != other.size())
      throw InputError(recording_.path, "states one axis of an ellipse without the other");
    for (std::size_t i = 0; i < areas.size(); ++i) areas[i] = std::numbers::pi * areas[i] * other[i] / from->parts;
    return areas;
  }

  CsvFile file_;
  const Metadata& metadata_;
  ColumnRules rules_;
  Recording recording_;
  std::vector<Channel> channels_;
  std::size_t width_ = 0, first_line_ = 1;
  std::optional<ClockTime> began_, last_;
  std::int64_t days_ = 0;
};

}  // namespace

Recording read_recording(const std::string& path, const Metadata& metadata, Inputs& inputs) {
  return LogReader(path, metadata, inputs).read();
}

}  // namespace mixity
