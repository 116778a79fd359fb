#include "mechanics/vector_math.h"
// after the declarations of the vector forms
#include <cmath>

#include "mechanics/batch.h"
#include "mechanics/cube_root.h"

namespace mixity::batch_detail {
namespace {

/// pi a^2 of 4/3 a^3 = load.
inline double area_of(double load) {
  const double a = cube_root(0.75 * load);
  return pi<double>() * a * a;
}

MIXITY_LOOP void to_areas(double* __restrict load, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) load[i] = load[i] > 0 ? area_of(load[i]) : 0.0;
}

MIXITY_LOOP std::size_t closed_forms(double root_lambda, double S0, double P, const double* __restrict T,
                                     double* __restrict area, std::size_t n) {
  const double centre = 3 * pi<double>();
  const double limit = S0 * (1 + std::numeric_limits<double>::epsilon());  // as in LoadedContact::at
  double found = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double tau = root_lambda * T[i];
    const bool ok = (T[i] >= 0) & (T[i] <= kLargestLoad) & (tau <= limit);
    const double gap = S0 - tau;
    const double root = std::sqrt((ok & (gap > 0)) ? gap * (S0 + tau) : 0.0);
    area[i] = ok ? area_of(centre + root + P) : 0.0;
    found += ok ? 1.0 : 0.0;
  }
  return static_cast<std::size_t>(found);
}

}  // namespace

void areas_from_loads(std::span<double> loads) {
  in_vectors([&] { to_areas(loads.data(), loads.size()); });
}

std::size_t closed_form_areas(double root_lambda, double S0, double P, std::span<const double> T,
                              std::span<double> areas) {
  return in_vectors([&] { return closed_forms(root_lambda, S0, P, T.data(), areas.data(), T.size()); });
}

namespace {

constexpr std::size_t kBlock = 64;

/// One Euler step of each point, as in LoadedContact::solve; `settled` where only rounding is left.
template <class Law>
MIXITY_LOOP void euler_step(Law law, double parameter, double P, const BranchPart& part, const double* __restrict T,
                            double* __restrict y, double* __restrict settled, std::size_t n) {
  constexpr double eps = std::numeric_limits<double>::epsilon();
  const double low = part.low, high = part.y_jkr, centre = 3 * pi<double>();
  const double square = 2 * centre * above_pull_off(P), beside = std::abs(P);
  for (std::size_t i = 0; i < n; ++i) {
    const ShearTerm<double> tau2 = law.shear_term({parameter}, y[i], T[i]);
    const bool upper = y[i] > 4;  // which form of the residual does not cancel, as in circle_residual
    const double v = y[i] - centre, left = upper ? v * v : y[i] * (y[i] - 2 * centre);
    const double value = (left + (upper ? -square : 0.0) + tau2.value) - (upper ? 0.0 : 2 * centre * P);
    const double size = upper ? square + 2 * std::abs(v) * y[i] : 2 * centre * (y[i] + beside);
    const double d1 = 2 * v + tau2.d1, d2 = 2 + tau2.d2, inner = d1 * d1 - 2 * value * d2;
    const double step = -2 * value / (d1 + std::sqrt(inner > 0 ? inner : 0.0));
    const bool done = (std::abs(value) <= 0.5 * eps * size) | (std::abs(step) <= eps * y[i]) |
                      ((2 + std::abs(tau2.d2)) * std::abs(step * step * step) <= 0.1 * eps * d1 * y[i] * y[i]);
    const double next = y[i] + step;
    const bool inside = (next >= low) & (next <= high) & (d1 > 0);
    settled[i] = done & inside ? 1.0 : 0.0;
    y[i] = inside ? next : 0.5 * (y[i] + high);
  }
}

template <class Law>
MIXITY_LOOP void settle(Law law, double parameter, double P, const BranchPart& part, const double* __restrict T,
                        double* __restrict y, std::size_t n) {
  constexpr int kSteps = 6;
  for (std::size_t from = 0; from < n; from += kBlock) {
    const std::size_t count = std::min(kBlock, n - from);
    double shear[kBlock], place[kBlock], settled[kBlock], known[kBlock];
    for (std::size_t i = 0; i < count; ++i) {
      const double t = T[from + i];
      const bool ok = (t >= 0) & (t <= part.T_last);
      known[i] = ok ? 1.0 : 0.0;
      shear[i] = ok ? t : 0.0;
      const double rest = 1 - part.shrink * shear[i] * shear[i];
      place[i] = part.low + (part.y_jkr - part.low) * std::sqrt(rest > 0 ? rest : 0.0);
    }
    bool left = true;
    for (int step = 0; step < kSteps && left; ++step) {
      euler_step(law, parameter, P, part, shear, place, settled, count);
      left = false;
      for (std::size_t i = 0; i < count; ++i) left |= known[i] > settled[i];
    }
    for (std::size_t i = 0; i < count; ++i) y[from + i] = known[i] * settled[i] > 0 ? place[i] : 0.0;
  }
}

}  // namespace

template <class Law>
void settle_batch(Law law, double parameter, double P, const BranchPart& part, std::span<const double> T,
                  std::span<double> y) {
  in_vectors([&] { settle(law, parameter, P, part, T.data(), y.data(), T.size()); });
}

namespace {
[[gnu::used]] const auto settle_instances = each_law([]<class Law>() {
  if constexpr (HasPackedForm<Law>)
    return &settle_batch<Law>;
  else
    return nullptr;
});
}  // namespace

}  // namespace mixity::batch_detail
