// What holds of a typed law at given parameters, whatever the loads, and over the ranges of its parameters.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mechanics/laws/law.h"

namespace mixity {

/// cos psi is taken as this at least: 1/0 has no derivative. psi is the same double.
inline constexpr double kLeastCosine = 1e-20;

/// Below this T/y, or one still smaller, tau^2 is a power of it: the next term is a 1e8th, and the difference that it
/// stands for has lost as much by rounding.
inline constexpr double kSmallShear = 1e-4;

/// At the angle whose sine and cosine these are, along psi.
ExpressionLaw::State along_angle(double sine, double cosine);

struct LawTraits {
  static constexpr std::size_t kPlaces = 48;  // phase angles above 0, the last 90 degrees
  const ExpressionLaw* law = nullptr;
  std::size_t count = 0;
  std::array<double, ExpressionLaw::kMostParameters> p{};
  double f0 = 1;           // f at psi = 0
  double small_shear = 0;  // lim tau^2/T^2 at T -> 0; infinite where f leaves 1 with a slope
  double shear_limit = std::numeric_limits<double>::infinity();  // lim tau^2/y^2 at T -> infinity
  // tau^2/y^2 = small_value (T/(small_t y))^small_power where T/y < small_t
  double small_t = kSmallShear, small_value = 0, small_power = 2;
  bool tau_grows = true;                 // with y at fixed T
  std::optional<double> undefined_at{};  // psi [rad] at which f is no positive number
  std::optional<double> turned_at{};     // psi at which (1 + tan^2 psi)/f does not grow, and its value there
  double turned_g = 1;
  ShearBend bend{};     // model.h; as the samples have it, with a margin of two
  ShearReach reach{};   // model.h; as the samples have it, with a margin of two
  double rounding = 0;  // largest relative error of f for the rounding of psi, where psi stands for itself
  double rounding_at = 0;
  std::array<Taylor, kPlaces + 1> log_f;  // of an equation at the places, with derivatives in psi; NaN: not known

  /// Empty: there is an equilibrium.
  std::string_view obstacle() const;
  /// Whether one area may stand for several T (turning_curve.h).
  bool turns() const { return !undefined_at && (!(small_shear >= 0) || turned_at); }

  /// About ln f of an equation along the direction in which psi [rad] changes: the quintic between two places. Null
  /// where that is not known.
  std::optional<Taylor> about(const Taylor& psi) const;
};

/// tau^2/r^2, r^2 = y^2 + T^2, and its derivatives in y/r, at y/r = cosine and T/r = sine; `known`: null, or the traits
/// of the law at these parameters.
ShearTerm<double> reduced_shear(const ExpressionLaw& law, std::span<const Taylor> p, double sine, double cosine,
                                const LawTraits* known = nullptr);

/// At kPlaces phase angles, denser towards 0 and 90 degrees; with `rounding` if that is asked for.
LawTraits traits_of(const ExpressionLaw& law, std::span<const double> parameters, bool with_rounding = false);

/// What is to be said of a law before it is used.
struct LawCheck {
  std::optional<std::string> error{};   // it is no law over its ranges
  std::vector<std::string> warnings{};  // where its equilibrium is not unique, how many digits its form loses
};
LawCheck check_law(const ExpressionLaw& law);

}  // namespace mixity
