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

/// The two steps of it. After the first a fit whose tests fail is `suspect` and does not say why; the second finds what
/// explains it (consistency.h), or nothing to say. `left_behind`: by another model, which makes most causes idle.
FitResult fit_and_test(const Dataset& data, std::string_view model, const FitOptions& options,
                       const std::vector<std::size_t>* points = nullptr);
void find_cause(const Dataset& data, FitResult& fit, const FitOptions& options, bool left_behind = false);

/// Values alone, of almost the same data as `whole`, from the minimum of which it starts; from anywhere if that leads
/// nowhere, or if `whole` has a parameter without a standard error. The same exceptions.
FitResult refit_model(const Dataset& data, const FitResult& whole, const FitOptions& options,
                      const std::vector<std::size_t>& points);

}  // namespace mixity
