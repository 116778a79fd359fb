// The effect of constants of the experiment on the residuals of a fit.
#pragma once

#include <optional>

#include "dataset/constants.h"

namespace mixity {

/// The constant of this name; null if there is none.
inline std::optional<Constant> constant_named(std::string_view name) {
  for (const Constant c : kAllConstants)
    if (kConstantNames[c] == name) return c;
  return std::nullopt;
}

/// Derivatives of a residual in P, T and A; `in` gives that in a constant, by the chain rule through ConstantsScale.
struct ResidualSlopes {
  double by_P, by_T, by_A;                  // in the scaled P, T and A
  double log_sigma_T = 0, log_sigma_A = 0;  // in the logarithms of their errors

  /// The derivative in `constant`, at scaled P, T and A.
  double in(Constant constant, double P, double T, double A, const ConstantsScale& scale,
            const PointPlace& place) const {
    const double by_force = by_P * P + by_T * T + log_sigma_T, by_area = by_A * A + log_sigma_A;
    const double by_toughness = -by_force - 2.0 / 3 * by_area;
    switch (constant) {
      case kToughness:
        return by_toughness;
      case kModulus:
        return 2.0 / 3 * by_area;
      case kRadius:
        return -by_force - 4.0 / 3 * by_area;
      case kAreaScale:
        return by_area;
      case kForceGain:
        return by_force;
      case kLoadOffset:
        return by_P * scale.force;
      case kShearOffset:
        return by_T * scale.shear_force;
      case kAreaOffset:
        break;
      case kModulusDrift:
        return place.order * 2.0 / 3 * by_area;
      case kToughnessDrift:
        return place.order * by_toughness;
      case kShape:
        return -2 * place.stretch * by_area;
      case kHysteresis:
        return place.unsheared ? by_toughness : 0;
    }
    return by_A * scale.area;
  }
};

}  // namespace mixity
