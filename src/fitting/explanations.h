// Refits to a part of the points that may explain why tests of a fit fail.
#pragma once

#include <optional>
#include <vector>

#include "fitting/consistency.h"

namespace mixity {

using Points = std::vector<std::size_t>;  // indices into Dataset::points

/// The fit to explain, and how to refit its data.
struct Case {
  const Dataset& data;
  const FitResult& fit;
  const FitOptions& options;
  const Refit& refit;
  std::optional<double> to_beat{};  // see diagnose
};

/// What does not explain a sample of many points does not explain all, except in one case of ten thousand: a cause is
/// tried on a sample of this size first.
inline constexpr std::size_t kTriedFirst = 200;
inline bool worth_a_sample(const Points& points) { return points.size() >= 5 * kTriedFirst; }

/// At most `enough` of the points, evenly spaced.
Points thinned(const PointIndices& points, std::size_t enough);
/// About as many, with the last point of each run, where points past the onset of sliding are.
Points thinned_from_ends(const Dataset& data, const Points& points, std::size_t enough);

/// Whether a refit reached a minimum with more points than parameters.
bool is_found(const FitResult& fit);

/// Sum of squares per degree of freedom, counted as at least one.
double per_freedom(const FitResult& fit);

/// The fit of the points before the onset of sliding.
struct Cut {
  FitResult fit;
  std::size_t points, first;          // number of points left out; the first of them in the file
  std::vector<std::size_t> onsets{};  // the first of each run that is cut
};
/// Where the runs are cut: points of the fit at the shear of the onsets and above, as lines to exclude. None if they
/// are too many to list.
Message cut_at(const std::vector<std::size_t>& onsets, const Dataset& data, const FitResult& fit);
inline constexpr std::size_t kFew = 3;  // points that may lie beyond an onset by chance
/// First fits the first half of each run, then repeatedly all points that agree with the last fit. Null if fewer than
/// `few` points lie beyond the onset, or if this does not converge.
std::optional<Cut> before_sliding(const Case& of, const Points& points, std::size_t few);

/// The fit without the points above nine tenths of each run's largest shear.
FitResult without_ends(const Case& of, const FitResult& whole, const Points& points);

inline constexpr double kHardly = 1e-5;  // a test with a lower p-value fails clearly
/// Whether no test of the fit has a p-value below `chance`. By default only those count that fail clearly: an
/// explanation need not be perfect.
bool explains(const Dataset& data, const FitResult& fit, double chance = kHardly);

}  // namespace mixity
