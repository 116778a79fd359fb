#include "statistics/variance_components.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace mixity {
namespace {

constexpr std::size_t kMost = Deviations::kMostComponents;
using Vector = std::array<double, kMost>;
using Matrix = std::array<Vector, kMost>;

/// Solves N x = b restricted to the components in `open`, by Cholesky; false unless N is positive definite there.
bool solve(const Matrix& N, const Vector& b, std::uint32_t open, Vector& x) {
  std::array<std::size_t, kMost> at{};
  std::size_t n = 0;
  for (std::size_t k = 0; k < kMost; ++k)
    if (open >> k & 1) at[n++] = k;
  Matrix L{};
  Vector y{};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = N[at[i]][at[j]];
      for (std::size_t k = 0; k < j; ++k) sum -= L[i][k] * L[j][k];
      if (i == j && !(sum > 1e-12 * N[at[i]][at[i]])) return false;
      L[i][j] = i == j ? std::sqrt(sum) : sum / L[j][j];
    }
    y[i] = b[at[i]];
    for (std::size_t k = 0; k < i; ++k) y[i] -= L[i][k] * y[k];
    y[i] /= L[i][i];
  }
  x = {};
  for (std::size_t i = n; i-- > 0;) {
    double sum = y[i];
    for (std::size_t k = i + 1; k < n; ++k) sum -= L[k][i] * x[at[k]];
    x[at[i]] = sum / L[i][i];
  }
  return true;
}

/// theta >= 0 that minimises theta'N theta/2 - b'theta: the best over all choices of positive components.
std::optional<Vector> non_negative(const Matrix& N, const Vector& b, std::uint32_t allowed) {
  std::optional<Vector> best;
  double most = -1;
  for (std::uint32_t open = allowed;; open = (open - 1) & allowed) {
    Vector x;
    if (solve(N, b, open, x) && std::all_of(x.begin(), x.end(), [](double one) { return one >= 0; }))
      if (const double gain = std::inner_product(b.begin(), b.end(), x.begin(), 0.0); gain > most) {
        most = gain;
        best = x;
      }
    if (open == 0) return best;
  }
}

using Rows = Eigen::Map<const Eigen::ArrayXd>;

Rows rows_of(const std::vector<double>& list) { return {list.data(), static_cast<Eigen::Index>(list.size())}; }

class Likelihood {
 public:
  explicit Likelihood(const Deviations& rows) : rows_(rows) {}

  /// ln L; minus infinity where a variance is not positive.
  double at(const Vector& theta) {
    if (!set(theta)) return -std::numeric_limits<double>::infinity();
    const auto logarithms = variances_.unaryExpr([](double v) { return std::log(v); });  // faster than Eigen's
    return -(rows_of(rows_.shares) * (logarithms + rows_of(rows_.squares) * inverses_)).sum() / 2;
  }

  /// The variances of the next step. False where one is not positive.
  bool set(const Vector& theta) {
    variances_ = rows_of(rows_.fixed);
    for (std::size_t k = 0; k < rows_.components; ++k)
      if (theta[k] != 0) variances_ += theta[k] * rows_of(rows_.shapes[k]);
    inverses_ = variances_.inverse();
    return (variances_ > 0).all();
  }

  /// One step of weighted least squares at the variances that were set last.
  std::optional<Vector> next(std::uint32_t allowed) {
    Matrix N{};
    Vector b{};
    weights_ = rows_of(rows_.shares) * inverses_.square();
    for (std::size_t k = 0; k < rows_.components; ++k) {
      if (!(allowed >> k & 1)) continue;
      weighted_ = weights_ * rows_of(rows_.shapes[k]);
      b[k] = (weighted_ * (rows_of(rows_.squares) - rows_of(rows_.fixed))).sum();
      for (std::size_t l = 0; l <= k; ++l)
        if (allowed >> l & 1) N[k][l] = N[l][k] = (weighted_ * rows_of(rows_.shapes[l])).sum();
    }
    return non_negative(N, b, allowed);
  }

 private:
  const Deviations& rows_;
  Eigen::ArrayXd variances_, inverses_, weights_, weighted_;
};

}  // namespace

void Deviations::add(double square, double share, double fixed_part, std::span<const double> shape) {
  if (added++ % pool > 0) {
    shares.back() += share;
    const double part = shares.back() > 0 ? share / shares.back() : 0;
    const auto move = [part](double& mean, double to) { mean += part * (to - mean); };
    move(squares.back(), square);
    move(fixed.back(), fixed_part);
    for (std::size_t k = 0; k < components; ++k) move(shapes[k].back(), shape[k]);
    return;
  }
  squares.push_back(square);
  shares.push_back(share);
  fixed.push_back(fixed_part);
  for (std::size_t k = 0; k < components; ++k) shapes[k].push_back(shape[k]);
}

void Deviations::append(const Deviations& other) {
  const auto join = [](std::vector<double>& list, const std::vector<double>& more) {
    list.insert(list.end(), more.begin(), more.end());
  };
  join(squares, other.squares);
  join(shares, other.shares);
  join(fixed, other.fixed);
  for (std::size_t k = 0; k < components; ++k) join(shapes[k], other.shapes[k]);
  added = 0;  // the next row begins anew
}

double log_likelihood(const Deviations& rows, std::span<const double> theta) {
  Vector all{};
  std::copy(theta.begin(), theta.end(), all.begin());
  return Likelihood(rows).at(all);
}

namespace {

/// Each component's value if it explained all the squares alone.
Vector alone(const Deviations& rows, std::uint32_t allowed) {
  const std::size_t m = rows.components;
  Vector theta{};
  const int parts = std::max(1, std::popcount(allowed));
  for (std::size_t k = 0; k < m; ++k) {
    if (!(allowed >> k & 1)) continue;
    const Eigen::ArrayXd weighted = rows_of(rows.shares) * rows_of(rows.shapes[k]);
    const double square = (weighted * rows_of(rows.squares)).sum(), shape = (weighted * rows_of(rows.shapes[k])).sum();
    if (shape > 0) theta[k] = square / shape / parts;
  }
  return theta;
}

bool has_others(const Vector& theta, std::uint32_t allowed) {
  for (std::size_t k = 0; k < kMost; ++k)
    if (theta[k] > 0 && !(allowed >> k & 1)) return true;
  return false;
}

/// Iterates from theta until no component changes by more than `digits` (relative), or ln L by more than `gain`. theta
/// may have components that are not allowed: the first step then begins with the variances of all.
std::optional<VarianceComponents> scored(const Deviations& rows, std::uint32_t allowed, Vector theta, double digits,
                                         double gain) {
  constexpr int kRounds = 60;
  const std::size_t m = rows.components;
  Likelihood likelihood(rows);
  double value = -std::numeric_limits<double>::infinity();
  if (has_others(theta, allowed)) {
    const std::optional<Vector> first = likelihood.set(theta) ? likelihood.next(allowed) : std::nullopt;
    if (first) value = likelihood.at(theta = *first);
    if (!std::isfinite(value)) theta = alone(rows, allowed);
  }
  if (!std::isfinite(value)) value = likelihood.at(theta);
  for (int round = 0; round < kRounds && std::isfinite(value); ++round) {
    const std::optional<Vector> found = likelihood.next(allowed);
    if (!found) break;
    Vector to = *found;
    double reached = likelihood.at(to);
    for (int half = 0; half < 30 && !(reached >= value - 1e-12 * std::abs(value)); ++half) {
      for (std::size_t k = 0; k < m; ++k) to[k] = (to[k] + theta[k]) / 2;
      reached = likelihood.at(to);
    }
    double change = 0;
    for (std::size_t k = 0; k < m; ++k)
      if (const double size = std::max(theta[k], to[k]); size > 0)
        change = std::max(change, std::abs(to[k] - theta[k]) / size);
    theta = to;
    const double gained = reached - value;
    value = reached;
    if (change <= digits || gained <= gain) break;
  }
  if (!std::isfinite(value)) return std::nullopt;
  VarianceComponents result{{theta.begin(), theta.begin() + static_cast<std::ptrdiff_t>(m)}, value, 0};
  result.used = static_cast<std::size_t>(
      std::count_if(result.theta.begin(), result.theta.end(), [](double one) { return one > 0; }));
  return result;
}

}  // namespace

std::optional<VarianceComponents> fit_variances(const Deviations& rows, std::uint32_t allowed,
                                                std::span<const double> from) {
  Vector start{};
  std::copy(from.begin(), from.end(), start.begin());
  return scored(rows, allowed, from.empty() ? alone(rows, allowed) : start, 1e-9, -1);
}

std::optional<VarianceComponents> choose_variances(const Deviations& rows, std::span<const std::uint32_t> allowed,
                                                   std::span<const double> from) {
  constexpr double kHardly = 1e-3;  // of ln L: less than the differences between choices
  const double price = std::log(std::accumulate(rows.shares.begin(), rows.shares.end(), 0.0));
  const std::uint32_t any = std::accumulate(allowed.begin(), allowed.end(), 0u, std::bit_or{});
  Vector start = alone(rows, any);
  if (std::any_of(from.begin(), from.end(), [](double one) { return one > 0; }))
    std::copy(from.begin(), from.end(), start.begin());
  const auto all = scored(rows, any, start, 0, kHardly);
  if (all) std::copy(all->theta.begin(), all->theta.end(), start.begin());
  std::vector<std::uint32_t> choices(allowed.begin(), allowed.end());
  std::stable_sort(choices.begin(), choices.end(),
                   [](std::uint32_t x, std::uint32_t y) { return std::popcount(x) < std::popcount(y); });
  std::optional<VarianceComponents> best;
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t choice : choices) {
    // No choice is more likely than all components together.
    if (all && best && price * std::popcount(choice) - 2 * (all->log_likelihood + kHardly) >= least) break;
    auto found = scored(rows, choice, all ? start : alone(rows, choice), 0, kHardly);
    if (!found) continue;
    if (const double bic = price * static_cast<double>(found->used) - 2 * found->log_likelihood; bic < least) {
      least = bic;
      best = std::move(found);
    }
  }
  return best;
}

}  // namespace mixity
