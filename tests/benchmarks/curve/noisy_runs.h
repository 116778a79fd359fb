// What a laboratory measures: runs of loads up to close to the jump, with errors of T and of A that are known.
#pragma once

#include <array>
#include <random>
#include <string>

#include "dataset/dataset.h"
#include "fitting/synthetic_runs.h"

namespace mixity {

/// The normal loads of Mergel et al. (2018), P/(R G_Ic).
inline constexpr std::array<double, 8> kMergelLoads{30.4, 15.0, 11.5, 6.2, 3.7, 2.0, -0.23, -1.79};

struct RunsWanted {
  std::size_t points;
  double noise = 0.01;    // relative to the true T and A
  double reach = 0.95;    // last T over that of the jump, or of a natural scale where the contact never jumps
  bool own_loads = true;  // each point states the load that was measured with it, which scatters by 0.1 %
  unsigned seed = 1;
};

/// Points in turn over the eight loads, dimensionless, with their standard errors. The contact is at the load stated:
/// no error of P spoils what is fitted.
inline Dataset noisy_runs(const std::string& key, const ParameterValues& p, const RunsWanted& wanted) {
  const ContactModel model = model_named(key);
  std::mt19937_64 random(wanted.seed);
  std::normal_distribution<double> normal;
  Dataset data;
  data.path = data.name = "synthetic";
  data.has_loads = true;
  const double w = small_shear(key, p);
  for (std::size_t run = 0; run < kMergelLoads.size(); ++run) {
    const double P_run = kMergelLoads[run];
    const double jump = model.first_stable_end(p, P_run);
    const double last = wanted.reach * std::min(jump, 3 * circle_radius(P_run) / std::sqrt(w));
    const std::size_t n = (run + 1) * wanted.points / kMergelLoads.size() - run * wanted.points / kMergelLoads.size();
    data.curves.push_back(std::to_string(run + 1));
    data.curve_loads.push_back(P_run);
    for (std::size_t i = 0; i < n; ++i) {
      const double P = P_run * (wanted.own_loads ? 1 + 1e-3 * normal(random) : 1);
      const double T = last * static_cast<double>(i + 1) / static_cast<double>(n);
      const double A = contact_state(P, T, model.equilibria(p, P, {&T, 1}).at[0].y).A;
      const PointErrors errors{wanted.noise * T, wanted.noise * A, 0};
      data.points.push_back(
          {data.points.size() + 2, run, P, T + errors.T * normal(random), A + errors.A * normal(random)});
      data.errors.push_back(errors);
    }
  }
  data.rows = data.points.size();
  return data;
}

}  // namespace mixity
