// Fits one model to one data set.
#pragma once

#include <string_view>
#include <vector>

#include "fitting/result.h"

namespace mixity {

/// `points`: indices of the points to fit, all if null. Throws std::invalid_argument for a model that is not in
/// model_keys(). Throws InputError if a parameter is to be held at a value that is out of range or not stated, if the
/// data set lacks what the objective needs, or if a point lacks a standard error.
FitResult fit_model(const Dataset& data, std::string_view model, const FitOptions& options = {},
                    const std::vector<std::size_t>* points = nullptr);

/// The two steps of fit_model. The first marks a fit whose tests fail as `suspect`; the second adds an explanation to
/// the message if there is one. `to_beat`: see diagnose in consistency.h.
FitResult fit_and_test(const Dataset& data, std::string_view model, const FitOptions& options,
                       const std::vector<std::size_t>* points = nullptr);
void find_cause(const Dataset& data, FitResult& fit, const FitOptions& options, std::optional<double> to_beat = {});

/// Refits almost the same data, for the values alone. Starts from the minimum of `whole`; searches the whole range if
/// that fails or if a parameter of `whole` has no standard error. Throws as fit_model does.
FitResult refit_model(const Dataset& data, const FitResult& whole, const FitOptions& options,
                      const std::vector<std::size_t>& points);

}  // namespace mixity
