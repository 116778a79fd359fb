#include "fitting/prediction.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "fitting/predicted_area.h"

namespace mixity {
namespace {

/// Free parameters with standard errors, in the order of FitResult::correlations; empty if one has none.
std::vector<std::size_t> uncertain_parameters(const FitResult& fit) {
  std::vector<std::size_t> free;
  for (std::size_t k = 0; k < fit.parameters.size(); ++k) {
    if (fit.parameters[k].held) continue;
    if (!fit.parameters[k].stderr_) return {};
    free.push_back(k);
  }
  return free;
}

/// Numbers that follow from a fit, null where they do not exist; their count is constant.
using Follows = std::function<std::vector<std::optional<double>>(const FitResult&)>;

/// Standard errors to first order (delta method): finite differences of a thousandth of a standard error, with the
/// covariance of all fitted parameters and constants; one-sided where a number exists on one side only. Calls `follows`
/// with the fit and four times for each free parameter. No standard errors if any parameter has none.
std::vector<Derived> propagate(const FitResult& fit, const Follows& follows) {
  std::vector<Derived> numbers;
  for (const std::optional<double>& value : follows(fit)) numbers.push_back({value, {}});
  const std::vector<std::size_t> free = uncertain_parameters(fit);
  if (free.empty()) return numbers;
  constexpr double kStep = 1e-3;            // standard errors
  std::vector<std::vector<double>> slopes;  // derivatives times standard errors, [parameter][number]
  std::vector<bool> linear(numbers.size(), true);
  for (const std::size_t k : free) {
    const FittedParameter& parameter = fit.parameters[k];
    const auto moved = [&](double steps) {
      FitResult one = fit;
      one.parameters[k].value =
          std::clamp(*parameter.value + steps * kStep * *parameter.stderr_, parameter.lower, parameter.upper);
      return std::pair(follows(one), (*one.parameters[k].value - *parameter.value) / *parameter.stderr_);
    };
    for (const double whole : {-1 / kStep, 1 / kStep}) {
      const auto there = moved(whole).first;
      for (std::size_t i = 0; i < numbers.size(); ++i) linear[i] = linear[i] && there[i];
    }
    const auto [below, down] = moved(-1);
    const auto [above, up] = moved(1);
    std::vector<double>& slope = slopes.emplace_back();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const double at = numbers[i].value.value_or(0), from = below[i].value_or(at), to = above[i].value_or(at);
      const double width = (above[i] ? up : 0) - (below[i] ? down : 0);
      slope.push_back(width > 0 ? (to - from) / width : 0);
    }
  }
  const std::size_t p = free.size();
  const auto correlation = [&](std::size_t k, std::size_t l) {
    return k == l ? 1 : fit.correlations.size() == p * p ? fit.correlations[k * p + l] : 0;
  };
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!numbers[i].value || !linear[i]) continue;
    double variance = 0;
    for (std::size_t k = 0; k < p; ++k)
      for (std::size_t l = 0; l < p; ++l) variance += slopes[k][i] * slopes[l][i] * correlation(k, l);
    numbers[i].standard_error = std::sqrt(std::max(variance, 0.0));
  }
  return numbers;
}

/// A fold in measured quantities, corrected by the fitted constants.
Fold measured(Fold fold, const Constants& c) {
  const ConstantsScale scale(c);
  fold.T = scale.measured_shear(fold.T);
  fold.A = scale.measured_area(fold.A);
  fold.u /= scale.displacement;
  fold.area_after = fold.area_after > 0 ? scale.measured_area(fold.area_after) : 0;
  return fold;
}

/// The folds under one control; sets `problem` if there is no curve.
std::vector<Fold> folds_at(const Dataset& data, const ContactModel& model, const FitResult& fit,
                           const FitOptions& options, double P, Control control, std::string& problem) {
  const Candidate candidate = fitted_candidate(data, model, fit, options);
  const Constants& c = candidate.constants;
  const double load = ConstantsScale(c).load(P);
  const ContactModel scaled = at_scale(model, ConstantsScale(c));
  problem = scaled.problem(candidate.parameters, load);
  if (!problem.empty()) return {};
  control.stiffness /= std::exp(2.0 / 3 * (c[kModulus] + c[kRadius]) + c[kToughness] / 3);  // of xi^2 G_Ic
  std::vector<Fold> folds;
  for (const Fold& fold : scaled.folds(candidate.parameters, load, control)) folds.push_back(measured(fold, c));
  return folds;
}

/// Where the edge of an elliptic contact closes before a fold, in measured quantities; without standard errors.
std::optional<ClosingPrediction> closing_at(const Dataset& data, const ContactModel& model, const FitResult& fit,
                                            const FitOptions& options, double P, Control control) {
  const Candidate candidate = fitted_candidate(data, model, fit, options);
  const ConstantsScale scale(candidate.constants);
  const auto end = model.closing(candidate.parameters, scale.load(P), control);
  if (!end) return std::nullopt;
  return ClosingPrediction{control,
                           end->kind,
                           {scale.measured_shear(end->T)},
                           {end->u / scale.displacement},
                           {scale.measured_area(pi<double>() * end->a * end->b)}};
}

}  // namespace

std::vector<AreaPrediction> predict_areas_of(const Dataset& data, const FitResult& fit, const FitOptions& options,
                                             std::span<const double> P, std::span<const double> T) {
  if (!has_all_values(fit)) return {};
  const ContactModel model = model_of(data, fit);
  const auto at_all = [&](const FitResult& with) {
    return predicted_areas(model, fitted_candidate(data, model, with, options), P, T);
  };
  const std::size_t n = P.size();
  const std::vector<Derived> numbers = propagate(fit, [&](const FitResult& with) {
    std::vector<std::optional<double>> values;
    const std::vector<PredictedArea> areas = at_all(with);
    for (const PredictedArea& area : areas)
      values.push_back(area.state == PredictedArea::State::equilibrium ? std::optional(area.value) : std::nullopt);
    if (!model.is_elliptic()) return values;
    values.resize(3 * n);
    for (std::size_t i = 0; i < n; ++i) {
      if (!values[i] || !std::isfinite(areas[i].q)) continue;
      values[n + i] = std::sqrt(*values[i] / pi<double>()) * std::exp(0.5 * areas[i].q);
      values[2 * n + i] = std::sqrt(*values[i] / pi<double>()) * std::exp(-0.5 * areas[i].q);
    }
    return values;
  });
  std::vector<AreaPrediction> predictions;
  for (const PredictedArea& area : at_all(fit)) {
    const Derived& number = numbers[predictions.size()];
    const EquilibriumStatus none =
        area.state == PredictedArea::State::undefined ? EquilibriumStatus::invalid : EquilibriumStatus::no_equilibrium;
    predictions.push_back(
        {number.value ? EquilibriumStatus::ok : none, number.value.value_or(0), number.standard_error});
    if (const std::size_t i = predictions.size() - 1; numbers.size() == 3 * n) {
      predictions[i].a = numbers[n + i];
      predictions[i].b = numbers[2 * n + i];
    }
  }
  return predictions;
}

FoldsPrediction predict_folds_of(const Dataset& data, const FitResult& fit, const FitOptions& options, double P,
                                 const std::vector<Control>& controls) {
  if (!has_all_values(fit)) return {{}, {}, "the fit has no values"};
  const ContactModel model = model_of(data, fit);
  FoldsPrediction predicted;
  for (const Control control : controls) {
    const std::vector<Fold> folds = folds_at(data, model, fit, options, P, control, predicted.problem);
    if (!predicted.problem.empty()) return predicted;
    const std::vector<Derived> numbers = propagate(fit, [&](const FitResult& near) {
      std::string ignored;
      const std::vector<Fold> same = folds_at(data, model, near, options, P, control, ignored);
      std::vector<std::optional<double>> values(3 * folds.size());
      // a fold that appears or disappears within a thousandth of a standard error has no derivative
      for (std::size_t i = 0; same.size() == folds.size() && i < folds.size(); ++i) {
        values[3 * i] = same[i].T;
        values[3 * i + 1] = same[i].u;
        values[3 * i + 2] = same[i].A;
      }
      return values;
    });
    for (std::size_t i = 0; i < folds.size(); ++i)
      predicted.folds.push_back({control, folds[i].place.maximum, numbers[3 * i], numbers[3 * i + 1],
                                 numbers[3 * i + 2], folds[i].psi, folds[i].jumps_to, folds[i].area_after});
    if (auto closing = closing_at(data, model, fit, options, P, control)) {
      const std::vector<Derived> at = propagate(fit, [&](const FitResult& near) -> std::vector<std::optional<double>> {
        const auto same = closing_at(data, model, near, options, P, control);
        if (!same || same->end != closing->end) return std::vector<std::optional<double>>(3);
        return {same->T.value, same->u.value, same->A.value};
      });
      closing->T = at[0];
      closing->u = at[1];
      closing->A = at[2];
      predicted.closings.push_back(*closing);
    }
  }
  return predicted;
}

std::optional<FoldPrediction> predict_jump_of(const Dataset& data, const FitResult& fit, const FitOptions& options,
                                              double P) {
  for (FoldPrediction& fold : predict_folds_of(data, fit, options, P, {{Control::Kind::load}}).folds)
    if (fold.on_loading) return std::move(fold);
  return std::nullopt;
}

}  // namespace mixity
