#include "fitting/expected_fall.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mixity {
namespace {

/// What a fall of chi^2 in units of the scatter is worth in -2 ln L.
class Likelihood {
 public:
  Likelihood(const FitResult& fit, std::size_t points)
      : known_(fit.known_errors),
        share_(static_cast<double>(points) / static_cast<double>(std::max<std::size_t>(fit.used.size(), 1))),
        rows_(share_ * static_cast<double>(fit.rows())),
        freedom_(share_ * static_cast<double>(fit.freedom())) {}

  double share() const { return share_; }
  double worth(double fall) const {
    if (known_) return fall;
    return fall < freedom_ ? -rows_ * std::log1p(-fall / freedom_) : std::numeric_limits<double>::infinity();
  }

 private:
  bool known_;
  double share_, rows_, freedom_;
};

}  // namespace

double expected_fall(const FitResult& fit, Constant constant, std::size_t points, double times) {
  if (fit.budget)
    for (const ExactConstant& one : fit.budget->exact)
      if (one.score && one.constant == kConstantNames[constant]) {
        const Likelihood likelihood(fit, points);
        return likelihood.worth(likelihood.share() * times * one.score->fall);
      }
  return std::numeric_limits<double>::infinity();
}

double expected_fall(const FitResult& fit, const RunTest& test, std::size_t points) {
  const Likelihood likelihood(fit, points);
  // Tests of known errors that are too small take the scatter as their unit, too.
  const double scatter = fit.known_errors && fit.freedom() > 0
                             ? std::max(1.0, fit.sum_of_squares / static_cast<double>(fit.freedom()))
                             : 1;
  // Of G deviations with the most likely spread: chi^2 falls by F - G, and ln of the variances grows by G ln(F/G).
  const auto of_effects = [&](double chi2, double effects) {
    const double fall = likelihood.share() * scatter * chi2;
    return fall > effects ? likelihood.worth(fall - effects) - effects * std::log(fall / effects) : 0;
  };
  const auto runs = std::max(test.directions, 1.0);
  return std::max(of_effects(test.all.fall, runs), of_effects(test.odd.fall, 1) - 2 * std::log(runs));
}

}  // namespace mixity
