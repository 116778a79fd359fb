// Which column is which quantity: by a mapping, by the program's own names, or by the vocabulary.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dataset/table/column_rules.h"
#include "dataset/table/heading_meaning.h"

namespace mixity {

/// The columns that name quantities, in their order, each quantity once. The mapping of the user comes first, as it may
/// contradict all names; then the program's own names; and only if these make no complete set the vocabulary, whose
/// names may mean other things in other files. A name counts if its unit fits; one of the program's own counts without
/// it if there is no other, so that its unit is refused. Throws InputError for a mapping to a column that is not there,
/// for two headings that name one quantity, and for a name of a required quantity with a unit that is not one of it.
std::vector<NamedColumn> name_columns(const std::string& path, const std::vector<Heading>& headings,
                                      const ColumnRules& rules);

/// Those of them whose fields have to be numbers; none if name_columns throws: whoever reads the table gets that error.
std::vector<NamedColumn> number_columns(const std::string& path, const std::vector<Heading>& headings,
                                        const ColumnRules& rules);

/// The mapping of a column to a quantity: --columns="P=Load (mN)". By its number if its heading would not be understood
/// there; with UNIT to be filled in if that of the heading is not known or does not fit.
Remedy mapping(ColumnId id, const std::vector<Heading>& headings, std::size_t index);

}  // namespace mixity
