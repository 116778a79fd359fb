#include "dataset/logs/recording.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "base/input_error.h"
#include "base/printable.h"
#include "dataset/table/clock_time.h"
#include "dataset/table/columns.h"
#include "dataset/table/number.h"
#include "dataset/table/table.h"

namespace mixity {
namespace {

/// A column of the log, and where its values go.
struct Channel {
  ColumnId id;
  std::size_t index;
  double factor;
  std::vector<double>* values;
};

class LogReader {
 public:
  LogReader(const std::string& path, const Metadata& metadata) : file_(path), metadata_(metadata) {
    recording_.path = path;
  }

  Recording read() {
    find_columns();
    CsvWanted wanted{{}, {}, width_};
    for (const Channel& channel : channels_) wanted.numbers.push_back(channel.index);
    const auto rows = [&](const CsvNumbers& numbers) {
      for (std::size_t k = 0; k < channels_.size(); ++k)
        for (std::size_t i = 0; i < numbers.size(); ++i)
          channels_[k].values->push_back(numbers.numbers(k)[i] * channels_[k].factor);
    };
    const auto row = [&](const CsvRow& one) {
      require_width(recording_.path, one, width_);
      for (const Channel& channel : channels_) {
        double value = 0;
        if (channel.id == ColumnId::time && clock_time(one, channel.index, value)) {
          channel.values->push_back(value);
          continue;
        }
        const bool given = number_at(recording_.path, one, channel.index, to_string(channel.id), value);
        channel.values->push_back(given ? value * channel.factor : std::nan(""));
      }
    };
    for (CsvBlock block; file_.next(block);) block.rows(wanted, rows, row);
    for (std::size_t i = 1; i < recording_.time.size(); ++i)
      if (!(recording_.time[i] >= recording_.time[i - 1]))
        throw InputError(recording_.path, first_line_ + i, 1, "the time does not rise from row to row");
    if (recording_.time.size() < 3) throw InputError(recording_.path, "holds fewer than three rows of a log");
    make_areas();
    if (recording_.P.empty() && recording_.holds_forces())
      recording_.P.assign(recording_.time.size(), metadata_.load.value_or(0));
    return std::move(recording_);
  }

 private:
  /// Of a field that holds no number, the seconds since the first row, which a clock shows; false of a number or an
  /// empty field. Without a date a clock that goes back by hours has passed midnight.
  bool clock_time(const CsvRow& row, std::size_t i, double& seconds) {
    constexpr std::int64_t kDay = 86400;
    double number = 0;
    if (row.number(i, number) || is_missing(row[i]) || row[i].empty()) return false;
    auto time = parse_clock(row[i]);
    const bool first = recording_.time.empty();
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
    seconds = static_cast<double>(time->seconds - began_->seconds) + (time->fraction - began_->fraction);
    return true;
  }

  void find_columns() {
    ColumnRules rules = rules_of(metadata_);
    rules.log = true;
    const auto table = find_table(recording_.path, file_.start(), file_.line_end(), rules, metadata_.decimal);
    if (!table) throw InputError(recording_.path, "holds no table with headings and rows of numbers");
    recording_.reading = describe(*table);
    for (const NamedColumn& column : name_columns(recording_.path, table->headings, rules)) {
      const ColumnKind& kind = kind_of(column.id);
      std::vector<double>* const values = values_of(column.id);
      if (!values) continue;
      const Unit unit = unit_of(column.heading, kind, recording_.path, false, metadata_.pixel);
      if (unit.dimension == dimension::none && column.id != ColumnId::time)
        throw InputError(recording_.path, column.heading.place,
                         "column '" + column.heading.name + "' needs a unit: a log is not dimensionless");
      channels_.push_back({column.id, column.index, unit.factor, values});
      width_ = std::max(width_, column.index + 1);
      if (column.id == ColumnId::T) {
        recording_.force_unit = unit.text;
        recording_.force_factor = unit.factor;
      } else if (column.id == ColumnId::A && kind.dimension == dimension::area) {
        recording_.area_unit = unit.text;
        recording_.area_factor = unit.factor;
      }
      if (column.heading.name != kind.name)
        recording_.taken.push_back(std::string(kind.name) + " from '" + table->headings[column.index].text + "'");
    }
    for (std::size_t i = 0; i < table->headings.size(); ++i)
      if (!table->headings[i].text.empty()) width_ = std::max(width_, i + 1);
    if (recording_.area_unit.starts_with("p") || recording_.area_unit.starts_with("P") ||
        recording_.area_unit.empty()) {
      recording_.area_unit = "mm^2";
      recording_.area_factor = 1e-6;
    }
    const auto has = [&](const std::vector<double>& values) {
      for (const Channel& channel : channels_)
        if (channel.values == &values) return true;
      return false;
    };
    if (!has(recording_.time))
      throw InputError(recording_.path, table->header_line, 1,
                       "column 'time' is missing; to say which it is: --columns=\"time=HEADING (s)\"");
    if (!has(recording_.T) && !has(recording_.A) && !has(one_))
      throw InputError(recording_.path, table->header_line, 1, "neither T nor A is there");
    if (has(recording_.T) && !has(recording_.P) && !metadata_.load)
      throw InputError(recording_.path, table->header_line, 1, "column 'P' is missing, and no load is stated");
    first_line_ = table->line;
    file_.begin_at(table->offset, table->line, table->format);
  }

  std::vector<double>* values_of(ColumnId id) {
    switch (id) {
      case ColumnId::time:
        return &recording_.time;
      case ColumnId::P:
        return &recording_.P;
      case ColumnId::T:
        return &recording_.T;
      case ColumnId::A:
        return &recording_.A;
      case ColumnId::a:
      case ColumnId::a_par:
      case ColumnId::major:
        whole_ = id == ColumnId::major;
        round_ = id == ColumnId::a;
        return &one_;
      case ColumnId::a_perp:
      case ColumnId::minor:
        return &other_;
      default:
        return nullptr;
    }
  }

  /// Of radii or axes.
  void make_areas() {
    if (!recording_.A.empty() || one_.empty()) return;
    if (!round_ && other_.size() != one_.size())
      throw InputError(recording_.path, "states one axis of an ellipse without the other");
    for (std::size_t i = 0; i < one_.size(); ++i)
      recording_.A.push_back(std::numbers::pi * one_[i] * (round_ ? one_[i] : other_[i]) / (whole_ ? 4 : 1));
  }

  CsvFile file_;
  const Metadata& metadata_;
  Recording recording_;
  std::vector<Channel> channels_;
  std::vector<double> one_, other_;  // radii or axes
  bool whole_ = false, round_ = false;
  std::size_t width_ = 0, first_line_ = 1;
  std::optional<ClockTime> began_, last_;
  std::int64_t days_ = 0;
};

}  // namespace

Recording read_recording(const std::string& path, const Metadata& metadata) { return LogReader(path, metadata).read(); }

}  // namespace mixity
