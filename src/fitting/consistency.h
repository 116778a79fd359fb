// Tests of a fit's residuals (consistency.cc), which of them fails (failures.cc), and why (diagnosis.cc).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "dataset/dataset.h"
#include "fitting/result.h"

namespace mixity {

/// A test fails at this p-value.
inline constexpr double kChance = 1e-3;

/// Whether a constant asks to be free, of so many tests. Less evidence is enough against one that would move the first
/// parameter far beyond its interval: by as much the fit is wrong if it is believed.
inline bool asks_to_be_free(const ExactConstant::Score& score, double tests) {
  constexpr double kFar = 6, kLess = 1e-2;  // standard errors; a chance
  return score.p_value * tests < (std::abs(score.change) > kFar ? kLess : kChance);
}

/// Standard error of a residual: 1 where errors are known, else from the scatter about the fit. Of Student's likelihood
/// its scale, which is that of most points.
double residual_unit(const FitResult& fit);

/// Of a fit that has residuals.
Consistency test_consistency(const Dataset& data, const FitResult& fit);

/// The exact constant with the most significant score test among those that matter, if that fails; else null.
const ExactConstant* wrong_constant(const FitResult& fit);

/// A constant that lies farther from what was stated than its standard error explains; else null.
const BudgetPart* far_from_stated(const FitResult& fit);

/// Whether more points lie beyond the last equilibrium than by chance.
bool slides(const FitResult& fit);

/// Whether the residuals are far larger than the scatter of neighbours.
bool is_far(const ResidualTests& tests);

/// The mean correlation of neighbouring residuals by the estimate of the errors; 0 without one.
double mean_correlation(const FitResult& fit);
/// How many independent points the points of the fit are worth: n (1 - r)/(1 + r), r the mean correlation.
double independent_points(const FitResult& fit);
/// The first test that fails, as a sentence with a remedy; empty if none does.
Message failed_test(const Dataset& data, const FitResult& fit);

/// A refit of the same model to some points, for its values; from `near` if that is not null.
using Refit = std::function<FitResult(const FitOptions& options, const std::vector<std::size_t>& points,
                                      const std::vector<FittedParameter>* near)>;

/// The best explanation for the tests that fail, with a remedy, in one sentence: a wrong constant of the experiment,
/// points past the onset of sliding, errors that are too small, or a wrong model. Empty if no test fails.
/// `left_behind`: another model fits far better, so only a constant that explains everything is considered.
struct Diagnosis {
  Message reason;
  std::optional<double> explained{};  // the cost with the best cause that explains everything
  std::vector<Explanation> explanations{};
};
Diagnosis diagnose(const Dataset& data, const FitResult& fit, const FitOptions& options, const Refit& refit,
                   bool left_behind);

/// Of a fit that passes its tests, the explanation that is better nevertheless (shape_instead_of_memory); no reason if
/// there is none.
Diagnosis second_thought(const Dataset& data, const FitResult& fit, const FitOptions& options, const Refit& refit);

}  // namespace mixity
