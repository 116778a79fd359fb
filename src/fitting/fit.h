// One model fitted to one data set.
#pragma once

#include <string_view>
#include <vector>

#include "fitting/result.h"

namespace mixity {

/// `points`: indices of the points to fit, all if null. Throws std::invalid_argument for a model that is none of
/// model_keys(), and InputError if a parameter is to be held at a value that is out of range or not stated, if the
/// objective needs what the data set does not have, or if a point lacks a standard error.
FitResult fit_model(const Dataset& data, std::string_view model, const FitOptions& options = {},
                    const std::vector<std::size_t>* points = nullptr);

/// The two steps of fit_model. After the first a fit whose tests fail is `suspect`; the second adds the explanation to
/// the message, if any. `left_behind`: see diagnose in consistency.h.
FitResult fit_and_test(const Dataset& data, std::string_view model, const FitOptions& options,
                       const std::vector<std::size_t>* points = nullptr);
void find_cause(const Dataset& data, FitResult& fit, const FitOptions& options, bool left_behind = false);

/// A refit to almost the same data, for its values. Starts from the minimum of `whole`; searches the whole range if
/// that fails, or if a parameter of `whole` has no standard error. The same exceptions.
FitResult refit_model(const Dataset& data, const FitResult& whole, const FitOptions& options,
                      const std::vector<std::size_t>& points);

}  // namespace mixity
