// Which column is which quantity: by a mapping, by the program's own names, or by the vocabulary.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dataset/table/vocabulary.h"

namespace mixity {

/// How to read the columns of a table.
struct ColumnRules {
  /// From quantities to headings, with or without their unit, or to numbers of columns.
  std::map<std::string, std::string> mapping{};
  std::shared_ptr<const Vocabulary> names{};  // null: the shipped vocabulary
  bool load_stated = false;                   // the table needs no column P
  std::optional<double> pixel{};              // m, the side of a pixel
  bool vocabulary = true;                     // false: only the program's own names count
  bool log = false;                           // the table needs a column of times, and T or A; only logs have times
  bool shared_mapping = false;                // the mapping is that of two tables: one may lack its columns
};

/// The columns that name quantities, in their order, each quantity once. The mapping of the user comes first, as it may
/// contradict all names, then the program's own names. The vocabulary, whose names may mean other things in other
/// files, is used if these are not a complete set; otherwise only for what may stand beside it: standard errors, names
/// of runs, include. A name counts if its unit fits. One of the program's own names
/// counts without a fitting unit if there is no other column, so that the unit is rejected. Throws InputError for a
/// mapping to a column that does not exist, for two headings that name one quantity, and for a name of a required
/// quantity with a unit that does not fit it.
std::vector<NamedColumn> name_columns(const std::string& path, const std::vector<Heading>& headings,
                                      const ColumnRules& rules);

/// The quantities of the mapping whose columns are in the table. A number of a column is in it if its unit fits.
std::vector<ColumnId> mapped_in(const std::vector<Heading>& headings, const ColumnRules& rules);

/// Those of them whose fields must be numbers; none if name_columns throws, which it does again when the table is read.
std::vector<NamedColumn> number_columns(const std::string& path, const std::vector<Heading>& headings,
                                        const ColumnRules& rules);

/// The mapping of a column to a quantity, as in --columns="P=Load (mN)". By number if its heading would not be
/// understood there, and with UNIT to be filled in if the unit of the heading is not known or does not fit.
Remedy mapping(ColumnId id, const std::vector<Heading>& headings, std::size_t index);
/// Part of one, "P=Load (mN)", with a unit that the heading lacks.
std::string mapping_with(const std::string& unit, ColumnId id, const std::vector<Heading>& headings, std::size_t index);

}  // namespace mixity
