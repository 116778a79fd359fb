#include "dataset/table/clock_time.h"

#include <chrono>
#include <initializer_list>
#include <string>

#include "base/text.h"
#include "base/units.h"
#include "dataset/table/number.h"

namespace mixity {
namespace {

/// Takes a pattern off the front of a text: each run of 'd' stands for the digits of a number, other characters for
/// themselves. False if the text does not match.
bool take(std::string_view& text, std::string_view pattern, std::initializer_list<int*> numbers) {
  if (text.size() < pattern.size()) return false;
  auto number = numbers.begin();
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] != 'd' ? text[i] != pattern[i] : !is_digit(text[i])) return false;
    if (pattern[i] != 'd')
      ++number;
    else
      **number = 10 * **number + (text[i] - '0');
  }
  text.remove_prefix(pattern.size());
  return true;
}

bool take_one_of(std::string_view& text, std::string_view signs) {
  if (text.empty() || signs.find(text[0]) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

}  // namespace

std::optional<ClockTime> parse_clock(std::string_view text) {
  text = trim(text);
  ClockTime time;
  if (text.size() > 10 && text[4] == '-') {
    int year = 0, month = 0, day = 0;
    if (!take(text, "dddd-dd-dd", {&year, &month, &day}) || !take_one_of(text, "T ")) return std::nullopt;
    using namespace std::chrono;
    const year_month_day date{std::chrono::year{year}, std::chrono::month{static_cast<unsigned>(month)},
                              std::chrono::day{static_cast<unsigned>(day)}};
    if (!date.ok()) return std::nullopt;
    time.dated = true;
    time.seconds = std::int64_t{86400} * sys_days{date}.time_since_epoch().count();
  }
  int hours = 0, minutes = 0, seconds = 0;
  if (!take(text, text.find(':') == 1 ? "d:dd:dd" : "dd:dd:dd", {&hours, &minutes, &seconds}) || hours > 23 ||
      minutes > 59 || seconds > 59)
    return std::nullopt;
  time.seconds += 3600 * hours + 60 * minutes + seconds;
  if (take_one_of(text, ".,")) {
    std::string digits = "0.";
    for (; !text.empty() && is_digit(text[0]); text.remove_prefix(1)) digits += text[0];
    if (digits.size() == 2 || !parse_number(digits, time.fraction)) return std::nullopt;
  }
  if (time.dated && !text.empty() && !take_one_of(text, "Z")) {
    const int direction = text[0] == '-' ? 1 : -1;
    int zone_hours = 0, zone_minutes = 0;
    if (!take_one_of(text, "+-") || !take(text, "dd", {&zone_hours})) return std::nullopt;
    take_one_of(text, ":");
    if (!text.empty() && !take(text, "dd", {&zone_minutes})) return std::nullopt;
    time.seconds += direction * (3600 * zone_hours + 60 * zone_minutes);
  }
  return text.empty() ? std::optional(time) : std::nullopt;
}

}  // namespace mixity
