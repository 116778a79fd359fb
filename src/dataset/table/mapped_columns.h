// The columns that the user says are which: --columns="P=Kanal 3 (mN)".
#pragma once

#include <map>
#include <string>
#include <vector>

#include "dataset/table/column_names.h"

namespace mixity {

/// The column that the mapping says a quantity is, with the unit stated there. Throws InputError if there is none, if
/// there are two, or if its heading states another unit.
NamedColumn mapped_column(const std::string& path, const std::vector<Heading>& headings, ColumnId id,
                          const std::map<std::string, std::string>& mapping);

/// The quantities of the mapping whose columns are in the table. A number of a column is in it if its unit fits.
std::vector<ColumnId> mapped_in(const std::vector<Heading>& headings, const ColumnRules& rules);

/// The heading and unit of a named column as a mapping finds it in another table with these headings; its number and
/// unit if no heading would be understood.
std::string mapped_as(const NamedColumn& column, const std::vector<Heading>& headings);

}  // namespace mixity
