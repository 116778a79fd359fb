// The columns of a table: the quantity and unit of each.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/input_error.h"
#include "base/units.h"
#include "dataset/table/column_names.h"

namespace mixity {

/// The header of a table lacks a column for a required quantity.
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
  /// and, except for logs, for columns that give no points: MissingColumn if one is missing.
  Columns(const std::string& path, const std::vector<Heading>& headings, const ColumnRules& rules = {});
  Columns() = default;

  const Column* find(ColumnId id) const {
    const auto& column = by_id[static_cast<std::size_t>(id)];
    return column ? &*column : nullptr;
  }
  bool has(ColumnId id) const { return find(id) != nullptr; }
  /// True for P, T and A (or a, or the axes of an ellipse); false for psi and Gc, or energies.
  bool holds_loads() const { return has(ColumnId::T) || holds_pull_off(); }
  /// True for P_c with T or u: loads without areas.
  bool holds_pull_off() const { return has(ColumnId::P_c); }
  /// True for G_I and G_II.
  bool holds_energies() const { return has(ColumnId::G_I); }
  /// The lengths that give the area; null if the table has none.
  const ContactLengths* lengths() const {
    return contact_lengths([&](ColumnId id) { return has(id); });
  }
  /// Those of P, T and A that the table lacks.
  std::vector<ColumnId> missing_loads(bool load_stated) const;
  /// How to say which columns they are; see advice_on_missing.
  Message advice(const std::vector<ColumnId>& missing, const std::vector<Heading>& headings) const;

  std::array<std::optional<Column>, kColumnCount> by_id;
  std::size_t count = 0;             // fields in the header, up to the last with a name
  std::size_t needed = 0;            // of them, up to the last that is read
  std::vector<std::string> ignored;  // names of columns that are not read
  /// Ignored columns with known or misspelt names, except times, and why they are ignored.
  std::vector<std::pair<std::string, std::string>> unused;
  std::map<std::string, std::string> mapped;  // each quantity that is read, to its column in another such table
  std::vector<std::string> taken;  // headings that differ from the program's own names: "P from 'Normalkraft (mN)'"
  /// Columns whose names differ from those of P, T and A only in a number: runs beside the one that is read. Empty if
  /// none.
  std::string beside;

 private:
  void find_unused(const std::vector<Heading>& headings, const std::vector<bool>& used, const ColumnRules& rules);
  /// The optional quantity, not read from another column, that a misspelt heading names.
  std::optional<ColumnId> meant_column(const Heading& heading) const;
  void find_runs_beside(const std::vector<Heading>& headings, const std::vector<bool>& used);
  void require_a_complete_set(const std::string& path, const std::vector<Heading>& headings,
                              const ColumnRules& rules) const;
  void require_consistent_units(const std::string& path, const std::vector<Heading>& headings,
                                const ColumnRules& rules) const;
};

// ---- For any file with such a header. Each function throws InputError with line and column. ----

/// The unit of a heading, which must fit the quantity; without one, that of a plain number. Pixels become metres by the
/// size of a pixel. `alone`: the table has no other heading.
Unit unit_of(const Heading& heading, const ColumnKind& kind, const std::string& path, bool alone,
             std::optional<double> pixel = {});

bool holds_a_number(const CsvRow& row);

/// Requires as many fields as the header has; additional fields must be empty or words. If separators other than blanks
/// divide them, fields after the `needed` ones may be missing, as LabVIEW's comments are in most rows.
void require_width(const std::string& path, const CsvRow& row, std::size_t count, std::size_t needed);

/// Advice to append to a message about a text that is not a number.
std::string_view decimal_comma_hint(std::string_view text);

/// Reads the number in field i, without its unit; false if the field is empty. `name`: of the column. `error`: receives
/// the standard error that the field states; null if none is allowed.
bool number_at(const std::string& path, const CsvRow& row, std::size_t i, std::string_view name, double& value,
               double* error = nullptr);

}  // namespace mixity
