// Whether the data are what a fit takes them for: tests of its residuals (consistency.cc), and what explains it when
// one of them fails (diagnosis.cc).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "dataset/dataset.h"
#include "fitting/result.h"

namespace mixity {

/// A test fails where so much happens by chance in one of a thousand consistent experiments.
inline constexpr double kChance = 1e-3;

/// What a residual's standard error is: 1 where errors are known, else as they scatter about the fit.
double residual_unit(const FitResult& fit);

/// Of a fit that has residuals.
Consistency test_consistency(const Dataset& data, const FitResult& fit);

/// The constant that chi^2 would gain most from, if that is more than chance gives; else null.
const ExactConstant* wrong_constant(const FitResult& fit);

/// Whether more points lie beyond the last equilibrium than noise puts there.
bool slides(const FitResult& fit);

/// Whether the residuals are far larger than neighbours scatter.
bool is_far(const ResidualTests& tests);

/// Which test of the fit's constants and residuals fails, as a sentence with a remedy; empty if none does.
Message failed_test(const FitResult& fit);

/// A fit of the same model to some points, for its values; from `near` where that is not null.
using Refit = std::function<FitResult(const FitOptions& options, const std::vector<std::size_t>& points,
                                      const std::vector<FittedParameter>* near)>;

/// What explains best why tests of this fit fail, and the remedy, in one sentence: a constant of the experiment that is
/// wrong, points past the onset of sliding, errors that are too small, a model that is wrong. Empty if none fails. Of a
/// model that another one leaves far behind only a constant that explains everything is of interest.
struct Diagnosis {
  Message reason;
  std::optional<double> explained{};  // the cost with the constant free that explains all
};
Diagnosis diagnose(const Dataset& data, const FitResult& fit, const FitOptions& options, const Refit& refit,
                   bool left_behind);

}  // namespace mixity
