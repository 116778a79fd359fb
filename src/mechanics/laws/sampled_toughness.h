// The toughness ratio f(psi) of a law that is a function of arrays, such as a Python function, at one set of
// parameters: sampled once, then evaluated as polynomials in psi on pieces of 0..90 degrees.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "mechanics/laws/taylor.h"

namespace mixity {

/// Fills f = G_c/G_Ic at phase angles psi [rad], 0 <= psi < pi/2. Must be thread-safe. Its exceptions reach the caller
/// who evaluates the law.
using LawSampler =
    std::function<void(std::span<const double> psi, std::span<const double> parameters, std::span<double> f)>;

/// Immutable.
class SampledToughness {
 public:
  /// Calls the sampler with some hundred angles, then again for the pieces on which these do not suffice: towards 0 and
  /// 90 degrees, where f may be any power of psi or cos psi, and at kinks.
  SampledToughness(const LawSampler& sampler, std::span<const double> parameters);

  /// f along the direction in which psi and its cosine > 0 change; NaN on pieces where a sample is not a positive
  /// number.
  Taylor toughness(const Taylor& psi, const Taylor& cosine) const;
  double log_toughness(double psi, double cosine) const;

  /// Largest error, beyond rounding, that further samples would not reduce (of f or of 1/f, whichever is smaller), and
  /// its psi.
  double error() const { return error_; }
  double error_at() const { return error_at_; }
  /// The smallest psi at which a sample is not a positive number; infinite if there is none.
  double undefined_at() const { return undefined_at_; }

 private:
  static constexpr std::size_t kNodes = 21;  // Chebyshev nodes of a piece
  /// h = ln f + power ln cos psi as a Chebyshev series, without the last terms if these are rounding.
  struct Piece {
    double begin, end;
    std::array<double, kNodes> coefficients{};
    std::size_t count = kNodes;
    Taylor at(double psi) const;  // with derivatives in psi
  };
  Piece piece_through(double begin, double end, std::span<const double> psi, std::span<const double> f) const;
  const Piece& piece_at(double psi) const;
  Taylor smooth(double psi) const;  // h
  Taylor at_zero() const;

  std::vector<Piece> pieces_;
  double power_ = 0;  // f grows as cos^-power towards 90 degrees
  double log_f0_ = 0;
  double error_ = 0, error_at_ = 0, undefined_at_ = std::numeric_limits<double>::infinity();
};

}  // namespace mixity
