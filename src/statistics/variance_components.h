// Variances that are sums of known shapes, such as an instrument's noise: a constant part and a part proportional to
// the reading.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace mixity {

/// Normal deviations with mean 0, one per row. The variance of row i is fixed[i] + sum over k of theta[k] shapes[k][i].
struct Deviations {
  static constexpr std::size_t kMostComponents = 8;

  /// `pooled`: how many successive rows become one, with the mean of their squares, shapes and fixed parts. This does
  /// not bias the sizes found, and hardly increases their errors where the shapes are alike.
  explicit Deviations(std::size_t count, std::size_t pooled = 1) : components(count), pool(pooled) {}
  /// `share`: the weight of the row; 1 for an independent one, 1 - leverage for a residual, whose `square` must then
  /// have been divided by it. `shape`: one value >= 0 per component.
  void add(double square, double share, double fixed, std::span<const double> shape);
  /// Adds the rows of another, of as many components, as they are.
  void append(const Deviations& other);
  std::size_t size() const { return squares.size(); }

  std::size_t components, pool, added = 0;
  std::vector<double> squares, shares, fixed;
  std::array<std::vector<double>, kMostComponents> shapes;  // by component
};

struct VarianceComponents {
  std::vector<double> theta;  // one per component, >= 0; 0 for those left out
  double log_likelihood;      // without -n/2 ln(2 pi)
  std::size_t used;           // number of components above 0
};

/// ln L at these theta, without the term -n/2 ln(2 pi); minus infinity where a variance is 0.
double log_likelihood(const Deviations& rows, std::span<const double> theta);

/// theta >= 0 of maximum likelihood to 1e-9, using only the components in `allowed` (bit k: component k). Fisher
/// scoring: weighted least squares of the squares on the shapes, repeated with the resulting variances (Davidian &
/// Carroll 1987, J. Am. Stat. Assoc. 82, 1079). `from`: start values; empty: a guess. Null where a variance is 0.
std::optional<VarianceComponents> fit_variances(const Deviations& rows, std::uint32_t allowed,
                                                std::span<const double> from = {});

/// The choice among `allowed` with the smallest BIC, -2 ln L + used ln(sum of shares) (Schwarz 1978), with ln L to
/// 0.001. `from`: start values of all components; empty or 0: a guess. Null if none can be fitted.
std::optional<VarianceComponents> choose_variances(const Deviations& rows, std::span<const std::uint32_t> allowed,
                                                   std::span<const double> from = {});

}  // namespace mixity
