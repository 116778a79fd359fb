// Fits as text: for a terminal, in the style of lmfit's fit_report, and as lines that page and summary also show.
#pragma once

#include <string>
#include <vector>

#include "analysis/result.h"

namespace mixity {

std::string to_text(const Analysis& result);

// ---- Parts of a fit (fit_statistics_text.cc); empty where the fit has none. ----

/// "0.00228 .. 0.00233", rounded to `width`. `open` replaces an open end, `bound` follows one at a bound.
std::string ends_text(const ShownInterval& interval, double width, const char* open, const char* bound);
/// "   95% 0.00228 .. 0.00233", rounded to the interval's own width. If the value is not believed and lies outside,
/// since the interval is that of possible causes: "   95% 0.00228 .. 0.00233 if a cause is fitted".
std::string interval_text(const FittedParameter& parameter);
/// "0.9999", or the reason why there is none.
std::string shown_r2(const std::optional<double>& r2);
/// One line on the paper's fit of the same data.
std::string paper_text(const FitResult& fit);
/// A few lines: bootstrap intervals, and the points and runs with most influence.
std::string resampling_text(const FitResult& fit, const Dataset& data);
/// The errors that are not stated: "A 0.0041 mm^2 + 0.3 %, T 0.21 mN, from scatter"; empty if all are stated.
std::string estimated_errors(const StandardErrors& errors, const DisplayUnits& units);
/// The cost of correlated neighbours: "neighbours correlate by 0.6: as good as 100 of 400 points"; empty without it.
std::string correlation_text(const FitResult& fit);
/// How many standard errors of 0 were replaced, and by what: one clause for T and one for A.
std::vector<std::string> raised_errors(const StandardErrors& errors);
/// The source of standard errors and correlations, and the loss, one a line.
std::string errors_text(const FitResult& fit, const Dataset& data, Wording words);
/// A residual of A(T), in the unit of A; 0 for a rounding error.
std::string area_error_text(double error, const Dataset& data);
std::string comparison_text(const Analysis& result);
std::string per_curve_text(const Analysis& result);

// ---- Error budget and consistency (budget_text.cc): lines without a line end; empty where nothing was tested. ----

/// The parts of the parameter's variance, the deviations of uncertain constants from their priors, and the effect of
/// constants taken as exact.
std::vector<std::string> budget_lines(const FitResult& fit);
/// For a constant with a prior: "stated 2.13 +/- 0.10, moved by -0.05 of that error".
std::string prior_text(const FittedParameter& parameter, const std::optional<Budget>& budget);
/// Posterior, credible interval and evidence.
std::string posterior_line(const FitResult& fit);
/// The tests of the residuals, the constants that the data suggest to free, and the points beyond the last equilibrium.
std::vector<std::string> consistency_lines(const FitResult& fit, const Dataset& data);
/// All of these, after the reason why the fit is suspect.
std::vector<std::string> budget_and_consistency(const FitResult& fit, const Analysis& result);
/// One sentence on the areas without shear compared with JKR.
std::string unsheared_sentence(const UnshearedTest& test);

}  // namespace mixity
