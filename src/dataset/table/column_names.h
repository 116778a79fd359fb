// Which heading names which quantity: by a mapping, by the program's own names, or by the vocabulary.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dataset/table/column_kinds.h"
#include "dataset/table/column_rules.h"
#include "dataset/table/heading.h"

namespace mixity {

/// A heading that names a quantity.
struct NamedColumn {
  ColumnId id;
  std::size_t index;
  Heading heading;  // with its unit, wherever that stands: "F_N / mN", "Reibkraft in N", "A_mm2"
};

/// Those that do, in their order, each quantity once. By `rules.mapping`; else by the program's own names; and if these
/// make no complete set, by the vocabulary. A name counts where the unit fits; one of the
/// program's own whose unit does not counts only if there is no other, and is to be refused for its unit. Throws
/// InputError for a mapping to a column that is not there, for two headings that name one quantity, and for one that
/// names a quantity without which there are no points and has no unit of it.
std::vector<NamedColumn> name_columns(const std::string& path, const std::vector<Heading>& headings,
                                      const ColumnRules& rules);

/// What says that this column is that quantity: --columns="P=Load (mN)". By its number where its heading would not be
/// understood there; with UNIT to be filled in where the heading's is not known or does not fit.
std::string mapping_flag(ColumnId id, const std::vector<Heading>& headings, std::size_t index);

/// Whether the heading states a unit that this quantity may have.
bool has_unit_of(const Heading& heading, ColumnId id);

/// Whether a number of pixels, or of square ones, may stand for this length or area.
bool is_pixels(const Dimension& found, const Dimension& wanted);

}  // namespace mixity
