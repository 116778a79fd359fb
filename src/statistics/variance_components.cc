#include "statistics/variance_components.h"

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

class Likelihood {
 public:
  explicit Likelihood(const Deviations& rows) : rows_(rows), variances_(rows.size()) {}

  /// ln L; minus infinity where a variance is 0.
  double at(const Vector& theta) { return rows_.components == kUsual ? at<kUsual>(theta) : at<0>(theta); }

  /// One step of weighted least squares at the variances of the last call of at().
  std::optional<Vector> next(std::uint32_t allowed) const {
    return rows_.components == kUsual ? next<kUsual>(allowed) : next<0>(allowed);
  }

 private:
  static constexpr std::size_t kUsual = 4;  // a constant and a share of each axis

  /// Loops of known length need a third of the time. kCount: the number of components; 0: known at run time.
  template <std::size_t kCount>
  std::size_t count() const {
    return kCount > 0 ? kCount : rows_.components;
  }

  template <std::size_t kCount>
  double at(const Vector& theta) {
    const std::size_t m = count<kCount>();
    double sum = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      double v = rows_.fixed[i];
      for (std::size_t k = 0; k < m; ++k) v += theta[k] * rows_.shapes[i * m + k];
      if (!(v > 0)) return -std::numeric_limits<double>::infinity();
      variances_[i] = v;
      sum -= rows_.shares[i] * (std::log(v) + rows_.squares[i] / v) / 2;
    }
    return sum;
  }

  template <std::size_t kCount>
  std::optional<Vector> next(std::uint32_t allowed) const {
    const std::size_t m = count<kCount>();
    Matrix N{};
    Vector b{};
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const double weight = rows_.shares[i] / (variances_[i] * variances_[i]);
      const double* shape = &rows_.shapes[i * m];
      for (std::size_t k = 0; k < m; ++k) {
        b[k] += weight * shape[k] * (rows_.squares[i] - rows_.fixed[i]);
        for (std::size_t l = 0; l <= k; ++l) N[k][l] += weight * shape[k] * shape[l];
      }
    }
    for (std::size_t k = 0; k < m; ++k)
      for (std::size_t l = 0; l < k; ++l) N[l][k] = N[k][l];
    return non_negative(N, b, allowed);
  }

  const Deviations& rows_;
  std::vector<double> variances_;
};

}  // namespace

void Deviations::add(double square, double share, double fixed_part, std::span<const double> shape) {
  if (added++ % pool > 0) {
    shares.back() += share;
    const double part = shares.back() > 0 ? share / shares.back() : 0;
    const auto move = [part](double& mean, double to) { mean += part * (to - mean); };
    move(squares.back(), square);
    move(fixed.back(), fixed_part);
    for (std::size_t k = 0; k < components; ++k) move(shapes[shapes.size() - components + k], shape[k]);
    return;
  }
  squares.push_back(square);
  shares.push_back(share);
  fixed.push_back(fixed_part);
  shapes.insert(shapes.end(), shape.begin(), shape.end());
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
    double square = 0, shape = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      square += rows.shares[i] * rows.shapes[i * m + k] * rows.squares[i];
      shape += rows.shares[i] * rows.shapes[i * m + k] * rows.shapes[i * m + k];
    }
    if (shape > 0) theta[k] = square / shape / parts;
  }
  return theta;
}

/// Iterates from theta until no component changes by more than `digits` (relative), or ln L by more than `gain`.
std::optional<VarianceComponents> scored(const Deviations& rows, std::uint32_t allowed, Vector theta, double digits,
                                         double gain) {
  constexpr int kRounds = 60;
  const std::size_t m = rows.components;
  Likelihood likelihood(rows);
  double value = likelihood.at(theta);
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

std::optional<VarianceComponents> choose_variances(const Deviations& rows, std::span<const std::uint32_t> allowed) {
  constexpr double kHardly = 1e-3;  // of ln L: less than the differences between choices
  const double price = std::log(std::accumulate(rows.shares.begin(), rows.shares.end(), 0.0));
  const std::uint32_t any = std::accumulate(allowed.begin(), allowed.end(), 0u, std::bit_or{});
  const auto all = scored(rows, any, alone(rows, any), 0, kHardly);
  std::vector<std::uint32_t> choices(allowed.begin(), allowed.end());
  std::stable_sort(choices.begin(), choices.end(),
                   [](std::uint32_t x, std::uint32_t y) { return std::popcount(x) < std::popcount(y); });
  std::optional<VarianceComponents> best;
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t choice : choices) {
    // No choice is more likely than all components together.
    if (all && best && price * std::popcount(choice) - 2 * (all->log_likelihood + kHardly) >= least) break;
    auto found = scored(rows, choice, alone(rows, choice), 0, kHardly);
    if (!found) continue;
    if (const double bic = price * static_cast<double>(found->used) - 2 * found->log_likelihood; bic < least) {
      least = bic;
      best = std::move(found);
    }
  }
  return best;
}

}  // namespace mixity
