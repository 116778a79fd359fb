// Which quantity and unit a heading names. The vocabulary is data/headings.toml, the names of columns in exports of
// laboratories, and what a user adds to it.
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
  /// The one that is compiled into the program.
  static const Vocabulary& shipped();
  /// The shipped one with the additions of the TOML at `path`. Throws InputError, with line and column, for anything in
  /// it that cannot be understood, and for a name that two quantities would share.
  static Vocabulary with(const std::string& path, Inputs& inputs);

  /// The quantity of a heading without its unit; null if it is not known. "T_err", "error of friction force" are
  /// standard errors.
  std::optional<ColumnId> find(std::string_view name) const;

  /// Reads a heading by the program's own names and the vocabulary; null if it names no quantity. `with_unit`: only if
  /// it ends in a unit.
  std::optional<NamedColumn> read(const Heading& heading, std::size_t index, bool with_unit = false) const;

 private:
  template <class TomlTable>
  void add(const std::string& path, const TomlTable& table);
  std::optional<ColumnId> find_quantity(std::string_view name) const;
  std::optional<ColumnId> find_error(std::string_view name) const;
  std::optional<ColumnId> find_with_symbol(std::string_view name) const;

  /// A quantity; null: a word that makes another name that of its standard error.
  using Meaning = std::optional<ColumnId>;
  std::map<std::string, Meaning, std::less<>> symbols_, names_;        // as written; folded
  std::map<std::string, std::optional<ColumnId>, std::less<>> words_;  // sorted words of names; null: of two quantities
};

/// Whether a quantity may have this unit, or none.
bool unit_fits(const std::optional<std::string>& unit, ColumnId id);

/// Whether a unit is one of mass, which a balance gives where a force is wanted: "g", "mg", "kg".
bool is_mass(std::string_view unit);

/// Whether a dimension is pixels or square pixels, and a length or area in them is wanted.
bool is_pixels(const Dimension& found, const Dimension& wanted);

}  // namespace mixity
