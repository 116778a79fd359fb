// Points that a user leaves out of a data set.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/dataset.h"

namespace mixity {

/// Lines of the CSV, both included.
struct LineRange {
  std::size_t first, last;
  std::string file{};  // of a data set of several: its name, without folder; empty: of the only one
};
/// "17" or "40-58", or "run_3.csv:17". Null if the text is neither.
std::optional<LineRange> parse_lines(std::string_view text);

struct Exclusion {
  std::vector<LineRange> lines{};
  /// Runs by their name as outputs show it, or by their load ("4.68 mN") to the 0.1 % that a reader rounds it to.
  std::vector<std::string> runs{};
};

/// Moves these points to Dataset::excluded; a run that loses all of its points is none any more. Throws InputError for
/// lines that hold no point and for a run that the data set does not have, or if no point is left.
void exclude(Dataset& data, const Exclusion& which);

}  // namespace mixity
