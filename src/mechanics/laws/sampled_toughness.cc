#include "mechanics/laws/sampled_toughness.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/base/constants.h"

namespace mixity {
namespace {

constexpr double kBeyondAll = std::numeric_limits<double>::infinity();
constexpr double kRounding = 4e-15;    // of ln f in samples
constexpr double kNoise = 1e-6;        // coefficients below this are noise of f if they stop falling with the degree,
constexpr double kSmallNoise = 1e-10;  // and below this if they stop falling with the length of a piece
constexpr std::size_t kMostPieces = 300;
constexpr double kSmooth = 1e-2;  // [rad] f has derivatives at 0 if the first piece is longer
constexpr double kNear = 1e-4;    // [rad] below, the power of ln f is determined in another way
constexpr double kRight = 1.5707963267948966;

/// Ends of the parts of a piece: two halves; towards 0 and 90 degrees, halved four times.
std::vector<double> cuts_of(double begin, double end) {
  const double length = end - begin;
  if (begin == 0) return {0, length / 16, length / 8, length / 4, length / 2, length};
  if (end == kRight) return {begin, end - length / 2, end - length / 4, end - length / 8, end - length / 16, end};
  return {begin, 0.5 * (begin + end), end};
}

struct Pending {
  double begin, end;
  double before;  // last coefficients of the piece it was cut from
};

}  // namespace

Taylor SampledToughness::Piece::at(double psi) const {
  const double half = 0.5 * (end - begin), x = std::clamp((psi - begin) / half - 1, -1.0, 1.0);
  Taylor one, two;  // Clenshaw's sums, with derivatives in x
  for (std::size_t k = count; k-- > 1;) {
    const Taylor next{coefficients[k] + 2 * x * one.value - two.value, 2 * one.value + 2 * x * one.first - two.first,
                      4 * one.first + 2 * x * one.second - two.second};
    two = one;
    one = next;
  }
  return {coefficients[0] + x * one.value - two.value, (one.value + x * one.first - two.first) / half,
          (2 * one.first + x * one.second - two.second) / (half * half)};
}

SampledToughness::Piece SampledToughness::piece_through(double begin, double end, std::span<const double> psi,
                                                        std::span<const double> f) const {
  static const std::array<std::array<double, kNodes>, kNodes> cosines = [] {
    std::array<std::array<double, kNodes>, kNodes> all;
    for (std::size_t k = 0; k < kNodes; ++k)
      for (std::size_t j = 0; j < kNodes; ++j)
        all[k][j] = (k == 0 ? 1.0 : 2.0) / kNodes *
                    std::cos(pi<double>() * static_cast<double>(k) * (static_cast<double>(j) + 0.5) / kNodes);
    return all;
  }();
  Piece piece{begin, end};
  for (std::size_t j = 0; j < kNodes; ++j) {
    const double h =
        f[j] > 0 && f[j] < kBeyondAll ? std::log(f[j]) + (power_ == 0 ? 0 : power_ * std::log(std::cos(psi[j]))) : NAN;
    for (std::size_t k = 0; k < kNodes; ++k) piece.coefficients[k] += h * cosines[k][j];
  }
  return piece;
}

SampledToughness::SampledToughness(const LawSampler& sampler, std::span<const double> parameters) {
  constexpr double kBeside = 1e-12, kFarther = 1e-10;  // distances from 90 degrees at which the power is determined
  std::vector<Pending> pending, next;
  for (int i = 0; i < 4; ++i) pending.push_back({i * kRight / 4, (i + 1) * kRight / 4, kBeyondAll});
  std::vector<double> psi{0, kRight - kFarther, kRight - kBeside}, f;
  for (bool first = true; !pending.empty(); first = false) {
    for (const Pending& one : pending)
      for (std::size_t j = 0; j < kNodes; ++j)
        psi.push_back(one.begin + 0.5 * (one.end - one.begin) *
                                      (1 + std::cos(pi<double>() * (static_cast<double>(j) + 0.5) / kNodes)));
    f.resize(psi.size());
    sampler(psi, parameters, f);
    for (std::size_t i = 0; i < f.size(); ++i)
      if (!(f[i] > 0 && f[i] < kBeyondAll)) undefined_at_ = std::min(undefined_at_, psi[i]);
    std::size_t at = 0;
    if (first) {
      at = 3;
      log_f0_ = f[0] > 0 ? std::log(f[0]) : NAN;
      const double power = std::log(f[2] / f[1]) / std::log(std::cos(psi[1]) / std::cos(psi[2]));
      // a tiny power is taken as 0, one close to 2 as 2
      if (std::isfinite(power) && std::abs(power) > 0.1) power_ = std::abs(power - 2) < 1e-3 ? 2 : power;
    }
    next.clear();
    for (const Pending& one : pending) {
      Piece piece =
          piece_through(one.begin, one.end, std::span(psi).subspan(at, kNodes), std::span(f).subspan(at, kNodes));
      at += kNodes;
      const auto largest = [&](std::size_t from, std::size_t to) {
        double most = 0;
        for (std::size_t k = from; k < to; ++k) most = std::max(most, std::abs(piece.coefficients[k]));
        return most;
      };
      const double left = largest(kNodes - 2, kNodes);
      const bool narrow = one.end - one.begin <= (one.end == kRight ? 1e-13 : 1e-8 * one.begin + 1e-16);
      const bool noisy = (left < kNoise && largest(kNodes - 4, kNodes) > 0.5 * largest(5, 9)) ||
                         (left < kSmallNoise && left > 0.5 * one.before);
      const double rounding = kRounding * std::max(1.0, largest(0, kNodes));
      const bool many = pieces_.size() + pending.size() + next.size() > kMostPieces;
      if (left > rounding && !narrow && !noisy && !many) {
        const std::vector<double> cuts = cuts_of(one.begin, one.end);
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) next.push_back({cuts[i], cuts[i + 1], left});
        continue;
      }
      const double middle = 0.5 * (one.begin + one.end),
                   log_f = piece.at(middle).value - power_ * std::log(std::cos(middle));
      if (const double error = left * std::exp(-std::abs(log_f)); left > rounding && error > error_) {
        error_ = error;
        error_at_ = middle;
      }
      while (piece.count > 1 && std::abs(piece.coefficients[piece.count - 1]) <= 0.02 * rounding) --piece.count;
      pieces_.push_back(piece);
    }
    pending.swap(next);
    psi.clear();
  }
  std::sort(pieces_.begin(), pieces_.end(),
            [](const Piece& one, const Piece& other) { return one.begin < other.begin; });
}

const SampledToughness::Piece& SampledToughness::piece_at(double psi) const {
  const auto behind = std::upper_bound(pieces_.begin() + 1, pieces_.end(), psi,
                                       [](double value, const Piece& piece) { return value < piece.begin; });
  return *(behind - 1);
}

Taylor SampledToughness::smooth(double psi) const { return psi == 0 ? at_zero() : piece_at(psi).at(psi); }

Taylor SampledToughness::at_zero() const {
  if (pieces_[0].end > kSmooth) {
    const Taylor h = pieces_[0].at(0);
    const double rounding = 1e-9 + 4 * kNodes * kNodes * error_ / pieces_[0].end;
    return {log_f0_, std::abs(h.first) < rounding ? 0 : h.first, h.second};
  }
  const double one = log_toughness(kNear, std::cos(kNear)) - log_f0_;
  const double two = log_toughness(2 * kNear, std::cos(2 * kNear)) - log_f0_;
  // for a power below 2 the second derivative is infinite; for other powers it is unknown here
  return {log_f0_, 0, std::abs(two) < 3.99 * std::abs(one) ? std::copysign(kBeyondAll, one) : NAN};
}

Taylor SampledToughness::toughness(const Taylor& psi, const Taylor& cosine) const {
  const Taylor h = smooth(psi.value), f = exp(psi.through(h.value, h.first, h.second));
  if (power_ == 0) return f;
  return power_ == 2 ? f / (cosine * cosine) : f * pow(cosine, Taylor(-power_));
}

double SampledToughness::log_toughness(double psi, double cosine) const {
  return smooth(psi).value - (power_ == 0 ? 0 : power_ * std::log(cosine));
}

}  // namespace mixity
