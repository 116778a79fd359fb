#include "dataset/table/clock_time.h"

#include <cctype>
#include <chrono>
#include <string>

#include "base/trim.h"
#include "base/units.h"

namespace mixity {
namespace {

/// So many digits at the front of a text, taken off; null if there are others.
std::optional<int> take_digits(std::string_view& text, std::size_t count) {
  if (text.size() < count) return std::nullopt;
  int value = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isdigit(static_cast<unsigned char>(text[i]))) return std::nullopt;
    value = 10 * value + (text[i] - '0');
  }
  text.remove_prefix(count);
  return value;
}

bool take_sign(std::string_view& text, std::string_view signs) {
  if (text.empty() || signs.find(text[0]) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

}  // namespace

std::optional<ClockTime> parse_clock(std::string_view text) {
  text = trim(text);
  ClockTime time;
  if (text.size() > 10 && text[4] == '-') {
    const auto year = take_digits(text, 4);
    const bool first = take_sign(text, "-");
    const auto month = take_digits(text, 2);
    const bool second = take_sign(text, "-");
    const auto day = take_digits(text, 2);
    if (!year || !first || !month || !second || !day || !take_sign(text, "T ")) return std::nullopt;
    using namespace std::chrono;
    const year_month_day date{std::chrono::year{*year}, std::chrono::month{static_cast<unsigned>(*month)},
                              std::chrono::day{static_cast<unsigned>(*day)}};
    if (!date.ok()) return std::nullopt;
    time.dated = true;
    time.seconds = std::int64_t{86400} * sys_days{date}.time_since_epoch().count();
  }
  const auto hours = take_digits(text, text.find(':') == 1 ? 1 : 2);
  const bool first = take_sign(text, ":");
  const auto minutes = take_digits(text, 2);
  const bool second = take_sign(text, ":");
  const auto seconds = take_digits(text, 2);
  if (!hours || !first || !minutes || !second || !seconds || *hours > 23 || *minutes > 59 || *seconds > 59)
    return std::nullopt;
  time.seconds += 3600 * *hours + 60 * *minutes + *seconds;
  if (take_sign(text, ".,")) {
    std::size_t digits = 0;
    while (digits < text.size() && std::isdigit(static_cast<unsigned char>(text[digits]))) ++digits;
    const auto fraction = parse_number("0." + std::string(text.substr(0, digits)));
    if (digits == 0 || !fraction) return std::nullopt;
    time.fraction = *fraction;
    text.remove_prefix(digits);
  }
  if (time.dated && !text.empty() && !take_sign(text, "Z")) {
    const int direction = text[0] == '-' ? 1 : -1;
    if (!take_sign(text, "+-")) return std::nullopt;
    const auto zone_hours = take_digits(text, 2);
    take_sign(text, ":");
    const auto zone_minutes = text.empty() ? std::optional(0) : take_digits(text, 2);
    if (!zone_hours || !zone_minutes) return std::nullopt;
    time.seconds += direction * (3600 * *zone_hours + 60 * *zone_minutes);
  }
  return text.empty() ? std::optional(time) : std::nullopt;
}

}  // namespace mixity
