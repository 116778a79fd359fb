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
/// (E R/G)^(2/3)/R^2.
struct ConstantsScale {
  double force, area, load_offset, shear_offset, area_offset;

  explicit ConstantsScale(const Constants& c)
      : force(std::exp(-c[kToughness] - c[kRadius])),
        area(std::exp(2.0 / 3 * (c[kModulus] - c[kToughness] - 2 * c[kRadius]) + c[kAreaScale])),
        load_offset(c[kLoadOffset]),
        shear_offset(c[kShearOffset]),
        area_offset(c[kAreaOffset]) {}

  double load(double P) const { return (P + load_offset) * force; }
  double shear(double T) const { return (T + shear_offset) * force; }
  double true_area(double A) const { return (A + area_offset) * area; }
  double measured_area(double A) const { return A / area - area_offset; }
};

/// Derivatives of a residual; `in` gives that in a constant, by the chain rule through ConstantsScale.
struct ResidualSlopes {
  double by_P, by_T, by_A;                  // in P, T and A as scaled
  double log_sigma_T = 0, log_sigma_A = 0;  // in the logarithms of their errors

  double in(Constant constant, double P, double T, double A, const ConstantsScale& scale) const {
    const double by_force = by_P * P + by_T * T + log_sigma_T, by_area = by_A * A + log_sigma_A;
    switch (constant) {
      case kToughness:
        return -by_force - 2.0 / 3 * by_area;
      case kModulus:
        return 2.0 / 3 * by_area;
      case kRadius:
        return -by_force - 4.0 / 3 * by_area;
      case kAreaScale:
        return by_area;
      case kLoadOffset:
        return by_P * scale.force;
      case kShearOffset:
        return by_T * scale.force;
      case kAreaOffset:
        break;
    }
    return by_A * scale.area;
  }
};

}  // namespace mixity
