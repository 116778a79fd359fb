#include "solver/random_effects.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

namespace mixity {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// K = D (1 + D Z'Z D)^-1 D for D = diag(spread), and ln of the determinant of what is inverted. One or two effects are
/// by far the most frequent, and are evaluated thousands of times.
double inner_inverse(const Matrix& Z_Z, const Vector& spread, Eigen::Map<Matrix> K) {
  if (spread.size() == 1) {
    const double square = spread[0] * spread[0], inner = 1 + square * Z_Z(0, 0);
    K(0, 0) = square / inner;
    return std::log(inner);
  }
  if (spread.size() == 2) {
    const double across = spread[0] * spread[1], a = 1 + spread[0] * spread[0] * Z_Z(0, 0), b = across * Z_Z(0, 1),
                 c = 1 + spread[1] * spread[1] * Z_Z(1, 1), left = c - b / a * b;
    K(0, 0) = spread[0] * spread[0] * (1 + b / a * (b / left)) / a;
    K(0, 1) = K(1, 0) = -across * (b / a) / left;
    K(1, 1) = spread[1] * spread[1] / left;
    return left > 0 ? std::log(a) + std::log(left) : std::numeric_limits<double>::infinity();
  }
  const auto D = spread.asDiagonal();
  const Matrix inner = Matrix::Identity(spread.size(), spread.size()) + D * Z_Z * D;
  K = D * solve_columns(inner, Matrix(D));
  return log_determinant(inner).value_or(std::numeric_limits<double>::infinity());
}

/// The restricted likelihood and derived quantities at given spreads. Within a group V^-1 = 1 - Z K Z'.
struct Restricted {
  Restricted(const GroupedRows& rows, const Vector& spread)
      : H(rows.J_J), g(rows.J_r), effects(spread.size()), inverses(rows.groups.size() * square_of(effects)) {
    double squares = rows.r_r;
    const Eigen::Index p = g.size();
    for (std::size_t i = 0; i < rows.groups.size(); ++i) {
      const auto& group = rows.groups[i];
      determinant += inner_inverse(group.Z_Z, spread, {inverses.data() + i * square_of(effects), effects, effects});
      const auto of_group = K(i);
      for (Eigen::Index q = 0; q < effects; ++q)
        for (Eigen::Index s = 0; s < effects; ++s) {
          const double k = of_group(q, s);
          squares -= k * group.Z_r[q] * group.Z_r[s];
          for (Eigen::Index a = 0; a < p; ++a) {
            const double slope = k * group.J_Z(a, q);
            g[a] -= slope * group.Z_r[s];
            for (Eigen::Index b = 0; b < p; ++b) H(a, b) -= slope * group.J_Z(b, s);
          }
        }
    }
    const auto of_H = log_determinant(H);
    determined = of_H.has_value();
    if (!determined) return;
    step = -solve_symmetric(H, g);
    log_likelihood = -(determinant + *of_H + squares + g.dot(step)) / 2;
  }

  static std::size_t square_of(Eigen::Index n) { return static_cast<std::size_t>(n * n); }
  Eigen::Map<const Matrix> K(std::size_t group) const {
    return {inverses.data() + group * square_of(effects), effects, effects};
  }

  /// 2 d(ln L)/d(spread^2) for effect q.
  double score(const GroupedRows& rows, Eigen::Index q) const {
    double sum = 0;
    Matrix J_z(g.size(), static_cast<Eigen::Index>(rows.groups.size()));
    Vector left(effects);  // of the effects after V^-1
    for (std::size_t i = 0; i < rows.groups.size(); ++i) {
      const auto& group = rows.groups[i];
      const auto column = static_cast<Eigen::Index>(i);
      left.noalias() = -(K(i) * group.Z_Z.col(q));
      left[q] += 1;
      J_z.col(column).noalias() = group.J_Z * left;
      const double z_r = left.dot(group.Z_r) + J_z.col(column).dot(step);
      sum += z_r * z_r - group.Z_Z.col(q).dot(left);
    }
    return sum + J_z.cwiseProduct(solve_columns(H, J_z)).sum();
  }

  Matrix H;
  Vector g, step;
  Eigen::Index effects;
  std::vector<double> inverses;  // K of each group
  double determinant = 0, log_likelihood = -std::numeric_limits<double>::infinity();
  bool determined = false;
};

/// The most likely spread of effect q, the others being as in `spread`: the local maximum near its value in `spread`,
/// unless that is 0.
double best_spread(const GroupedRows& rows, Vector spread, Eigen::Index q, double tolerance) {
  constexpr double kStep = 1;      // of ln(spread), to bracket the maximum
  constexpr double kLeast = 1e-4;  // of the spread that one group determines: less makes no difference
  constexpr double kMost = 1e4;
  double information = 0;
  for (const auto& group : rows.groups) information = std::max(information, group.Z_Z(q, q));
  if (!(information > 0)) return 0;
  const double unit = 1 / std::sqrt(information);
  const auto at = [&](double size) {
    spread[q] = size;
    return Restricted(rows, spread);
  };
  const auto slope = [&](double size) { return at(size).score(rows, q); };
  const auto rises_and_falls = [&](double size) {
    return slope(size * std::exp(-kStep)) > 0 && slope(size * std::exp(kStep)) < 0;
  };
  double best = spread[q];
  if (best == 0 || !rises_and_falls(best)) {
    best = 0;
    double most = at(0).log_likelihood;
    for (double x = std::log(kLeast); x <= std::log(kMost); x += kStep)
      if (const double value = at(unit * std::exp(x)).log_likelihood; value > most) {
        most = value;
        best = unit * std::exp(x);
      }
    if (best == 0 || !rises_and_falls(best)) return best;
  }
  std::uintmax_t calls = 200;
  const auto found = boost::math::tools::toms748_solve(
      slope, best * std::exp(-kStep), best * std::exp(kStep),
      [&](double low, double high) { return high - low <= tolerance * high; }, calls);
  return 0.5 * (found.first + found.second);
}

/// Of the first parameter's variance v(spread^2): 2 v^2 over the variance of v that the uncertain spreads give.
double satterthwaite(const GroupedRows& rows, const Vector& spread, const Restricted& at) {
  constexpr double kStep = 1e-3;
  const auto variance = [&](const Restricted& one) { return solve_symmetric(one.H, Vector::Unit(one.H.rows(), 0))[0]; };
  const double v = variance(at);
  double of_v = 0;
  for (Eigen::Index q = 0; q < spread.size(); ++q) {
    if (!(spread[q] > 0)) continue;
    Vector more = spread, less = spread;
    more[q] *= std::sqrt(1 + kStep);
    less[q] *= std::sqrt(1 - kStep);
    const Restricted above(rows, more), below(rows, less);
    const double width = 2 * kStep;  // of spread^2, relative
    const double slope = (variance(above) - variance(below)) / width,
                 curvature = (above.score(rows, q) - below.score(rows, q)) / width * spread[q] * spread[q] / 2;
    if (curvature < 0) of_v += slope * slope / -curvature;
  }
  return of_v > 0 ? 2 * v * v / of_v : std::numeric_limits<double>::infinity();
}

/// The same rows with this effect alone.
GroupedRows with_one_effect(const GroupedRows& rows, Eigen::Index effect) {
  GroupedRows one{rows.J_J, rows.J_r, rows.r_r, {}};
  for (const GroupedRows::Group& group : rows.groups)
    one.groups.push_back({group.Z_Z.block(effect, effect, 1, 1), group.J_Z.col(effect), group.Z_r.segment(effect, 1)});
  return one;
}

}  // namespace

GroupedRows grouped_rows(const Matrix& J, const Vector& r, const Matrix& Z, const Groups& groups) {
  GroupedRows rows{J.transpose() * J, J.transpose() * r, r.squaredNorm(), {}};
  const Eigen::Index p = J.cols(), k = Z.cols();
  Matrix all;  // of a group: of J, Z and r
  for (const auto& group : groups) {
    const auto n = static_cast<Eigen::Index>(group.size());
    all.resize(n, p + k + 1);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto row = static_cast<Eigen::Index>(group[static_cast<std::size_t>(i)]);
      for (Eigen::Index c = 0; c < p; ++c) all(i, c) = J(row, c);
      for (Eigen::Index c = 0; c < k; ++c) all(i, p + c) = Z(row, c);
      all(i, p + k) = r[row];
    }
    const Matrix sums = all.middleCols(p, k).transpose().lazyProduct(all);  // lazily: the matrices are small
    rows.groups.push_back({sums.middleCols(p, k), sums.leftCols(p).transpose(), sums.col(p + k)});
  }
  return rows;
}

std::optional<Spreads> restricted_spreads(const GroupedRows& rows, double tolerance) {
  constexpr int kRounds = 50;
  const Eigen::Index k = rows.groups.empty() ? 0 : rows.groups[0].Z_r.size();
  Vector spread = Vector::Zero(k);
  if (!Restricted(rows, spread).determined) return std::nullopt;
  for (int round = 0; round < kRounds; ++round) {
    double change = 0;
    for (Eigen::Index q = 0; q < k; ++q) {
      const double before = spread[q];
      spread[q] = best_spread(rows, spread, q, 1e-2 * tolerance);
      change = std::max(change, std::abs(spread[q] - before) / std::max(spread[q], 1e-300));
    }
    if (k == 1 || change <= tolerance) break;
  }
  return Spreads{spread, satterthwaite(rows, spread, Restricted(rows, spread))};
}

std::optional<MostProbable> most_probable(const GroupedRows& rows, const Vector& spread) {
  const Restricted at(rows, spread);
  if (!at.determined) return std::nullopt;
  MostProbable found{at.step, std::sqrt(std::max(-at.g.dot(at.step), 0.0)), {}};
  for (std::size_t i = 0; i < rows.groups.size(); ++i)
    found.deviations.push_back(-at.K(i) * (rows.groups[i].Z_r + rows.groups[i].J_Z.transpose() * at.step));
  return found;
}

Vector shares_of_noise(const Matrix& J, const Matrix& Z, const Groups& groups, const Vector& spread) {
  Matrix left = J;  // V^-1 J
  Vector shares = Vector::Ones(Z.rows());
  for (const auto& group : groups) {
    const Matrix Z_g = Z(group, Eigen::all);
    const auto D = spread.asDiagonal();
    const Matrix inner = Matrix::Identity(spread.size(), spread.size()) + D * Z_g.transpose() * Z_g * D;
    const Matrix Z_K = Z_g * (D * solve_columns(inner, Matrix(D)));
    left(group, Eigen::all) -= Z_K * (Z_g.transpose() * J(group, Eigen::all));
    for (std::size_t i = 0; i < group.size(); ++i)
      shares[static_cast<Eigen::Index>(group[i])] -=
          Z_K.row(static_cast<Eigen::Index>(i)).dot(Z_g.row(static_cast<Eigen::Index>(i)));
  }
  const Matrix H = J.transpose() * left, solved = solve_columns(H, left.topRows(Z.rows()).transpose());
  for (Eigen::Index i = 0; i < shares.size(); ++i) shares[i] -= left.row(i).dot(solved.col(i));
  return shares;
}

std::optional<GroupTest> test_groups(const GroupedRows& rows, std::span<const double> course, Eigen::Index effect) {
  constexpr double kNone = 1e-9;  // of the largest effect: a direction that the parameters already have
  const auto n = static_cast<Eigen::Index>(rows.groups.size());
  if (!log_determinant(rows.J_J)) return std::nullopt;
  Matrix C(rows.J_J.rows(), n);
  Vector d(n), u(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto& group = rows.groups[static_cast<std::size_t>(i)];
    C.col(i) = group.J_Z.col(effect);
    d[i] = group.Z_Z(effect, effect);
    u[i] = group.Z_r[effect];
  }
  const Matrix S = Matrix(d.asDiagonal()) - C.transpose() * solve_columns(rows.J_J, C);
  u -= C.transpose() * solve_symmetric(rows.J_J, rows.J_r);
  GroupTest test;
  const double error = std::sqrt(solve_symmetric(rows.J_J, Vector::Unit(rows.J_J.rows(), 0))[0]);
  const auto one = [&](const Vector& c) {
    const double slope = c.dot(u), square = c.dot(S * c), scale = c.dot(d.asDiagonal() * c);
    if (!(square > kNone * scale)) return GroupTest::One{};
    const double value = -slope / square, moved = solve_symmetric(rows.J_J, C * c)[0] / error;
    return GroupTest::One{slope * slope / square, value, -moved * value, std::sqrt(1 + moved * moved / square)};
  };
  for (Eigen::Index i = 0; i < n; ++i) test.groups.push_back(one(Vector::Unit(n, i)));
  test.along = one(as_vector(course));
  const SquareAlong all = square_along(S, u, kNone * d.maxCoeff());
  test.fall = all.square;
  test.directions = all.directions;
  if (test.directions > 0) test.spread = std::sqrt(std::max(test.fall - test.directions, 0.0) / S.trace());
  if (!(test.spread > 0)) return test;
  const GroupedRows alone = with_one_effect(rows, effect);
  const Restricted without(alone, Vector::Zero(1)), with(alone, Vector::Constant(1, test.spread));
  if (!with.determined) return test;
  const double variance = solve_symmetric(with.H, Vector::Unit(with.H.rows(), 0))[0];
  test.change = (with.step[0] - without.step[0]) / error;
  test.widening = std::sqrt(std::max(variance, 0.0)) / error;
  return test;
}

std::optional<double> jackknife_error(const Matrix& J, const Vector& r, const Groups& groups) {
  if (groups.size() < 2) return std::nullopt;
  const Matrix H = J.transpose() * J;
  const Vector g = J.transpose() * r;
  double sum = 0, squares = 0;
  const auto n = static_cast<double>(groups.size());
  for (const auto& group : groups) {
    const Matrix of_group = J(group, Eigen::all), rest = H - of_group.transpose() * of_group;
    if (!log_determinant(rest)) return std::nullopt;
    const double change = solve_symmetric(rest, of_group.transpose() * r(group) - g)[0];
    sum += change;
    squares += change * change;
  }
  return std::sqrt((n - 1) / n * std::max(squares - sum * sum / n, 0.0));
}

GroupWhitening::GroupWhitening(Matrix Z, const Vector& spread, const Groups& groups) : groups_(groups) {
  for (std::size_t g = 0; g < groups.size(); ++g) {
    Matrix left = Z(groups[g], Eigen::all) * spread.asDiagonal();
    // One effect after the other: (1 + z z')^-1/2 changes the columns of the following ones.
    for (Eigen::Index q = 0; q < left.cols(); ++q) {
      const double square = left.col(q).squaredNorm();
      if (!(square > 0)) continue;
      const Direction direction{left.col(q) / std::sqrt(square), 1 / std::sqrt(1 + square) - 1, g};
      left += direction.factor * direction.z * (direction.z.transpose() * left);
      directions_.push_back(direction);
      log_determinant_ += std::log1p(square);
    }
  }
}

void GroupWhitening::apply(std::span<double> values, std::size_t stride) const {
  for (const Direction& direction : directions_) {
    const auto& rows = groups_[direction.group];
    double along = 0;
    for (std::size_t i = 0; i < rows.size(); ++i)
      along += direction.z[static_cast<Eigen::Index>(i)] * values[rows[i] * stride];
    along *= direction.factor;
    for (std::size_t i = 0; i < rows.size(); ++i)
      values[rows[i] * stride] += along * direction.z[static_cast<Eigen::Index>(i)];
  }
}

}  // namespace mixity
