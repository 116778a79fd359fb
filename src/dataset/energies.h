// Converts energies of the two modes to toughness: Gc = G_I + G_II at sin^2 psi = G_II/Gc.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "dataset/dataset.h"

namespace mixity {

/// Sets `point` and returns an empty text, or returns the reason why these energies are not a point.
std::string_view convert(const PointEnergies& energies, ToughnessPoint& point);

/// Standard error of G_I + G_II, whose errors are independent; 0 if neither is given.
inline double error_of_sum(const PointEnergies& energies) {
  return std::hypot(std::max(energies.sigma_GI, 0.0), std::max(energies.sigma_GII, 0.0));
}

/// Whether every series has points of different mode mixity. At a single phase angle, as for one kind of test, a
/// toughness of the series cannot be distinguished from the law's value.
bool series_have_toughness(const Dataset& data);

/// Completes data of energies when all rows are read. If G_Ic is not known, the largest G_I becomes 1, and points that
/// are then out of range are excluded. Adds notes on this, on energies below zero, on errors of 0 and on series without
/// their own toughness. Throws InputError if no G_I is positive. `metadata_path`: the file that could state the
/// toughness.
void finish_energies(const std::string& metadata_path, Dataset& data);

}  // namespace mixity
