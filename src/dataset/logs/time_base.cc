#include "dataset/logs/time_base.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "base/phrases.h"
#include "statistics/readings.h"

namespace mixity {
namespace {

/// Rows with the same time.
struct Stamp {
  double time;
  std::size_t first, count;
};

std::vector<Stamp> stamps_of(const std::vector<double>& time) {
  std::vector<Stamp> stamps;
  for (std::size_t i = 0; i < time.size(); ++i)
    if (stamps.empty() || time[i] != stamps.back().time)
      stamps.push_back({time[i], i, 1});
    else
      ++stamps.back().count;
  return stamps;
}

/// The step of a clock, and the number of rows in a step.
struct Rate {
  double step, rows;
};

/// The typical rate between the first and the last stamp, which may be incomplete.
Rate rate_of(const std::vector<Stamp>& stamps) {
  std::vector<double> steps, rows;
  for (std::size_t k = 1; k + 1 < stamps.size(); ++k) {
    steps.push_back(stamps[k + 1].time - stamps[k].time);
    rows.push_back(static_cast<double>(stamps[k].count));
  }
  return {median(steps), median(rows)};
}

std::string seconds(double time) { return rounded(time, 6) + " s"; }

}  // namespace

ClockFault spread_times(std::vector<double>& time, TimeBase& base) {
  constexpr double kMore = 0.25;         // of the rows of a stamp: tolerated variation of the rate
  constexpr std::size_t kFewStamps = 4;  // of which two are complete
  const std::vector<Stamp> stamps = stamps_of(time);
  if (stamps.size() == time.size()) return {};
  if (stamps.size() < kFewStamps)
    return {0, "only " + counted(stamps.size(), "stamp") + " for " + std::to_string(time.size()) + " rows"};
  const Rate rate = rate_of(stamps);
  const bool coarse = rate.rows > 1;  // if most rows have distinct times, a pause is allowed
  std::vector<double> spread = time;
  for (std::size_t k = 0; k < stamps.size(); ++k) {
    const Stamp& one = stamps[k];
    const bool last = k + 1 == stamps.size(), cut = last || k == 0;
    const double lasts = last ? rate.step : stamps[k + 1].time - one.time, rows = static_cast<double>(one.count);
    const double expected = rate.rows * (lasts / rate.step), tolerated = 1 + kMore * expected;
    if (rows > expected + tolerated)
      return {one.first, counted(one.count, "row") + " share the stamp " + seconds(one.time) + ", where some " +
                             rounded(expected, 2) + " would be usual"};
    if (coarse && !last && rows < expected - tolerated && (!cut || lasts > 1.5 * rate.step))
      return {one.first, "the stamp " + seconds(one.time) + " has " + counted(one.count, "row") + " for the " +
                             seconds(lasts) + " up to the next one, where some " + rounded(expected, 2) +
                             " would be usual"};
    // an incomplete stamp, or one before a pause, has the rate of the others
    const bool own_rate = !cut && lasts <= 1.5 * rate.step;
    const double apart = own_rate ? lasts / rows : std::min(lasts / rows, rate.step / rate.rows);
    const double begin = k == 0 && coarse ? stamps[1].time - apart * rows : one.time;
    for (std::size_t i = 0; i < one.count; ++i) spread[one.first + i] = begin + static_cast<double>(i) * apart;
    if (one.count > 1) base.shared += one.count;
  }
  for (std::size_t i = 1; i < spread.size(); ++i)
    if (!(spread[i] > spread[i - 1])) return {i, "times as large as " + seconds(time[i]) + " have no room for more"};
  base.stamp = rate.step;
  time = std::move(spread);
  return {};
}

}  // namespace mixity
