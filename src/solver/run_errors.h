// Standard errors that the differences between runs tell, whatever the errors within them.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "solver/problem.h"

namespace mixity {

/// To first order about a fit (Liang & Zeger 1986, Biometrika 73, 13). Priors count with the errors that they state.
class RunErrors {
 public:
  /// `groups`: the residuals of each run; those behind them are of priors.
  RunErrors(const Problem& problem, const std::vector<double>& fitted,
            const std::vector<std::vector<std::size_t>>& groups);

  /// Of each parameter, `change` away from the fit. `drawn`: how often each run counts. Empty where fewer than three
  /// count, or these do not determine the parameters.
  std::vector<double> operator()(const std::vector<double>& drawn, const std::vector<double>& change) const;

 private:
  std::vector<Eigen::MatrixXd> squares_;  // J'J of each run
  std::vector<Eigen::VectorXd> slopes_;   // J'r
  Eigen::MatrixXd of_priors_;
};

}  // namespace mixity
