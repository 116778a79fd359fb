// Judges fits of several models to one data set: which model describes the data best, and which fits are suspect.
#pragma once

#include <string>
#include <vector>

#include "analysis/result.h"

namespace mixity {

struct Agreement {
  Published published;
  bool agrees;
};

/// Compares a fit with the published numbers of its model. A value that was not found does not agree.
std::vector<Agreement> compare(const FitResult& fit, const FitRequest& request);

/// The model that has status ok, an AICc weight above 0.999, and the preference of every criterion. Null if none has.
const ComparedModel* winner(const Analysis& result);

/// Sets fits of status ok to suspect if the areas without shear contradict JKR with the stated constants: these areas
/// do not depend on the model. Only for constants that are taken as stated, and objective curve without a loss.
/// `options`: of the fits. Names a toughness of these areas alone if that explains them.
void reject_for_unsheared_areas(Analysis& result, const FitOptions& options);

/// If most areas do not exceed Hertz's, says so in the messages of fits that are not ok.
void name_misfit_of_units(Analysis& result);

/// Sets fits to suspect, naming the winner, if they are suspect already or have an AICc weight below 1e-6. Exempts fits
/// that a wrong constant would explain almost as well as the winner does.
void reject_for_better_model(Analysis& result);

/// True if each fit has status ok or was rejected for a better model.
bool can_be_believed(const Analysis& result);

/// Why no model is named best: a preferred fit is suspect, or the criteria disagree. Empty if there is a best model.
std::string no_best_model(const Analysis& result);

/// Indices of the fits, best first. Fits within an AICc weight of 1/100 of the best are sorted by status ok, then by
/// AICc; then the others by AICc; fits without a value last. Ties keep their order.
std::vector<std::size_t> by_merit(const Analysis& result);

}  // namespace mixity
