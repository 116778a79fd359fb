// Points, fits, residuals and predicted curves as CSV. Headers are part of the interface: see README.md in this folder.
#pragma once

#include <string>
#include <vector>

#include "analysis/result.h"

namespace mixity {

/// One row per data set, model and parameter.
std::string fits_csv(const std::vector<Analysis>& results);

/// One row per model and used point: the measured value, the model's prediction, and the difference.
std::string residuals_csv(const Analysis& result);
/// One row per model and pull-off load: the measured value, the model's, and the residual in standard errors.
std::string pull_off_csv(const Analysis& result);
/// Predicted curves of every fitted model: A(T) at each load of the data, or f(psi) without loads.
std::string curves_csv(const Analysis& result);

// The same for several data sets, each row with the data set's name and units; fields that need loads are empty for
// data sets without.
std::string residuals_table(const std::vector<Analysis>& results);
std::string curves_table(const std::vector<Analysis>& results);

/// The usable points as a file that can be read again, in the units of the input files: curve, P, T, A and the standard
/// errors stated for all points; psi and Gc_over_GIc without loads.
std::string used_csv(const Dataset& data);

}  // namespace mixity
