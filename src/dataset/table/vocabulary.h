// Finds the quantity and unit that a heading names. The vocabulary is data/headings.toml, a list of column names in
// laboratories' exports, and a user's additions.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "base/inputs.h"
#include "dataset/table/column_kinds.h"
#include "dataset/table/heading.h"

namespace mixity {

/// A column whose heading names a quantity.
struct NamedColumn {
  ColumnId id;
  std::size_t index;
  Heading heading;  // with its unit, wherever that is written: "F_N / mN", "Reibkraft in N", "A_mm2"
};

class Vocabulary {
 public:
  /// The vocabulary compiled into the program.
  static const Vocabulary& shipped();
  /// The shipped one with the additions of the TOML at `path`. Throws InputError, with line and column, for invalid
  /// content and for a name that two quantities would share.
  static Vocabulary with(const std::string& path, Inputs& inputs);

  /// The quantity of a heading without its unit; null if unknown. "T_err" and "error of friction force" are standard
  /// errors.
  std::optional<ColumnId> find(std::string_view name) const;

  /// Reads a heading by the program's own names and the vocabulary; null if it names no quantity. `with_unit`: accept
  /// it only if it ends in a unit.
  std::optional<NamedColumn> read(const Heading& heading, std::size_t index, bool with_unit = false) const;

 private:
  template <class TomlTable>
  void add(const std::string& path, const TomlTable& table);
  std::optional<ColumnId> find_quantity(std::string_view name) const;
  std::optional<ColumnId> find_error(std::string_view name) const;
  std::optional<ColumnId> find_symbol_of_force(std::string_view name) const;
  std::optional<ColumnId> find_with_symbol(std::string_view name) const;

  /// A quantity; null: a word that turns another name into that of its standard error.
  using Meaning = std::optional<ColumnId>;
  std::map<std::string, Meaning, std::less<>> symbols_, names_;        // as written; folded
  std::map<std::string, std::optional<ColumnId>, std::less<>> words_;  // sorted words of names; null: ambiguous
};

/// Whether a quantity may have this unit; null: no unit.
bool unit_fits(const std::optional<std::string>& unit, ColumnId id);

/// Whether a unit is one of mass, which a balance shows where a force is wanted: "g", "mg", "kg".
bool is_mass(std::string_view unit);

/// Whether a dimension is in pixels where a length or area is wanted.
bool is_pixels(const Dimension& found, const Dimension& wanted);

}  // namespace mixity
