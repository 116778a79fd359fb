// Refits that may explain why tests of a fit fail, without some of the points.
#pragma once

#include <optional>
#include <vector>

#include "fitting/consistency.h"

namespace mixity {

using Points = std::vector<std::size_t>;  // indices into Dataset::points

/// The fit that is to be explained, and how to refit its data.
struct Case {
  const Dataset& data;
  const FitResult& fit;
  const FitOptions& options;
  const Refit& refit;
  bool left_behind;  // see diagnose
};

/// Every n-th point if there are more than enough.
Points thinned(const Points& points, std::size_t enough);

/// A refit with a minimum and more points than parameters.
bool is_found(const FitResult& fit);

/// Sum of squares per degree of freedom, of which there is one at least.
double per_freedom(const FitResult& fit);

/// The fit of the points before the onset of sliding.
struct Cut {
  FitResult fit;
  std::size_t points, first;  // how many were left out; the first of them in the file
};
inline constexpr std::size_t kFew = 3;  // points that may lie behind an onset by chance
/// First fits the first half of each run, then all points that agree with the fit before. Null if fewer points than
/// `few` lie behind the onset, or if this does not settle.
std::optional<Cut> before_sliding(const Case& of, const Points& points, std::size_t few);

/// The fit without the points above nine tenths of each run's largest shear.
FitResult without_ends(const Case& of, const FitResult& whole, const Points& points);

/// Whether no test of the fit fails clearly: an explanation need not be perfect.
bool explains(const Dataset& data, const FitResult& fit);

}  // namespace mixity
