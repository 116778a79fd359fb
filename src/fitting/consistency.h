// Tests of a fit's residuals (consistency.cc), which one fails (failures.cc), and why (diagnosis.cc).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "dataset/dataset.h"
#include "fitting/result.h"

namespace mixity {

/// A test fails if its p-value is below this.
inline constexpr double kChance = 1e-3;

/// Whether one of `tests` score tests shows that a constant should be free. The threshold is lower if freeing it would
/// move the first parameter far outside its interval, because the fit would then be wrong by as much.
inline bool asks_to_be_free(const ExactConstant::Score& score, double tests) {
  constexpr double kFar = 6, kLess = 1e-2;  // in standard errors; a probability
  return score.p_value * tests < (std::abs(score.change) > kFar ? kLess : kChance);
}

/// Standard error of a residual: 1 where errors are known, else from the scatter about the fit. For Student's
/// likelihood the scale parameter, which most points follow.
double residual_unit(const FitResult& fit);

/// The fit must have residuals.
Consistency test_consistency(const Dataset& data, const FitResult& fit);
/// That of the fit, found where it has none yet.
Consistency consistency_of(const Dataset& data, const FitResult& fit);

/// Among the exact constants that matter, the one with the most significant score test, if that test fails; else null.
const ExactConstant* wrong_constant(const FitResult& fit);

/// The exact constant whose score test comes nearest to failing although the fit is believed, if freeing it would move
/// the first parameter by an amount that matters: p below 0.1, corrected for the number of tests but for a radius that
/// reads too large, which elliptic contacts make and whose test has one side; else null. A
/// threshold alone would leave the intervals of fits just below it too narrow. With an ellipse of 1 % under model b
/// (docs/noise.md), 6.9 % of the fits were `ok` and wrong, and 1.1 % are; 0.2 changes nothing more and is met by twice
/// as many right fits.
const ExactConstant* nearly_wrong_constant(const FitResult& fit);
/// The p-value of its score test, of that side for a radius that reads too large.
double p_value_of(const ExactConstant& one);
/// Whether a constant's score test nearly fails as one of so many tests.
bool is_nearly_wrong(const ExactConstant& one, double tests);

/// A constant farther from its stated value than its standard error explains; else null.
const BudgetPart* far_from_stated(const FitResult& fit);

/// The points that lie beyond the last equilibrium and far off, if there are more than chance allows; else none.
std::vector<std::size_t> sliding_points(const FitResult& fit);

/// Whether the residuals are far larger than the scatter of neighbours.
bool is_far(const ResidualTests& tests);

/// The mean correlation of neighbouring residuals, from the error estimate; 0 without one.
double mean_correlation(const FitResult& fit);
/// The effective number of independent points: n (1 - r)/(1 + r), r the mean correlation.
double independent_points(const FitResult& fit);
/// The first test that fails, as a sentence with a remedy; empty if none does. `constants`: including the score tests
/// of exact constants.
Message failed_test(const Dataset& data, const FitResult& fit, bool constants = true);

/// Refits the same model to some points of the data or of a part of them, for its values; starts from `near` unless
/// that is null.
using Refit =
    std::function<FitResult(const Dataset& data, const FitOptions& options, const std::vector<std::size_t>& points,
                            const std::vector<FittedParameter>* near)>;

/// The best explanation for failed tests and its remedy, in one sentence: a wrong constant of the experiment, points
/// past the onset of sliding, errors that are too small, or a wrong model. Empty if no test fails. `to_beat`: the
/// misfit (causes.h) of a model that fits far better, so that only a constant that explains everything as well is
/// considered.
struct Diagnosis {
  Message reason;
  std::optional<double> explained{};  // the cost with the best cause that explains everything
  std::vector<Explanation> explanations{};
  bool passes = false;  // the fit is believed: its interval includes the explanations
};
Diagnosis diagnose(const Dataset& data, const FitResult& fit, const FitOptions& options, const Refit& refit,
                   std::optional<double> to_beat = {});

/// For a fit that passes its tests, an explanation that is better nevertheless (shape_instead_of_memory); else no
/// reason.
Diagnosis second_thought(const Dataset& data, const FitResult& fit, const FitOptions& options, const Refit& refit);

/// For a fit that passes its tests, the fits with another constant that its interval includes (beside_the_fit); no
/// reason without one.
Diagnosis included(const Dataset& data, const FitResult& fit, const FitOptions& options, const Refit& refit);

}  // namespace mixity
