// The law G_c(psi) = G_Ic f(psi) in the plane of the two energies G_I = G_c cos^2 psi and G_II = G_c sin^2 psi, and the
// point of it nearest to a measured one. With B = sin^2 psi and h = 1/f the law is the curve
//
//     G_I = G_Ic (1 - B)/h,   G_II = G_Ic B/h,      h = (1 - B) + tau^2(y = sqrt(1-B), T = sqrt(B)),
//
// regular in B for every model whose f is regular in psi^2; for model c it is the straight line G_I = G_Ic - lambda
// G_II.
#pragma once

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "mechanics/model.h"
#include "mechanics/registry.h"

namespace mixity {

/// Signed distance of a measured point in units of its standard errors, positive where the law's energies are the
/// larger, with its derivatives in the model's parameters and in ln G_Ic.
template <class Model>
struct EnergyDistance {
  double value;
  Parameters<Model> parameters;
  double log_toughness;
};

template <class Model>
class EnergyLaw {
 public:
  explicit EnergyLaw(const Parameters<Model>& p) : p_(p), slope_at_mode_I_(-Model::small_shear(p)) {}

  /// Of the point (G_I, G_II) with standard errors > 0, in any unit of energy per area, as G_Ic > 0. A reading of G_II
  /// below zero is compared with the tangent that continues the law beyond psi = 0.
  EnergyDistance<Model> distance(double G_I, double G_II, double sigma_I, double sigma_II, double toughness) const {
    const Target target{G_I / toughness, G_II / toughness, sigma_I / toughness, sigma_II / toughness};
    const Nearest nearest = find(target);
    // along the normal, where a rounding of the place does not show; the offset itself at an end of the law
    double x = (nearest.G_I - target.G_I) / target.sigma_I, y = (nearest.G_II - target.G_II) / target.sigma_II;
    double n_I = nearest.d_II / target.sigma_II, n_II = -nearest.d_I / target.sigma_I;
    const double size = std::hypot(n_I, n_II), length = std::hypot(x, y);
    n_I /= size;
    n_II /= size;
    const double along = x * n_I + y * n_II;
    EnergyDistance<Model> r{along, {}, 0};
    if (nearest.at_end && length > 0) {
      r.value = std::copysign(length, along);
      n_I = x / r.value;
      n_II = y / r.value;
    }
    const double lever_I = n_I * nearest.G_I / target.sigma_I, lever_II = n_II * nearest.G_II / target.sigma_II;
    r.log_toughness = lever_I + lever_II;
    // at a fixed psi the law moves along its ray, by d ln f
    const auto log_f = Model::log_toughness(p_, mixity_from_mode_ratio(std::max(nearest.B, kTiny)));
    for (std::size_t k = 0; k < p_.size(); ++k)
      r.parameters[k] = nearest.on_tangent ? n_I / target.sigma_I * log_f.gradient[k] / kTiny * nearest.G_II
                                           : r.log_toughness * log_f.gradient[k];
    return r;
  }

 private:
  static constexpr double kTiny = 1e-18;  // a mode ratio at which ln f is its first term
  static constexpr double kCorner = 1e-12;
  static constexpr int kNodes = 48;

  struct Target {
    double G_I, G_II, sigma_I, sigma_II;
  };
  struct Nearest {
    double B, G_I, G_II, d_I, d_II;  // energies and their derivatives in B, in units of G_Ic
    bool at_end = false, on_tangent = false;
  };

  Nearest at(double B) const {
    const double c = std::sqrt(1 - B), s = std::sqrt(B);
    const ShearTerm<double> tau2 = Model::shear_term(p_, c, s);
    const double h = (1 - B) + tau2.value;
    const double slope = B > kTiny ? -1 + tau2.value / B - tau2.d1 / (2 * B * c) : -1 - slope_at_mode_I_;
    return {B, (1 - B) / h, B / h, (-h - (1 - B) * slope) / (h * h), (h - B * slope) / (h * h)};
  }
  static double half_slope(const Target& t, const Nearest& q) {
    return (q.G_I - t.G_I) / (t.sigma_I * t.sigma_I) * q.d_I + (q.G_II - t.G_II) / (t.sigma_II * t.sigma_II) * q.d_II;
  }
  static double square(const Target& t, const Nearest& q) {
    return std::pow((q.G_I - t.G_I) / t.sigma_I, 2) + std::pow((q.G_II - t.G_II) / t.sigma_II, 2);
  }

  /// Those that every search goes over, found when the first one comes to them.
  const Nearest& node(int i) const {
    for (; known_ <= i; ++known_)
      nodes_[static_cast<std::size_t>(known_)] =
          at(known_ < kNodes ? std::pow(std::sin(0.5 * pi<double>() * known_ / kNodes), 2) : 1 - 1e-12);
    return nodes_[static_cast<std::size_t>(i)];
  }

  Nearest find(const Target& target) const {
    // Nodes even in psi, up to where the energies are finite; each sign change of the slope from - to + is a minimum.
    // (bk with eta < 1 leaves psi = 0 with an infinite slope: a corner)
    Nearest best = std::isfinite(slope_at_mode_I_) ? node(0) : at(kCorner), before = best;
    best.at_end = true;
    double least = square(target, best), slope = half_slope(target, before);
    if (std::isfinite(slope_at_mode_I_) && slope > 0) {  // beyond psi = 0, on the tangent G_I = 1 + slope G_II
      const double m = slope_at_mode_I_, a = m / target.sigma_I, b = 1 / target.sigma_II;
      const double t = (a * (target.G_I - 1) / target.sigma_I + b * target.G_II / target.sigma_II) / (a * a + b * b);
      if (t <= 0) {
        best = {0, 1 + m * t, t, m, 1, false, true};
        least = square(target, best);
      }
    }
    for (int i = 1; i <= kNodes; ++i) {
      Nearest here = node(i);
      if (!std::isfinite(here.G_II + here.d_I + here.d_II)) break;
      const double next = half_slope(target, here);
      if (slope < 0 && next >= 0) {
        std::uintmax_t evaluations = 100;
        const auto [low, high] = boost::math::tools::toms748_solve(
            [&](double B) { return half_slope(target, at(B)); }, before.B, here.B, slope, next,
            [](double one, double two) { return two - one <= 1e-16 * two; }, evaluations);
        const Nearest inside = at(0.5 * (low + high));
        if (const double found = square(target, inside); found < least) {
          best = inside;
          least = found;
        }
      }
      if (i == kNodes && next < 0)
        if (const double found = square(target, here); found < least) {
          best = here;
          best.at_end = true;
        }
      before = here;
      slope = next;
    }
    return best;
  }

  mutable std::array<Nearest, kNodes + 1> nodes_;
  mutable int known_ = 0;
  Parameters<Model> p_;
  double slope_at_mode_I_;  // dG_I/dG_II there
};

}  // namespace mixity
