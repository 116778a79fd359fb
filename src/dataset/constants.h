// Constants of the experiment, and how they rescale measured values.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace mixity {

/// Constants of the experiment that may be fitted with a model's parameters, with or without a prior. Factors
/// (toughness, modulus and radius on the data set's own values, area_scale on the areas) are logarithms; offsets,
/// dimensionless, are added to the readings.
enum Constant : std::size_t { kToughness, kModulus, kRadius, kAreaScale, kLoadOffset, kShearOffset, kAreaOffset };
inline constexpr std::array<std::string_view, 7> kConstantNames{
    "toughness", "modulus", "radius", "area_scale", "load_offset", "shear_offset", "area_offset"};
using Constants = std::array<double, kConstantNames.size()>;
inline constexpr std::array<Constant, kConstantNames.size()> kAllConstants{
    kToughness, kModulus, kRadius, kAreaScale, kLoadOffset, kShearOffset, kAreaOffset};

constexpr bool is_factor(Constant c) { return c <= kAreaScale; }

/// Measured values in the dimensionless units of the contact with these constants: forces by 1/(R G), areas by
/// (E R/G)^(2/3)/R^2, displacements by (E R/G)^(2/3)/R.
struct ConstantsScale {
  double force, area, displacement, load_offset, shear_offset, area_offset;

  explicit ConstantsScale(const Constants& c)
      : force(std::exp(-c[kToughness] - c[kRadius])),
        area(std::exp(2.0 / 3 * (c[kModulus] - c[kToughness] - 2 * c[kRadius]) + c[kAreaScale])),
        displacement(std::exp(2.0 / 3 * (c[kModulus] - c[kToughness] + c[kRadius]) - c[kRadius])),
        load_offset(c[kLoadOffset]),
        shear_offset(c[kShearOffset]),
        area_offset(c[kAreaOffset]) {}

  double load(double P) const { return (P + load_offset) * force; }
  double shear(double T) const { return (T + shear_offset) * force; }
  double true_area(double A) const { return (A + area_offset) * area; }
  double measured_load(double P) const { return P / force - load_offset; }
  double measured_shear(double T) const { return T / force - shear_offset; }
  double measured_area(double A) const { return A / area - area_offset; }
};

}  // namespace mixity
