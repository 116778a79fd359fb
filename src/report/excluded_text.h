// What a data set leaves out, as text for a terminal.
#pragma once

#include <algorithm>
#include <ostream>
#include <string_view>

#include "dataset/dataset.h"

namespace mixity {

/// The first lines left out, each with its reason; nothing if there are none. `elsewhere`: what tells of all.
inline void write_excluded(std::ostream& out, const Dataset& data, std::string_view elsewhere) {
  constexpr std::size_t kShown = 8;
  if (data.excluded.empty()) return;
  out << "[[Excluded]]\n";
  for (std::size_t i = 0; i < std::min(kShown, data.excluded.size()); ++i)
    out << "    line " << data.excluded[i].line << ": " << data.excluded[i].reason << '\n';
  if (data.excluded.size() > kShown)
    out << "    and " << data.excluded.size() - kShown << " more (" << elsewhere << ")\n";
}

}  // namespace mixity
