// The columns of a data CSV: which quantity each holds, in which unit.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/input_error.h"
#include "base/units.h"
#include "dataset/table/column_names.h"

namespace mixity {

/// The header of a table has no column for a quantity that is needed.
class MissingColumn : public InputError {
  using InputError::InputError;
};

struct Column {
  ColumnId id;
  std::size_t index;  // 0-based position in the row
  Unit unit;
};

class Columns {
 public:
  /// Throws InputError as name_columns does, for a unit that is none or of the wrong kind, and for a set of columns of
  /// which no point can be made: MissingColumn if one is missing.
  Columns(const std::string& path, const std::vector<Heading>& headings, const ColumnRules& rules = {});

  const Column* find(ColumnId id) const {
    const auto& column = columns_[static_cast<std::size_t>(id)];
    return column ? &*column : nullptr;
  }
  bool has(ColumnId id) const { return find(id) != nullptr; }
  std::size_t count() const { return count_; }                          // fields in the header, to the last with a name
  const std::vector<std::string>& ignored() const { return ignored_; }  // names of columns that are not read
  /// Those of them that differ from the name of a missing quantity in case or punctuation only; with that name.
  const std::vector<std::pair<std::string, std::string>>& misspelt() const { return misspelt_; }
  /// Headings other than the program's own names: "P from 'Normalkraft (mN)'".
  const std::vector<std::string>& taken() const { return taken_; }
  /// Columns that have the names of all those of P, T and A but for a number: other runs beside the one that is read.
  /// Empty if there are none.
  const std::string& beside() const { return beside_; }
  /// P, T and A (or a, or the axes of an ellipse), rather than psi and Gc, or energies.
  bool holds_loads() const { return has(ColumnId::T); }
  /// G_I and G_II.
  bool holds_energies() const { return has(ColumnId::G_I); }
  /// The axes of an ellipse.
  bool holds_axes() const { return has(ColumnId::a_par) || has(ColumnId::major); }

 private:
  void require_a_complete_set(const std::string& path, const std::vector<Heading>& headings,
                              const ColumnRules& rules) const;
  void require_consistent_units(const std::string& path, const std::vector<Heading>& headings) const;

  std::array<std::optional<Column>, kColumnCount> columns_;
  std::vector<std::string> ignored_, taken_;
  std::string beside_;
  std::vector<std::pair<std::string, std::string>> misspelt_;
  std::size_t count_ = 0;
};

// ---- For any file with such a header. Each throws InputError with line and column. ----

/// The unit of a heading, if the quantity may have it; none if it states none. Pixels become metres if their size is
/// stated. `alone`: it is the only heading of the table.
Unit unit_of(const Heading& heading, const ColumnKind& kind, const std::string& path, bool alone,
             std::optional<double> pixel = {});

bool holds_a_number(const CsvRow& row);

/// Requires as many fields as the header has; further ones must be empty.
void require_width(const std::string& path, const CsvRow& row, std::size_t count);

/// Advice behind the message on a text that is no number.
std::string_view decimal_comma_hint(std::string_view text);

/// Reads the number in field i, without its unit; false if the field is empty. `name`: of the column.
bool number_at(const std::string& path, const CsvRow& row, std::size_t i, std::string_view name, double& value);

}  // namespace mixity
