// The columns of a table: which quantity each contains, in which unit.
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

struct Columns {
  /// Throws InputError as name_columns does, for a text that is not a unit, for a unit that does not fit its quantity,
  /// and, except of logs, for columns that make no points: MissingColumn if one is missing.
  Columns(const std::string& path, const std::vector<Heading>& headings, const ColumnRules& rules = {});
  Columns() = default;

  const Column* find(ColumnId id) const {
    const auto& column = by_id[static_cast<std::size_t>(id)];
    return column ? &*column : nullptr;
  }
  bool has(ColumnId id) const { return find(id) != nullptr; }
  /// P, T and A (or a, or the axes of an ellipse), rather than psi and Gc, or energies.
  bool holds_loads() const { return has(ColumnId::T); }
  /// G_I and G_II.
  bool holds_energies() const { return has(ColumnId::G_I); }
  /// The lengths that give the area; null if it has none.
  const ContactLengths* lengths() const {
    return contact_lengths([&](ColumnId id) { return has(id); });
  }

  std::array<std::optional<Column>, kColumnCount> by_id;
  std::size_t count = 0;             // fields in the header, up to the last with a name
  std::size_t needed = 0;            // of them, up to the last that is read
  std::vector<std::string> ignored;  // names of columns that are not read
  /// Ignored columns whose names are known, except of times; with the reason.
  std::vector<std::pair<std::string, std::string>> unused;
  std::vector<std::string> taken;  // headings other than the program's own names: "P from 'Normalkraft (mN)'"
  /// Columns whose names differ from those of P, T and A only in a number: runs beside the one that is read. Empty if
  /// there are none.
  std::string beside;

 private:
  void find_unused(const std::vector<Heading>& headings, const std::vector<bool>& used, const Vocabulary& vocabulary);
  void find_runs_beside(const std::vector<Heading>& headings, const std::vector<bool>& used);
  void require_a_complete_set(const std::string& path, const std::vector<Heading>& headings,
                              const ColumnRules& rules) const;
  void require_consistent_units(const std::string& path, const std::vector<Heading>& headings,
                                const ColumnRules& rules) const;
};

// ---- For any file with such a header. Each throws InputError with line and column. ----

/// The unit of a heading, which must fit the quantity; that of a plain number if it states none. Pixels become metres
/// by the size of a pixel. `alone`: it is the only heading of the table.
Unit unit_of(const Heading& heading, const ColumnKind& kind, const std::string& path, bool alone,
             std::optional<double> pixel = {});

bool holds_a_number(const CsvRow& row);

/// Requires as many fields as the header has; further ones must be empty or words. Where separators other than blanks
/// part them, those behind the `needed` ones may be missing, as LabVIEW's comments are in most rows.
void require_width(const std::string& path, const CsvRow& row, std::size_t count, std::size_t needed);

/// Advice to append to a message about a text that is not a number.
std::string_view decimal_comma_hint(std::string_view text);

/// Reads the number in field i, without its unit; false if the field is empty. `name`: of the column. `error`: set if
/// the field states a standard error; null if it must not.
bool number_at(const std::string& path, const CsvRow& row, std::size_t i, std::string_view name, double& value,
               double* error = nullptr);

}  // namespace mixity
