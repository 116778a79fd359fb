// The statistics of a fit as text: intervals, errors, comparison of models, fits of each run.
#pragma once

#include <string>

#include "fitting/fit_definition.h"

namespace mixity {

/// "   95% 0.00228..0.00233", rounded to the interval's own width; empty without one.
std::string interval_text(const FittedParameter& parameter);
/// Bootstrap intervals and what moves the fit most: a few lines, or nothing.
std::string resampling_text(const FitResult& fit, const Dataset& data);
/// Where relative errors that nobody stated come from: "estimated from ...".
std::string origin_of_scatter(const StandardErrors& errors);
/// Where the standard errors come from, correlations, the loss: a line each, or nothing.
std::string errors_text(const FitResult& fit, const Dataset& data);
std::string comparison_text(const JobResult& result);
std::string per_curve_text(const JobResult& result);

}  // namespace mixity
