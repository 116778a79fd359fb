// Properties, at given parameters and for every load, of a law that is defined at run time.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "mechanics/base/law.h"
#include "mechanics/base/parameter_values.h"
#include "mechanics/laws/taylor.h"

namespace mixity {

class LawWorkspace;

/// Lower limit of cos psi, because 1/0 has no derivative. psi stays the same double.
inline constexpr double kLeastCosine = 1e-20;

/// Below this T/y, or a smaller one (LawTraits::small_t), tau^2 is treated as a power of T/y: the next term is smaller
/// by 1e-8, and rounding costs the difference that gives tau^2 as much.
inline constexpr double kSmallShear = 1e-4;

/// Where a law is evaluated, with derivatives along some direction.
struct LawState {
  Taylor psi, sin, cos;
  std::optional<Taylor> about{};  // an estimate of ln f along the direction: where the solution of an equation starts
};

/// At the angle with this sine and cosine, along psi.
LawState along_angle(double sine, double cosine);

struct LawTraits {
  static constexpr std::size_t kAngles = 48;  // above 0, denser towards 0 and 90 degrees; the last is 90 degrees
  static double angle(std::size_t i);         // angle i [rad]; angle 0 is 0

  ParameterValues p{};
  double f0 = 1;           // f at psi = 0
  double small_shear = 0;  // lim tau^2/T^2 at T -> 0; infinite where f leaves 1 with a slope
  double shear_limit = std::numeric_limits<double>::infinity();  // lim tau^2/y^2 at T -> infinity
  // tau^2/y^2 = small_value (T/(small_t y))^small_power where T/y < small_t
  double small_t = kSmallShear, small_value = 0, small_power = 2;
  bool tau_grows = true;                 // with y at fixed T
  std::optional<double> undefined_at{};  // psi [rad] at which f is no positive number
  std::optional<double> falls_at{};      // psi at which g = (1 + tan^2 psi)/f does not grow; falling_g is g there
  double falling_g = 1;
  ShearBend bend{};     // base/law.h; from the samples, with a margin of two
  ShearReach reach{};   // base/law.h; from the samples, with a margin of two
  double rounding = 0;  // largest relative error of f that the rounding of psi causes, where f depends on psi itself
  double rounding_at = 0;
  std::array<Taylor, kAngles + 1> log_f;  // of an equation: ln f at the angles, with derivatives in psi; NaN: unknown

  /// Empty if equilibrium exists with these parameters, else the reason.
  std::string_view obstacle() const {
    return undefined_at ? "the law is not a positive number at every phase angle, with these parameters" : "";
  }
  /// base/law.h
  bool non_monotone() const { return !undefined_at && (!(small_shear >= 0) || falls_at); }

  /// Estimates ln f of an equation along the direction in which psi [rad] changes, by the quintic between two angles.
  /// Null where these are unknown.
  std::optional<Taylor> about(const Taylor& psi) const;
};

/// tau^2/r^2, r^2 = y^2 + T^2, and its derivatives in y/r, at y/r = cosine and T/r = sine. `known` is null, or the
/// traits of the law with these parameters.
ShearTerm<double> reduced_shear(LawWorkspace& law, std::span<const double> p, double sine, double cosine,
                                const LawTraits* known = nullptr);

/// Derives the traits from samples at the angles. Sets `rounding` only if with_rounding.
LawTraits traits_of(LawWorkspace& law, std::span<const double> p, bool with_rounding = false);

}  // namespace mixity
