// Objective `curve` of measured energies (G_I, G_II): signed distances from the law in their plane, in standard errors;
// with G_Ic free, of each series its own.
#pragma once

#include <vector>

#include "dataset/dataset.h"
#include "fitting/model_problem.h"

namespace mixity {

/// Energies in units of the data set's G_Ic, and the series of each point, 0, 1, ...; all 0 if they have one G_Ic.
struct EnergyPoint {
  PointEnergies energies;  // standard errors > 0
  std::size_t series;
};

/// The energies of the points used. Errors of 0 are raised to kLeastError of the largest energy; without errors they
/// are
/// 1. Throws InputError where only some errors are stated.
std::vector<EnergyPoint> energy_points(const Dataset& data, const std::vector<std::size_t>& used);

/// G_Ic of each series, as ln of a factor on the data set's own. Without a prior (0) it starts at Gc of the point with
/// the smallest share of mode II.
std::vector<FreeParameter> series_toughness(const Dataset& data, const std::vector<EnergyPoint>& points,
                                            const std::vector<std::size_t>& used, double prior);

class EnergyObjective final : public WeightedProblem {
 public:
  /// `toughness`: of each series, ln of a factor on G_Ic; empty: G_Ic is as stated. The targets, which the reported R^2
  /// compares with, are the energies of mode I.
  EnergyObjective(const std::vector<EnergyPoint>& points, FreeChoice choice,
                  const std::vector<FreeParameter>& toughness);

  const std::vector<FreeParameter>& parameters() const override { return parameters_; }
  double data_norm() const override;
  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override;
  /// From a polygon instead of the law.
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
