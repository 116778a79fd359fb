#include "dataset/logs/log_clock.h"

#include <algorithm>
#include <cmath>

#include "base/input_error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "dataset/logs/stated_rate.h"
#include "dataset/table/column_advice.h"
#include "dataset/table/vocabulary.h"
#include "statistics/readings.h"

namespace mixity {
namespace {

std::string own_times() { return "give each row its own time: row number divided by the sampling rate"; }

}  // namespace

LogClock::LogClock(const std::string& path, const Table& table, const Columns& columns, const Metadata& metadata,
                   std::string_view head)
    : path_(path),
      table_(table),
      metadata_(metadata),
      head_(head),
      time_(columns.find(ColumnId::time)),
      frame_(columns.find(ColumnId::frame)),
      forces_(columns.has(ColumnId::T)),
      areas_(columns.has(ColumnId::A) || columns.lengths()) {
  if (!time_) count_by_rate(false);
}

/// The rate as an option or a line of the file states it. Where forces and areas are two files, frames are those of the
/// areas.
std::optional<double> LogClock::stated(bool by_frames) {
  const bool both = forces_ && areas_;
  const auto option = [&](const char* name, const std::optional<double>& value) {
    text_ = by_frames ? "times by the numbers of frames, " + rounded(*value, 6) + " a second"
                      : "times by the " + std::string(name) + " that is stated, " + rounded(*value, 6) + " Hz";
    return value;
  };
  if (metadata_.fps && (areas_ && (by_frames || both || !metadata_.rate))) return option("fps", metadata_.fps);
  if (metadata_.rate && (!by_frames || forces_)) return option("rate", metadata_.rate);
  const auto found = stated_rate(path_, head_, &not_taken_);
  if (!found) return std::nullopt;
  text_ = std::string(by_frames ? "times by the numbers of frames and" : "times by") + " the rate in line " +
          std::to_string(found->line) + ", " + rounded(found->rate, 6) + " Hz";
  return found->rate;
}

/// How to say which column holds the times: the only one with a unit of time, or any.
Remedy LogClock::time_column() const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < table_.headings.size(); ++i)
    if (const auto& unit = table_.headings[i].unit; unit && unit_fits(unit, ColumnId::time)) found.push_back(i);
  return found.size() == 1 ? mapping(ColumnId::time, table_.headings, found[0])
                           : Remedy::set("columns", "time=HEADING (s)");
}

/// Counts frames, or rows. Throws if their rate is not known.
void LogClock::count_by_rate(bool column_is_empty) {
  if (column_is_empty) {
    empty_ = time_->index;
    time_ = nullptr;
  }
  const auto rate = stated(frame_ != nullptr);
  if (rate) {
    rate_ = *rate;
    return;
  }
  const Remedy by_rate = Remedy::set("rate", "400 Hz"), by_frames = Remedy::set("fps", "25");
  Message text = column_is_empty ? "column 'time' is empty" : "column 'time' is missing";
  if (frame_)
    text += ", and '" + printable(table_.headings[frame_->index].text, 40) +
            "' counts frames or rows: say how many a " + "second: " + (areas_ ? by_frames : by_rate);
  else
    text += "; state the rate of the rows, such as " + (areas_ && !forces_ ? by_frames : by_rate);
  if (!column_is_empty) text += ", or which column it is: " + time_column();
  if (!not_taken_.empty()) text += "; " + not_taken_ + ", is not taken for it";
  throw InputError(path_, table_.header_line, 1, text);
}

double LogClock::time_of(const CsvRow& row) {
  if (times_.empty() && time_ && (row[time_->index].empty() || is_missing(row[time_->index]))) count_by_rate(true);
  const std::size_t i = times_.size();
  const std::size_t column = time_ ? time_->index : frame_ ? frame_->index : 0;
  const auto fail = [&](const std::string& name, const std::string& what) {
    throw InputError(path_, row.place(column), "column '" + name + "': " + what);
  };
  double time = 0;
  if (empty_ && !row[*empty_].empty() && !is_missing(row[*empty_]))
    fail("time", "the row has a time where rows above have none");
  if (time_ && row.number(column, time)) {
    if (is_form_of_clock(time_->unit.text))
      fail("time",
           "'" + std::string(row[column]) + "' is a number, not a time " + time_->unit.text + "; " + own_times());
    time *= time_->unit.factor;
  } else if (const auto given = time_ ? parse_quantity(row[column]) : std::nullopt;
             given && given->unit.dimension == dimension::time) {
    time = given->si();  // "0.02 sec", as MATLAB writes durations
  } else if (time_ && !row[column].empty() && !is_missing(row[column])) {
    time = clock_time(row);
  } else if (time_) {
    fail("time", "the row has no time; leave it out, or " + own_times());
  } else if (frame_) {
    time = frame_time(row);
  } else {
    time = static_cast<double>(i) / rate_;
  }
  if (!std::isfinite(time)) fail("time", "the row has no time; leave it out, or " + own_times());
  time += shift_;
  if (i == 0) return time;
  if (anew_ && i > 1 && time < times_[i - 1]) {
    const double next = 2 * times_[i - 1] - times_[i - 2];
    shift_ += next - time;
    time = next;
  }
  if (time < times_[i - 1] && starts_anew(time)) return time;
  if (goes_on(time))
    fail("time", "after " + rounded(times_[logs_.back() - 1], 9) + " s the clock goes back to " +
                     rounded(times_[logs_.back()], 9) + " s, and on from " + rounded(time, 9) +
                     " s, so that no log begins there; " + own_times());
  if (!time_ && frame_ && !(time > times_[i - 1]))
    fail("frame", "frame " + std::string(row[column]) + " after frame " + rounded(times_[i - 1] * rate_, 9) +
                      ": each row needs a frame of its own");
  if (time < times_[i - 1])
    fail("time", rounded(time, 9) + " s after " + rounded(times_[i - 1], 9) +
                     " s: the clock goes back, and not to the start of the log; split the file there");
  return time;
}

/// Whether this time, which lies before that of the row above, is about the first of the log.
bool LogClock::starts_anew(double time) const {
  constexpr double kSteps = 2;
  const std::size_t first = logs_.back();
  return times_.size() > first + 2 && std::abs(time - times_[first]) <= kSteps * (times_[first + 1] - times_[first]);
}

/// Whether this time is where the clock would be had it not gone back, and the row above is not: a fault of the clock.
bool LogClock::goes_on(double time) const {
  constexpr double kSteps = 2;
  if (logs_.size() < 2) return false;
  const std::size_t first = logs_[logs_.size() - 2], begin = logs_.back();
  const double last = times_[begin - 1], step = (last - times_[first]) / static_cast<double>(begin - 1 - first);
  const double expected = last + step * static_cast<double>(times_.size() - begin + 1);
  return std::abs(time - expected) <= kSteps * step && time - times_.back() > kSteps * step;
}

void LogClock::keep(const CsvRow& row, double time) {
  const std::size_t i = times_.size();
  if (logs_.empty() || time < times_[i - 1]) logs_.push_back(i);
  times_.push_back(time);
  anew_ = false;
  if (lines_.empty() || row.line() != lines_.back().line + (i - lines_.back().row)) lines_.push_back({i, row.line()});
}

double LogClock::frame_time(const CsvRow& row) const {
  double number = 0;
  if (!number_at(path_, row, frame_->index, "frame", number) || number != std::floor(number))
    throw InputError(path_, row.place(frame_->index),
                     "column 'frame': '" + printable(row[frame_->index], 40) + "' is no number of a frame");
  return number / rate_;
}

/// The seconds from the time of the first row to this one. Without a date, a clock that goes back by hours has passed
/// midnight.
double LogClock::clock_time(const CsvRow& row) {
  constexpr std::int64_t kDay = 86400;
  const bool first = times_.empty();
  auto time = parse_clock(row[time_->index]);
  if (!time || (!first && (!began_ || began_->dated != time->dated)))
    throw InputError(path_, row.place(time_->index),
                     "column 'time': '" + printable(row[time_->index], 60) +
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

std::string LogClock::unused_rate(const std::vector<double>& times) const {
  // The rate is that of forces where there are two files, and fps that of areas.
  const bool is_rate = metadata_.rate && forces_;
  if (!time_ || !(is_rate || (metadata_.fps && areas_))) return {};
  constexpr double kDeviation = 0.01;  // of clocks: crystals deviate by 1e-4, frame rates are rounded (29.97)
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(times[i] - times[i - 1]);
  const double rate = 1 / median(std::move(steps));
  const std::string name = is_rate ? "rate" : "fps", found = rounded(rate, 6) + " rows a second",
                    text = printable(table_.headings[time_->index].text, 40);
  if (is_rate && std::abs(rate / *metadata_.rate - 1) > kDeviation)
    throw InputError(path_, table_.header_line, 1,
                     "column '" + text + "' has " + found + ", and the rate that is stated is " +
                         rounded(*metadata_.rate, 6) + " Hz: leave out the one that is wrong");
  return "the " + name + " that is stated is not used: column '" + text + "' has " + found;
}

std::size_t LogClock::line_of(std::size_t i) const {
  const auto behind = std::upper_bound(lines_.begin(), lines_.end(), i,
                                       [](std::size_t row, const LineOfRow& one) { return row < one.row; });
  return (behind - 1)->line + (i - (behind - 1)->row);
}

std::vector<double> LogClock::spread(std::vector<double> times, std::size_t first, TimeBase& base) const {
  if (const ClockFault fault = spread_times(times, base); !fault.reason.empty())
    throw InputError(path_, line_of(first + fault.row), time_ && time_->index == 0 ? 1 : 0,
                     "column 'time': " + fault.reason + ": the rows do not come at a constant rate; " + own_times());
  return times;
}

}  // namespace mixity
