// Points, fits, residuals and predicted curves as CSV. Headers are a contract: see README.md beside this file.
#pragma once

#include <string>
#include <vector>

#include "analysis/result.h"

namespace mixity {

/// A row for each data set, model and parameter.
std::string fits_csv(const std::vector<Analysis>& results);

/// A row for each model and used point: what was measured, what the model predicts, and the difference.
std::string residuals_csv(const Analysis& result);
/// Predicted curves of every fitted model: A(T) at each load of the data, or f(psi) if it has no loads.
std::string curves_csv(const Analysis& result);

// The same of several data sets, each row with the data set's name and its units; fields that a data set without loads
// does not have are empty.
std::string residuals_table(const std::vector<Analysis>& results);
std::string curves_table(const std::vector<Analysis>& results);

/// The usable points as a file that can be read again, in the units of the files that were read: curve, P, T, A and the
/// standard errors that are stated of all points; psi and Gc_over_GIc without loads.
std::string used_csv(const Dataset& data);

}  // namespace mixity
