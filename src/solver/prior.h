// What is known of parameters beforehand, as further residuals: (x - mean)/standard error.
#pragma once

#include <algorithm>
#include <vector>

#include "solver/problem.h"

namespace mixity {

struct Prior {
  std::size_t parameter;        // its number
  double mean, standard_error;  // as the solver counts, > 0
};

/// A problem of known errors, with priors behind its residuals.
class ProblemWithPriors final : public WrappedProblem {
 public:
  ProblemWithPriors(const Problem& problem, std::vector<Prior> priors)
      : WrappedProblem(problem), priors_(std::move(priors)) {}

  std::size_t residual_count() const override { return problem_.residual_count() + priors_.size(); }
  std::size_t scan_density(std::size_t searched) const override { return problem_.scan_density(searched); }

  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override {
    const std::size_t n = problem_.residual_count(), p = x.size();
    if (!problem_.evaluate(x, residuals.first(n), jacobian.empty() ? jacobian : jacobian.first(n * p))) return false;
    for (std::size_t i = 0; i < priors_.size(); ++i) {
      const Prior& prior = priors_[i];
      residuals[n + i] = (x[prior.parameter] - prior.mean) / prior.standard_error;
      if (jacobian.empty()) continue;
      const std::span<double> row = jacobian.subspan((n + i) * p, p);
      std::fill(row.begin(), row.end(), 0.0);
      row[prior.parameter] = 1 / prior.standard_error;
    }
    return true;
  }

 private:
  std::vector<Prior> priors_;
};

}  // namespace mixity
