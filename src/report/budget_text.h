// What a fit's error is made of and whether the data are consistent, as sentences for text, page and summary.
#pragma once

#include <string>
#include <vector>

#include "analysis/result.h"

namespace mixity {

/// Where the variance of the parameter comes from, how far uncertain constants moved, and what constants that were
/// taken as exact would do to it; empty without a budget.
std::vector<std::string> budget_lines(const FitResult& fit);

/// Of a constant with a prior: "stated 2.13 +/- 0.10, moved by -0.05 of that error".
std::string prior_text(const FittedParameter& parameter, const std::optional<Budget>& budget);

/// Posterior, credible interval and evidence; empty without them.
std::string posterior_line(const FitResult& fit);

/// What the tests of the residuals say, which constants the data ask to be free, and where points lie beyond the last
/// equilibrium; empty where nothing was tested.
std::vector<std::string> consistency_lines(const FitResult& fit, const Dataset& data);

/// Both, with what makes the fit suspect first.
std::vector<std::string> budget_and_consistency(const FitResult& fit, const Analysis& result);

/// The areas without shear against JKR, in one sentence.
std::string unsheared_sentence(const UnshearedTest& test);

}  // namespace mixity
