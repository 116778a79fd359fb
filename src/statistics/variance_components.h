// Variances that are sums of known shapes, such as the noise of an instrument: a constant part and a part that is
// proportional to the reading.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace mixity {

/// Normal deviations of mean 0, one a row. The variance of row i is fixed[i] + sum over k of theta[k] shapes[i][k].
struct Deviations {
  static constexpr std::size_t kMostComponents = 8;

  /// `pooled`: how many rows that are added one after the other become one, with the mean of their squares, shapes and
  /// fixed parts. The sizes that are found have no bias by it, and hardly larger errors where the shapes are alike.
  explicit Deviations(std::size_t count, std::size_t pooled = 1) : components(count), pool(pooled) {}
  /// `share`: what the row counts, 1 for an independent one; 1 - leverage for a residual, whose square must then be
  /// divided by that. `shape`: one value, not below 0, for each component.
  void add(double square, double share, double fixed, std::span<const double> shape);
  std::size_t size() const { return squares.size(); }

  std::size_t components, pool, added = 0;
  std::vector<double> squares, shares, fixed, shapes;  // shapes: [rows x components], by row
};

struct VarianceComponents {
  std::vector<double> theta;  // one for each component, 0 or above; 0 for those that are left out
  double log_likelihood;      // without -n/2 ln(2 pi)
  std::size_t used;           // components above 0
};

/// ln L without -n/2 ln(2 pi) at these theta; minus infinity where a variance is 0.
double log_likelihood(const Deviations& rows, std::span<const double> theta);

/// theta >= 0 of greatest likelihood, with the components in `allowed` (bit k: component k) alone. Fisher's scoring:
/// weighted least squares of the squares on the shapes, repeated with the variances that these give (Davidian &
/// Carroll 1987, J. Am. Stat. Assoc. 82, 1079). theta to 1e-9. `from`: theta to start at; empty: a guess. Null where a
/// variance is 0.
std::optional<VarianceComponents> fit_variances(const Deviations& rows, std::uint32_t allowed,
                                                std::span<const double> from = {});

/// The choice among `allowed` with the least BIC, -2 ln L + used ln(sum of shares) (Schwarz 1978), its ln L to
/// 0.001. Null where none has a fit.
std::optional<VarianceComponents> choose_variances(const Deviations& rows, std::span<const std::uint32_t> allowed);

}  // namespace mixity
