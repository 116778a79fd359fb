// Definitions of LoadedContact. Included by equilibrium.h only.
#pragma once

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>

namespace mixity {

template <class Model>
LoadedContact<Model>::LoadedContact(const Parameters<Model>& parameters, double P) : p_(parameters), P_(P) {
  for (std::size_t i = 0; i < p_.size(); ++i)
    if (!(p_[i] >= Model::parameters[i].lower && p_[i] <= Model::parameters[i].upper)) {
      obstacle_ = "a model parameter lies outside its range";
      return;
    }
  if (!(std::abs(P) <= kLargestLoad)) {
    obstacle_ = "the load is not a number below 1e150";
    return;
  }
  obstacle_ = Model::equilibrium_domain(p_);
  if (!obstacle_.empty() || above_pull_off(P) < 0) return;
  in_contact_ = true;
  S0_ = circle_radius(P);
  y_jkr_ = 3 * pi<double>() + S0_;
  simple_top_ = Model::tau_grows_with_edge_load(p_);
}

/// Largest root of R in [low, high], where R(low) <= 0 <= R(high): steps to the upper root of the quadratic that
/// R's value, slope and curvature define (Euler's method). It is cubically convergent, exact in one step for
/// model c, and keeps its pace where Newton's crawls, at the double root of a fold. Bisection is the safeguard.
template <class Model>
Equilibrium LoadedContact<Model>::solve(double T, double low, double high, double start) const {
  constexpr double eps = std::numeric_limits<double>::epsilon();
  double y = start;
  int iterations = 0;
  for (; iterations < 200 && low < high; ++iterations) {
    const ShearTerm<double> R = circle_residual<Model, double>(p_, P_, y, T);
    if (R.value == 0) break;
    (R.value > 0 ? high : low) = y;
    // Within rounding of a fold the discriminant may come out negative: the vertex is then the root.
    const double root = std::sqrt(std::max(R.d1 * R.d1 - 2 * R.value * R.d2, 0.0));
    const double step = R.d1 > 0 ? -2 * R.value / (R.d1 + root) : (root - R.d1) / R.d2;
    const double next = y + step;
    if (!(next >= low && next <= high)) {
      y = low > 0 && high > 16 * low ? std::sqrt(low * high) : 0.5 * (low + high);
      if (high - low <= eps * high) break;
      continue;
    }
    // What the step leaves is a third of a cubic term, |R''' step^3/6 R'|, with R''' about R''/y.
    const bool done = std::abs(step) <= eps * y || std::abs(R.d2 * step * step * step) <= 0.1 * eps * R.d1 * y * y;
    y = next;
    if (done) {
      ++iterations;
      break;
    }
  }
  return {EquilibriumStatus::ok, y, iterations};
}

template <class Model>
Equilibrium LoadedContact<Model>::at(double T) const {
  if (!obstacle_.empty() || !(T >= 0 && T <= kLargestLoad)) return {EquilibriumStatus::invalid};
  if (!in_contact_) return {EquilibriumStatus::no_equilibrium};
  const double centre = 3 * pi<double>();
  if constexpr (requires { Model::shear_on_circle(p_, T); }) {
    // Closed form: tau does not depend on y.
    const double tau = Model::shear_on_circle(p_, T);
    // One rounding of tau may put the fold itself beyond the circle.
    if (tau > S0_ * (1 + std::numeric_limits<double>::epsilon())) return {EquilibriumStatus::no_equilibrium};
    return {EquilibriumStatus::ok, centre + std::sqrt(std::max(S0_ - tau, 0.0) * (S0_ + tau))};
  } else {
    const auto gap = [&](double y) { return S0_ * S0_ - Model::shear_term(p_, y, T).value; };
    if (simple_top_ && gap(centre) >= 0) {
      // R rises with y above the centre, so this root is the only one there. tau is largest at the top,
      // which makes the start a lower bound close to the root.
      const double room = gap(y_jkr_);
      return solve(T, centre, y_jkr_, room > 0 ? centre + std::sqrt(room) : 0.5 * (centre + y_jkr_));
    }
    for (const StableBranch& branch : branches())
      if (T <= branch.T_bottom)
        return T < branch.T_top
                   ? solve(branch.T_top, branch.y_bottom, branch.y_top, branch.y_top)
                   : solve(T, branch.y_bottom, branch.y_top, std::max(branch.y_bottom, 0.5 * branch.y_top));
    return {EquilibriumStatus::no_equilibrium};
  }
}

/// Upper intersection of the ray T/y = tan_psi with the curve; NaN where the ray misses it (P < 0 only).
template <class Model>
double LoadedContact<Model>::edge_load_on_curve(double tan_psi) const {
  const double centre = 3 * pi<double>();
  const double g = 1 + Model::shear_term(p_, 1.0, tan_psi).value;
  return (centre + std::sqrt(centre * centre + 2 * centre * P_ * g)) / g;
}

/// dR/dy along the curve: > 0 where A falls as T rises, 0 at a fold.
template <class Model>
double LoadedContact<Model>::slope(double log_tan_psi) const {
  const double t = std::exp(log_tan_psi), y = edge_load_on_curve(t);
  return std::isnan(y) ? -1.0 : circle_residual<Model, double>(p_, P_, y, t * y).d1;
}

template <class Model>
double LoadedContact<Model>::refine_fold(double log_low, double log_high) const {
  std::uintmax_t evaluations = 200;
  const auto root = boost::math::tools::toms748_solve([this](double x) { return slope(x); }, log_low, log_high,
                                                      boost::math::tools::eps_tolerance<double>(50), evaluations);
  return 0.5 * (root.first + root.second);
}

template <class Model>
const std::vector<StableBranch>& LoadedContact<Model>::branches() const {
  if (branches_.empty()) find_branches();
  return branches_;
}

/// Walks down the curve in log tan psi and cuts it where dR/dy changes sign. The walk starts where the curve may
/// first fold and ends where nothing changes any more; sign changes are then found to the last digit, and a dip of
/// the slope between two steps is followed to its bottom so that a close pair of folds is not overlooked.
template <class Model>
void LoadedContact<Model>::find_branches() const {
  const double infinity = std::numeric_limits<double>::infinity();
  if constexpr (requires { Model::shear_on_circle(p_, 1.0); }) {
    const double per_load = Model::shear_on_circle(p_, 1.0);
    const double centre = 3 * pi<double>();
    branches_ = per_load > 0 ? std::vector{StableBranch{y_jkr_, 0, centre, S0_ / per_load, true}}
                             : std::vector{StableBranch{y_jkr_, 0, y_jkr_, infinity, false}};
    return;
  }
  constexpr double kStep = 0.25, kSteepest = 340;  // in ln tan psi; e^340 = 1e147
  const auto load_at = [&](double x) { return std::exp(x) * edge_load_on_curve(std::exp(x)); };

  double x = simple_top_ ? -40 : -20;
  if (simple_top_) {  // nothing folds above the centre of the circle: skip to it
    double below = x, above = kSteepest;
    while (above - below > kStep) {
      const double middle = 0.5 * (below + above);
      (edge_load_on_curve(std::exp(middle)) > 3 * pi<double>() ? below : above) = middle;
    }
    x = below;
  }

  StableBranch current{y_jkr_, 0, 0, 0, false};
  bool stable = true;
  const auto cut = [&](double fold) {
    const double y = edge_load_on_curve(std::exp(fold)), T = load_at(fold);
    if (stable) {
      branches_.push_back({current.y_top, current.T_top, y, T, true});
    } else {
      current = {y, T, 0, 0, false};
    }
    stable = !stable;
  };

  double before = infinity, here = slope(x);
  for (; x < kSteepest; x += kStep) {
    const double t = std::exp(x), y = edge_load_on_curve(t);
    if (std::isnan(y)) break;  // the ray has left the circle: the rest of the curve is unstable
    const double next = slope(x + kStep);
    if ((here > 0) != (next > 0)) {
      cut(refine_fold(x, x + kStep));
    } else if (const double sign = here > 0 ? 1 : -1;
               sign * before > sign * here && sign * next > sign * here && !std::isinf(before)) {
      const auto dip =
          boost::math::tools::brent_find_minima([&](double z) { return sign * slope(z); }, x - kStep, x + kStep, 40);
      if (dip.second < 0) {
        cut(refine_fold(x - kStep, dip.first));
        cut(refine_fold(dip.first, x + kStep));
      }
    }
    const double g = Model::shear_term(p_, 1.0, t).value, g_next = Model::shear_term(p_, 1.0, 1e4 * t).value;
    if (y < 1e-17 * P_ || g_next - g <= 1e-17 * g_next) break;
    before = (here > 0) == (next > 0) ? here : infinity;
    here = next;
  }
  if (stable) {
    const double end = std::exp(kSteepest);
    const double at_hertz = Model::shear_term(p_, 0.0, 1.0).value;  // tau^2/T^2 at y = 0
    if (at_hertz > 0)
      branches_.push_back({current.y_top, current.T_top, 0, std::sqrt(6 * pi<double>() * P_ / at_hertz), false});
    else
      branches_.push_back({current.y_top, current.T_top, edge_load_on_curve(end), infinity, false});
  }
}

}  // namespace mixity
