// Energies whose standard errors nobody states: the distance from the law takes those of G_I and G_II as equal.
#pragma once

#include <functional>

#include "base/message.h"
#include "dataset/dataset.h"
#include "fitting/result.h"

namespace mixity {

/// Fits the values of the same model to other data.
using FitOfValues = std::function<FitResult(const Dataset&)>;

/// Empty unless the first parameter moves as far as counts (moves_or_widens) where the errors of G_II are a tenth or
/// ten times those of G_I: an error in both variables leaves the slope between them undetermined without their
/// ratio (Madansky, J. Am. Stat. Assoc. 54, 173 (1959)). Also empty where errors are stated.
Message ratio_of_errors_matters(const Dataset& data, const FitResult& fit, const FitOfValues& refit);

}  // namespace mixity
