// The areas that a candidate predicts at measured loads, and how well.
#pragma once

#include <span>
#include <vector>

#include "fitting/model_problem.h"
#include "fitting/result.h"

namespace mixity {

/// The model that was fitted. Throws std::invalid_argument where there is none with this key.
ContactModel model_of(const FitResult& fit);

/// These constants with those that were fitted as found. Each of `parameters` has a value.
Constants with_fitted(Constants constants, const Dataset& data, const std::vector<FittedParameter>& parameters);

/// A finished fit, all of whose parameters have values, as what it tried out. `options`: those of the fit, for
/// constants that were not free.
Candidate fitted_candidate(const Dataset& data, const ContactModel& model, const FitResult& fit,
                           const FitOptions& options);

/// As it would be measured, dimensionless: beyond the last equilibrium the area at the fold, below pull-off that of no
/// contact; 0 where the law defines no equilibrium with these parameters. A load within kFoldWidth of that of the fold
/// is at the fold.
struct PredictedArea {
  enum class State { equilibrium, beyond_fold, below_pull_off, undefined } state;
  double value;
};

/// At loads as they are read, which neighbours share.
std::vector<PredictedArea> predicted_areas(const ContactModel& model, const Candidate& candidate,
                                           std::span<const double> P, std::span<const double> T);

/// The same at points of a data set, indices into Dataset::points.
std::vector<PredictedArea> predicted_areas(const ContactModel& model, const Candidate& candidate, const Dataset& data,
                                           const std::vector<std::size_t>& points);

/// Of a whole fit, at the points it used.
AreaGoodness area_goodness(const Dataset& data, const std::vector<std::size_t>& used, const ContactModel& model,
                           const Candidate& candidate);

}  // namespace mixity
