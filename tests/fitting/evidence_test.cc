// The evidence of a fit over uncertain constants: Laplace's method against a sum over all of them.
#include "solver/evidence.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numbers>

#include "fitting/measured_runs.h"
#include "fitting/prepare.h"
#include "solver/prior.h"
#include "solver/solve.h"

namespace mixity {
namespace evidence_test {

/// ln of the integral of exp(-cost/2) over all parameters, by the trapezoidal rule in the principal axes of the
/// covariance, +-7 standard errors in steps of a half: exact to rounding where the cost is smooth.
struct Summed {
  double log_integral, mean, standard_deviation;
};
Summed summed(const Problem& cost, const Verdict& verdict) {
  const std::size_t n = cost.residual_count(), p = cost.parameters().size();
  std::vector<double> r(n), jacobian(n * p);
  EXPECT_TRUE(cost.evaluate(verdict.best.x, r, jacobian));
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Map<const Rows> J(jacobian.data(), static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(p));
  const Eigen::MatrixXd covariance = (J.transpose() * J).inverse(), L = covariance.llt().matrixL();
  constexpr int kSide = 14;
  constexpr double kStep = 0.5;
  double sum = 0, first = 0, second = 0;
  std::vector<double> x(p);
  Eigen::VectorXd z(static_cast<Eigen::Index>(p));
  std::vector<int> index(p, -kSide);
  for (bool more = true; more;) {
    for (std::size_t k = 0; k < p; ++k) z[static_cast<Eigen::Index>(k)] = kStep * index[k];
    const Eigen::VectorXd move = L * z;
    for (std::size_t k = 0; k < p; ++k) x[k] = verdict.best.x[k] + move[static_cast<Eigen::Index>(k)];
    if (const auto square = sum_of_squares(cost, x, r)) {
      const double density = std::exp(-0.5 * (*square - verdict.best.sum_of_squares));
      sum += density;
      first += density * x[0];
      second += density * x[0] * x[0];
    }
    more = false;
    for (std::size_t k = 0; k < p && !more; ++k) {
      more = ++index[k] <= kSide;
      if (!more) index[k] = -kSide;
    }
  }
  const double mean = first / sum;
  return {std::log(sum) + static_cast<double>(p) * std::log(kStep) + std::log(L.determinant()) -
              0.5 * verdict.best.sum_of_squares,
          mean, std::sqrt(second / sum - mean * mean)};
}

TEST(EvidenceOfAFit, OverTwoConstantsIsThatOfTheTripleIntegral) {
  const Dataset data = measured_runs(3, {{"modulus", 1e5}, {"toughness", 2.7e-3}});
  const FitOptions options = stated_errors();
  const PreparedFit prepared = prepare(data, model_named("c"), options, Objective::curve, nullptr);
  ASSERT_EQ(prepared.fitted.size(), 2U);
  const auto problem = make_problem(data, options, prepared);
  ASSERT_TRUE(problem->known_errors());
  const ProblemWithPriors cost(*problem);
  const Verdict verdict = solve(cost);
  ASSERT_EQ(verdict.status, FitStatus::ok) << verdict.message;
  const auto found = evidence(cost, verdict.best, verdict.standard_errors[0], {});
  ASSERT_TRUE(found);
  const Summed all = summed(cost, verdict);
  double log_evidence = all.log_integral;  // the range of lambda is 1
  for (const FreeParameter& one : cost.parameters())
    if (one.prior > 0) log_evidence -= std::log(one.prior * std::sqrt(2 * std::numbers::pi));
  // What Laplace's method leaves out: a fraction of the priors' relative errors squared.
  EXPECT_NEAR(found->log_evidence, log_evidence, 2e-3);
  EXPECT_NEAR(found->mean, all.mean, 2e-3 * all.standard_deviation);
  EXPECT_NEAR(found->standard_deviation, all.standard_deviation, 2e-3 * all.standard_deviation);
}

}  // namespace evidence_test
}  // namespace mixity
