// One set of constants of the experiment for runs that each have parameters of their own.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "fitting/constants.h"
#include "fitting/options.h"
#include "fitting/result.h"

namespace mixity {

struct CommonConstants {
  Constants constants{};  // all of them, those that were fitted as found
  /// Of each run, the free parameters of the model with standard errors and intervals that hold those of the constants.
  std::vector<std::vector<FittedParameter>> own;
  double sum_of_squares = 0;        // as FitResult has it: of the data and of what is known beforehand
  std::size_t free_parameters = 0;  // of all runs together, without those that something is known of
};

/// `runs`: the points of each, with its own fit at constants near the common ones, from where it starts. Intervals of
/// up to 40 runs. Null if no minimum is found, or it does not determine what it fits. Not for data of energies.
std::optional<CommonConstants> fit_common_constants(const Dataset& data, std::string_view model,
                                                    const FitOptions& options, const Constants& near,
                                                    const std::vector<std::vector<std::size_t>>& runs,
                                                    const std::vector<FitResult>& fits);

}  // namespace mixity
