// The header of a data CSV: which quantity stands in which column, in which unit.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dataset/csv.h"
#include "dataset/units.h"

namespace mixity {

/// Quantities a data CSV may hold. Names are those of the header, case included: A is an area, a a radius.
enum class ColumnId {
  P,
  T,
  A,
  a,
  psi,
  mode_ratio,
  Gc,
  Gc_over_GIc,
  G_I,
  G_II,
  sigma_T,
  sigma_A,
  sigma_Gc,
  sigma_GI,
  sigma_GII,
  curve,
  include
};
inline constexpr std::size_t kColumnCount = 17;

struct Column {
  ColumnId id;
  std::size_t index;  // 0-based position in the row
  Unit unit;
};

class Columns {
 public:
  /// Understands a header row; throws InputError for a unit that is none or of the wrong kind, for a quantity
  /// that stands twice, and for a set of columns from which no data point can be made.
  Columns(const std::string& path, const CsvRow& header);

  const Column* find(ColumnId id) const {
    const auto& column = columns_[static_cast<std::size_t>(id)];
    return column ? &*column : nullptr;
  }
  bool has(ColumnId id) const { return find(id) != nullptr; }
  std::size_t count() const { return count_; }                          // fields in the header, to the last with a name
  const std::vector<std::string>& ignored() const { return ignored_; }  // names of columns that mean nothing to us
  /// Of these the ones that differ from a quantity's name, which no column has, in case or signs only; with that name.
  const std::vector<std::pair<std::string, std::string>>& misspelt() const { return misspelt_; }
  /// P, T and A (or a), rather than psi and Gc, or energies.
  bool holds_loads() const { return has(ColumnId::P); }
  /// G_I and G_II.
  bool holds_energies() const { return has(ColumnId::G_I); }

 private:
  void require_a_complete_set(const std::string& path, const CsvRow& header) const;
  void require_consistent_units(const std::string& path, const CsvRow& header) const;

  std::array<std::optional<Column>, kColumnCount> columns_;
  std::vector<std::string> ignored_;
  std::vector<std::pair<std::string, std::string>> misspelt_;
  std::size_t count_ = 0;
};

std::string_view to_string(ColumnId id);

// ---- What any file with such a header is read by. Each throws InputError that names line and column. ----

/// "T [mN]", "T (mN)" or "T".
struct Heading {
  std::string name;
  std::optional<std::string> unit;  // as written; null without brackets
  bool closed = true;               // false of an opening bracket that is not closed at the heading's end
};
Heading heading_at(const CsvRow& header, std::size_t i);

/// The heading's unit, checked against what the quantity may have; none if it states none.
Unit unit_of(const Heading& heading, const Dimension& wanted, bool always_a_number, const std::string& path,
             const CsvRow& header, std::size_t i);

bool holds_a_number(const CsvRow& row);

/// A row must have as many fields as the header; further ones must be empty.
void require_width(const std::string& path, const CsvRow& row, std::size_t count);

/// Behind what is said of a text that is no number.
std::string_view decimal_comma_hint(std::string_view text);

/// Reads the number in field i, as it stands; false if the field is empty. `name`: of the column.
bool number_at(const std::string& path, const CsvRow& row, std::size_t i, std::string_view name, double& value);

}  // namespace mixity
