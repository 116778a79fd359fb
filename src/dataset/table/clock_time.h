// Times as clocks show them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace mixity {

struct ClockTime {
  bool dated = false;
  std::int64_t seconds = 0;  // whole ones since midnight, or since 1970 where it is dated
  double fraction = 0;       // of one
};

/// "10:05:00.000", or with a date before it as ISO 8601 has them: "2026-05-01T10:05:00,5Z", "2026-05-01
/// 10:05:00+02:00". Null for anything else.
std::optional<ClockTime> parse_clock(std::string_view text);

}  // namespace mixity
