// Effects of groups against dense linear algebra of all rows at once.
#include "solver/random_effects.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numeric>
#include <random>

namespace mixity {
namespace random_effects_test {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// r = J t + Z_g b_g + e, with two parameters and k effects.
struct Experiment {
  Matrix J, Z;
  Vector r;
  Groups groups;

  Experiment(unsigned seed, const Vector& spread, std::size_t count = 8, std::size_t size = 15) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    const auto n = static_cast<Eigen::Index>(count * size);
    J.resize(n, 2);
    Z.resize(n, spread.size());
    r.resize(n);
    for (std::size_t g = 0; g < count; ++g) {
      std::vector<std::size_t>& rows = groups.emplace_back(size);
      std::iota(rows.begin(), rows.end(), g * size);
      Vector b(spread.size());
      for (Eigen::Index q = 0; q < b.size(); ++q) b[q] = spread[q] * normal(random);
      for (const std::size_t row : rows) {
        const auto i = static_cast<Eigen::Index>(row);
        const double t = static_cast<double>(row % size) / static_cast<double>(size);
        J.row(i) << t, 1 + 0.1 * static_cast<double>(g);
        for (Eigen::Index q = 0; q < b.size(); ++q) Z(i, q) = q == 0 ? 2 + t : t * t;
        r[i] = 0.3 * t - 0.2 + Z.row(i).dot(b) + normal(random);
      }
    }
  }

  GroupedRows rows() const { return grouped_rows(J, r, Z, groups); }

  Matrix covariance(const Vector& spread) const {
    Matrix V = Matrix::Identity(r.size(), r.size());
    for (const auto& group : groups)
      for (const std::size_t i : group)
        for (const std::size_t j : group)
          for (Eigen::Index q = 0; q < spread.size(); ++q)
            V(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) +=
                spread[q] * spread[q] * Z(static_cast<Eigen::Index>(i), q) * Z(static_cast<Eigen::Index>(j), q);
    return V;
  }

  double restricted_likelihood(const Vector& spread) const {
    const Eigen::LLT<Matrix> V(covariance(spread));
    const Matrix H = J.transpose() * V.solve(J);
    const Vector left = r - J * H.llt().solve(J.transpose() * V.solve(r));
    const double of_V = 2 * Matrix(V.matrixL()).diagonal().array().log().sum();
    return -(of_V + std::log(H.determinant()) + left.dot(V.solve(left))) / 2;
  }
};

TEST(RandomEffects, HaveTheSpreadsOfGreatestRestrictedLikelihood) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Experiment made(seed, Vector{{0.6, 1.5}});
    const auto found = restricted_spreads(made.rows());
    ASSERT_TRUE(found);
    const double most = made.restricted_likelihood(found->spread);
    for (Eigen::Index q = 0; q < 2; ++q)
      for (const double factor : {0.98, 1.02}) {
        Vector beside = found->spread;
        beside[q] *= factor;
        EXPECT_GE(most, made.restricted_likelihood(beside)) << seed << ' ' << q;
      }
  }
}

TEST(RandomEffects, HaveNoSpreadWhereGroupsAreAlike) {
  int none = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const auto found = restricted_spreads(Experiment(seed, Vector{{0.0}}).rows());
    none += found->spread[0] == 0;
  }
  EXPECT_GE(none, 12);  // half of them; fewer than 12 of 40 have a probability of 0.4 %
}

TEST(RandomEffects, HaveTheFreedomOfTheirGroupsWhereTheseDecide) {
  const Experiment made(3, Vector{{5.0}}, 12);
  // The second parameter acts as the effect does; made the first, its variance is that of twelve groups' values.
  Matrix swapped(made.J.rows(), 2);
  swapped << made.Z.col(0), made.J.col(0);
  const auto found = restricted_spreads(grouped_rows(swapped, made.r, made.Z, made.groups));
  EXPECT_NEAR(found->freedom, 11, 0.5);
}

TEST(RandomEffects, AreWhitened) {
  const Experiment made(2, Vector{{0.7, 1.2}});
  const Vector spread{{0.7, 1.2}};
  const GroupWhitening whitening(made.Z, spread, made.groups);
  const Matrix V = made.covariance(spread);
  Matrix W = Matrix::Identity(V.rows(), V.cols());
  for (Eigen::Index k = 0; k < W.cols(); ++k) whitening.apply({W.col(k).data(), static_cast<std::size_t>(W.rows())});
  // 120 rows, rounding of a matrix with elements up to 10
  EXPECT_LT((W * V * W.transpose() - Matrix::Identity(V.rows(), V.cols())).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_NEAR(whitening.log_determinant(), std::log(V.determinant()), 1e-10);
}

/// One and two effects have formulas of their own.
TEST(RandomEffects, WithoutSpreadAreAsIfTheyWereNotThere) {
  const Experiment three(4, Vector{{0.7, 0.4, 0.2}});
  for (const Eigen::Index kept : {1, 2}) {
    const Vector some = Vector{{0.6, 0.5}}.head(kept);
    Vector all = Vector::Zero(3);
    all.head(kept) = some;
    const auto with = most_probable(three.rows(), all),
               without = most_probable(grouped_rows(three.J, three.r, three.Z.leftCols(kept), three.groups), some);
    ASSERT_TRUE(with && without);
    EXPECT_LT((with->step - without->step).norm(), 1e-12);  // of sums of some hundred numbers of size 1
    for (std::size_t g = 0; g < three.groups.size(); ++g)
      EXPECT_LT((with->deviations[g].head(kept) - without->deviations[g]).norm(), 1e-12);
  }
}

TEST(RandomEffects, LeaveSharesOfNoiseAsTheDenseProjectionDoes) {
  const Experiment made(4, Vector{{0.5, 1.0}});
  const Vector spread{{0.5, 1.0}};
  const Matrix inverse = made.covariance(spread).inverse();
  const Matrix P =
      inverse - inverse * made.J * (made.J.transpose() * inverse * made.J).inverse() * made.J.transpose() * inverse;
  EXPECT_LT((shares_of_noise(made.J, made.Z, made.groups, spread) - P.diagonal()).cwiseAbs().maxCoeff(), 1e-12);
}

/// Each group's own deviation as further columns of the matrix.
TEST(RandomEffects, AreTestedAsFurtherColumnsAre) {
  const Experiment made(6, Vector{{0.4}});
  const auto n = static_cast<Eigen::Index>(made.groups.size());
  Matrix wide = Matrix::Zero(made.J.rows(), 2 + n);
  wide.leftCols(2) = made.J;
  std::vector<double> course;
  Vector along = Vector::Zero(made.J.rows());
  for (Eigen::Index g = 0; g < n; ++g) {
    course.push_back(static_cast<double>(g) / 7 - 0.5);
    for (const std::size_t row : made.groups[static_cast<std::size_t>(g)]) {
      const auto i = static_cast<Eigen::Index>(row);
      wide(i, 2 + g) = made.Z(i, 0);
      along[i] = made.Z(i, 0) * course.back();
    }
  }
  const auto squares = [&](const Matrix& J) {
    return (made.r - J * J.colPivHouseholderQr().solve(made.r)).squaredNorm();
  };
  const auto with = [&](const Vector& column) {
    Matrix J(made.J.rows(), 3);
    J << made.J, column;
    return J;
  };
  const auto test = test_groups(made.rows(), course);
  ASSERT_TRUE(test);
  const double alone = squares(made.J);
  EXPECT_NEAR(test->fall, alone - squares(wide), 1e-9 * alone);
  EXPECT_EQ(test->directions, 8);
  EXPECT_NEAR(test->groups[2].fall, alone - squares(with(wide.col(4))), 1e-9 * alone);
  EXPECT_NEAR(test->along.fall, alone - squares(with(along)), 1e-9 * alone);
  const Matrix J = with(along);
  EXPECT_NEAR(test->along.value, -(J.colPivHouseholderQr().solve(made.r))[2], 1e-9);
}

TEST(RandomEffects, AreTestedOneByOne) {
  const Experiment made(6, Vector{{0.4, 0.9}});
  const std::vector<double> course{-0.5, -0.3, -0.2, -0.1, 0.1, 0.2, 0.3, 0.5};
  const auto one = test_groups(grouped_rows(made.J, made.r, made.Z.col(1), made.groups), course),
             of_both = test_groups(made.rows(), course, 1);
  ASSERT_TRUE(one && of_both);
  constexpr double kRounding = 1e-12;  // sums of 120 rows in another order
  EXPECT_NEAR(of_both->fall, one->fall, kRounding * one->fall);
  EXPECT_NEAR(of_both->along.fall, one->along.fall, kRounding * one->fall);
  EXPECT_NEAR(of_both->groups[3].value, one->groups[3].value, kRounding * one->fall);
  EXPECT_NEAR(of_both->spread, one->spread, kRounding * one->fall);
  EXPECT_NEAR(of_both->change, one->change, kRounding * one->fall);
  EXPECT_NEAR(of_both->widening, one->widening, kRounding * one->fall);
}

/// A deviation of all groups together is then one of the parameter.
TEST(RandomEffects, OfAParameterAreTestedInOneDirectionLess) {
  Experiment made(7, Vector{{0.4}});
  made.J.col(0) = made.Z.col(0);
  const auto test = test_groups(made.rows(), std::vector<double>(8, 1.0));
  ASSERT_TRUE(test);
  EXPECT_EQ(test->directions, 7);
  Matrix wide = Matrix::Zero(made.J.rows(), 10);
  wide.leftCols(2) = made.J;
  for (Eigen::Index g = 0; g < 8; ++g)
    for (const std::size_t row : made.groups[static_cast<std::size_t>(g)])
      wide(static_cast<Eigen::Index>(row), 2 + g) = made.Z(static_cast<Eigen::Index>(row), 0);
  const auto squares = [&](const Matrix& J) {
    return (made.r - J * J.colPivHouseholderQr().solve(made.r)).squaredNorm();
  };
  EXPECT_NEAR(test->fall, squares(made.J) - squares(wide), 1e-9 * squares(made.J));
  EXPECT_EQ(test->along.fall, 0);
}

TEST(RandomEffects, HaveAJackknifeThatLeavesOutEachGroup) {
  const Experiment made(9, Vector{{0.3}});
  const auto fit = [&](const Matrix& J, const Vector& r) { return J.colPivHouseholderQr().solve(r)[0]; };
  const Vector at = made.J.colPivHouseholderQr().solve(made.r);
  double sum = 0, squares = 0;
  for (const auto& group : made.groups) {
    Matrix J = made.J;
    Vector r = made.r;
    for (const std::size_t row : group) {
      J.row(static_cast<Eigen::Index>(row)).setZero();
      r[static_cast<Eigen::Index>(row)] = 0;
    }
    const double value = fit(J, r);
    sum += value / 8;
    squares += value * value;
  }
  const auto error = jackknife_error(made.J, made.r - made.J * at, made.groups);
  EXPECT_NEAR(*error, std::sqrt(7.0 / 8 * (squares - 8 * sum * sum)), 1e-10);
}

}  // namespace random_effects_test
}  // namespace mixity
