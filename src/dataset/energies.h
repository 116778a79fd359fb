// Energies of the two modes as points of a toughness: Gc = G_I + G_II at sin^2 psi = G_II/Gc.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "dataset/dataset.h"

namespace mixity {

/// Empty, or why these energies are no point; `point` is then left as it was.
std::string_view convert(const PointEnergies& energies, ToughnessPoint& point);

/// Standard error of G_I + G_II, whose errors are independent; 0 if neither is given.
inline double error_of_sum(const PointEnergies& energies) {
  return std::hypot(std::max(energies.sigma_GI, 0.0), std::max(energies.sigma_GII, 0.0));
}

/// Finishes the energies once all rows are read. If G_Ic is not known, the largest G_I becomes 1; points that are out
/// of range by it are excluded. Notes this, and how many energies are below zero. Throws InputError if no G_I is
/// positive. `metadata_path`: where the toughness might have been stated.
void finish_energies(const std::string& metadata_path, Dataset& data);

}  // namespace mixity
