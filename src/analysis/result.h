// The result of a request: a data set and the fits of all models to it.
#pragma once

#include <optional>
#include <vector>

#include "analysis/request.h"
#include "fitting/comparison.h"
#include "fitting/fit.h"
#include "fitting/unsheared.h"

namespace mixity {

struct Analysis {
  FitRequest request;
  Dataset data;
  std::vector<FitResult> fits;               // in the order of request.models
  std::vector<ComparedModel> comparison;     // empty with one model
  std::vector<PerCurve> per_curve;           // per model, if requested
  std::optional<UnshearedTest> unsheared{};  // if there are areas without shear
};

/// The objective of the fits: as requested, else the default of the data.
inline Objective objective_of(const Analysis& result) {
  return result.request.options.objective.value_or(default_objective(result.data));
}

}  // namespace mixity
