#include "dataset/logs/recording.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/input_error.h"
#include "base/number_text.h"
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
      : metadata_(metadata),
        rules_(rules_of(metadata, inputs)),
        file_(path, inputs, {metadata.sheet, metadata.decimal, &rules_}) {
    rules_.log = true;
    recording_.path = path;
  }

  Recording read() {
    find_columns();
    for (CsvRow row; file_.next(row);) {
      if (row.is_comment()) continue;
      require_width(recording_.path, row, width_);
      for (Channel& channel : channels_) channel.values.push_back(value_of(row, channel));
      require_rise(row);
    }
    using enum ColumnId;
    if (channel(ColumnId::time)->values.size() < 3)
      throw InputError(recording_.path, "holds fewer than three rows of a log");
    take_times();
    const std::vector<double>& times = recording_.time;
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

  /// Seconds from the time of the first row. A clock without a date that goes back by hours has passed midnight.
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

  /// Requires that the time of this row, the last one read, does not decrease. Remembers the row's line.
  void require_rise(const CsvRow& row) {
    const Channel& clock = channels_[clock_];
    const std::size_t i = clock.values.size() - 1;
    const double time = clock.values[i];
    const auto fail = [&](const std::string& what) {
      throw InputError(recording_.path, row.place(clock.index), "column 'time': " + what);
    };
    if (!std::isfinite(time)) fail("the row has no time; leave it out, or " + by_rate());
    if (i > 0 && time < clock.values[i - 1])
      fail(rounded(time, 9) + " s after " + rounded(clock.values[i - 1], 9) +
           " s: the clock goes back; each part in which it rises is a log of its own");
    if (lines_.empty() || row.line() != lines_.back().line + (i - lines_.back().row)) lines_.push_back({i, row.line()});
  }

  std::size_t line_of(std::size_t i) const {
    const auto behind = std::upper_bound(lines_.begin(), lines_.end(), i,
                                         [](std::size_t row, const LineOfRow& one) { return row < one.row; });
    return (behind - 1)->line + (i - (behind - 1)->row);
  }

  static std::string by_rate() { return "give each row its own: its number divided by the rate of the rows"; }

  /// Rows that share a time: left out if each repeats the row before it, otherwise spread over the step of the clock.
  void take_times() {
    const std::vector<double>& stamps = channels_[clock_].values;
    const auto shares = [&](std::size_t i) { return i > 0 && stamps[i] == stamps[i - 1]; };
    const auto repeats = [&](std::size_t i) {
      return std::all_of(channels_.begin(), channels_.end(), [&](const Channel& one) {
        return one.values[i] == one.values[i - 1] || (std::isnan(one.values[i]) && std::isnan(one.values[i - 1]));
      });
    };
    std::vector<std::size_t> kept;
    bool all_repeat = true;
    for (std::size_t i = 0; i < stamps.size() && all_repeat; ++i)
      if (!shares(i))
        kept.push_back(i);
      else
        all_repeat = repeats(i);
    if (all_repeat && kept.size() >= 3 && kept.size() < stamps.size()) {
      recording_.clock.repeated = stamps.size() - kept.size();
      for (Channel& one : channels_) {
        for (std::size_t k = 0; k < kept.size(); ++k) one.values[k] = one.values[kept[k]];
        one.values.resize(kept.size());
      }
    }
    recording_.time = stamps;
    if (const ClockFault fault = spread_times(recording_.time, recording_.clock); !fault.reason.empty())
      throw InputError(recording_.path, line_of(fault.row), channels_[clock_].index == 0 ? 1 : 0,
                       "column 'time': " + fault.reason + ": no clock of one rate; " + by_rate());
  }

  void find_columns() {
    using enum ColumnId;
    const auto table = find_table(recording_.path, file_.start(), file_.line_end(), rules_, metadata_.decimal);
    if (!table) throw InputError(recording_.path, "holds no table with headings and rows of numbers");
    recording_.reading = file_.sheet() ? describe(*file_.sheet(), describe(*table)) : describe(*table);
    if (file_.sheet())
      for (const Message& note : file_.sheet()->notes) recording_.reading += "; " + note.text();
    const Columns columns(recording_.path, table->headings, rules_);
    recording_.taken = columns.taken;
    width_ = columns.count;
    for (const auto& column : columns.by_id) {
      if (!column) continue;
      const Heading& heading = table->headings[column->index];
      if (column->unit.dimension == dimension::none && column->id != ColumnId::time)
        throw InputError(recording_.path, heading.place,
                         "column '" + heading.name + "' needs a unit: a log is not dimensionless");
      if (column->id == ColumnId::time) clock_ = channels_.size();
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
  /// The values of a column; empty if there is none.
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

  const Metadata& metadata_;
  ColumnRules rules_;
  CsvFile file_;
  Recording recording_;
  std::vector<Channel> channels_;
  std::size_t width_ = 0, clock_ = 0;  // fields in a row; the channel of times
  struct LineOfRow {
    std::size_t row, line;
  };
  std::vector<LineOfRow> lines_;  // only rows that are not on the line after the last row
  std::optional<ClockTime> began_, last_;
  std::int64_t days_ = 0;
};

}  // namespace

Recording read_recording(const std::string& path, const Metadata& metadata, Inputs& inputs) {
  return LogReader(path, metadata, inputs).read();
}

}  // namespace mixity
