// Synthetic loading runs (P, T, A) of a model for tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "dataset/dataset.h"
#include "mechanics/equilibrium.h"
#include "mechanics/registry.h"

namespace mixity {

/// A shear at which the contact of `Model` has lost a good part of its area: its first fold, or a natural scale of T.
template <class Model>
double shear_to_lose_area(const Parameters<Model>& p, double P) {
  const double fold = LoadedContact<Model>(p, P).branches().front().T_bottom, w = Model::small_shear(p);
  return std::min(fold, circle_radius(P) / std::sqrt(w > 0 && w < 1 ? w : 1.0));
}

inline Dataset empty_runs() {
  Dataset data;
  data.path = data.name = "synthetic";
  data.has_loads = true;
  return data;
}

/// Appends the run of one load: n shears from 0 to `upto` of shear_to_lose_area, A multiplied by 1 + noise().
template <class Model>
void add_run(
    Dataset& data, const Parameters<Model>& p, double P, std::size_t n, double upto,
    const std::function<double()>& noise = [] { return 0.0; }) {
  const LoadedContact<Model> contact(p, P);
  const std::size_t curve = data.curves.size();
  data.curves.push_back("run " + std::to_string(curve + 1));
  data.curve_loads.push_back(P);
  const double T_last = upto * shear_to_lose_area<Model>(p, P);
  for (std::size_t i = 0; i < n; ++i) {
    const double T = T_last * static_cast<double>(i) / static_cast<double>(n - 1);
    const double A = area_from_radius(radius_from_edge_load(contact.at(T).y, P)) * (1 + noise());
    data.points.push_back({data.points.size() + 2, curve, P, T, A});
  }
  data.rows = data.points.size();
}

template <class Model>
Dataset synthetic_runs(
    const Parameters<Model>& p, const std::vector<double>& loads, std::size_t n = 12, double upto = 0.9,
    const std::function<double()>& noise = [] { return 0.0; }) {
  Dataset data = empty_runs();
  for (const double P : loads) add_run<Model>(data, p, P, n, upto, noise);
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
