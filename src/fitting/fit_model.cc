#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/number_text.h"
#include "base/phrases.h"
#include "fitting/assumed_ratio.h"
#include "fitting/consistency.h"
#include "fitting/explanations.h"
#include "fitting/fit.h"
#include "fitting/fitter.h"
#include "mechanics/contact_model.h"
#include "mechanics/ellipse.h"
#include "statistics/distributions.h"

namespace mixity {
namespace {

FitResult fit(const Dataset& data, std::string_view model, const FitOptions& options, Purpose purpose,
              const std::vector<std::size_t>* points, const std::vector<FittedParameter>* near) {
  const auto found = ContactModel::find(model);
  if (!found) throw std::invalid_argument("there is no model '" + std::string(model) + "'");
  return Fitter(data, data.under_control(*found), options, purpose, points, near).run();
}

/// Where several explanations do about as well, the interval includes the value of each. That of a fit that is not
/// suspect remains part of it.
void show_union(FitResult& fit) {
  const bool believed = fit.status == FitStatus::ok;
  if (fit.explanations.size() < (believed ? 1 : 2)) return;
  const auto first = std::find_if(fit.parameters.begin(), fit.parameters.end(), [&](const FittedParameter& one) {
    return one.name == fit.explanations[0].first.name;
  });
  if (first == fit.parameters.end() || !first->interval || !first->stderr_) return;
  const double quantile = std::sqrt(chi_squared_quantile(first->interval->confidence, 1));
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Explanation& one : fit.explanations) {
    if (!one.first.value) continue;
    const double half = quantile * one.first.stderr_.value_or(0);
    low = std::min(low, *one.first.value - half);
    high = std::max(high, *one.first.value + half);
  }
  if (!(low < high)) return;
  low = std::max(low, first->lower);
  high = std::min(high, first->upper);
  if (!believed) {
    first->interval = {"explanations", first->interval->confidence, low, high, EndStatus::found, EndStatus::found};
    return;
  }
  first->interval->method = "explanations";
  if (first->interval->low_status == EndStatus::found) first->interval->low = std::min(low, *first->interval->low);
  if (first->interval->high_status == EndStatus::found) first->interval->high = std::max(high, *first->interval->high);
}

/// A parameter of one mode of an elliptic contact.
bool is_coupling(std::string_view parameter) { return parameter.ends_with("_II") || parameter.ends_with("_III"); }

/// Where an elliptic contact with tied couplings fails its tests and passes them without the tie: both couplings.
std::optional<Diagnosis> without_tie(const Dataset& data, const FitResult& result, FitOptions options) {
  const ContactModel model = ContactModel::find(result.model).value();
  if (!model.is_elliptic() || failed_test(data, result).empty()) return std::nullopt;
  std::string key = result.model;
  const bool equal = key.ends_with(kEqualEllipse);
  if (equal) key.replace(key.size() - kEqualEllipse.size(), kEqualEllipse.size(), kEllipse);
  const std::size_t held = std::erase_if(options.hold, [&](const HeldParameter& one) { return is_coupling(one.name); });
  if (!equal && held == 0) return std::nullopt;
  const std::vector<std::size_t> used = result.used.list();
  const FitResult without = fit(data, key, options, Purpose::tried, &used, nullptr);
  if (!is_found(without) || !explains(data, without)) return std::nullopt;
  std::vector<std::string> couplings;
  for (const FittedParameter& one : without.parameters)
    if (one.value && is_coupling(one.name)) couplings.push_back(one.name + " = " + rounded(*one.value, 4));
  return Diagnosis{
      "the couplings differ: without the tie " + joined(couplings, " and ") + " describe the points", {}, {}};
}

}  // namespace

FitResult fit_and_test(const Dataset& data, std::string_view model, const FitOptions& options,
                       const std::vector<std::size_t>* points) {
  return fit(data, model, options, Purpose::shown, points, nullptr);
}

void find_cause(const Dataset& data, FitResult& result, const FitOptions& options, std::optional<double> to_beat) {
  if (result.status == FitStatus::ok && options.checks) {
    const Message ratio = ratio_of_errors_matters(data, result, [&](const Dataset& other) {
      const std::vector<std::size_t> used = result.used.list();
      return fit(other, result.model, value_only(options), Purpose::values, &used, nullptr);
    });
    if (!ratio.empty()) {
      result.status = FitStatus::suspect;
      result.message = ratio;
    }
  }
  if (!result.consistency) return;
  const Refit refit = [&](const Dataset& of, const FitOptions& with, const std::vector<std::size_t>& points,
                          const std::vector<FittedParameter>* near) {
    return fit(of, result.model, with, Purpose::tried, &points, near);
  };
  const auto untied = to_beat ? std::nullopt : without_tie(data, result, value_only(options));
  Diagnosis found = untied ? *untied : diagnose(data, result, value_only(options), refit, to_beat);
  // a status that says more than that tests fail has its own message
  if (found.passes && result.status == FitStatus::suspect && result.message.empty()) result.status = FitStatus::ok;
  if (found.reason.empty() && result.status == FitStatus::ok && options.checks) {
    found = second_thought(data, result, value_only(options), refit);
    if (!found.reason.empty())
      result.status = FitStatus::suspect;
    else
      found = included(data, result, value_only(options), refit);
  }
  const auto& [reason, explained, explanations, passes] = found;
  if (reason.empty()) return;
  result.explained = explained;
  result.explanations = explanations;
  show_union(result);
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
  if (whole.errors) values.errors = whole.errors;
  // The fit to fewer data has its minimum nearby only if `whole` has a curvature at its minimum.
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
