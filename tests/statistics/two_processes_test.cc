// The likelihood of correlated deviations, against that from their whole covariance matrix.
#include "statistics/two_processes.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numeric>
#include <random>

namespace mixity {
namespace two_processes_test {

constexpr std::size_t kRuns = 3, kReadings = 9;

struct Made {
  TwoProcesses processes;
  std::vector<double> deviations;
};

Made made(std::size_t own) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  Made all;
  double place = 0;
  for (std::size_t r = 0; r < kRuns; ++r) {
    std::vector<std::size_t>& run = all.processes.runs.emplace_back(kReadings);
    std::iota(run.begin(), run.end(), r * kReadings);
    for (std::size_t k = 0; k < kReadings; ++k) {
      place += k % 4 == 3 ? 2 : 1;  // with gaps
      all.processes.places.push_back(place);
      all.processes.first.push_back(normal(random));
      all.processes.second.push_back(normal(random));
      all.deviations.push_back(normal(random));
    }
  }
  for (std::size_t q = 0; q < own; ++q)
    for (auto& column = all.processes.own.emplace_back(); column.size() < kRuns * kReadings;)
      column.push_back(normal(random));
  return all;
}

std::array<ScaledCorrelations, kTrials> trials() {
  std::array<ScaledCorrelations, kTrials> list;
  for (std::size_t t = 0; t < kTrials; ++t) {
    const double part = static_cast<double>(t) / kTrials;
    list[t] = {{0.95 * part, 0.9 - 0.8 * part}, 1 + part, 1.5 - part};
  }
  return list;
}

Eigen::MatrixXd covariance(const TwoProcesses& of, const std::vector<std::size_t>& run, const ScaledCorrelations& at) {
  const auto n = static_cast<Eigen::Index>(run.size());
  return Eigen::MatrixXd::NullaryExpr(n, n, [&](Eigen::Index i, Eigen::Index j) {
    const std::size_t a = run[static_cast<std::size_t>(i)], b = run[static_cast<std::size_t>(j)];
    const double apart = std::abs(of.places[a] - of.places[b]);
    return at.first * at.first * of.first[a] * of.first[b] * std::pow(at.correlations.first, apart) +
           at.second * at.second * of.second[a] * of.second[b] * std::pow(at.correlations.second, apart);
  });
}

TEST(Independent, IsWhatTheCovarianceMatrixGives) {
  for (const std::size_t own : {0u, 1u, 2u}) {
    const Made all = made(own);
    const auto at = trials();
    const Independent found = independent(all.processes, all.deviations, at);
    for (std::size_t t = 0; t < kTrials; ++t) {
      double squares = 0, log_determinant = 0;
      for (const auto& run : all.processes.runs) {
        const Eigen::LLT<Eigen::MatrixXd> V(covariance(all.processes, run, at[t]));
        const auto n = static_cast<Eigen::Index>(run.size());
        Eigen::VectorXd y(n);
        Eigen::MatrixXd C(n, static_cast<Eigen::Index>(own));
        for (Eigen::Index i = 0; i < n; ++i) {
          y[i] = all.deviations[run[static_cast<std::size_t>(i)]];
          for (std::size_t q = 0; q < own; ++q)
            C(i, static_cast<Eigen::Index>(q)) = all.processes.own[q][run[static_cast<std::size_t>(i)]];
        }
        const Eigen::VectorXd w = V.matrixL().solve(y);
        const Eigen::MatrixXd W = V.matrixL().solve(C);
        squares += w.squaredNorm();
        for (Eigen::Index i = 0; i < n; ++i) log_determinant += 2 * std::log(Eigen::MatrixXd(V.matrixL())(i, i));
        if (own == 0) continue;
        const Eigen::LLT<Eigen::MatrixXd> of_own(W.transpose() * W);
        squares -= Eigen::VectorXd(of_own.matrixL().solve(W.transpose() * w)).squaredNorm();
        log_determinant += std::log((W.transpose() * W).determinant());
      }
      // the rounding of both ways, for weights close to 0
      EXPECT_NEAR(found.squares[t], squares, 1e-9 * squares) << own << " " << t;
      EXPECT_NEAR(found.log_determinant[t], log_determinant, 1e-9 * (1 + std::abs(log_determinant))) << own << " " << t;
      EXPECT_EQ(found.n[t], static_cast<double>(kRuns * (kReadings - own)));
    }
  }
}

TEST(Independent, AColumnThatRepeatsAnotherTakesNothingOff) {
  Made all = made(1);
  const Independent one = independent(all.processes, all.deviations, trials());
  all.processes.own.push_back(all.processes.own.front());
  for (double& value : all.processes.own.back()) value *= 3;
  const Independent both = independent(all.processes, all.deviations, trials());
  EXPECT_EQ(both.squares, one.squares);
  EXPECT_EQ(both.log_determinant, one.log_determinant);
  EXPECT_EQ(both.n, one.n);
}

/// The product of so small variances is 0 in a double.
TEST(Independent, OfManySmallDeviationsIsFinite) {
  constexpr std::size_t kMany = 300;
  constexpr double kSmall = 1e-12;
  TwoProcesses processes{{std::vector<std::size_t>(kMany)}, {}, {}, std::vector<double>(kMany)};
  std::iota(processes.runs[0].begin(), processes.runs[0].end(), std::size_t{0});
  for (std::size_t i = 0; i < kMany; ++i) {
    processes.places.push_back(static_cast<double>(i));
    processes.first.push_back(kSmall);
  }
  const Independent found = independent(processes, std::vector<double>(kMany, kSmall), {});
  EXPECT_NEAR(found.squares[0], kMany, 1e-9 * kMany);  // rounding
  EXPECT_NEAR(found.log_determinant[0], 2 * kMany * std::log(kSmall), 1e-9 * kMany);
}

}  // namespace two_processes_test
}  // namespace mixity
