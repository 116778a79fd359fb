// Runs of a contact under rising shear, of any number of points: a model near its fold and below, with 1 % noise.
#pragma once

#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "dataset/dataset.h"
#include "mechanics/contact_model.h"

namespace mixity::growth {

struct Measured {
  double P, T, A;
};

/// What is measured, up to which part of the fold. Noise is of ln A, or of both T and A: then also the fit of ten
/// million points finds what it assumes.
struct Truth {
  const char* model = "b";
  double lambda = 0.3, last = 0.95;
  bool of_both = false;
};

inline std::vector<Measured> measurements(std::size_t n, std::size_t runs, unsigned seed = 1, const Truth& truth = {}) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0, 0.01);
  const ContactModel model = ContactModel::find(truth.model).value();
  const ParameterValues lambda{truth.lambda};
  std::vector<Measured> points;
  points.reserve(n);
  for (std::size_t run = 0; run < runs; ++run) {
    const double P = 0.5 + 10.0 * static_cast<double>(run) / static_cast<double>(runs);
    const double last = truth.last * model.first_stable_end(lambda, P);
    const std::size_t here = (run + 1) * n / runs - run * n / runs;
    for (std::size_t i = 0; i < here; ++i) {
      const double T = last * (static_cast<double>(i) + 1) / static_cast<double>(here);
      const double A = contact_state(P, T, model.equilibria(lambda, P, {&T, 1}).at[0].y).A;
      if (truth.of_both)
        points.push_back({P, T * (1 + noise(random)), A * (1 + noise(random))});
      else
        points.push_back({P, T, A * std::exp(noise(random))});
    }
  }
  return points;
}

inline void write_csv(const std::string& path, std::size_t n, std::size_t runs = 10, unsigned seed = 1,
                      const Truth& truth = {}) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (!file) std::exit(2);
  std::fputs("P,T,A\n", file);
  for (const Measured& point : measurements(n, runs, seed, truth))
    std::fprintf(file, "%.6g,%.6g,%.6g\n", point.P, point.T, point.A);
  std::fclose(file);
}

}  // namespace mixity::growth
