// Problems for the solver in a line or two: residuals templated on their scalar, whose Jacobian comes from ceres::Jet.
#pragma once

#include <ceres/jet.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "solver/problem.h"

namespace mixity {

/// Residual i at b is residual(b, i), for any scalar.
template <int kParameters, class Residual>
class JetProblem final : public Problem {
 public:
  JetProblem(std::size_t n, std::vector<FreeParameter> parameters, double data_norm, bool known_errors,
             Residual residual)
      : n_(n),
        parameters_(std::move(parameters)),
        data_norm_(data_norm),
        known_errors_(known_errors),
        residual_(std::move(residual)) {}

  std::size_t residual_count() const override { return n_; }
  const std::vector<FreeParameter>& parameters() const override { return parameters_; }
  double data_norm() const override { return data_norm_; }
  bool known_errors() const override { return known_errors_; }

  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override {
    using Jet = ceres::Jet<double, kParameters>;
    bool finite = true;
    if (jacobian.empty()) {
      for (std::size_t i = 0; i < n_; ++i) finite &= std::isfinite(residuals[i] = residual_(x.data(), i));
      return finite;
    }
    std::array<Jet, kParameters> b;
    for (int k = 0; k < kParameters; ++k) b[k] = Jet(x[k], k);
    for (std::size_t i = 0; i < n_; ++i) {
      const Jet r = residual_(static_cast<const Jet*>(b.data()), i);
      residuals[i] = r.a;
      for (int k = 0; k < kParameters; ++k) jacobian[i * kParameters + k] = r.v[k];
      finite &= std::isfinite(r.a) && r.v.allFinite();
    }
    return finite;
  }

 private:
  std::size_t n_;
  std::vector<FreeParameter> parameters_;
  double data_norm_;
  bool known_errors_;
  Residual residual_;
};

struct Kind {
  double data_norm = 1;
  bool known_errors = false;
};

template <int kParameters, class Residual>
JetProblem<kParameters, Residual> problem_of(std::size_t n, std::vector<FreeParameter> parameters, Kind kind,
                                             Residual residual) {
  return {n, std::move(parameters), kind.data_norm, kind.known_errors, std::move(residual)};
}

/// A parameter with a start and without bounds.
inline FreeParameter unbounded(std::string name, double start) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return {std::move(name), -kInfinity, kInfinity, start};
}

inline double norm(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum);
}

inline double relative_error(double value, double truth) { return std::abs(value - truth) / std::abs(truth); }

}  // namespace mixity
