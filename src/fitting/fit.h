// One model fitted to one data set, with its goodness of fit: what `mixity fit` reports.
#pragma once

#include <string_view>
#include <vector>

#include "fitting/result.h"

namespace mixity {

/// `points`: indices of the points to fit, all if null. Throws std::invalid_argument for a model that is none of
/// model_keys(), and InputError if a parameter is to be held at a value that is out of range or that the data set does
/// not state, if the objective needs what the data set does not have, or if a point lacks a standard error.
FitResult fit_model(const Dataset& data, std::string_view model, const FitOptions& options = {},
                    const std::vector<std::size_t>* points = nullptr);

/// Values alone, of almost the same data as `whole`, from the minimum of which it starts; from anywhere if that leads
/// nowhere, or if `whole` has a parameter without a standard error. The same exceptions.
FitResult refit_model(const Dataset& data, const FitResult& whole, const FitOptions& options,
                      const std::vector<std::size_t>& points);

}  // namespace mixity
