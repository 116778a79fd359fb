// The effect of constants of the experiment on the residuals of a fit.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

#include "dataset/constants.h"

namespace mixity {

/// The constant of this name; null if there is none.
inline std::optional<Constant> constant_named(std::string_view name) {
  for (const Constant c : kAllConstants)
    if (kConstantNames[c] == name) return c;
  return std::nullopt;
}

/// Calls visit(constant) with a type that has the constant as its value, so that loops over points are compiled for it.
template <class Visit>
void with_constant(Constant constant, const Visit& visit) {
  const auto call = [&]<std::size_t... kIndices>(std::index_sequence<kIndices...>) {
    (..., (constant == kAllConstants[kIndices] ? visit(std::integral_constant<Constant, kAllConstants[kIndices]>())
                                               : void()));
  };
  call(std::make_index_sequence<kAllConstants.size()>());
}

/// Derivatives of a residual in P, T and A, and in the logarithms of all forces and of all areas; `in` gives that in a
/// constant, by the chain rule through ConstantsScale.
struct ScaledSlopes {
  double by_P, by_T, by_A;  // in the scaled P, T and A
  double by_force, by_area;

  double in(Constant constant, const ConstantsScale& scale, const PointPlace& place) const {
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
      case kApproachOffset:
        return 0;
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

/// The same where the approach is held: by_P is the derivative in the approach, which by_force does not contain.
struct HeldSlopes {
  ScaledSlopes of_forces;
  double by_approach, by_compliance;  // in the logarithms of the approach and of the machine's compliance
  double by_load;                     // in a load that was measured, too

  double in(Constant constant, const ConstantsScale& scale, const PointPlace& place) const {
    const double by_toughness = (by_compliance - 2 * by_approach) / 3,
                 by_modulus = 2.0 / 3 * (by_approach + by_compliance);
    switch (constant) {
      case kLoadOffset:
        return by_load * scale.force;
      case kApproachOffset:
        return of_forces.by_P * scale.held;
      case kToughness:
        return of_forces.in(constant, scale, place) + by_toughness;
      case kModulus:
        return of_forces.in(constant, scale, place) + by_modulus;
      case kRadius:
        return of_forces.in(constant, scale, place) + (2 * by_compliance - by_approach) / 3;
      case kModulusDrift:
        return of_forces.in(constant, scale, place) + place.order * by_modulus;
      case kToughnessDrift:
        return of_forces.in(constant, scale, place) + place.order * by_toughness;
      case kHysteresis:
        return of_forces.in(constant, scale, place) + (place.unsheared ? by_toughness : 0);
      default:
        return of_forces.in(constant, scale, place);
    }
  }
};

/// Derivatives of a residual in the scaled P, T and A, and in the logarithms of their errors.
struct ResidualSlopes {
  double by_P, by_T, by_A;
  double log_sigma_T = 0, log_sigma_A = 0;

  /// At scaled P, T and A.
  ScaledSlopes at(double P, double T, double A) const {
    return {by_P, by_T, by_A, by_P * P + by_T * T + log_sigma_T, by_A * A + log_sigma_A};
  }
  /// With the approach P. by_compliance, by_load: as in HeldSlopes; load: that reading, scaled; log_sigma: in the
  /// logarithm of its error.
  HeldSlopes held(double P, double T, double A, double by_compliance, double by_load = 0, double load = 0,
                  double log_sigma = 0) const {
    return {{by_P, by_T, by_A, by_T * T + log_sigma_T + by_load * load + log_sigma, by_A * A + log_sigma_A},
            by_P * P,
            by_compliance,
            by_load};
  }
  double in(Constant constant, double P, double T, double A, const ConstantsScale& scale,
            const PointPlace& place) const {
    return at(P, T, A).in(constant, scale, place);
  }
};

}  // namespace mixity
