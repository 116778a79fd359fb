// What is known of parameters beforehand (FreeParameter::prior), as further residuals: (x - start)/prior.
#pragma once

#include <algorithm>
#include <vector>

#include "solver/problem.h"

namespace mixity {

/// Of how many parameters something is known beforehand.
inline std::size_t prior_count(const Problem& problem) {
  const auto& parameters = problem.parameters();
  return static_cast<std::size_t>(
      std::count_if(parameters.begin(), parameters.end(), [](const FreeParameter& one) { return one.prior > 0; }));
}

/// A problem with its priors behind its residuals, which are in units of `unit`: their standard error, 1 where they are
/// in standard errors already.
class ProblemWithPriors final : public WrappedProblem {
 public:
  explicit ProblemWithPriors(const Problem& problem, double unit = 1) : WrappedProblem(problem), unit_(unit) {
    for (std::size_t k = 0; k < parameters().size(); ++k)
      if (parameters()[k].prior > 0) known_.push_back(k);
  }

  std::size_t residual_count() const override { return problem_.residual_count() + known_.size(); }
  bool known_errors() const override { return true; }
  double data_norm() const override { return problem_.data_norm() / unit_; }
  std::size_t scan_density(std::size_t searched) const override { return problem_.scan_density(searched); }

  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override {
    return problem_.evaluate(x, data(residuals), data(jacobian, x.size())) && add_priors(x, residuals, jacobian);
  }
  bool evaluate_again(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian,
                      std::vector<double>& memory) const override {
    return problem_.evaluate_again(x, data(residuals), data(jacobian, x.size()), memory) &&
           add_priors(x, residuals, jacobian);
  }
  bool evaluate_roughly(std::span<const double> x, std::span<double> residuals) const override {
    return problem_.evaluate_roughly(x, data(residuals)) && add_priors(x, residuals, {});
  }
  std::vector<double> curvatures(std::span<const double> x) const override {
    std::vector<double> values = problem_.curvatures(x);
    if (!values.empty()) values.resize(residual_count(), 1.0);
    return values;
  }

 private:
  /// The part of an array that the data fill.
  std::span<double> data(std::span<double> rows, std::size_t width = 1) const {
    return rows.empty() ? rows : rows.first(problem_.residual_count() * width);
  }

  bool add_priors(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const {
    const std::size_t n = problem_.residual_count(), p = x.size();
    if (unit_ != 1) {
      for (double& r : residuals.first(n)) r /= unit_;
      for (double& slope : data(jacobian, p)) slope /= unit_;
    }
    for (std::size_t i = 0; i < known_.size(); ++i) {
      const std::size_t k = known_[i];
      const FreeParameter& parameter = parameters()[k];
      residuals[n + i] = (x[k] - *parameter.start) / parameter.prior;
      if (jacobian.empty()) continue;
      const std::span<double> row = jacobian.subspan((n + i) * p, p);
      std::fill(row.begin(), row.end(), 0.0);
      row[k] = 1 / parameter.prior;
    }
    return true;
  }

  double unit_;
  std::vector<std::size_t> known_;
};

}  // namespace mixity
