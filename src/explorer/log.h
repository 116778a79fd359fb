// The loading runs of a log for the page.
#pragma once

#include <string>
#include <vector>

#include "dataset/logs/reduced_log.h"
#include "report/json.h"

namespace mixity::explorer {

/// Whether these files are one or more logs rather than points: one of them looks like a log (Dataset::like_a_log), or
/// is no data set but a recording of forces or of areas.
bool are_logs(const std::vector<std::string>& names, const Overrides& constants);

/// Finds the loading runs as `mixity runs` does, and writes its files with names that begin with `stem` and "_":
/// {"data": the file of points, "peaks": that of peaks, "files": {"runs", "constants", "peaks", "cuts": name},
/// "contents": {name: text}, "text": how the log was read, "runs": [{"name", "P", "T", "frames", "shear", "onset":
/// {"time", "low", "high", "stated"} or null, "falls"}], "units": {"force"}, "figures": [{"T": figure, "A": figure}]}
/// with figures {"title", "x", "y": [label, low, high], "series": [{"label", "look", "color", "points"}], "caption"}.
/// Throws InputError as reduce_logs does, and if there is no run.
Json cut_logs(const std::vector<std::string>& names, const std::string& stem, const Overrides& constants);

}  // namespace mixity::explorer
