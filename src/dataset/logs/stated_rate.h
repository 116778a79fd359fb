// The rate of the rows of a log as the lines above its table state it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace mixity {

struct StatedRate {
  double rate = 0;       // 1/s
  std::size_t line = 0;  // of the file
};

/// Reads "Sample rate: 400 Hz", "Sampling interval, 2.5 ms", "Abtastrate [samples/min];24000", LabVIEW's "Delta_X
/// 0.0025 0.0025". A rate without a unit is in Hz, Delta_X and dt in s; other intervals without a unit are passed over,
/// and so are rates with another word beside them ("Max. sampling rate", "Camera frame rate") and with an unknown unit.
/// Null if no line states a rate. Throws InputError if two lines state different ones. `not_taken`: receives the first
/// line that names a rate and is passed over.
std::optional<StatedRate> stated_rate(const std::string& path, std::string_view head, std::string* not_taken = nullptr);

}  // namespace mixity
