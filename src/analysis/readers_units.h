// Results in units in which a reader's numbers have few digits: 7.73 mN for a file's 0.00773 Newton.
#pragma once

#include <optional>

#include "analysis/result.h"

namespace mixity {

/// The result with forces, areas and lengths in such units. Null where those of the file are, so that texts keep the
/// file's unit wherever a person would. Sentences that stand in the result are unchanged; they choose units themselves.
std::optional<Analysis> in_readers_units(const Analysis& result);

}  // namespace mixity
