// Two forms of the equilibrium under load control that make its folds cheap to find.
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "mechanics/fold_search.h"
#include "mechanics/roots.h"

namespace mixity {

template <class Law>
std::optional<LoadFold> newton_fold(const Law& law, const Parameters<Law>& p, double P, double v, double T) {
  constexpr double eps = std::numeric_limits<double>::epsilon();
  const double S0 = circle_radius(P), y_least = 1e-3 * std::abs(P);
  for (int i = 0; i < 30; ++i) {
    const double y = 3 * pi<double>() + v;
    if (!(y > y_least && T > 0 && T < kInfiniteT)) return std::nullopt;
    const ShearTerm<double> tau2 = law.shear_term(p, y, T);
    const double R = (v - S0) * (v + S0) + tau2.value, R_y = 2 * v + tau2.d1, R_yy = 2 + tau2.d2;
    const double R_T = (2 * tau2.value - y * tau2.d1) / T, R_yT = (tau2.d1 - y * tau2.d2) / T;
    const double determinant = R_y * R_yT - R_T * R_yy;
    const double dv = (R_y * R_T - R * R_yT) / determinant, dT = (R * R_yy - R_y * R_y) / determinant;
    v += dv;
    T += dT;
    if (std::abs(dv) <= 4 * eps * S0 && std::abs(dT) <= 1e-8 * T)
      return LoadFold{v, T};  // Newton's method squares what is left of the error in T
  }
  return std::nullopt;
}

namespace load_folds_detail {

/// The upper half of the curve, y > -2 P, parametrised by x = ln tan psi. With tau^2 = y^2 (g - 1), where g depends on
/// psi alone, the circle is a quadratic in y, g y^2 = 6 pi (y + P), whose larger root is used: a point costs one
/// evaluation of the law. dT = 0 reads (y + 2 P)/(y + P) = d ln g/dx. The lower half, which exists only for P < 0,
/// therefore has no fold: there y + 2 P < 0, y + P > 0, and g grows with psi.
template <class Law>
class CurveByAngle {
 public:
  explicit CurveByAngle(const EquilibriumCurve<Law>& curve)
      : law_(curve.law()), p_(curve.parameters()), P_(curve.load()), S0_(circle_radius(P_)) {}

  struct Place {
    double y, offset;    // offset = y - 3 pi
    double tau2, slope;  // tau^2; R_y relative to its terms: > 0 where the contact is stable
    double growth;       // d ln tau^2/dx at fixed y
    bool exists;         // false beyond the largest psi of the curve
  };

  Place at(double x) const {
    const double centre = 3 * pi<double>();
    const ShearTerm<double> excess = law_.shear_term(p_, 1.0, std::exp(x));  // g - 1 and d1 = 2 (g - 1) - dg/dx
    const double g = 1 + excess.value, square = S0_ * S0_ + 2 * centre * P_ * excess.value;
    const double root = std::sqrt(std::max(square, 0.0)), y = (centre + root) / g;
    const double offset = (root - centre * excess.value) / g, d1 = y * excess.d1;
    const double size = 2 * std::abs(offset) + std::abs(d1);
    return {y,
            offset,
            y * y * excess.value,
            square < 0 ? -1
            : size > 0 ? (2 * offset + d1) / size
                       : 0,
            excess.value > 0 ? 2 - excess.d1 / excess.value : 2,
            square >= 0};
  }

  /// The fold at x. Newton's method finds its last digits, which x lacks near pull-off, where psi has a maximum close
  /// to the fold. At the edge of a law's domain it may not converge; then the digits of x remain.
  FoldPlace fold(const EquilibriumCurve<Law>& curve, double x, bool maximum) const {
    const Place place = at(x);
    double y = place.y, offset = place.offset, tau2 = place.tau2, T = y * std::exp(x);
    const auto last_digits = y > 4 ? newton_fold(law_, p_, P_, offset, T) : std::nullopt;  // y - 3 pi rounds a small y
    if (last_digits && std::abs(last_digits->v - offset) <= 1e-6 * S0_ && std::abs(last_digits->T - T) <= 1e-12 * T) {
      offset = last_digits->v;
      T = last_digits->T;
      y = 3 * pi<double>() + offset;
      tau2 = law_.shear_term(p_, y, T).value;
    }
    // each half angle from the form that does not cancel
    const double cosine = std::clamp(offset / S0_, -1.0, 1.0), sine2 = tau2 / (S0_ * S0_);
    const double larger = 0.5 * (1 + std::abs(cosine)), smaller = 0.25 * sine2 / larger;
    const CurvePosition on_circle{y, cosine > 0 ? larger : smaller, cosine > 0 ? smaller : larger};
    return {0, curve.coordinate(curve.pieces()[0], on_circle), on_circle, T, maximum};
  }

  /// x below which there is no fold: above the centre of the circle if tau grows with y; else where tau^2 is about 1e-9
  /// of S0^2.
  double first() const {
    const bool simple_top = law_.tau_grows_with_edge_load(p_);
    const auto before = [&](double x) {
      const Place place = at(x);
      return place.exists && (simple_top ? place.offset > 0 : place.tau2 <= 4e-9 * S0_ * S0_);
    };
    double low = -1, high = 1;
    while (low > kFirst && !before(low)) high = low, low = std::max(2 * low, kFirst);
    while (high < kLast && before(high)) low = high, high = std::min(2 * high, kLast);
    for (int i = 0; i < 20 && high - low > 0.25; ++i) {
      const double middle = 0.5 * (low + high);
      (before(middle) ? low : high) = middle;
    }
    return low;
  }

  /// The distance from x, where the curve is at `place`, to the next sample: a quarter of ln tau^2 at small psi, and
  /// fixed steps at large psi.
  static double step(double x, const Place& place) {
    if (!place.exists) return kLast - x;
    if (x < -1) return std::clamp(0.25 / std::max(place.growth, 0.02), 0.125, 12.0);
    const double fine = kMayBeNonMonotone<Law> && x < 3 ? 0.4 : 1;  // 1.5 degrees, for bumps of a user's law
    return fine * (x < 6 ? 0.125 : x < 12 ? 0.25 : 0.5);
  }

  static constexpr double kFirst = -700, kLast = kLastCoordinate<Law>;  // tan psi from the smallest double on

 private:
  [[no_unique_address]] Law law_;
  Parameters<Law> p_;
  double P_, S0_;
};

}  // namespace load_folds_detail

template <class Law>
bool folds_by_angle(const EquilibriumCurve<Law>& curve, FoundFolds& found) {
  using CurveByAngle = load_folds_detail::CurveByAngle<Law>;
  const CurveByAngle by_angle(curve);
  double x_last = std::numeric_limits<double>::quiet_NaN();
  typename CurveByAngle::Place last{};
  const auto at = [&](double x) -> const auto& {
    if (x != x_last) last = by_angle.at(x_last = x);
    return last;
  };
  const double from = by_angle.first();
  if (!(at(from).slope > 0)) return false;
  for_sign_changes([&](double x) { return at(x).slope; }, from, CurveByAngle::kLast, kShallow,
                   [&](double x) { return CurveByAngle::step(x, at(x)); },
                   [&](double x, bool maximum) { return found.add(by_angle.fold(curve, x, maximum)); });
  return true;
}

namespace {
[[gnu::used]] const auto load_instances =
    each_law([]<class Law>() { return std::tuple(&newton_fold<Law>, &folds_by_angle<Law>); });
}  // namespace

}  // namespace mixity
