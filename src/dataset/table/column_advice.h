// What to recommend where a table does not say which column is which.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/message.h"
#include "dataset/table/column_kinds.h"
#include "dataset/table/heading.h"

namespace mixity {

inline std::string name_of(ColumnId id) { return std::string(to_string(id)); }

/// The mapping of a column to a quantity, as in --columns="P=Load (mN)". It uses the column's number if its heading
/// would not be understood there, and UNIT as a placeholder if the unit of the heading is unknown or does not fit.
Remedy mapping(ColumnId id, const std::vector<Heading>& headings, std::size_t index);
/// One entry of a mapping, "P=Load (mN)", with a unit that the heading lacks.
std::string mapping_with(const std::string& unit, ColumnId id, const std::vector<Heading>& headings, std::size_t index);
/// Advice where columns are missing: "; not understood: 'x', 'y'. To say which column is P: --columns="P=HEADING
/// (UNIT)"", with the heading where only one has a unit that fits. Empty if no heading is left. `used`: those that are.
Message advice_on_missing(const std::vector<ColumnId>& missing, const std::vector<Heading>& headings,
                          const std::vector<bool>& used);
/// Advice where no column has the load: load_from, if the file's name has one force in it ("pad_12mN.txt"), else load.
Message advice_on_load(const std::string& path);

}  // namespace mixity
