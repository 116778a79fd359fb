// States of a contact and its regimes, as plain numbers. All quantities are dimensionless (contact.h).
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "base/enum_names.h"
#include "mechanics/base/law.h"
#include "mechanics/contact.h"

namespace mixity {

/// Largest T and |P| for which the formulas are guaranteed not to overflow.
inline constexpr double kLargestLoad = 1e150;

/// Stands for T = infinity.
inline constexpr double kInfiniteT = 1e150;

// ---- Equilibrium at given loads ----

enum class EquilibriumStatus : unsigned char { ok, no_equilibrium, invalid };
/// The name of a status in every output format.
inline std::string_view to_string(EquilibriumStatus status) {
  constexpr std::string_view kNames[]{"ok", "no_equilibrium", "invalid"};
  return name_among(kNames, status);
}

struct Equilibrium {
  EquilibriumStatus status;
  double y = 0;  // edge load; the other quantities follow from it
  int iterations = 0;
  double q = 0;  // ln(a/b) of an elliptic contact
};

/// A part of the equilibrium curve on which A falls steadily as T rises: stable under load control. y falls from y_top
/// (at T_top) to y_bottom (at T_bottom, which is infinite at an asymptote of model a).
struct StableBranch {
  double y_top, T_top, y_bottom, T_bottom;
  bool ends_in_fold;               // otherwise y_bottom is Hertz (0) or an asymptote
  double v_top = 0, v_bottom = 0;  // under a non-monotone law: coordinates on the curve, along which A may also rise
};

struct ContactState {
  double P, T;
  double y;    // edge load, 4/3 a^3 - P
  double a;    // contact radius
  double A;    // contact area, pi a^2
  double u;    // tangential displacement at nu = 1/2, 3/4 T/a
  double psi;  // phase angle [rad], atan2(T, y)
  double f;    // toughness ratio G_c/G_Ic in equilibrium, (y^2 + T^2)/(8 pi a^3); the largest double where it overflows
};

/// The state that follows from a solved edge load y with y + P > 0 (a contact that has not vanished).
inline ContactState contact_state(double P, double T, double y) {
  const double a = radius_from_edge_load(y, P);
  const Mixity<double> mixity = mixity_from_loads(y, T);
  const double f = T > 0 ? (y * y + T * T) / (6 * pi<double>() * (y + P)) : 1.0;
  return {P,
          T,
          y,
          a,
          area_from_radius(a),
          0.75 * T / a,
          phase_angle(mixity),
          std::fmin(f, std::numeric_limits<double>::max())};
}

/// A state at constant T, and whether it is stable under a controlled normal load.
struct ConstantShearPoint {
  double y, P, a;
  double dP_dy;  // > 0: stable, the load must grow for the contact to grow; 0 at pull-off under shear
};

// ---- Pull-off after shear ----

/// What of the shear is held while the normal load falls: T, or u = 3/4 T/a.
enum class HeldShear : unsigned char { load, displacement };
inline std::string_view to_string(HeldShear held) {
  constexpr std::string_view kNames[]{"load", "displacement"};
  return name_among(kNames, held);
}

/// The largest held T or u: powers of it do not overflow.
inline constexpr double kMostPullOffShear = 1e40;

/// The state of lowest load at a held shear; NaN where the parameters or the shear are out of range.
struct PullOff {
  double P = std::numeric_limits<double>::quiet_NaN(), y = P, a = P, T = P;
  double slope = P;     // dP/dT, or dP/du, of the held shear
  bool smooth = false;  // y = 0: the contact reaches Hertz without a jump
};

// ---- The whole curve ----

/// A position on the curve: the edge load, cos^2(phi/2) and sin^2(phi/2). Each is stored with full relative accuracy,
/// since computed from another it would lose digits somewhere (near pull-off, near the ends).
struct CurvePosition {
  double y, cos2, sin2;
  double t = 0;  // T/y, under a non-monotone law, which leaves cos2 and sin2 unused
};

/// A point of the curve with its derivatives in phi. All values are finite: the largest double replaces infinity.
struct CurvePoint {
  double phi, y, T, a, A, u, psi, f;
  double dy, dT, da, dA, du, dpsi, df;
};

// ---- Instabilities ----

/// The driving quantity: T (load), u (displacement), or u + T/k (a spring of stiffness k > 0 in series).
struct Control {
  enum class Kind { load, displacement, stiffness } kind;
  double stiffness = 0;  // k~ = k/(xi^2 G_Ic); only for Kind::stiffness
};
inline std::string_view to_string(Control::Kind kind) {
  constexpr std::string_view kNames[]{"load", "displacement", "stiffness"};
  return name_among(kNames, kind);
}

enum class Jump { hertz, lower_branch, upper_branch, off_contact };
inline std::string_view to_string(Jump jump) {
  constexpr std::string_view kNames[]{"hertz", "lower_branch", "upper_branch", "off_contact"};
  return name_among(kNames, jump);
}

/// Where the driving quantity has an extremum along the curve.
struct FoldPlace {
  std::size_t piece;  // index of the piece of the curve
  double coordinate;  // logistic, see EquilibriumCurve::position
  CurvePosition position;
  double T;
  bool maximum;  // reached on loading; a minimum is reached on reversal from a lower branch
};

/// A fold with its state and what follows it.
struct Fold {
  Control control;
  FoldPlace place;
  double T, u, A, psi;  // T equals that of the place
  Jump jumps_to;
  double area_after;  // area of the state after the jump: 0 off contact
  double area_lost;   // A - area_after; negative where the contact regains area
};

/// The regime of a contact that is sheared under a constant normal load: it
///
///   1 shrinks to a non-Hertzian area    2 shrinks smoothly to Hertz    3 reaches a critical point and jumps
///   4 slides first: T = tau0 A, the strength of the interface, is reached before 1, 2 or 3 is complete
enum class Regime { asymptote = 1, hertz = 2, jump = 3, strength = 4 };
inline std::string_view to_string(Regime regime) {
  constexpr std::string_view kNames[]{"", "shrinks", "reaches_hertz", "jumps", "slides_first"};
  return name_among(kNames, regime);
}

struct RegimeReport {
  Regime fracture;                   // 1, 2 or 3: the regime for unlimited strength
  Regime regime;                     // 4 if the strength is reached first, else the same
  double T_end;                      // where 2 or 3 happens; infinite for 1
  std::optional<Jump> jumps_to;      // for 3
  std::optional<double> T_strength;  // smallest T with T = tau0 A on the stable branch; null if none or no tau0
};

/// A boundary between regimes in the plane of load and lambda that is known in closed form.
struct RegimeBoundary {
  std::string_view name;  // jump; off_contact: where a jump ends off contact rather than on Hertz
  bool of_load;           // `at` gives lambda at a load; otherwise the load at a lambda
  double (*at)(double);   // NaN where there is no line
};

// ---- Measured points ----

/// Measured points in the plane of T and A: A > 0, both standard errors > 0, T of either sign (equilibrium depends on
/// T^2). The spans have one size.
///
/// q, its standard error and `slant`: for elliptic contacts, ln(a/b) of the semi-axes along and across the shear, NaN
/// where they were not measured; what has an error independent of A's is q - slant A/A_measured. Empty: no axes.
///
/// Under a held approach P is the approach, q the measured load, NaN where it was not measured, and slant is not used.
/// compliance: of the machine, for each point; empty: that of the model.
struct PlanePoints {
  std::span<const double> P, T, A, sigma_T, sigma_A, q{}, sigma_q{}, slant{}, compliance{};
};

/// local: the point of the curve that Newton's method reaches from the measured point; the nearest one if the measured
/// point lies within some standard errors of the curve. global: the nearest point of the whole curve that starts from
/// JKR. rough: to first order from a point of the curve beside the measured one, without Newton's method.
enum class Search { rough, local, global };

/// r is positive where the model's area is the larger. The nearest point is found anew for each value, so by the
/// envelope theorem the derivatives are those of -F/|grad F| there, or, at an end or a corner of the curve, those of
/// the distance from it. `parameters` has the derivatives in the model's parameters, point after point. d r/d ln
/// sigma_T is -r (dT sigma_T)^2, and likewise for A.
///
/// `place_T` and `place_A`, unless empty, pass in starting points, such as the nearest points for similar parameters (A
/// = 0: none), and return the nearest points.
///
/// `axes`, unless empty: of elliptic contacts, whose nearest point is that in T, A and q, the residual along the normal
/// perpendicular to that of r, which mostly is the difference of q, and its derivatives. The sum of both squares is
/// that of the distance. place_q: q there.
struct CurveDistances {
  std::span<double> r, dP, dT, dA, parameters, place_T{}, place_A{};
  struct Axes {
    std::span<double> r, dP, dT, dA, parameters;
    // in ln sigma_T and ln sigma_A: of the first residual, and of this one
    std::span<double> of_sigma_T, of_sigma_A, own_sigma_T, own_sigma_A;
    // under a held approach, whose third coordinate is the load
    std::span<double> dm{}, of_q{}, own_q{}, of_sigma_q{}, own_sigma_q{};
  } axes{};
  std::span<double> place_q{};
  std::span<double> dm{};  // under a held approach, unless empty: the derivative in the compliance of the machine
};

/// Measured energies of the two modes with standard errors > 0, and the toughness G_Ic > 0 at each point, all in one
/// unit of energy per area. The spans have one size.
struct EnergyPoints {
  std::span<const double> G_I, G_II, sigma_I, sigma_II, G_Ic;
};

/// Signed distances in units of the standard errors, positive where the law's energies are larger, with derivatives in
/// the model's parameters (point after point; not computed if empty) and in ln G_Ic.
struct EnergyDistances {
  std::span<double> value, log_toughness, parameters;
};

/// Measured pull-off loads at held shears of either sign; sigma_P > 0, sigma_shear >= 0. The spans have one size.
struct PullOffPoints {
  std::span<const double> P, shear, sigma_P, sigma_shear;
  std::span<const HeldShear> held;
};

/// Signed distances from P(shear), positive where the model's load is the larger, with derivatives in the measured
/// values and in the model's parameters (point after point); these are not computed if `parameters` is empty. Those in
/// the logarithms of the errors are -r normal_P^2 and -r (1 - normal_P^2).
struct PullOffDistances {
  std::span<double> r, dP, dshear, normal_P, parameters;
};

/// ln f of the model minus ln f of a measured point at the point's psi, with its derivatives in the point's P, T and A
/// and in the model's parameters (point after point).
struct ToughnessResiduals {
  std::span<double> value, P, T, A, parameters;
};

}  // namespace mixity
