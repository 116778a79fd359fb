#include "fitting/noise_alone.h"

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <memory>

#include "fitting/causes.h"
#include "fitting/consistency.h"
#include "fitting/fit.h"

namespace mixity {
namespace {

/// -ln of the smallest p-value of a test whose failure makes a fit suspect, times the number of such tests.
double improbability(const FitResult& fit) {
  double least = chance_of_runs(fit);
  if (const ExactConstant* const worst = most_significant_constant(fit))
    least = std::min(least, worst->score->p_value * fit.budget->independent);
  if (!fit.consistency) return -std::log(least);
  const ResidualTests& residuals = fit.consistency->residuals;
  for (const double p : {residuals.course_p, residuals.runs_p, residuals.correlation_p, residuals.trend_p,
                         residuals.ends_p, fit.consistency->chi2_p.value_or(1)})
    least = std::min(least, p);
  return -std::log(least);
}

/// Whether a test fails that does not compare residuals with noise.
bool fails_otherwise(const FitResult& fit) {
  const Consistency& tests = *fit.consistency;
  return slides(fit) || far_from_stated(fit) || tests.pinned || tests.residuals.together || is_far(tests.residuals);
}

/// The readings of this experiment with other noise: places on the fitted curve plus random errors as in `errors`.
Dataset with_other_noise(const Dataset& data, const FitResult& fit, unsigned seed) {
  boost::random::mt19937_64 random(seed);
  boost::random::normal_distribution<double> normal;
  const StandardErrors& errors = *fit.errors;
  Dataset simulated = data;
  std::vector<double> before_A(data.curves.size()), before_T(data.curves.size());
  std::vector<bool> begun(data.curves.size(), false);
  for (const std::size_t i : fit.used) {
    Point& point = simulated.points[i];
    const auto next = [&](double& before, double correlation) {
      const double innovation = normal(random);
      before = begun[point.curve] ? correlation * before + std::sqrt(1 - correlation * correlation) * innovation
                                  : innovation;
      return before;
    };
    const double of_A = next(before_A[point.curve], errors.correlations.first),
                 of_T = next(before_T[point.curve], errors.correlations.second);
    begun[point.curve] = true;
    point.A = std::max(errors.place_A[i] + errors.A[i] * of_A, 0.5 * errors.place_A[i]);
    point.T = std::copysign(errors.place_T[i] + errors.T[i] * of_T, point.T);
  }
  return simulated;
}

}  // namespace

bool noise_alone_fails_alike(const Dataset& data, const FitResult& fit, const FitOptions& options) {
  constexpr unsigned kExperiments = 10;
  constexpr double kScatter = 0.7;  // chi^2 per degree of freedom that fits errors as stated
  constexpr double kAlike = 1.5;    // in 1 to 3 of a hundred cases the largest of ten is exceeded by this factor
  if (!fit.errors || !fit.consistency || fit.errors->expected.empty() || fit.errors->place_A.empty()) return false;
  double squares = 0;
  for (const std::size_t i : fit.used) squares += std::pow(fit.errors->expected[i], 2);
  if (squares < kCurvatureMatters || fit.loss_scale > 0 || fails_otherwise(fit)) return false;
  // Stated errors that are larger than the scatter excuse nothing.
  if (fit.known_errors && fit.sum_of_squares < kScatter * static_cast<double>(fit.freedom())) return false;
  FitOptions alike = value_only(options);
  alike.checks = true;
  alike.errors = fit.errors;
  const double here = improbability(fit);
  for (unsigned seed = 1; seed <= kExperiments; ++seed)
    if (here < kAlike * improbability(fit_and_test(with_other_noise(data, fit, seed), fit.model, alike, &fit.used)))
      return true;
  return false;
}

}  // namespace mixity
