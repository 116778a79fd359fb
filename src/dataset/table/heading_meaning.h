// The quantity and the unit that a heading names.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "dataset/table/column_kinds.h"
#include "dataset/table/heading.h"

namespace mixity {

class Vocabulary;

/// A heading that names a quantity.
struct NamedColumn {
  ColumnId id;
  std::size_t index;
  Heading heading;  // with its unit, wherever that is: "F_N / mN", "Reibkraft in N", "A_mm2"
};

/// By the program's own names and the vocabulary; null if the heading names no quantity. `with_unit`: it must contain a
/// unit.
std::optional<NamedColumn> read_heading(const Heading& heading, std::size_t index, const Vocabulary& vocabulary,
                                        bool with_unit = false);

/// Whether a quantity may have this unit; none is fine.
bool unit_fits(const std::optional<std::string>& unit, ColumnId id);

/// Whether these are pixels or square pixels, in which such a length or area may be given.
bool is_pixels(const Dimension& found, const Dimension& wanted);

}  // namespace mixity
