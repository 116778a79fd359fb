// A law that is a function of arrays, such as one of Python, at one set of its parameters: sampled, and then a
// polynomial in psi on each of some pieces of 0..90 degrees.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "mechanics/laws/taylor.h"

namespace mixity {

/// Fills f = G_c/G_Ic at phase angles psi [rad], 0 <= psi < pi/2. Called on any thread, on several at once; what it
/// throws comes out where the law was asked for.
using LawSampler =
    std::function<void(std::span<const double> psi, std::span<const double> parameters, std::span<double> f)>;

/// Not to change once made.
class SampledLaw {
 public:
  /// Calls the sampler with some hundred angles, and again for those pieces that this does not settle: towards 0 and 90
  /// degrees, where f may be any power of psi or cos psi, and at kinks.
  SampledLaw(const LawSampler& sampler, std::span<const double> parameters);

  /// f along the direction in which psi and its cosine > 0 change; NaN on pieces with a sample that is no positive
  /// number.
  Taylor toughness(const Taylor& psi, const Taylor& cosine) const;
  double log_toughness(double psi, double cosine) const;

  /// Largest error, of f or of 1/f, whichever is smaller, that further samples would not have made less, beyond
  /// rounding; psi there.
  double error() const { return error_; }
  double error_at() const { return error_at_; }
  /// The least psi of a sample that is no positive number; infinite where there is none.
  double undefined_at() const { return undefined_at_; }

 private:
  static constexpr std::size_t kNodes = 21;  // of a piece, Chebyshev's
  /// h = ln f + power ln cos psi in Chebyshev polynomials, of which the last may be left out.
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
