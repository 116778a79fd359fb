// Random effects of groups in a linear model with noise of variance 1: the residuals of group g are J t + Z_g b_g + e,
// where b_g is normal with a standard deviation, its spread, for each effect.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "solver/linear_algebra.h"

namespace mixity {

/// Indices of the rows of each group.
using Groups = std::vector<std::vector<std::size_t>>;

/// Sums over the rows of one group and over all rows, with k effects and p parameters.
struct GroupedRows {
  struct Group {
    Eigen::MatrixXd Z_Z;  // [k x k]
    Eigen::MatrixXd J_Z;  // [p x k]
    Eigen::VectorXd Z_r;  // [k]
  };
  Eigen::MatrixXd J_J;  // [p x p], with the priors
  Eigen::VectorXd J_r;  // [p], with the priors
  double r_r = 0;
  std::vector<Group> groups;
};

/// J and r: rows of the data, then of the priors. Z: [data x k].
GroupedRows grouped_rows(const Eigen::MatrixXd& J, const Eigen::VectorXd& r, const Eigen::MatrixXd& Z,
                         const Groups& groups);

/// Spreads of maximum restricted likelihood (Pinheiro & Bates 2000, Mixed-Effects Models in S and S-PLUS, 2.2).
struct Spreads {
  Eigen::VectorXd spread;  // [k], >= 0, to the relative `tolerance`
  double freedom;          // of the variance of the first parameter (Satterthwaite 1946)
};
/// Null if the parameters are not determined.
std::optional<Spreads> restricted_spreads(const GroupedRows& rows, double tolerance = 1e-9);
/// The most probable step of the parameters and deviations of the groups for these spreads.
struct MostProbable {
  Eigen::VectorXd step;                     // [p]
  double length;                            // of the step, in standard errors
  std::vector<Eigen::VectorXd> deviations;  // per group: [k]
};
/// Null if the parameters are not determined.
std::optional<MostProbable> most_probable(const GroupedRows& rows, const Eigen::VectorXd& spread);

/// 1 - leverage of each row of the data: the part of its variance that remains after fitting J t and Z_g b_g, both at
/// their most probable values. The noise is estimated with it.
Eigen::VectorXd shares_of_noise(const Eigen::MatrixXd& J, const Eigen::MatrixXd& Z, const Groups& groups,
                                const Eigen::VectorXd& spread);

/// Test whether one effect differs between the groups.
struct GroupTest {
  struct One {
    double fall = 0, value = 0;       // fall of the sum of squares with that deviation free; the deviation
    double change = 0, widening = 1;  // change of the first parameter in standard errors; factor on that error
  };
  double fall = 0, directions = 0;  // with every group's deviation free; number of these independent of the parameters
  std::vector<One> groups;          // one group's deviation free
  One along{};                      // all groups' deviations in proportion to `course`
  double spread = 0;                // by moments (DerSimonian & Laird 1986)
  double change = 0, widening = 1;  // as above, for deviations with that spread
};
/// Of this effect alone; `course`: one number per group. Null if the parameters are not determined.
std::optional<GroupTest> test_groups(const GroupedRows& rows, std::span<const double> course, Eigen::Index effect = 0);

/// Jackknife standard error of the first parameter, leaving out each group in turn, to first order (Tukey 1958); null
/// for fewer than two groups, or where the rest does not determine the parameter.
std::optional<double> jackknife_error(const Eigen::MatrixXd& J, const Eigen::VectorXd& r, const Groups& groups);

/// Decorrelates rows whose noise is e + Z_g b_g.
class GroupWhitening {
 public:
  GroupWhitening(Eigen::MatrixXd Z, const Eigen::VectorXd& spread, const Groups& groups);
  /// Works in place; `stride`: distance between rows.
  void apply(std::span<double> values, std::size_t stride = 1) const;
  double log_determinant() const { return log_determinant_; }

 private:
  struct Direction {
    Eigen::VectorXd z;  // of unit length
    double factor;      // the component along z is multiplied by 1 + factor
    std::size_t group;
  };
  Groups groups_;
  std::vector<Direction> directions_;
  double log_determinant_ = 0;
};

}  // namespace mixity
