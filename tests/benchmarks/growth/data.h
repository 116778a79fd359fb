// Runs of a contact under rising shear, of any number of points: model b near its fold and below, with 1 % noise.
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

inline std::vector<Measured> measurements(std::size_t n, std::size_t runs, unsigned seed = 1) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0, 0.01);
  const ContactModel model = ContactModel::find("b").value();
  const ParameterValues lambda{0.3};
  std::vector<Measured> points;
  points.reserve(n);
  for (std::size_t run = 0; run < runs; ++run) {
    const double P = 0.5 + 10.0 * static_cast<double>(run) / static_cast<double>(runs);
    const double last = 0.95 * model.first_stable_end(lambda, P);
    const std::size_t here = (run + 1) * n / runs - run * n / runs;
    for (std::size_t i = 0; i < here; ++i) {
      const double T = last * (static_cast<double>(i) + 1) / static_cast<double>(here);
      points.push_back(
          {P, T, contact_state(P, T, model.equilibria(lambda, P, {&T, 1}).at[0].y).A * std::exp(noise(random))});
    }
  }
  return points;
}

inline void write_csv(const std::string& path, std::size_t n, std::size_t runs = 10, unsigned seed = 1) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (!file) std::exit(2);
  std::fputs("P,T,A\n", file);
  for (const Measured& point : measurements(n, runs, seed))
    std::fprintf(file, "%.6g,%.6g,%.6g\n", point.P, point.T, point.A);
  std::fclose(file);
}

}  // namespace mixity::growth
