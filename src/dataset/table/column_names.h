// Assigns columns to quantities: by a mapping, the program's own names, or the vocabulary.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dataset/table/vocabulary.h"

namespace mixity {

/// The rules for reading the columns of a table.
struct ColumnRules {
  /// Quantities to headings (with or without unit) or to column numbers.
  std::map<std::string, std::string> mapping{};
  std::shared_ptr<const Vocabulary> names{};  // null: the shipped vocabulary
  bool load_stated = false;                   // the table needs no column P
  bool approach_held = false;                 // it has a column delta, and P is optional
  std::optional<double> pixel{};              // m, the side of a pixel
  bool vocabulary = true;                     // false: only the program's own names count
  bool log = false;                           // the table needs a column of times, and T or A; only logs have times
  bool shared_mapping = false;                // the mapping is that of two tables: one may lack its columns

  /// The vocabulary. The shipped one takes a while to read when it is first asked for.
  const Vocabulary& known_names() const { return names ? *names : Vocabulary::shipped(); }
};

/// The columns that name quantities, in their order, each quantity once. The user's mapping comes first, as it may
/// contradict all names, then the program's own names. If these are incomplete, the vocabulary is used, whose names may
/// mean other things in other files; otherwise it serves only for optional columns: standard errors, names of runs,
/// include. A name counts if its unit fits. One of the program's own names counts even if its unit does not fit when
/// there is no other column, so that the unit is rejected. Throws InputError for a mapping to a column that does not
/// exist, for two headings of one quantity, and for a required quantity with a unit that does not fit.
std::vector<NamedColumn> name_columns(const std::string& path, const std::vector<Heading>& headings,
                                      const ColumnRules& rules);

/// The named columns whose fields must be numbers; none if name_columns throws, as it will when the table is read.
std::vector<NamedColumn> number_columns(const std::string& path, const std::vector<Heading>& headings,
                                        const ColumnRules& rules);

}  // namespace mixity
