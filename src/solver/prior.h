// Priors of parameters (FreeParameter::prior) as additional residuals (x - start)/prior.
#pragma once

#include <algorithm>
#include <vector>

#include "solver/problem.h"

namespace mixity {

/// The number of parameters with a prior.
inline std::size_t prior_count(const Problem& problem) {
  const auto& parameters = problem.parameters();
  return static_cast<std::size_t>(
      std::count_if(parameters.begin(), parameters.end(), [](const FreeParameter& one) { return one.prior > 0; }));
}

/// A problem whose priors are appended as residuals to its own, which are divided by `unit`: their standard error, or 1
/// if they are in standard errors already. Without priors it equals the problem.
class ProblemWithPriors final : public WrappedProblem {
 public:
  explicit ProblemWithPriors(const Problem& problem, double unit = 1)
      : WrappedProblem(problem), unit_(unit), priors_(prior_count(problem)) {}

  std::size_t residual_count() const override { return problem_.residual_count() + priors_; }
  bool known_errors() const override { return priors_ > 0 || problem_.known_errors(); }
  double data_norm() const override { return problem_.data_norm() / unit_; }
  std::unique_ptr<Cost> cost() const override { return priors_ > 0 ? Problem::cost() : problem_.cost(); }
  std::vector<double> curvatures(std::span<const double> x) const override {
    std::vector<double> values = problem_.curvatures(x);
    if (!values.empty()) values.resize(residual_count(), 1.0);
    return values;
  }

 private:
  void change(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override {
    const std::size_t p = x.size();
    if (unit_ != 1) {
      for (double& r : of_other(residuals)) r /= unit_;
      for (double& slope : of_other(jacobian, p)) slope /= unit_;
    }
    std::size_t row = problem_.residual_count();
    if (!jacobian.empty()) std::fill(jacobian.begin() + static_cast<std::ptrdiff_t>(row * p), jacobian.end(), 0.0);
    for (std::size_t k = 0; k < p; ++k) {
      const FreeParameter& parameter = parameters()[k];
      if (!(parameter.prior > 0)) continue;
      residuals[row] = (x[k] - *parameter.start) / parameter.prior;
      if (!jacobian.empty()) jacobian[row * p + k] = 1 / parameter.prior;
      ++row;
    }
  }

  double unit_;
  std::size_t priors_;
};

}  // namespace mixity
