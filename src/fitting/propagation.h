// What a fit does not know, carried over to anything that follows from it.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "fitting/result.h"

namespace mixity {

/// A number that follows from a fit, and its standard error; null where it has none.
struct Derived {
  std::optional<double> value{}, standard_error{};
};

/// What follows from a fit: numbers, each null where it does not exist.
using Follows = std::function<std::vector<std::optional<double>>(const FitResult&)>;

/// To first order (delta method): derivatives by differences, a thousandth of a standard error wide, on the covariance
/// of all fitted parameters and constants; one-sided where a number exists on one side only. `follows` is called with
/// the fit and twice for each free parameter, and returns as many numbers each time. Without standard errors (a
/// parameter at its bound, not identifiable) numbers have none.
std::vector<Derived> propagate(const FitResult& fit, const Follows& follows);

}  // namespace mixity
