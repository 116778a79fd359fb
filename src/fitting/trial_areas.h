// The areas that a trial predicts at measured loads.
#pragma once

#include <optional>

#include "fitting/trial.h"
#include "mechanics/equilibrium.h"

namespace mixity {

/// As it would be measured, dimensionless: beyond the last equilibrium the area at the fold, below pull-off that of no
/// contact; 0 where the law defines no equilibrium with these parameters. A load within kFoldWidth of that of the fold
/// is at the fold.
struct TrialArea {
  enum class Place { equilibrium, beyond_fold, below_pull_off, undefined } place;
  double value;
};

/// Points of one load in a row share their contact.
template <class Model>
class TrialAreas {
 public:
  explicit TrialAreas(const Trial<Model>& trial) : parameters_(trial.parameters), scale_(trial.corrections) {}

  TrialArea at(double P, double T) {
    const double load = scale_.load(P);
    if (!contact_ || load != load_) contact_.emplace(parameters_, load_ = load);
    if (!contact_->obstacle().empty()) return {TrialArea::Place::undefined, 0};
    if (!contact_->in_contact()) return {TrialArea::Place::below_pull_off, scale_.measured_area(0)};
    const double shear = scale_.shear(T);
    const Equilibrium equilibrium = contact_->at(shear);
    const bool found = equilibrium.status == EquilibriumStatus::ok;
    const StableBranch& last = contact_->branches().back();
    const bool exists = found || shear <= (1 + kFoldWidth) * last.T_bottom;
    const double y = found ? equilibrium.y : last.y_bottom;
    return {exists ? TrialArea::Place::equilibrium : TrialArea::Place::beyond_fold,
            scale_.measured_area(area_from_radius(radius_from_edge_load(y, load)))};
  }

 private:
  /// Relative. Least squares often lie where a measured load is that of the fold, and are known to some 1e-10
  /// (edge_minimum.h): on which side the point lies is rounding then.
  static constexpr double kFoldWidth = 1e-9;

  Parameters<Model> parameters_;
  CorrectedScale scale_;
  std::optional<LoadedContact<Model>> contact_;
  double load_ = 0;
};

}  // namespace mixity
