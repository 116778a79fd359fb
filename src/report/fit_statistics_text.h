// The statistics of a fit as text: intervals, errors, comparison of models, fits of each run.
#pragma once

#include <string>
#include <vector>

#include "analysis/result.h"

namespace mixity {

/// "   95% 0.00228..0.00233", rounded to the interval's own width; empty without one.
std::string interval_text(const FittedParameter& parameter);
/// "0.9999", or why there is none.
std::string shown_r2(const std::optional<double>& r2);
/// The paper's fit of the same data: a line, or nothing.
std::string paper_text(const FitResult& fit);
/// Bootstrap intervals and what moves the fit most: a few lines, or nothing.
std::string resampling_text(const FitResult& fit, const Dataset& data);
/// Where relative errors that nobody stated come from: "estimated from ...".
std::string origin_of_scatter(const StandardErrors& errors);
/// What stands for standard errors of 0: a clause for T and one for A, or none.
std::vector<std::string> raised_errors(const StandardErrors& errors);
/// Where the standard errors come from, correlations, the loss: a line each, or nothing.
std::string errors_text(const FitResult& fit, const Dataset& data, Wording words);
std::string comparison_text(const Analysis& result);
std::string per_curve_text(const Analysis& result);

}  // namespace mixity
