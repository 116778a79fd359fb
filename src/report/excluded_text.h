// What a data set leaves out, as text for a terminal.
#pragma once

#include <algorithm>
#include <ostream>
#include <string_view>
#include <vector>

#include "dataset/dataset.h"

namespace mixity {

inline constexpr std::size_t kShownExcluded = 8;

/// The first of a list, each a line that begins so. `elsewhere`: what tells of all.
inline void write_first(std::ostream& out, const Dataset& data, const std::vector<Excluded>& list,
                        std::string_view beginning, std::string_view elsewhere) {
  for (std::size_t i = 0; i < std::min(kShownExcluded, list.size()); ++i)
    out << "    " << beginning << data.line_text(list[i].line) << ": " << list[i].reason << '\n';
  if (list.size() > kShownExcluded)
    out << "    and " << list.size() - kShownExcluded << " more (" << elsewhere << ")\n";
}

/// The first lines left out, each with its reason; nothing if there are none. `elsewhere`: what tells of all.
inline void write_excluded(std::ostream& out, const Dataset& data, std::string_view elsewhere) {
  if (data.excluded.empty()) return;
  out << "[[Excluded]]\n";
  write_first(out, data, data.excluded, "", elsewhere);
}

}  // namespace mixity
