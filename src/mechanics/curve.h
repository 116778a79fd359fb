// The whole equilibrium curve of a model at one normal load, on the circle
//
//     y = 3 pi + S0 cos phi,   tau = S0 sin phi,       T from tau by the model's change of variable.
//
// phi = 0 is JKR. y falls monotonically along the curve, through every fold, to its end: Hertz (y = 0, P > 0), the
// asymptote of a model whose g stays bounded (T -> infinity), or for P <= 0 the unstable JKR point phi = pi (T = 0),
// where at P = 0 the contact vanishes. Of a law that turns (turning_curve.h) the curve is the same, but its parameter
// is that of TurningCurve, and y need not fall along it.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "mechanics/contact.h"
#include "mechanics/model.h"
#include "mechanics/registry.h"
#include "mechanics/states.h"
#include "mechanics/turning_curve.h"

namespace mixity {

enum class CurveEnd { hertz, asymptote, unstable_jkr };

/// A connected piece of the curve, from its top (largest y) down to y_end. Only a model with an asymptote at P < 0 has
/// two: the contact cannot pass from one to the other.
struct CurvePiece {
  double y_top, y_end,
      width;  // width = y_top - y_end, also where that difference would cancel; of a law that turns, of s
  double sin2_top, cos2_end;  // sin^2(phi/2) at the top, cos^2(phi/2) at the end
  CurveEnd end;
  bool from_asymptote;  // T -> infinity at the top, too
};

inline constexpr double kLargest = std::numeric_limits<double>::max();

/// g - 1 = tau^2/y^2 at psi = pi/2.
template <class Model>
double shear_limit(const Parameters<Model>& p) {
  if constexpr (requires { Model::shear_limit(p); })
    return Model::shear_limit(p);
  else
    return std::numeric_limits<double>::infinity();
}

/// Edge loads y_+ > y_- at which T -> infinity: g = g_inf, its limit at psi = pi/2, in y^2 g = 6 pi (y + P). Returns
/// false if g is unbounded (every model but a with lambda < 1) or the load admits no such state.
template <class Model>
bool asymptotic_edge_loads(const Parameters<Model>& p, double P, double& upper, double& lower);

/// tangential_load of a model without a closed form, tau > 0: Newton's method, then a bracket.
template <class Model>
double search_tangential_load(const Parameters<Model>& p, double y, double tau);

/// T of the state (y, tau): inverts tau^2 = shear_term(p, y, T). y >= 0, tau >= 0, not both 0. Infinite where the
/// model reaches no such tau. Relative error a few roundings.
template <class Model>
double tangential_load(const Parameters<Model>& p, double y, double tau) {
  if (tau == 0) return 0;
  if constexpr (requires { Model::tangential_load(p, y, tau); })
    return Model::tangential_load(p, y, tau);
  else
    return search_tangential_load<Model>(p, y, tau);
}

/// The pieces of the curve in the order of falling y; none if shear does not act on the area.
template <class Model>
std::vector<CurvePiece> curve_pieces(const Parameters<Model>& p, double P);

/// The one of a law that turns.
template <class Model>
CurvePiece turning_piece(const TurningCurve<Model>& curve, double P);

template <class Model>
class EquilibriumCurve {
 public:
  /// Valid parameters and load only (the same as LoadedContact accepts, and in contact).
  EquilibriumCurve(const Parameters<Model>& parameters, double P) : p_(parameters), P_(P) {
    if (mixity::turns<Model>(p_)) {
      turning_.emplace(p_, P_);
      pieces_ = {turning_piece<Model>(*turning_, P_)};
    } else {
      pieces_ = curve_pieces<Model>(p_, P_);
    }
  }

  double load() const { return P_; }
  const Parameters<Model>& parameters() const { return p_; }

  /// True if shear does not act on the area at all (lambda = 0): the curve is the point phi = 0.
  bool uncoupled() const { return pieces_.empty(); }
  const std::vector<CurvePiece>& pieces() const { return pieces_; }
  bool turns() const { return kMayTurn<Model> && turning_.has_value(); }

  /// The place with y = 3 pi + offset.
  CurvePosition position_at_offset(double offset) const {
    return {3 * pi<double>() + offset, 0.5 * (1 + offset / S0_), 0.5 * (1 - offset / S0_)};
  }
  /// Its logistic coordinate on a piece; not of a law that turns.
  double coordinate(const CurvePiece& piece, const CurvePosition& at) const {
    return std::log((at.sin2 - piece.sin2_top) / (at.cos2 - piece.cos2_end));
  }

  /// Place on a piece from the logistic coordinate v: (y - y_end)/(y_top - y) = exp(-v), so that uniform steps in v
  /// resolve both ends.
  CurvePosition position(const CurvePiece& piece, double v) const {
    if (turns()) {
      const auto place = turning_->at(piece.width / (1 + std::exp(-v)), piece.width / (1 + std::exp(v)));
      return {place.y, 0, 0, place.t};
    }
    const double above = piece.width / (1 + std::exp(v)), below = piece.width / (1 + std::exp(-v));
    return {v > 0 ? piece.y_end + above : piece.y_top - below, piece.cos2_end + above / (2 * S0_),
            piece.sin2_top + below / (2 * S0_)};
  }

  /// Negative on the stretches of a law that turns where g < 1.
  double tau_squared(const CurvePosition& at) const {
    if (turns()) return Model::shear_term(p_, at.y, at.t * at.y).value;
    return 4 * S0_ * S0_ * at.sin2 * at.cos2;
  }
  /// y - 3 pi = S0 cos phi.
  double offset(const CurvePosition& at) const {
    return S0_ < at.y && !turns() ? S0_ * (at.cos2 - at.sin2) : at.y - 3 * pi<double>();
  }
  double tangential_load(const CurvePosition& at) const {
    if (turns()) return at.t * at.y;
    return mixity::tangential_load<Model>(p_, at.y, std::sqrt(tau_squared(at)));
  }

  /// phi at the start and the end of a piece; the end of the curve for the last.
  double phi_begin(const CurvePiece& piece) const {
    if (turns()) return 0;
    return 2 * std::atan2(std::sqrt(piece.sin2_top), std::sqrt(piece.cos2_end + piece.width / (2 * S0_)));
  }
  double phi_end(const CurvePiece& piece) const {
    if (turns()) return piece.width;
    return 2 * std::atan2(std::sqrt(piece.sin2_top + piece.width / (2 * S0_)), std::sqrt(piece.cos2_end));
  }

  /// The point at phi, phi_begin <= phi <= phi_end of some piece. At an asymptote T is infinite: stay inside.
  CurvePoint point(double phi) const;

 private:
  CurvePoint turning_point(double s) const;

  Parameters<Model> p_;
  double P_, S0_ = circle_radius(P_), y_jkr_ = 3 * pi<double>() + S0_;
  double y_low_ = -2 * (3 * pi<double>()) * P_ / y_jkr_;  // 3 pi - S0, the unstable JKR state for P < 0
  std::vector<CurvePiece> pieces_;
  std::optional<TurningCurve<Model>> turning_;
};

}  // namespace mixity
