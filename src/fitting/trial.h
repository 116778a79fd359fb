// What a fit tries out: a model's parameters, and corrections to what the experiment took as known.
#pragma once

#include <array>
#include <cmath>

#include "dataset/dataset.h"
#include "mechanics/registry.h"

namespace mixity {

/// What may be freed beside a model's parameters. Toughness and modulus as logarithms of factors on the data set's own
/// values; offsets, dimensionless, are added to the measured load and area.
enum Correction : std::size_t { kToughness, kModulus, kLoadOffset, kAreaOffset };
inline constexpr std::array<std::string_view, 4> kCorrectionNames{"toughness", "modulus", "load_offset", "area_offset"};
using Corrections = std::array<double, 4>;

template <class Model>
struct Trial {
  Parameters<Model> parameters{};
  Corrections corrections{};
};

/// Measured values in the dimensionless units of the corrected contact: forces by 1/G, areas by (E/G)^(2/3).
struct CorrectedScale {
  double force, area, load_offset, area_offset;

  explicit CorrectedScale(const Corrections& c)
      : force(std::exp(-c[kToughness])),
        area(std::exp(2.0 / 3 * (c[kModulus] - c[kToughness]))),
        load_offset(c[kLoadOffset]),
        area_offset(c[kAreaOffset]) {}

  double load(double P) const { return (P + load_offset) * force; }
  double shear(double T) const { return T * force; }
  double true_area(double A) const { return (A + area_offset) * area; }
  /// What would be measured of a contact of this true area.
  double measured_area(double A) const { return A / area - area_offset; }
};

}  // namespace mixity
