#include <algorithm>
#include <stdexcept>

#include "fitting/consistency.h"
#include "fitting/fit.h"
#include "fitting/fitter.h"

namespace mixity {
namespace {

FitResult fit(const Dataset& data, std::string_view model, const FitOptions& options, Purpose purpose,
              const std::vector<std::size_t>* points, const std::vector<FittedParameter>* near) {
  const auto found = ContactModel::find(model);
  if (!found) throw std::invalid_argument("there is no model '" + std::string(model) + "'");
  return Fitter(data, *found, options, purpose, points, near).run();
}

}  // namespace

FitResult fit_and_test(const Dataset& data, std::string_view model, const FitOptions& options,
                       const std::vector<std::size_t>* points) {
  return fit(data, model, options, Purpose::shown, points, nullptr);
}

void find_cause(const Dataset& data, FitResult& result, const FitOptions& options, bool left_behind) {
  if (!result.consistency) return;
  const Refit refit = [&](const FitOptions& with, const std::vector<std::size_t>& points,
                          const std::vector<FittedParameter>* near) {
    return fit(data, result.model, with, Purpose::tried, &points, near);
  };
  FitOptions values = value_only(options);
  // Errors that are not estimated with the fit are the same for each explanation.
  values.fitted_errors &= result.errors && result.errors->freedom > 0;
  const auto [reason, explained] = diagnose(data, result, values, refit, left_behind);
  if (reason.empty()) return;
  result.explained = explained;
  result.message += (result.message.empty() ? "" : "; ") + reason;
}

FitResult fit_model(const Dataset& data, std::string_view model, const FitOptions& options,
                    const std::vector<std::size_t>* points) {
  FitResult result = fit_and_test(data, model, options, points);
  find_cause(data, result, options);
  return result;
}

FitResult refit_model(const Dataset& data, const FitResult& whole, const FitOptions& options,
                      const std::vector<std::size_t>& points) {
  FitOptions values = value_only(options);
  if (whole.errors) values.errors = std::make_shared<StandardErrors>(*whole.errors);
  // Only with a curvature at its minimum the fit to fewer data has its minimum nearby.
  const bool smooth = std::all_of(whole.parameters.begin(), whole.parameters.end(), [](const FittedParameter& one) {
    return one.value && (one.held || one.at_bound || one.stderr_);
  });
  if (smooth) {
    FitResult near = fit(data, whole.model, values, Purpose::values, &points, &whole.parameters);
    if (near.status != FitStatus::not_converged) return near;
  }
  return fit(data, whole.model, values, Purpose::values, &points, nullptr);
}

}  // namespace mixity
