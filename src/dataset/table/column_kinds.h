// The quantities that the columns of a table may contain.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/units.h"

namespace mixity {

/// The program's own, case-sensitive names: A is an area, a is a radius. a_par and a_perp are semi-axes along and
/// across the shear, d_par and d_perp whole axes; major and minor are whole axes as image programs give them, and angle
/// is that of the major one from the shear. delta is an approach, which is held in place of P. P_c is the load at which
/// a sheared contact is pulled off, u the tangential displacement that is held meanwhile.
enum class ColumnId {
  P,
  T,
  A,
  a,
  diameter,
  a_par,
  a_perp,
  d_par,
  d_perp,
  major,
  minor,
  angle,
  delta,
  psi,
  mode_ratio,
  Gc,
  Gc_over_GIc,
  G_I,
  G_II,
  P_c,
  u,
  sigma_T,
  sigma_A,
  sigma_a_par,
  sigma_a_perp,
  sigma_Gc,
  sigma_GI,
  sigma_GII,
  sigma_P,
  sigma_u,
  curve,
  include,
  time,
  frame
};
inline constexpr std::size_t kColumnCount = 34;

struct ColumnKind {
  ColumnId id;
  std::string_view name;
  Dimension dimension;  // of its unit; none: the column has no unit
};

inline constexpr std::array<ColumnKind, kColumnCount> kColumnKinds{{
    {ColumnId::P, "P", dimension::force},
    {ColumnId::T, "T", dimension::force},
    {ColumnId::A, "A", dimension::area},
    {ColumnId::a, "a", dimension::length},
    {ColumnId::diameter, "diameter", dimension::length},
    {ColumnId::a_par, "a_par", dimension::length},
    {ColumnId::a_perp, "a_perp", dimension::length},
    {ColumnId::d_par, "d_par", dimension::length},
    {ColumnId::d_perp, "d_perp", dimension::length},
    {ColumnId::major, "major", dimension::length},
    {ColumnId::minor, "minor", dimension::length},
    {ColumnId::angle, "angle", dimension::angle},
    {ColumnId::delta, "delta", dimension::length},
    {ColumnId::psi, "psi", dimension::angle},
    {ColumnId::mode_ratio, "mode_ratio", dimension::none},
    {ColumnId::Gc, "Gc", dimension::energy_per_area},
    {ColumnId::Gc_over_GIc, "Gc_over_GIc", dimension::none},
    {ColumnId::G_I, "G_I", dimension::energy_per_area},
    {ColumnId::G_II, "G_II", dimension::energy_per_area},
    {ColumnId::P_c, "P_c", dimension::force},
    {ColumnId::u, "u", dimension::length},
    {ColumnId::sigma_T, "sigma_T", dimension::force},
    {ColumnId::sigma_A, "sigma_A", dimension::area},
    {ColumnId::sigma_a_par, "sigma_a_par", dimension::length},
    {ColumnId::sigma_a_perp, "sigma_a_perp", dimension::length},
    {ColumnId::sigma_Gc, "sigma_Gc", dimension::energy_per_area},
    {ColumnId::sigma_GI, "sigma_GI", dimension::energy_per_area},
    {ColumnId::sigma_GII, "sigma_GII", dimension::energy_per_area},
    {ColumnId::sigma_P, "sigma_P", dimension::force},
    {ColumnId::sigma_u, "sigma_u", dimension::length},
    {ColumnId::curve, "curve", dimension::none},
    {ColumnId::include, "include", dimension::none},
    {ColumnId::time, "time", dimension::time},
    {ColumnId::frame, "frame", dimension::none},
}};

/// Times and numbers of frames or rows, which only logs have.
inline bool is_clock(ColumnId id) { return id == ColumnId::time || id == ColumnId::frame; }
inline const ColumnKind& kind_of(ColumnId id) { return kColumnKinds[static_cast<std::size_t>(id)]; }
inline std::string_view to_string(ColumnId id) { return kind_of(id).name; }
/// The quantity of this name; null if there is none.
inline std::optional<ColumnId> column_named(std::string_view name) {
  for (const ColumnKind& kind : kColumnKinds)
    if (kind.name == name) return kind.id;
  return std::nullopt;
}
/// All names, in the order of the ids.
inline std::vector<std::string> column_names() {
  std::vector<std::string> names;
  for (const ColumnKind& kind : kColumnKinds) names.emplace_back(kind.name);
  return names;
}

/// Lengths that give a contact area pi one other/parts; `other` equals `one` for a round contact.
struct ContactLengths {
  ColumnId one, other;
  double parts;
  constexpr bool round() const { return one == other; }
};
inline constexpr std::array<ContactLengths, 5> kContactLengths{{
    {ColumnId::a, ColumnId::a, 1},
    {ColumnId::diameter, ColumnId::diameter, 4},
    {ColumnId::a_par, ColumnId::a_perp, 1},
    {ColumnId::d_par, ColumnId::d_perp, 4},
    {ColumnId::major, ColumnId::minor, 4},
}};
/// Other names of the errors of axes, beside the lengths that they are of: of semi-axes called a and b, or of whole
/// axes, which are twice as large.
struct ErrorOfAxis {
  std::string_view name;
  ColumnId id, beside;
  double per_semi_axis;
};
inline constexpr std::array<ErrorOfAxis, 8> kErrorsOfAxes{{
    {"sigma_a", ColumnId::sigma_a_par, ColumnId::a_par, 1},
    {"sigma_b", ColumnId::sigma_a_perp, ColumnId::a_perp, 1},
    {"sigma_d_par", ColumnId::sigma_a_par, ColumnId::d_par, 2},
    {"sigma_d_perp", ColumnId::sigma_a_perp, ColumnId::d_perp, 2},
    {"sigma_major", ColumnId::sigma_a_par, ColumnId::major, 2},
    {"sigma_minor", ColumnId::sigma_a_perp, ColumnId::minor, 2},
    {"sigma_Major", ColumnId::sigma_a_par, ColumnId::major, 2},
    {"sigma_Minor", ColumnId::sigma_a_perp, ColumnId::minor, 2},
}};
inline const ErrorOfAxis* error_of_axis(std::string_view name) {
  for (const ErrorOfAxis& one : kErrorsOfAxes)
    if (one.name == name) return &one;
  return nullptr;
}
/// What multiplies ln(one/other) to give ln(a/b) of the semi-axes along and across the shear. `angle` [rad]: of the
/// longer axis from the shear; without it an image program's ellipse is taken as shorter along the shear.
inline double turn_of_axes(const ContactLengths& lengths, std::optional<double> angle) {
  if (lengths.one != ColumnId::major) return 1;
  return angle ? std::cos(2 * *angle) : -1;
}

/// The first entry for which a table has columns; null if there is none. `has`: whether the table has a column.
template <class Has>
constexpr const ContactLengths* contact_lengths(Has has) {
  for (const ContactLengths& lengths : kContactLengths)
    if (has(lengths.one) || has(lengths.other)) return &lengths;
  return nullptr;
}

}  // namespace mixity
