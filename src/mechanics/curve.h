// The whole equilibrium curve of a model at one normal load, on the circle
//
//     y = 3 pi + S0 cos phi,   tau = S0 sin phi,       T from tau by the model's change of variable.
//
// phi = 0 is JKR. y falls monotonically along the curve, through every fold, to its end: Hertz (y = 0, P > 0), the
// asymptote of a law whose g stays bounded (T -> infinity), or for P <= 0 the unstable JKR point phi = pi (T = 0),
// where at P = 0 the contact vanishes. Under a non-monotone law (non_monotone_curve.h) the parameter is that of
// NonMonotoneCurve instead, and y need not fall along the curve.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "mechanics/base/law.h"
#include "mechanics/contact.h"
#include "mechanics/non_monotone_curve.h"
#include "mechanics/registry.h"
#include "mechanics/states.h"

namespace mixity {

enum class CurveEnd { hertz, asymptote, unstable_jkr };

/// A connected piece of the curve, from its top (largest y) down to y_end. Only a model with an asymptote has two, at
/// P < 0; the contact cannot pass from one to the other.
struct CurvePiece {
  double y_top, y_end;
  double width;               // y_top - y_end without cancellation; under a non-monotone law the range of s
  double sin2_top, cos2_end;  // sin^2(phi/2) at the top, cos^2(phi/2) at the end
  CurveEnd end;
  bool from_asymptote;  // T -> infinity at the top, too
};

inline constexpr double kLargest = std::numeric_limits<double>::max();

/// g - 1 = tau^2/y^2 at psi = pi/2.
template <class Law>
double shear_limit(const Law& law, const Parameters<Law>& p) {
  if constexpr (requires { law.shear_limit(p); })
    return law.shear_limit(p);
  else
    return std::numeric_limits<double>::infinity();
}

/// tangential_load for tau > 0 under a law without a closed form: Newton's method, then a bracket.
template <class Law>
double search_tangential_load(const Law& law, const Parameters<Law>& p, double y, double tau);

/// T of the state (y, tau): inverts tau^2 = shear_term(p, y, T). y >= 0, tau >= 0, not both 0. Infinite where the
/// model reaches no such tau. Relative error a few roundings.
template <class Law>
double tangential_load(const Law& law, const Parameters<Law>& p, double y, double tau) {
  if (tau == 0) return 0;
  if constexpr (requires { law.tangential_load(p, y, tau); })
    return law.tangential_load(p, y, tau);
  else
    return search_tangential_load(law, p, y, tau);
}

/// The pieces of the curve in order of falling y; none if shear does not affect the area.
template <class Law>
std::vector<CurvePiece> curve_pieces(const Law& law, const Parameters<Law>& p, double P);

/// The only piece under a non-monotone law.
template <class Law>
CurvePiece non_monotone_piece(const NonMonotoneCurve<Law>& curve, double P);

template <class Law>
class EquilibriumCurve {
 public:
  /// The parameters and the load must be valid (as for LoadedContact), and the load above pull-off.
  EquilibriumCurve(const Law& law, const Parameters<Law>& parameters, double P) : law_(law), p_(parameters), P_(P) {
    if (is_non_monotone(law_, p_)) {
      by_angle_.emplace(law_, p_, P_);
      pieces_ = {non_monotone_piece(*by_angle_, P_)};
    } else {
      pieces_ = curve_pieces(law_, p_, P_);
    }
  }

  double load() const { return P_; }
  const Law& law() const { return law_; }
  const Parameters<Law>& parameters() const { return p_; }

  /// True if shear does not affect the area (lambda = 0): the curve is then the point phi = 0.
  bool uncoupled() const { return pieces_.empty(); }
  const std::vector<CurvePiece>& pieces() const { return pieces_; }
  bool non_monotone() const { return kMayBeNonMonotone<Law> && by_angle_.has_value(); }

  /// The position with y = 3 pi + offset.
  CurvePosition position_at_offset(double offset) const {
    return {3 * pi<double>() + offset, 0.5 * (1 + offset / S0_), 0.5 * (1 - offset / S0_)};
  }
  /// The logistic coordinate of a position on a piece; not under a non-monotone law.
  double coordinate(const CurvePiece& piece, const CurvePosition& at) const {
    return std::log((at.sin2 - piece.sin2_top) / (at.cos2 - piece.cos2_end));
  }

  /// The position on a piece with the logistic coordinate v: (y - y_end)/(y_top - y) = exp(-v), so that uniform steps
  /// in v resolve both ends.
  CurvePosition position(const CurvePiece& piece, double v) const {
    if (non_monotone()) {
      const auto place = by_angle_->at(piece.width / (1 + std::exp(-v)), piece.width / (1 + std::exp(v)));
      return {place.y, 0, 0, place.t};
    }
    const double above = piece.width / (1 + std::exp(v)), below = piece.width / (1 + std::exp(-v));
    return {v > 0 ? piece.y_end + above : piece.y_top - below, piece.cos2_end + above / (2 * S0_),
            piece.sin2_top + below / (2 * S0_)};
  }

  /// tau^2; negative where g < 1, which happens only under a non-monotone law.
  double tau_squared(const CurvePosition& at) const {
    if (non_monotone()) return law_.shear_term(p_, at.y, at.t * at.y).value;
    return 4 * S0_ * S0_ * at.sin2 * at.cos2;
  }
  /// y - 3 pi = S0 cos phi.
  double offset(const CurvePosition& at) const {
    return S0_ < at.y && !non_monotone() ? S0_ * (at.cos2 - at.sin2) : at.y - 3 * pi<double>();
  }
  double tangential_load(const CurvePosition& at) const {
    if (non_monotone()) return at.t * at.y;
    return mixity::tangential_load(law_, p_, at.y, std::sqrt(tau_squared(at)));
  }

  /// phi at the start and at the end of a piece; the last piece ends with the curve.
  double phi_begin(const CurvePiece& piece) const {
    if (non_monotone()) return 0;
    return 2 * std::atan2(std::sqrt(piece.sin2_top), std::sqrt(piece.cos2_end + piece.width / (2 * S0_)));
  }
  double phi_end(const CurvePiece& piece) const {
    if (non_monotone()) return piece.width;
    return 2 * std::atan2(std::sqrt(piece.sin2_top + piece.width / (2 * S0_)), std::sqrt(piece.cos2_end));
  }

  /// The point at phi, which lies within a piece. phi must not be that of an asymptote, where T is infinite.
  CurvePoint point(double phi) const;

 private:
  CurvePoint non_monotone_point(double s) const;

  [[no_unique_address]] Law law_;
  Parameters<Law> p_;
  double P_, S0_ = circle_radius(P_), y_jkr_ = 3 * pi<double>() + S0_;
  double y_low_ = -2 * (3 * pi<double>()) * P_ / y_jkr_;  // 3 pi - S0, the unstable JKR state for P < 0
  std::vector<CurvePiece> pieces_;
  std::optional<NonMonotoneCurve<Law>> by_angle_;
};

}  // namespace mixity
