// Standard errors from the differences between runs, whatever the errors within them.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "solver/problem.h"

namespace mixity {

/// Cluster-robust, to first order about a fit (Liang & Zeger 1986, Biometrika 73, 13). Priors use their stated errors.
class RunErrors {
 public:
  /// `groups`: the residuals of each run; the residuals after these belong to priors.
  RunErrors(const Problem& problem, const std::vector<double>& fitted,
            const std::vector<std::vector<std::size_t>>& groups);

  /// Standard errors of the parameters at `change` from the fit. `drawn`: how often each run counts. Empty if fewer
  /// than three runs count, or if these do not determine the parameters.
  std::vector<double> operator()(const std::vector<double>& drawn, const std::vector<double>& change) const;

 private:
  std::vector<Eigen::MatrixXd> squares_;  // J'J of each run
  std::vector<Eigen::VectorXd> slopes_;   // J'r
  Eigen::MatrixXd of_priors_;
};

}  // namespace mixity
