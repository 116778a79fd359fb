// Synthetic loading runs (P, T, A) of a model for tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "dataset/dataset.h"
#include "fitting/models.h"

namespace mixity {

/// tau^2/T^2 at small T of a published model.
inline double small_shear(const std::string& model, const ParameterValues& p) {
  if (model == "a" || model == "c") return p[0];
  if (model == "b") return p[0] * (1 - 0.25 * p[0]);
  if (p[1] > 1 || p[0] == 1) return 1;
  return p[1] == 1 ? 2 - p[0] : std::copysign(HUGE_VAL, 1 - p[0]);
}

/// A shear at which the contact has lost a good part of its area: its first fold, or a natural scale of T.
inline double shear_to_lose_area(const std::string& model, const ParameterValues& p, double P) {
  const double fold = model_named(model).first_stable_end(p, P), w = small_shear(model, p);
  return std::min(fold, circle_radius(P) / std::sqrt(w > 0 && w < 1 ? w : 1.0));
}

inline Dataset empty_runs() {
  Dataset data;
  data.path = data.name = "synthetic";
  data.has_loads = true;
  return data;
}

/// Appends the run of one load: n shears from 0 to `upto` of shear_to_lose_area, A multiplied by 1 + noise().
inline void add_run(
    Dataset& data, const std::string& model, const ParameterValues& p, double P, std::size_t n, double upto,
    const std::function<double()>& noise = [] { return 0.0; }) {
  const std::size_t curve = data.curves.size();
  data.curves.push_back("run " + std::to_string(curve + 1));
  data.curve_loads.push_back(P);
  const double T_last = upto * shear_to_lose_area(model, p, P);
  std::vector<double> T;
  for (std::size_t i = 0; i < n; ++i) T.push_back(T_last * static_cast<double>(i) / static_cast<double>(n - 1));
  const std::vector<Equilibrium> found = model_named(model).equilibria(p, P, T).at;
  for (std::size_t i = 0; i < n; ++i) {
    const double A = area_from_radius(radius_from_edge_load(found[i].y, P)) * (1 + noise());
    data.points.push_back({data.points.size() + 2, curve, P, T[i], A});
  }
  data.rows = data.points.size();
}

inline Dataset synthetic_runs(
    const std::string& model, const ParameterValues& p, const std::vector<double>& loads, std::size_t n = 12,
    double upto = 0.9, const std::function<double()>& noise = [] { return 0.0; }) {
  Dataset data = empty_runs();
  for (const double P : loads) add_run(data, model, p, P, n, upto, noise);
  return data;
}

/// Gaussian numbers from a seed, the same on every machine: the sum of twelve uniform ones, which has variance 1.
class SeededNoise {
 public:
  SeededNoise(unsigned seed, double size) : random_(seed), size_(size) {}
  double operator()() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += std::ldexp(static_cast<double>(random_() >> 11), -53);
    return size_ * sum;
  }

 private:
  std::mt19937_64 random_;
  double size_;
};

}  // namespace mixity
