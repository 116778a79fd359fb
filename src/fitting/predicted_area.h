// Predicted areas at measured loads, and their agreement with the data.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "fitting/model_problem.h"
#include "fitting/point_indices.h"
#include "fitting/result.h"

namespace mixity {

/// The model that was fitted, under the control of the data and with their own constants (at_scale). Throws
/// std::invalid_argument if its key is unknown.
ContactModel model_of(const Dataset& data, const FitResult& fit);

/// All constants of a fit; those among `parameters`, which must have values, as fitted.
Constants constants_of(const Dataset& data, const FitOptions& options, const std::vector<FittedParameter>& parameters);

/// The parameters and constants of a fit whose parameters all have values. `options`: those of the fit; they set the
/// constants that were not free.
Candidate fitted_candidate(const Dataset& data, const ContactModel& model, const FitResult& fit,
                           const FitOptions& options);

/// An area as it would be measured, dimensionless: beyond the last equilibrium the area at the fold; below pull-off the
/// reading without contact; 0 where the law defines no equilibrium with these parameters.
struct PredictedArea {
  enum class State { equilibrium, beyond_fold, below_pull_off, undefined } state;
  double value;
  double q = std::numeric_limits<double>::quiet_NaN();  // ln(a/b), 0 for circles; known before the last equilibrium
};

/// At measured loads; consecutive points with the same load are computed together.
std::vector<PredictedArea> predicted_areas(const ContactModel& model, const Candidate& candidate,
                                           std::span<const double> P, std::span<const double> T);

/// The same at these points of a data set.
std::vector<PredictedArea> predicted_areas(const ContactModel& model, const Candidate& candidate, const Dataset& data,
                                           const PointIndices& points);

struct Goodness {
  std::optional<double> r2;  // null if the targets do not vary or are fewer than two
  double rmse = 0, max_abs_residual = 0;
};

/// All spans have the same length > 0; `weights` are 1/standard error, or empty: 1. Residuals and targets are already
/// weighted. R^2 = 1 - SS_res/SS_tot about the weighted mean of the data.
Goodness goodness(std::span<const double> residuals, std::span<const double> targets,
                  std::span<const double> weights = {});

/// The goodness of the predicted areas at the points that a fit used.
AreaGoodness area_goodness(const Dataset& data, const PointIndices& used, const ContactModel& model,
                           const Candidate& candidate);

}  // namespace mixity
