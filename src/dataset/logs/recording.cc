#include "dataset/logs/recording.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/input_error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "dataset/logs/log_clock.h"
#include "dataset/table/channel_clocks.h"
#include "dataset/table/column_advice.h"
#include "dataset/table/columns.h"
#include "dataset/table/csv_file.h"
#include "dataset/table/table_rows.h"
#include "dataset/table/vocabulary.h"
#include "statistics/readings.h"

namespace mixity {
namespace {

/// A column of the log.
struct Channel {
  ColumnId id;
  std::size_t index;
  double factor;
  std::vector<double> values{};
};

class LogReader : public UseOfRows {
 public:
  LogReader(const std::string& path, const Metadata& metadata, Inputs& inputs, bool one_of_two)
      : metadata_(metadata),
        rules_(rules_of(metadata, inputs)),
        file_(path, inputs, {metadata.sheet, metadata.decimal, &rules_}) {
    rules_.log = true;
    rules_.shared_mapping = one_of_two;
    recording_.path = path;
  }

  std::vector<Recording> read() {
    TableRows rows(recording_.path, file_,
                   {rules_, metadata_.decimal, number_of_table(metadata_),
                    [&](const Table& table) { return holds_readings(table); }});
    if (!rows.table()) throw InputError(recording_.path, "holds no table with headings and rows of numbers");
    columns_ = Columns(recording_.path, rows.table()->headings, rules_);
    find_columns(*rows.table(), columns_);
    channel_clocks_ = ChannelClocks(recording_.path, rows.table()->headings, columns_, rules_);
    clock_.emplace(recording_.path, *rows.table(), columns_, metadata_, rows.head());
    rows.read(*this);
    recording_.reading = file_.sheet() ? describe(*file_.sheet(), describe(rows)) : describe(rows);
    for (const Message& note : file_.notes()) recording_.reading += "; " + note.text();
    if (!clock_->text().empty()) recording_.reading += ", " + clock_->text();
    for (const auto& [line, names] : rows.other_tables())
      recording_.reading += ", the table in line " + std::to_string(line) + " not read";
    recording_.reading += lines_left_out();
    std::vector<std::size_t> begins = clock_->logs();
    if (begins.size() < 2) return {recording_of(0, clock_->times().size())};
    std::vector<Recording> logs;
    const std::vector<Channel> all = std::move(channels_);
    begins.push_back(clock_->times().size());
    for (std::size_t k = 0; k + 1 < begins.size(); ++k) {
      channels_.clear();
      for (const Channel& one : all)
        channels_.push_back({one.id, one.index, one.factor, part_of(one.values, begins[k], begins[k + 1])});
      logs.push_back(recording_of(begins[k], begins[k + 1]));
      logs.back().line = clock_->line_of(begins[k]);
    }
    return logs;
  }

  void row(const CsvRow& row) override {
    require_width(recording_.path, row, columns_.count, columns_.needed);
    const double time = clock_->time_of(row);
    values_.clear();
    for (const Channel& channel : channels_) values_.push_back(value_of(row, channel));
    channel_clocks_.take(row);
    clock_->keep(row, time);
    for (std::size_t k = 0; k < channels_.size(); ++k) channels_[k].values.push_back(values_[k]);
  }
  void left_out(std::size_t line, std::string_view reason) override { left_out_.emplace_back(line, reason); }
  void begin_table(const std::string&) override { clock_->begin_table(); }

 private:
  /// ", line 7 left out: words below the table", for the first few.
  std::string lines_left_out() const {
    constexpr std::size_t kShown = 8;
    std::string text;
    for (std::size_t i = 0; i < left_out_.size() && i < kShown; ++i)
      text += ", line " + std::to_string(left_out_[i].first) + " left out: " + std::string(left_out_[i].second);
    if (left_out_.size() > kShown) text += ", and " + std::to_string(left_out_.size() - kShown) + " more lines";
    return text;
  }
  /// The value in SI; NaN if the field is empty.
  double value_of(const CsvRow& row, const Channel& channel) {
    double value = 0;
    if (row.number(channel.index, value)) return value * channel.factor;
    const bool given = number_at(recording_.path, row, channel.index, to_string(channel.id), value);
    return given ? value * channel.factor : std::nan("");
  }

  /// The log in rows begin..end (end excluded), whose values the channels hold.
  Recording recording_of(std::size_t begin, std::size_t end) {
    using enum ColumnId;
    Recording log = recording_;
    if (end < begin + 3) {
      const bool whole = end == clock_->times().size() && begin == 0;
      throw InputError(log.path, whole ? 0 : clock_->line_of(begin), 0, "holds fewer than three rows of a log");
    }
    log.time = times_of(begin, end, log.clock);
    if (const std::string unused = clock_->unused_rate(log.time); !unused.empty()) log.reading += ", " + unused;
    log.T = values(T);
    log.A = has(A) ? values(A) : areas();
    log.q = axes();
    if (has(A) && !log.q.empty()) log.reading += area_beside(log.A, areas());
    log.load_is_stated = has(T) && !has(P);
    log.P = has(P) || !has(T) ? values(P) : std::vector<double>(log.time.size(), metadata_.load.value_or(0));
    return log;
  }

  /// Rows that share a time: left out if each repeats the row before it, otherwise spread over the step of the clock.
  std::vector<double> times_of(std::size_t begin, std::size_t end, TimeBase& clock) {
    std::vector<double> stamps = part_of(clock_->times(), begin, end);
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
      clock.repeated = stamps.size() - kept.size();
      const auto keep = [&](std::vector<double>& values) {
        for (std::size_t k = 0; k < kept.size(); ++k) values[k] = values[kept[k]];
        values.resize(kept.size());
      };
      for (Channel& one : channels_) keep(one.values);
      keep(stamps);
    }
    return clock_->spread(std::move(stamps), begin, clock);
  }

  bool holds_readings(const Table& table) const {
    try {
      const Columns columns(recording_.path, table.headings, rules_);
      return columns.has(ColumnId::T) || columns.has(ColumnId::A) || columns.lengths();
    } catch (const InputError&) {
      return false;
    }
  }

  void find_columns(const Table& table, const Columns& columns) {
    using enum ColumnId;
    recording_.headings = table.headings;
    recording_.taken = columns.taken;
    recording_.mapping = columns.mapped;
    for (const auto& column : columns.by_id) {
      if (!column || is_clock(column->id)) continue;
      const Heading& heading = table.headings[column->index];
      const bool degrees = column->id == angle && column->unit.dimension == dimension::none;
      if (column->unit.dimension == dimension::none && !degrees)
        throw InputError(recording_.path, heading.place,
                         "column '" + heading.name + "' needs a unit: a log is not dimensionless; say it: " +
                             Remedy::set("columns", units_to_state(table, columns)));
      channels_.push_back({column->id, column->index, degrees ? std::numbers::pi / 180 : column->unit.factor});
    }
    if (const Column* shear = columns.find(T)) {
      recording_.force_unit = shear->unit.text;
      recording_.force_factor = shear->unit.factor;
    }
    const Column* const area = columns.find(A);
    const bool pixels = area && (area->unit.text.starts_with("p") || area->unit.text.starts_with("P"));
    recording_.area_unit = area && !pixels ? area->unit.text : "mm^2";
    recording_.area_factor = area && !pixels ? area->unit.factor : 1e-6;
    const auto fail = [&](const Message& message) { throw InputError(recording_.path, table.header_line, 1, message); };
    if (!has(T) && !has(A) && !lengths())
      fail("neither T nor A is there" +
           columns.advice(columns.missing_loads(metadata_.load.has_value()), table.headings));
    if (has(T) && !has(P) && !metadata_.load)
      fail("column 'P' is missing, and no load is stated" + columns.advice({P}, table.headings));
    const auto may_hold = [&](ColumnId id) {
      return std::any_of(table.headings.begin(), table.headings.end(),
                         [&](const Heading& one) { return one.unit && unit_fits(one.unit, id); });
    };
    if (!has(A) && !lengths() && may_hold(A)) recording_.advice = columns.advice({A}, table.headings);
    if (!has(T) && may_hold(T))
      recording_.advice = columns.advice(columns.missing_loads(metadata_.load.has_value()), table.headings);
  }

  /// Entries of a mapping for all columns without a unit.
  static std::string units_to_state(const Table& table, const Columns& columns) {
    std::string entries;
    for (const auto& column : columns.by_id)
      if (column && !is_clock(column->id) && column->unit.dimension == dimension::none)
        entries += (entries.empty() ? "" : ",") + mapping_with("UNIT", column->id, table.headings, column->index);
    return entries;
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

  /// By how much a column of areas differs from that of the axes beside it, if by more than both scatter.
  static std::string area_beside(const std::vector<double>& area, const std::vector<double>& of_axes) {
    constexpr double kScatter = 0.05;
    std::vector<double> shares;
    for (std::size_t i = 0; i < area.size(); ++i)
      if (area[i] > 0 && of_axes[i] > 0) shares.push_back(area[i] / of_axes[i]);
    const double share = shares.empty() ? 1 : median(std::move(shares));
    if (std::abs(share - 1) <= kScatter) return {};
    return "; A is " + rounded(share, 3) + " times pi a b of the axes (median), and is used";
  }

  /// ln(a/b) of elliptic contacts along and across the shear; empty without both axes.
  std::vector<double> axes() const {
    const ContactLengths* const from = lengths();
    if (!from || from->round()) return {};
    std::vector<double> q = values(from->one);
    const std::vector<double> other = values(from->other), angles = values(ColumnId::angle);
    for (std::size_t i = 0; i < q.size(); ++i)
      q[i] = std::log(q[i] / other[i]) * turn_of_axes(*from, angles.empty() ? std::nullopt : std::optional(angles[i]));
    return q;
  }

  const Metadata& metadata_;
  ColumnRules rules_;
  CsvFile file_;
  Recording recording_;
  std::vector<Channel> channels_;
  std::vector<double> values_;                                      // of the row, by channel
  std::vector<std::pair<std::size_t, std::string_view>> left_out_;  // lines, and why
  Columns columns_;
  std::optional<LogClock> clock_;
  ChannelClocks channel_clocks_;
};

}  // namespace

std::vector<Heading> headings_of_log(const std::string& path, const Metadata& metadata, Inputs& inputs) {
  ColumnRules rules = rules_of(metadata, inputs);
  rules.log = rules.shared_mapping = true;
  CsvFile file(path, inputs, {metadata.sheet, metadata.decimal, &rules});
  const std::string_view start = file.start();  // which finds the line ends
  const auto table = find_table(path, start, file.line_end(), rules, metadata.decimal);
  return table ? table->headings : std::vector<Heading>{};
}

std::vector<Recording> read_recordings(const std::string& path, const Metadata& metadata, Inputs& inputs,
                                       bool one_of_two) {
  return LogReader(path, metadata, inputs, one_of_two).read();
}

}  // namespace mixity
