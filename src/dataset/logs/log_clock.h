// The times of the rows of a log: by a column of times, of frames, or by the rate of its rows.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/logs/time_base.h"
#include "dataset/metadata.h"
#include "dataset/table/columns.h"
#include "dataset/table/number.h"
#include "dataset/table/table.h"

namespace mixity {

class LogClock {
 public:
  /// `head`: the lines above the rows, which may state a rate. Throws InputError, which names the options, if there is
  /// neither a column of times nor a rate, and for a column of frames without frames a second. Texts and metadata must
  /// outlive this.
  LogClock(const std::string& path, const Table& table, const Columns& columns, const Metadata& metadata,
           std::string_view head);

  /// The time of the next row in s. A clock that starts anew begins another log; that of another table follows the
  /// table before at the same step. Throws InputError if the row has no time, or if the clock goes back otherwise.
  double time_of(const CsvRow& row);
  /// Adds it to the times.
  void keep(const CsvRow& row, double time);
  void begin_table() { anew_ = true; }

  const std::vector<double>& times() const { return times_; }
  /// The first row of each log; none without rows.
  const std::vector<std::size_t>& logs() const { return logs_; }
  /// The line of the file that has this row.
  std::size_t line_of(std::size_t row) const;
  /// Gives rows that share a stamp times of their own (time_base.h). `first`: the row of the first time. Throws
  /// InputError if no constant rate explains them.
  std::vector<double> spread(std::vector<double> times, std::size_t first, TimeBase& base) const;
  /// What to say about a rate that is stated although a column has the times, which are those of a log; empty if none
  /// is. Throws InputError if they have another rate.
  std::string unused_rate(const std::vector<double>& times) const;
  /// "times by the rate in line 3, 400 Hz"; empty if a column states them.
  const std::string& text() const { return text_; }

 private:
  double clock_time(const CsvRow& row);
  double frame_time(const CsvRow& row) const;
  void count_by_rate(bool column_is_empty);
  bool starts_anew(double time) const;
  bool goes_on(double time) const;
  std::optional<double> stated(bool by_frames);
  Remedy time_column() const;

  const std::string& path_;
  const Table& table_;
  const Metadata& metadata_;
  std::string head_, text_, not_taken_;
  const Column *time_, *frame_;  // null: there is no such column, or it is not read
  bool forces_, areas_;
  double rate_ = 0;                   // 1/s, of rows or frames
  std::optional<std::size_t> empty_;  // the column of times, if it is empty
  std::vector<double> times_;
  std::vector<std::size_t> logs_;
  double shift_ = 0;   // s, of the clock of this table
  bool anew_ = false;  // a table begins
  struct LineOfRow {
    std::size_t row, line;
  };
  std::vector<LineOfRow> lines_;  // where rows are not on the line behind the one before
  std::optional<ClockTime> began_, last_;
  std::int64_t days_ = 0;
};

}  // namespace mixity
