#include "fitting/prediction.h"

#include <cmath>

#include "fitting/predicted_area.h"

namespace mixity {
namespace {

/// What a fold of the contact is as measured, where constants were fitted.
Fold measured(Fold fold, const Constants& c) {
  const ConstantsScale scale(c);
  fold.T = fold.T / scale.force - scale.shear_offset;
  fold.A = scale.measured_area(fold.A);
  fold.u *= std::exp(c[kRadius] + 2.0 / 3 * (c[kToughness] - c[kModulus] - c[kRadius]));  // R/xi^2
  fold.area_after = fold.area_after > 0 ? scale.measured_area(fold.area_after) : 0;
  return fold;
}

/// The folds under one control; says why there is no curve.
std::vector<Fold> folds_at(const Dataset& data, const ContactModel& model, const FitResult& fit,
                           const FitOptions& options, double P, Control control, std::string& problem) {
  const Candidate candidate = fitted_candidate(data, model, fit, options);
  const Constants& c = candidate.constants;
  const double load = ConstantsScale(c).load(P);
  problem = model.problem(candidate.parameters, load);
  if (!problem.empty()) return {};
  control.stiffness /= std::exp(2.0 / 3 * (c[kModulus] + c[kRadius]) + c[kToughness] / 3);  // of xi^2 G_Ic
  std::vector<Fold> folds;
  for (const Fold& fold : model.folds(candidate.parameters, load, control)) folds.push_back(measured(fold, c));
  return folds;
}

}  // namespace

std::vector<AreaPrediction> predict_areas_of(const Dataset& data, const FitResult& fit, const FitOptions& options,
                                             std::span<const double> P, std::span<const double> T) {
  if (!has_all_values(fit)) return {};
  const ContactModel model = model_of(fit);
  const auto at_all = [&](const FitResult& with) {
    return predicted_areas(model, fitted_candidate(data, model, with, options), P, T);
  };
  const std::vector<Derived> numbers = propagate(fit, [&](const FitResult& with) {
    std::vector<std::optional<double>> values;
    for (const PredictedArea& area : at_all(with))
      values.push_back(area.state == PredictedArea::State::equilibrium ? std::optional(area.value) : std::nullopt);
    return values;
  });
  std::vector<AreaPrediction> predictions;
  for (const PredictedArea& area : at_all(fit)) {
    const Derived& number = numbers[predictions.size()];
    const EquilibriumStatus none =
        area.state == PredictedArea::State::undefined ? EquilibriumStatus::invalid : EquilibriumStatus::no_equilibrium;
    predictions.push_back(
        {number.value ? EquilibriumStatus::ok : none, number.value.value_or(0), number.standard_error});
  }
  return predictions;
}

FoldsPrediction predict_folds_of(const Dataset& data, const FitResult& fit, const FitOptions& options, double P,
                                 const std::vector<Control>& controls) {
  if (!has_all_values(fit)) return {{}, "the fit has no values"};
  const ContactModel model = model_of(fit);
  FoldsPrediction predicted;
  for (const Control control : controls) {
    const std::vector<Fold> folds = folds_at(data, model, fit, options, P, control, predicted.problem);
    if (!predicted.problem.empty()) return predicted;
    const std::vector<Derived> numbers = propagate(fit, [&](const FitResult& near) {
      std::string ignored;
      const std::vector<Fold> same = folds_at(data, model, near, options, P, control, ignored);
      std::vector<std::optional<double>> values(3 * folds.size());
      // a fold that appears or goes within a thousandth of a standard error has no derivative
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
