#include "mechanics/curve.h"

#include <algorithm>
#include <tuple>

#include "mechanics/roots.h"

namespace mixity {

namespace {

/// Edge loads upper > lower at which T -> infinity.
struct AsymptoticLoads {
  double upper, lower;
};

/// The states at psi = pi/2, where g = 1 + excess in y^2 g = 6 pi (y + P). Null if g is unbounded (every published law
/// but a with lambda < 1) or the load admits no such state.
std::optional<AsymptoticLoads> asymptotic_loads(double excess, double P) {
  if (std::isinf(excess)) return std::nullopt;
  const double g = 1 + excess, centre = 3 * pi<double>();
  const double square = 2 * centre * (above_pull_off(P) + P * excess);  // centre^2 + 2 centre P g without cancellation
  if (square < 0) return std::nullopt;
  const double root = std::sqrt(square);
  return AsymptoticLoads{(centre + root) / g, -2 * centre * P / (centre + root)};  // the product is -6 pi P/g
}

}  // namespace

template <class Law>
double search_tangential_load(const Law& law, const Parameters<Law>& p, double y, double tau) {
  const double w = law.small_shear(p);
  const bool regular = w > 0 && std::isfinite(w);
  double T = tau / (regular ? std::sqrt(w) : 1.0);
  if (tau < 1e-140 * y) return regular ? T : 0.0;  // tau^2 would underflow
  // tau is nearly linear in T: Newton's method ends in a few steps, or in rounding.
  double before = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 12; ++i) {
    const ShearTerm<double> term = law.shear_term(p, y, T);
    const double root = std::sqrt(term.value), step = (tau - root) * T * root / (term.value - 0.5 * y * term.d1);
    T += step;
    if (!(T > 0 && T < kInfiniteT)) break;
    if (std::abs(step) <= 4e-16 * T || (std::abs(step) <= 1e-13 * T && std::abs(step) >= 0.5 * before)) return T;
    before = std::abs(step);
  }
  // If Newton's method does not end, a bracketing search of ln T.
  const double target = std::log(tau);
  const auto error = [&](double x) {
    return std::max(0.5 * std::log(law.shear_term(p, y, std::exp(x)).value) - target, -kInfiniteT);
  };
  const double low = std::log(std::numeric_limits<double>::denorm_min()), high = 345;  // e^345 = kInfiniteT
  if (error(low) > 0) return 0;  // bk with a small eta: T lies below all doubles
  if (!(error(high) >= 0)) return std::numeric_limits<double>::infinity();
  T = std::exp(root_between(error, low, high, 40));
  // The last digits from T itself, since ln T of a large T has lost some.
  for (int i = 0; i < 2; ++i) {
    const ShearTerm<double> term = law.shear_term(p, y, T);
    const double root = std::sqrt(term.value);
    T += T * ((tau - root) * root / (term.value - 0.5 * y * term.d1));  // in this order for a denormal T
  }
  return std::isfinite(T) && T > 0 ? T : std::numeric_limits<double>::infinity();
}

template <class Law>
std::vector<CurvePiece> curve_pieces(const Law& law, const Parameters<Law>& p, double P) {
  const double centre = 3 * pi<double>(), S0 = circle_radius(P), y_jkr = centre + S0;
  const double y_low = -2 * centre * P / y_jkr;
  if (!(law.shear_term(p, 1.0, 1.0).value > 0)) return {};
  const double across = 2 * S0;
  const CurveEnd natural = P > 0 ? CurveEnd::hertz : CurveEnd::unstable_jkr;
  const double excess = shear_limit(law, p);
  const auto loads = asymptotic_loads(excess, P);
  if (!loads) {
    if (P > 0) return {{y_jkr, 0, y_jkr, 0, -y_low / across, natural, false}};
    return {{y_jkr, y_low, across, 0, 0, natural, false}};
  }
  // Where an asymptote lies close to an end of the circle, their difference follows from the difference of the
  // equations y^2 = 6 pi (y + P) and y^2 g = 6 pi (y + P).
  const auto [upper, lower] = *loads;
  const bool near_top = upper > 0.5 * y_jkr, near_low = lower < 2 * y_low;
  const double width = near_top ? excess * upper * upper / (S0 + upper - centre) : y_jkr - upper;
  const CurvePiece first{y_jkr, upper, width, 0, (upper - y_low) / across, CurveEnd::asymptote, false};
  if (P >= 0) return {first};
  const double rest = near_low ? excess * lower * lower / (S0 + centre - lower) : lower - y_low;
  return {first, {lower, y_low, rest, (y_jkr - lower) / across, 0, CurveEnd::unstable_jkr, true}};
}

template <class Law>
CurvePiece non_monotone_piece(const NonMonotoneCurve<Law>& curve, double P) {
  const double S0 = circle_radius(P), y_jkr = 3 * pi<double>() + S0;
  CurvePiece piece{y_jkr, 0, curve.length(), 0, 0, CurveEnd::unstable_jkr, false};
  if (curve.closed()) {
    piece.y_end = -6 * pi<double>() * P / y_jkr;
    return piece;
  }
  if (curve.grows_over_all_bounds()) {
    piece.end = CurveEnd::asymptote;
    piece.y_end = curve.at(piece.width, 0).y;
    return piece;
  }
  const auto near_end = [&](double rest) { return curve.at(piece.width - rest, rest); };
  const auto late = near_end(2e-18), later = near_end(1e-18);
  const bool grows = later.t * later.y > (1 + 1e-6) * late.t * late.y;
  piece.end = grows ? CurveEnd::asymptote : P > 0 ? CurveEnd::hertz : CurveEnd::unstable_jkr;
  if (grows) piece.y_end = later.y;
  return piece;
}

/// From R = 0, dy : dT = -R_T : R_y with R_y = 2 (g y - 3 pi) - y dg/d ln t and R_T = y^2 dg/d ln t/T, and by Euler's
/// theorem y R_y + T R_T = 2 y (g y - 3 pi), which fixes their size by that of dt/ds.
template <class Law>
CurvePoint EquilibriumCurve<Law>::non_monotone_point(double s) const {
  const auto place = by_angle_->at(s, by_angle_->length() - s);
  const double y = place.y, T = std::min(place.t * y, kInfiniteT), a = radius_from_edge_load(y, P_), sum = y + P_;
  CurvePoint q{};
  q.phi = s;
  q.y = y;
  q.T = T;
  q.a = a;
  q.A = area_from_radius(a);
  q.psi = place.psi;
  if (!(a > 0) || y == 0) {  // no derivative is finite where the contact vanishes
    q.f = law_.shear_term(p_, 0.0, 1.0).value > 0 ? 1 / law_.shear_term(p_, 0.0, 1.0).value : kLargest;
    q.u = a > 0 ? 0.75 * T / a : 0;
    return q;
  }
  q.u = 0.75 * T / a;
  q.f = (y * y + T * T) / (6 * pi<double>() * sum);
  const auto finite = [](double value) { return std::isnan(value) ? 0.0 : std::clamp(value, -kLargest, kLargest); };
  const double half = 0.5 * y * place.pace;
  q.dy = finite(place.t > 0 ? -y * place.growth * half / place.t : 0.0);
  q.dT = finite((2 * place.root - y * place.growth) * half);
  q.da = finite(q.dy / (4 * a * a));
  q.dA = finite(2 * pi<double>() * a * q.da);
  q.du = finite(0.75 * (q.dT - T * q.da / a) / a);
  q.dpsi = place.dpsi;
  q.df = finite(q.f * (2 * (y * q.dy + T * q.dT) / (y * y + T * T) - q.dy / sum));
  q.f = std::min(q.f, kLargest);
  return q;
}

template <class Law>
CurvePoint EquilibriumCurve<Law>::point(double phi) const {
  if constexpr (kMayBeNonMonotone<Law>) {
    if (non_monotone()) return non_monotone_point(phi);
  }
  const double half = std::sin(0.5 * phi), other = phi < pi<double>() ? std::cos(0.5 * phi) : 0.0;
  // y from the nearer end of the circle: y_jkr - y = 2 S0 sin^2(phi/2), y - y_low = 2 S0 cos^2(phi/2)
  const double y = std::max(phi < 2 ? y_jkr_ - 2 * S0_ * half * half : y_low_ + 2 * S0_ * other * other, 0.0);
  const double tau = 2 * S0_ * half * other;
  // kInfiniteT replaces an infinite T, where phi cannot resolve the distance from the asymptote.
  const double T = uncoupled() ? 0 : std::min(mixity::tangential_load(law_, p_, y, tau), kInfiniteT);
  const double a = radius_from_edge_load(y, P_), sum = y + P_, square = y * y + T * T;

  CurvePoint q{};
  q.phi = phi;
  q.y = y;
  q.T = T;
  q.a = a;
  q.A = area_from_radius(a);
  q.u = 0.75 * T / a;
  q.psi = phase_angle(mixity_from_loads(y, T));
  q.f = T > 0 ? square / (6 * pi<double>() * sum) : 1.0;

  if (!(a > 0) || square == 0) {  // the contact has vanished (P = 0, phi = pi): no derivative is finite
    q.u = q.dT = q.du = 0;
    q.psi = 0.5 * pi<double>();
    return q;
  }
  q.dy = -tau;
  q.da = q.dy / (4 * a * a);
  q.dA = 2 * pi<double>() * a * q.da;
  if (uncoupled()) return q;
  const double offset = S0_ < y ? S0_ * std::cos(phi) : y - 3 * pi<double>();
  if (T > 1e-140 * y) {
    // From tau^2(y, T) = tau^2: tau^2_T T' = 2 tau tau' - tau^2_y y', with tau' = y - 3 pi and T tau^2_T = 2 tau^2 -
    // y tau^2_y, so T'/T = tau (2 (y - 3 pi) + tau^2_y)/(2 tau^2 - y tau^2_y).
    const ShearTerm<double> term = law_.shear_term(p_, y, T);
    const double rate = tau * (2 * offset + term.d1) / (2 * term.value - y * term.d1);
    const double growth = std::isfinite(rate) ? rate : std::copysign(kInfiniteT, offset + 0.5 * term.d1);
    q.dT = std::clamp(T * growth, -kLargest, kLargest);
    q.du = std::clamp(0.75 * T * (growth - q.da / a) / a, -kLargest, kLargest);
    q.dpsi = T / square * (y * growth - q.dy);
    q.df = q.f * (2 * (y * q.dy + T * T * growth) / square - q.dy / sum);
  } else {
    // The limit of that at T = 0: sqrt(small_shear) T' = tau'. bk with eta = 1, r = 2 has an infinite slope there.
    const double w = law_.small_shear(p_);
    q.dT = w > 0 ? offset / std::sqrt(w) : std::copysign(kLargest, offset);
    q.du = std::clamp(0.75 * q.dT / a, -kLargest, kLargest);
    q.dpsi = std::clamp(q.dT / y, -kLargest, kLargest);
    q.df = 0;
  }
  for (double* value : {&q.f, &q.dpsi, &q.df, &q.da, &q.dA}) *value = std::clamp(*value, -kLargest, kLargest);
  return q;
}

namespace {
[[gnu::used]] const auto curve_instances = each_law([]<class Law>() {
  return std::tuple(&search_tangential_load<Law>, &curve_pieces<Law>, &non_monotone_piece<Law>,
                    &EquilibriumCurve<Law>::point);
});
}  // namespace

}  // namespace mixity
