// The areas that a candidate predicts at measured loads, and how well.
#pragma once

#include <optional>

#include "fitting/goodness.h"
#include "fitting/objective.h"
#include "fitting/result.h"
#include "fitting/stated_constants.h"
#include "mechanics/equilibrium.h"

namespace mixity {

/// These constants with those that were fitted as found. Each of `parameters` has a value.
inline Constants with_fitted(Constants constants, const Dataset& data, const std::vector<FittedParameter>& parameters) {
  for (const FittedParameter& parameter : parameters)
    for (const Constant constant : kAllConstants) {
      if (parameter.name != kConstantNames[constant]) continue;
      const double value = *parameter.value / constant_scale(data, constant);
      constants[constant] = is_factor(constant) ? std::log(value) : value;
    }
  return constants;
}

/// A finished fit, all of whose parameters have values, as what it tried out. `options`: those of the fit, for
/// constants that were not free.
template <class Model>
Candidate<Model> fitted_candidate(const Dataset& data, const FitResult& fit, const FitOptions& options) {
  Candidate<Model> candidate{{}, with_fitted(options.constants.value_or(stated_constants(data)), data, fit.parameters)};
  for (const FittedParameter& parameter : fit.parameters)
    for (std::size_t k = 0; k < candidate.parameters.size(); ++k)
      if (parameter.name == Model::parameters[k].name) candidate.parameters[k] = *parameter.value;
  return candidate;
}

/// As it would be measured, dimensionless: beyond the last equilibrium the area at the fold, below pull-off that of no
/// contact; 0 where the law defines no equilibrium with these parameters. A load within kFoldWidth of that of the fold
/// is at the fold.
struct PredictedArea {
  enum class State { equilibrium, beyond_fold, below_pull_off, undefined } state;
  double value;
};

/// Points of one load in a row share their contact.
template <class Model>
class PredictedAreas {
 public:
  explicit PredictedAreas(const Candidate<Model>& candidate)
      : parameters_(candidate.parameters), scale_(candidate.constants) {}

  PredictedArea at(double P, double T) {
    const double load = scale_.load(P);
    if (!contact_ || load != load_) contact_.emplace(parameters_, load_ = load);
    if (!contact_->obstacle().empty()) return {PredictedArea::State::undefined, 0};
    if (!contact_->in_contact()) return {PredictedArea::State::below_pull_off, scale_.measured_area(0)};
    const double shear = std::abs(scale_.shear(T));
    const Equilibrium equilibrium = contact_->at(shear);
    const auto measured = [&](double y) {
      return scale_.measured_area(area_from_radius(radius_from_edge_load(y, load)));
    };
    if (equilibrium.status == EquilibriumStatus::ok)
      return {PredictedArea::State::equilibrium, measured(equilibrium.y)};
    const StableBranch& last = contact_->branches().back();
    return {shear <= (1 + kFoldWidth) * last.T_bottom ? PredictedArea::State::equilibrium
                                                      : PredictedArea::State::beyond_fold,
            measured(last.y_bottom)};
  }

 private:
  /// Relative. Where a measured load is that of the fold, rounding alone says on which side it lies.
  static constexpr double kFoldWidth = 1e-9;

  Parameters<Model> parameters_;
  ConstantsScale scale_;
  std::optional<LoadedContact<Model>> contact_;
  double load_ = 0;
};

/// Of a whole fit, at the points it used.
template <class Model>
AreaGoodness area_goodness(const Dataset& data, const std::vector<std::size_t>& used,
                           const Candidate<Model>& candidate) {
  PredictedAreas<Model> predicted(candidate);
  AreaGoodness area;
  area.obstacle = LoadedContact<Model>(candidate.parameters, 0).obstacle();
  std::vector<double> residuals, targets;
  for (const std::size_t i : used) {
    const Point& point = data.points[i];
    const PredictedArea at_point = predicted.at(point.P, data.shear_as_read(i));
    if (at_point.state != PredictedArea::State::equilibrium) {
      ++area.unpredicted;
      area.areas.emplace_back();
      continue;
    }
    const double A = at_point.value;
    area.areas.emplace_back(A);
    residuals.push_back((A - point.A) * data.display.area_scale);
    targets.push_back(point.A * data.display.area_scale);
  }
  area.predicted = targets.size();
  if (targets.empty()) return area;
  const Goodness fit = goodness(residuals, targets);
  area.r2 = fit.r2;
  area.rmse = fit.rmse;
  area.max_abs_residual = fit.max_abs_residual;
  return area;
}

}  // namespace mixity
