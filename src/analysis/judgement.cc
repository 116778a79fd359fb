#include "analysis/judgement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/number_text.h"
#include "base/phrases.h"
#include "dataset/check.h"
#include "fitting/causes.h"
#include "fitting/consistency.h"
#include "fitting/constants.h"
#include "fitting/fit.h"

namespace mixity {
namespace {

constexpr double kNearlyCertain = 0.999;  // an AICc weight

/// Null if the models were not compared.
const ComparedModel* comparison_of(const Analysis& result, const std::string& model) {
  const auto found = std::find_if(result.comparison.begin(), result.comparison.end(),
                                  [&](const ComparedModel& one) { return one.model == model; });
  return found == result.comparison.end() ? nullptr : &*found;
}

/// Areas without shear that have a toughness of their own, if the fit then is ok and that toughness differs.
std::optional<Explanation> own_toughness(const Dataset& data, const FitResult& fit, FitOptions options) {
  constexpr double kClearly = 3;  // standard errors
  options.free.push_back(kHysteresis);
  const FitResult own = fit_and_test(data, fit.model, options);
  const FittedParameter* const found = find_parameter(own.parameters, kConstantNames[kHysteresis]);
  if (own.status != FitStatus::ok || !found || !found->value || !found->stderr_) return std::nullopt;
  if (!(std::abs(*found->value) > kClearly * *found->stderr_)) return std::nullopt;
  return Explanation{
      found->name, "", hysteresis_text(*found->value), Remedy::set("unsheared", "own"), own.parameters.front(), 0};
}

}  // namespace

std::vector<Agreement> compare(const FitResult& fit, const FitRequest& request) {
  std::vector<Agreement> agreements;
  const auto published = request.published.find(fit.model);
  if (published == request.published.end()) return agreements;
  for (const Published& number : published->second) {
    std::optional<double> found;
    if (number.name == "r2") found = fit.r2;
    if (number.name == "chi2" && fit.known_errors) found = fit.sum_of_squares;
    if (const FittedParameter* const parameter = find_parameter(fit.parameters, number.name)) found = parameter->value;
    agreements.push_back({number, found && std::abs(*found - number.value) <= number.tolerance});
  }
  return agreements;
}

const ComparedModel* winner(const Analysis& result) {
  if (!preferences(result.comparison).agree()) return nullptr;
  for (const FitResult& fit : result.fits) {
    const ComparedModel* const compared = comparison_of(result, fit.model);
    if (compared && compared->weight.value_or(0) > kNearlyCertain && fit.status == FitStatus::ok) return compared;
  }
  return nullptr;
}

void reject_for_unsheared_areas(Analysis& result, const FitOptions& options) {
  constexpr double kLevel = 3e-4;  // keeps the false alarms of this additional test below one in a hundred
  const FitRequest& request = result.request;
  // With constants that are fitted or differ between runs, the areas need not agree with the stated ones.
  const bool as_stated = request.options.free.empty() && request.options.by_run.empty() && request.drift.empty() &&
                         request.exclusion.unsheared == Unsheared::in;
  if (!result.unsheared || !(result.unsheared->p_value < kLevel) || !as_stated) return;
  if (objective_of(result) != Objective::curve || result.request.options.loss != Loss::none) return;
  for (FitResult& fit : result.fits) {
    if (fit.status != FitStatus::ok) continue;
    fit.status = FitStatus::suspect;
    const Message contradiction = "the areas without shear do not agree with JKR and the constants as stated: ";
    if (auto own = own_toughness(result.data, fit, options)) {
      fit.message = contradiction + own->size + "; " + own->remedy;  // other constants do not explain these areas
      fit.explanations = {std::move(*own)};
    } else {
      fit.message += (fit.message.empty() ? Message() : Message("; ")) + contradiction +
                     "check modulus, toughness and the zeros of load and area, or state their standard errors";
    }
  }
}

void name_misfit_of_units(Analysis& result) {
  const auto fails = [](const FitResult& fit) { return fit.status != FitStatus::ok; };
  if (std::none_of(result.fits.begin(), result.fits.end(), fails) || !BelowHertz(result.data).most()) return;
  for (FitResult& fit : result.fits)
    if (fails(fit))
      fit.message +=
          (fit.message.empty() ? "" : "; ") +
          std::string(
              "most areas do not exceed that of Hertz at their load: a unit is probably off by a power of ten, that of "
              "A, P, radius, modulus or toughness");
}

void reject_for_better_model(Analysis& result) {
  constexpr double kNearlyNone = 1e-6;  // AICc weight
  constexpr double kMuchBetter = 10;    // in AICc
  const ComparedModel* const best = winner(result);
  if (!best) return;
  for (FitResult& fit : result.fits) {
    if (fit.model == best->model) continue;
    const bool far_behind =
        fit.status == FitStatus::ok && comparison_of(result, fit.model)->weight.value_or(1) < kNearlyNone;
    if (fit.status != FitStatus::suspect && !far_behind) continue;
    const auto explained = information_explained(fit);
    if (explained && explained->aicc && best->aicc && *explained->aicc < *best->aicc + kMuchBetter) {
      fit.message += "; model " + best->model + " would explain the points as well";
      continue;
    }
    fit.status = FitStatus::suspect;
    fit.outdone_by = best->model;
    fit.message = "model " + best->model + " describes these points far better (AICc weight above " +
                  shortest(kNearlyCertain) + ")";
  }
}

bool can_be_believed(const Analysis& result) {
  return std::all_of(result.fits.begin(), result.fits.end(),
                     [](const FitResult& fit) { return fit.status == FitStatus::ok || !fit.outdone_by.empty(); });
}

std::string no_best_model(const Analysis& result) {
  const Preferences preferred = preferences(result.comparison);
  for (const FitResult& fit : result.fits) {
    bool named = false;
    for (const auto* models : {&preferred.aicc, &preferred.evidence, &preferred.left_out})
      named |= std::find(models->begin(), models->end(), fit.model) != models->end();
    if (named && fit.status == FitStatus::suspect && fit.outdone_by.empty())
      return "the fit of " + fit.model + " is suspect, and no model is named best until that is resolved";
  }
  if (preferred.agree()) return {};
  std::string text, separator = "the criteria disagree, and no model is named best: ";
  for (const auto& [criterion, models] :
       {std::pair("AICc prefers ", preferred.aicc), std::pair("the evidence ", preferred.evidence),
        std::pair("the loads left out ", preferred.left_out)}) {
    if (models.empty()) continue;
    text += separator + criterion + joined(models, " and ") + (models.size() > 1 ? " alike" : "");
    separator = ", ";
  }
  return text;
}

std::vector<std::size_t> by_merit(const Analysis& result) {
  constexpr double kClose = 9.2;  // in AICc: a hundredth of the weight
  constexpr double kWorst = std::numeric_limits<double>::max();
  std::vector<double> aicc;  // of each fit; unlike the weight it does not underflow
  double least = kWorst;
  for (const FitResult& fit : result.fits) {
    const ComparedModel* const compared = comparison_of(result, fit.model);
    const double known = compared ? compared->aicc.value_or(kWorst / 2) : 0;
    aicc.push_back(has_all_values(fit) ? known : kWorst);
    least = std::min(least, aicc.back());
  }
  std::vector<std::size_t> order(result.fits.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto rank = [&](std::size_t i) {
    return aicc[i] > least + kClose ? 2 : result.fits[i].status != FitStatus::ok ? 1 : 0;
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return rank(i) != rank(j) ? rank(i) < rank(j) : aicc[i] < aicc[j];
  });
  return order;
}

}  // namespace mixity
