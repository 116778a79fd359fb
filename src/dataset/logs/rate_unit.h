// Units of rates and intervals as instruments write them.
#pragma once

#include <optional>
#include <string_view>

#include "base/units.h"

namespace mixity {

/// The unit of a rate, in 1/s, or of an interval, in s: "Hz", "kS/s", "samples/min", "per minute", "fps", "ms per
/// sample", in brackets or not. Null for anything else.
std::optional<Unit> rate_unit(std::string_view text);

}  // namespace mixity
