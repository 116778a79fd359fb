// The statistics of a fit as JSON: intervals, comparison of models, fits of each run.
#pragma once

#include <nlohmann/json.hpp>

#include "analysis/result.h"

namespace mixity {

using Json = nlohmann::ordered_json;

inline Json number_or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

/// Everything that was found about one data set.
Json dataset_json(const Analysis& result);
/// Names and paths may hold bytes that are not UTF-8; they are replaced rather than thrown over.
std::string json_text(const Json& document);

/// `data`: which the rows are of; null for other files.
Json excluded_json(const std::vector<Excluded>& excluded, const Dataset* data);
Json interval_json(const std::optional<ShownInterval>& interval);
Json errors_json(const FitResult& fit);
Json bootstrap_json(const FittedParameter& parameter, const FitResult& fit);
Json influence_json(const FitResult& fit, const Dataset& data);
Json correlations_json(const FitResult& fit);
/// What was known of a constant of the experiment beforehand.
Json prior_json(const FittedParameter& parameter);
Json evidence_json(const FitResult& fit);
Json budget_json(const FitResult& fit);
Json consistency_json(const FitResult& fit, const Dataset& data);
Json unsheared_json(const std::optional<UnshearedTest>& test);
/// Those that are stated, in SI; a standard error of 0 says that one is taken as exact.
Json constants_json(const Dataset& data);
Json comparison_json(const Analysis& result);
Json per_curve_json(const Analysis& result);

}  // namespace mixity
