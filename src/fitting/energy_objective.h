// Objective `curve` for measured energies (G_I, G_II): signed distances from the law in their plane, in standard
// errors. G_Ic of each series may be free.
#pragma once

#include <vector>

#include "dataset/dataset.h"
#include "fitting/model_problem.h"
#include "fitting/point_indices.h"

namespace mixity {

/// Energies in units of the data set's G_Ic. Points are grouped in series 0, 1, ...; all are 0 if they share one G_Ic.
struct EnergyPoint {
  PointEnergies energies;  // standard errors > 0
  std::size_t series;
};

/// The energies of the used points. Errors of 0 are raised to kLeastError of the largest energy; without errors, all
/// are 1. Throws InputError where only some errors are stated.
std::vector<EnergyPoint> energy_points(const Dataset& data, const PointIndices& used);

/// G_Ic of each series, as ln of its ratio to the data set's G_Ic. Without a prior (0) it starts from Gc of the point
/// with the smallest share of mode II.
std::vector<FreeParameter> series_toughness(const Dataset& data, const std::vector<EnergyPoint>& points,
                                            const PointIndices& used, double prior);

class EnergyObjective final : public WeightedProblem {
 public:
  /// `toughness`: per series, ln of a factor on G_Ic; empty: G_Ic is as stated. Targets, from which the reported R^2 is
  /// computed, are the energies of mode I.
  EnergyObjective(const std::vector<EnergyPoint>& points, FreeChoice choice,
                  const std::vector<FreeParameter>& toughness);

  const std::vector<FreeParameter>& parameters() const override { return parameters_; }
  double data_norm() const override;
  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override;
  /// Uses a polygon in place of the law.
  bool evaluate_roughly(std::span<const double> x, std::span<double> residuals) const override;

 private:
  bool toughness_is_free() const { return parameters_.size() > choice_.size(); }
  /// G_Ic of each point.
  std::vector<double> toughness_at(std::span<const double> x) const;
  EnergyPoints points_at(const std::vector<double>& toughness) const;

  std::vector<double> G_I_, G_II_, sigma_I_, sigma_II_;
  std::vector<std::size_t> series_;
  std::vector<FreeParameter> parameters_;
};

}  // namespace mixity
