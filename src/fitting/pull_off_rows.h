// Residuals of pull-off loads: signed distances of measured (T, P_c), or (u, P_c), from the model's curve P_c(T), in
// standard errors. They stand behind those of areas and axes.
#pragma once

#include <span>
#include <vector>

#include "dataset/pull_off.h"
#include "fitting/model_problem.h"

namespace mixity {

/// As read, dimensionless.
struct MeasuredPullOff {
  HeldShear held;
  double P, shear, sigma_P, sigma_shear;  // sigma_P > 0, sigma_shear >= 0
};

/// A reading with its standard errors: those stated, `common` for a load without one, 0 for a shear without one. An
/// error of the load that is stated as 0 is `least`.
MeasuredPullOff measured_pull_off(const PullOffReading& reading, double common, double least);

/// The shear that is held, of the corrected reading, dimensionless by these constants.
double held_shear(const ConstantsScale& scale, HeldShear held, double reading);

/// Fills residuals and, unless it is empty, the rows of the Jacobian. False where the model has no such load.
bool pull_off_rows(const std::vector<MeasuredPullOff>& points, const FreeChoice& choice, const Candidate& at,
                   std::span<double> residuals, std::span<double> jacobian);

/// The largest |P| of the readings; 1 if all are 0.
double size_of_pull_off(const Dataset& data);

/// The standard error of loads where none is stated, before a fit: 1 % of the largest.
double assumed_pull_off_error(const Dataset& data);

}  // namespace mixity
