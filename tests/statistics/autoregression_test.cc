#include "statistics/autoregression.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace mixity {
namespace autoregression_test {

/// Runs of n deviations whose weights turn from the first process to the second along each run.
TwoProcesses turning(std::size_t runs, std::size_t n) {
  TwoProcesses made;
  for (std::size_t r = 0; r < runs; ++r) {
    std::vector<std::size_t>& run = made.runs.emplace_back(n);
    std::iota(run.begin(), run.end(), r * n);
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = 0.5 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
      made.places.push_back(static_cast<double>(i));
      made.first.push_back(std::cos(angle));
      made.second.push_back(-std::sin(angle));
    }
  }
  return made;
}

Eigen::MatrixXd covariance(const TwoProcesses& of, const NeighbourCorrelations& rho) {
  const auto n = static_cast<Eigen::Index>(of.places.size());
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(n, n);
  for (const auto& run : of.runs)
    for (const std::size_t i : run)
      for (const std::size_t j : run) {
        const double apart = std::abs(of.places[i] - of.places[j]);
        all(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
            of.first[i] * of.first[j] * std::pow(rho.first, apart) +
            of.second[i] * of.second[j] * std::pow(rho.second, apart);
      }
  return all;
}

std::vector<double> drawn(const TwoProcesses& of, const NeighbourCorrelations& rho, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> values(of.places.size());
  for (const auto& run : of.runs) {
    double u = 0, v = 0;
    for (std::size_t k = 0; k < run.size(); ++k) {
      const auto next = [&](double before, double r) {
        return k == 0 ? normal(random) : r * before + std::sqrt(1 - r * r) * normal(random);
      };
      u = next(u, rho.first);
      v = next(v, rho.second);
      values[run[k]] = of.first[run[k]] * u + of.second[run[k]] * v;
    }
  }
  return values;
}

double one(double) { return 1; }

/// Against the factors and the determinant of the whole covariance matrix, with a gap in the places.
TEST(Decorrelation, IsTheCholeskyFactorOfTheCovariance) {
  TwoProcesses runs = turning(2, 12);
  for (std::size_t i = 5; i < 12; ++i) runs.places[i] += 3;
  const NeighbourCorrelations rho{0.8, 0.35};
  const Eigen::MatrixXd all = covariance(runs, rho);
  std::vector<double> values = drawn(runs, rho, 3);
  const Eigen::LLT<Eigen::MatrixXd> factors(all);
  const Eigen::VectorXd expected = factors.matrixL().solve(
      Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())));
  const Decorrelation decorrelation(runs, {rho});
  std::vector<double> rows(3 * values.size(), 7.0);  // the second column of three
  for (std::size_t i = 0; i < values.size(); ++i) rows[3 * i + 1] = values[i];
  decorrelation.apply(values);
  decorrelation.apply(std::span(rows).subspan(1), 3);
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_NEAR(values[i], expected(static_cast<Eigen::Index>(i)), 1e-12);  // 24 steps of rounding
    EXPECT_EQ(rows[3 * i + 1], values[i]);
    EXPECT_EQ(rows[3 * i], 7);
  }
  EXPECT_NEAR(decorrelation.log_determinant(), 2 * factors.matrixLLT().diagonal().array().log().sum(), 1e-12);
}

TEST(Decorrelation, OfUncorrelatedDeviationsChangesNothing) {
  const TwoProcesses runs = turning(1, 20);
  std::vector<double> values = drawn(runs, {}, 1);
  const std::vector<double> before = values;
  const Decorrelation decorrelation(runs, {{}});
  decorrelation.apply(values);
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i], before[i], 1e-15);
  EXPECT_NEAR(decorrelation.log_determinant(), 0, 1e-14);
}

/// What the deviations before tell of the combination across: by conditioning in the whole covariance matrix.
TEST(Decorrelation, KnowsHowMuchOfTheNoiseAcrossItPredicts) {
  const TwoProcesses runs = turning(1, 10);
  const NeighbourCorrelations rho{0.9, 0.6};
  const Decorrelation decorrelation(runs, {rho});
  const Eigen::MatrixXd all = covariance(runs, rho);
  for (std::size_t i = 1; i < 10; ++i) {
    const auto n = static_cast<Eigen::Index>(i);
    Eigen::VectorXd across(n);  // covariance of second u - first v at i with the deviations before
    for (std::size_t j = 0; j < i; ++j) {
      const double apart = static_cast<double>(i - j);
      across(static_cast<Eigen::Index>(j)) = runs.second[i] * runs.first[j] * std::pow(rho.first, apart) -
                                             runs.first[i] * runs.second[j] * std::pow(rho.second, apart);
    }
    const double predicted = across.dot(all.topLeftCorner(n, n).llt().solve(across));
    EXPECT_NEAR(decorrelation.predicted_across()[i], predicted, 1e-12) << i;
  }
  EXPECT_NEAR(decorrelation.predicted_across()[0], 0, 1e-15);
}

TEST(Correlations, AreFoundForEachProcess) {
  const TwoProcesses runs = turning(8, 200);
  for (const NeighbourCorrelations rho : {NeighbourCorrelations{0.6, 0}, {0, 0.9}, {0.9, 0.3}}) {
    double first = 0, second = 0;
    constexpr int kSamples = 12;
    for (unsigned seed = 0; seed < kSamples; ++seed) {
      const NeighbourCorrelations found = choose_correlations(runs, drawn(runs, rho, seed), one).correlations;
      first += found.first / kSamples;
      second += found.second / kSamples;
    }
    // half of 1,600 deviations for each: a standard error of sqrt(1/800/12) = 0.01 at most
    EXPECT_NEAR(first, rho.first, 0.04);
    EXPECT_NEAR(second, rho.second, 0.04);
  }
}

/// The first one is found last, with the second as it is then.
TEST(Correlations, AreTheMostLikelyToATenThousandth) {
  const TwoProcesses runs = turning(8, 200);
  for (const NeighbourCorrelations rho : {NeighbourCorrelations{0.6, 0}, {0.9, 0.3}, {0.3, 0.8}})
    for (unsigned seed = 0; seed < 4; ++seed) {
      const std::vector<double> deviations = drawn(runs, rho, seed);
      const NeighbourCorrelations found = choose_correlations(runs, deviations, one).correlations;
      const auto likelihood = [&](double first) {
        std::array<ScaledCorrelations, kTrials> trials;
        trials.fill({{first, found.second}});
        const Independent at = independent(runs, deviations, trials);
        return -(at.n[0] * std::log(at.squares[0] / at.n[0]) + at.log_determinant[0]) / 2;
      };
      ASSERT_GT(found.first, 0);
      for (const double off : {-2e-4, 2e-4})
        EXPECT_GT(likelihood(found.first), likelihood(found.first + off)) << rho.first << " " << seed;
    }
}

TEST(Correlations, AreNoneOfIndependentDeviations) {
  const TwoProcesses runs = turning(5, 40);
  int any = 0;
  for (unsigned seed = 0; seed < 100; ++seed)
    any += choose_correlations(runs, drawn(runs, {}, seed), one).correlations.any();
  EXPECT_LE(any, 6);  // ln 200 = 5.3 for one parameter more: two of 100 by chance for two correlations of one sign
}

/// Small correlations of many points: ln L is lower at 0.3 than at 0.
TEST(Correlations, AreFoundWhereTheyAreSmall) {
  const TwoProcesses made = turning(8, 200);
  int found = 0;
  for (unsigned seed = 1; seed <= 20; ++seed)
    found += choose_correlations(made, drawn(made, {0.12, 0.12}, seed), [](double) { return 1.0; }).correlations.any();
  EXPECT_GE(found, 18);  // 0.12 is 4.8 standard errors; the price in ln L is one of 2.7
}

/// One that both share must be worth its price itself, not only about as likely as one that is.
TEST(Correlations, AreSharedOnlyWhereThatIsBetterThanNone) {
  const TwoProcesses runs = turning(3, 30);
  int any = 0, alike = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    const std::vector<double> values = drawn(runs, {0.5, 0}, seed);
    const auto found = choose_correlations(runs, values, one);
    const auto& [first, second] = found.correlations;
    double squares = 0;
    for (const double v : values) squares += v * v;
    const auto n = static_cast<double>(values.size());
    const double without = -0.5 * n * std::log(squares / n);
    any += found.correlations.any();
    if (first != second || first == 0) continue;
    ++alike;
    EXPECT_GT(found.log_likelihood - 0.5 * std::log(n), without) << seed;
  }
  EXPECT_GT(any, 100);
  EXPECT_GT(alike, 30);
}

/// Where the second process hardly acts, rounding does not decide whether the correlation is shared.
TEST(Correlations, AreSharedWhereTheDataDoNotTell) {
  TwoProcesses runs = turning(3, 20);
  std::fill(runs.first.begin(), runs.first.end(), 1.0);
  for (double& weight : runs.second) weight *= 1e-3;
  int any = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const auto [first, second] = choose_correlations(runs, drawn(runs, {0.7, 0}, seed), one).correlations;
    any += first > 0;
    EXPECT_EQ(first, second) << seed;
  }
  EXPECT_GT(any, 40);
}

TEST(Correlations, AreImprovedWithTheFactorsOfTheWeights) {
  const TwoProcesses runs = turning(8, 200);
  const NeighbourCorrelations rho{0.8, 0.5};
  std::vector<double> values = drawn(runs, rho, 5);
  for (double& value : values) value *= 1.3;
  ScaledCorrelations found{rho};
  TwoProcesses scaled = runs;
  double first = 1, second = 1;
  for (int round = 0; round < 12; ++round) {
    found = improve(scaled, values, found.correlations, [](const ScaledCorrelations&) { return 0.0; });
    for (double& weight : scaled.first) weight *= found.first;
    for (double& weight : scaled.second) weight *= found.second;
    first *= found.first;
    second *= found.second;
  }
  EXPECT_NEAR(found.first, 1, 1e-3);  // nothing changes any more
  EXPECT_NEAR(found.second, 1, 1e-3);
  EXPECT_NEAR(first, 1.3, 0.15);  // two standard errors of some 90 independent squares each
  EXPECT_NEAR(second, 1.3, 0.15);
}

}  // namespace autoregression_test
}  // namespace mixity
