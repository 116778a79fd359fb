#include "statistics/student.h"

#include <boost/math/tools/minima.hpp>
#include <cmath>

namespace mixity {
namespace {

/// The most likely scale: its square is a mean of weighted squares, found by fixed-point iteration.
double scale_of(std::span<const double> deviations, double freedom) {
  constexpr int kMost = 1000;
  constexpr double kSettled = 1e-13;
  double square = 0;
  for (const double d : deviations) square += d * d / static_cast<double>(deviations.size());
  for (int i = 0; i < kMost; ++i) {
    double sum = 0;
    for (const double d : deviations) sum += d * d * (freedom + 1) / (freedom + d * d / square);
    const double next = sum / static_cast<double>(deviations.size());
    const bool settled = std::abs(next - square) <= kSettled * square;
    square = next;
    if (settled) break;
  }
  return std::sqrt(square);
}

double log_likelihood(std::span<const double> deviations, const StudentErrors& errors) {
  const double nu = errors.freedom;
  double sum = 0;
  for (const double d : deviations) sum += std::log1p(d * d / (nu * errors.scale * errors.scale));
  const double each = std::lgamma(0.5 * (nu + 1)) - std::lgamma(0.5 * nu) - 0.5 * std::log(nu) - std::log(errors.scale);
  return static_cast<double>(deviations.size()) * each - 0.5 * (nu + 1) * sum;
}

}  // namespace

StudentErrors student_errors(std::span<const double> deviations, bool known_scale) {
  constexpr double kMostFreedom = 100;
  constexpr int kBits = 26;
  const auto with = [&](double freedom) {
    return StudentErrors{freedom, known_scale ? 1 : scale_of(deviations, freedom)};
  };
  const auto improbability = [&](double log_freedom) {
    const double freedom = std::exp(log_freedom);
    return 0.1 * freedom - 2 * log_freedom - log_likelihood(deviations, with(freedom));
  };
  return with(std::exp(boost::math::tools::brent_find_minima(improbability, 0.0, std::log(kMostFreedom), kBits).first));
}

}  // namespace mixity
