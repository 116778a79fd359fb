// The quantities that a table may hold.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "base/units.h"

namespace mixity {

/// The program's own names of them, case included: A is an area, a a radius. a_par and a_perp are semi-axes along and
/// across the shear, major and minor whole axes, as image programs give them.
enum class ColumnId {
  P,
  T,
  A,
  a,
  a_par,
  a_perp,
  major,
  minor,
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
  include,
  time
};
inline constexpr std::size_t kColumnCount = 22;

struct ColumnKind {
  ColumnId id;
  std::string_view name;
  Dimension dimension;   // when it has a unit
  bool always_a_number;  // never carries a unit of its own
};

inline constexpr std::array<ColumnKind, kColumnCount> kColumnKinds{{
    {ColumnId::P, "P", dimension::force, false},
    {ColumnId::T, "T", dimension::force, false},
    {ColumnId::A, "A", dimension::area, false},
    {ColumnId::a, "a", dimension::length, false},
    {ColumnId::a_par, "a_par", dimension::length, false},
    {ColumnId::a_perp, "a_perp", dimension::length, false},
    {ColumnId::major, "major", dimension::length, false},
    {ColumnId::minor, "minor", dimension::length, false},
    {ColumnId::psi, "psi", dimension::angle, false},
    {ColumnId::mode_ratio, "mode_ratio", dimension::none, true},
    {ColumnId::Gc, "Gc", dimension::energy_per_area, false},
    {ColumnId::Gc_over_GIc, "Gc_over_GIc", dimension::none, true},
    {ColumnId::G_I, "G_I", dimension::energy_per_area, false},
    {ColumnId::G_II, "G_II", dimension::energy_per_area, false},
    {ColumnId::sigma_T, "sigma_T", dimension::force, false},
    {ColumnId::sigma_A, "sigma_A", dimension::area, false},
    {ColumnId::sigma_Gc, "sigma_Gc", dimension::energy_per_area, false},
    {ColumnId::sigma_GI, "sigma_GI", dimension::energy_per_area, false},
    {ColumnId::sigma_GII, "sigma_GII", dimension::energy_per_area, false},
    {ColumnId::curve, "curve", dimension::none, true},
    {ColumnId::include, "include", dimension::none, true},
    {ColumnId::time, "time", dimension::time, false},
}};

inline const ColumnKind& kind_of(ColumnId id) { return kColumnKinds[static_cast<std::size_t>(id)]; }
inline std::string_view to_string(ColumnId id) { return kind_of(id).name; }
/// Null if no quantity has this name.
inline std::optional<ColumnId> column_named(std::string_view name) {
  for (const ColumnKind& kind : kColumnKinds)
    if (kind.name == name) return kind.id;
  return std::nullopt;
}

}  // namespace mixity
