#include "fitting/expected_fall.h"

#include <algorithm>
#include <cmath>

#include "fitting/explanations.h"
#include "statistics/distributions.h"

namespace mixity {
namespace {

/// The numbers of a fit to a part of its points.
struct PartOfFit {
  PartOfFit(const FitResult& fit, std::size_t points)
      : known_errors(fit.known_errors),
        share(static_cast<double>(points) / static_cast<double>(std::max<std::size_t>(fit.used.size(), 1))),
        rows(share * static_cast<double>(fit.rows())),
        freedom(share * static_cast<double>(fit.freedom())),
        squares(share * fit.sum_of_squares) {}

  /// The fall of -2 ln L if chi^2 falls by so much.
  double misfit(double chi2) const {
    if (known_errors) return chi2;
    return chi2 < freedom ? -rows * std::log1p(-chi2 / freedom) : kUnknownFall.misfit;
  }

  bool known_errors;
  double share, rows, freedom, squares;
};

}  // namespace

ExpectedFall expected_fall(const FitResult& fit, Constant constant, std::size_t points, double times) {
  if (fit.budget)
    for (const ExactConstant& one : fit.budget->exact)
      if (one.score && one.constant == kConstantNames[constant]) {
        const PartOfFit part(fit, points);
        const double chi2 = times * part.share * one.score->fall;
        return {chi2, part.misfit(chi2)};
      }
  return kUnknownFall;
}

ExpectedFall expected_fall(const FitResult& fit, const RunTest& test, std::size_t points) {
  const PartOfFit part(fit, points);
  // Tests of known errors that are too small take the scatter as their unit.
  const double unit = part.share * (part.known_errors ? std::max(1.0, part.squares / part.freedom) : 1);
  // Of G deviations with the most likely spread: chi^2 falls by F - G, and ln of the variances grows by G ln(F/G).
  const auto misfit = [&](double F, double G) { return F > G ? part.misfit(F - G) - G * std::log(F / G) : 0; };
  const double runs = std::max(test.directions, 1.0), all = unit * test.all.fall, odd = unit * test.odd.fall;
  return {all, std::max(misfit(all, runs), misfit(odd, 1) - 2 * std::log(runs))};
}

bool stays_too_large(const FitResult& fit, const ExpectedFall& fall, std::size_t points) {
  // In 311 simulated explanations (tools/laboratories) chi^2 per point was expected to be 1.4 at most.
  constexpr double kMore = 1.1;  // the fall, far from the minimum
  constexpr double kAtMost = 2;  // the factor by which correlated neighbours lower chi^2
  const PartOfFit part(fit, points);
  const double left = part.squares - kMore * fall.chi2;
  return part.known_errors && left > 0 && chi_squared_p_value(left / kAtMost, part.freedom) < kHardly;
}

}  // namespace mixity
