// Objective `curve` of measured energies (G_I, G_II): signed distances from the law in their plane, in standard errors;
// with G_Ic free, of each series its own.
#pragma once

#include <algorithm>
#include <limits>
#include <utility>

#include "base/input_error.h"
#include "dataset/dataset.h"
#include "fitting/objective.h"
#include "fitting/standard_errors.h"
#include "mechanics/energy_plane.h"

namespace mixity {

/// Energies in units of the data set's G_Ic, and the series of each point, 0, 1, ...
struct EnergyPoint {
  PointEnergies energies;  // standard errors > 0
  std::size_t series;
};

/// The energies of the points used, errors of 0 raised to kLeastError of the largest energy; 1 without any error.
/// Throws InputError where only some errors are stated.
inline std::vector<EnergyPoint> energy_points(const Dataset& data, const std::vector<std::size_t>& used) {
  double largest = 0;
  for (const PointEnergies& e : data.energies) largest = std::max({largest, e.G_I, e.G_II});
  std::vector<EnergyPoint> points;
  std::vector<std::size_t> series;  // those that occur, in order
  for (const std::size_t i : used) {
    const std::size_t curve = data.points[i].curve;
    if (std::find(series.begin(), series.end(), curve) == series.end()) series.push_back(curve);
    PointEnergies e = data.energies[i];
    for (const auto& [error, column] : {std::pair(&e.sigma_GI, "sigma_GI"), std::pair(&e.sigma_GII, "sigma_GII")}) {
      if (*error < 0 && !data.errors.empty())
        refuse_value(data, data.points[i], column,
                     std::string("this point has no standard error ") + column +
                         ": the distance from the law needs errors of both energies, or of none");
      if (!(*error > 0)) *error = *error < 0 ? 1 : kLeastError * largest;
    }
    points.push_back({e, static_cast<std::size_t>(std::find(series.begin(), series.end(), curve) - series.begin())});
  }
  return points;
}

/// G_Ic of each series, as ln of a factor on the data set's own. Nothing known of it (prior 0), it starts at Gc of the
/// point with the least mode II.
inline std::vector<FreeParameter> series_toughness(const Dataset& data, const std::vector<EnergyPoint>& points,
                                                   const std::vector<std::size_t>& used, double prior) {
  std::vector<FreeParameter> list;
  std::vector<double> least;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const EnergyPoint& point = points[i];
    const double sum = point.energies.G_I + point.energies.G_II, ratio = point.energies.G_II / sum;
    if (point.series == list.size()) {
      list.push_back(
          {"toughness", -std::log(1e3), std::log(1e3), 0.0, data.display.energy_scale, true, data.display.energy});
      const std::string& name = data.curves[data.points[used[i]].curve];
      if (!name.empty()) list.back().name += "(" + name + ")";
      list.back().prior = prior;
      least.push_back(std::numeric_limits<double>::infinity());
    }
    if (ratio < least[point.series]) {
      least[point.series] = ratio;
      if (prior == 0) list[point.series].start = std::log(sum);
    }
  }
  if (list.size() == 1) list[0].name = "toughness";
  return list;
}

template <class Model>
class EnergyObjective final : public ModelProblem<Model> {
 public:
  /// `toughness`: of each series, ln of a factor on G_Ic; empty: G_Ic is as stated. The targets, which the reported R^2
  /// compares with, are the energies of mode I.
  EnergyObjective(std::vector<EnergyPoint> points, FreeChoice<Model> choice,
                  const std::vector<FreeParameter>& toughness)
      : Base(std::move(choice)), points_(std::move(points)), parameters_(choice_.parameters()) {
    parameters_.insert(parameters_.end(), toughness.begin(), toughness.end());
    for (const EnergyPoint& point : points_) {
      targets_.push_back(point.energies.G_I / point.energies.sigma_GI);
      weights_.push_back(1 / point.energies.sigma_GI);
    }
  }

  const std::vector<FreeParameter>& parameters() const override { return parameters_; }
  double data_norm() const override {
    double square = 0;
    for (const EnergyPoint& point : points_)
      square += std::pow(point.energies.G_I / point.energies.sigma_GI, 2) +
                std::pow(point.energies.G_II / point.energies.sigma_GII, 2);
    return std::sqrt(square);
  }

  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override {
    [[maybe_unused]] const auto entered = choice_.enter_model();
    const EnergyLaw<Model> law(this->candidate(x).parameters);
    const std::size_t width = parameters_.size(), model = choice_.size();
    bool finite = true;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const PointEnergies& e = points_[i].energies;
      const std::size_t toughness = model + points_[i].series;
      const double G_Ic = width > model ? std::exp(x[toughness]) : 1;
      const EnergyDistance<Model> r = law.distance(e.G_I, e.G_II, e.sigma_GI, e.sigma_GII, G_Ic, !jacobian.empty());
      residuals[i] = r.value;
      finite &= std::isfinite(r.value);
      if (jacobian.empty()) continue;
      const std::span<double> row = jacobian.subspan(i * width, width);
      std::fill(row.begin(), row.end(), 0.0);
      for (std::size_t k = 0; k < model; ++k) row[k] = r.parameters[choice_.model()[k]];
      if (width > model) row[toughness] = r.log_toughness;
      for (const double value : row) finite &= std::isfinite(value);
    }
    return finite;
  }

  /// From the polygon through some points of the law.
  bool evaluate_roughly(std::span<const double> x, std::span<double> residuals) const override {
    [[maybe_unused]] const auto entered = choice_.enter_model();
    const EnergyPolygon<Model> law(this->candidate(x).parameters);
    bool finite = true;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const PointEnergies& e = points_[i].energies;
      const double G_Ic = parameters_.size() > choice_.size() ? std::exp(x[choice_.size() + points_[i].series]) : 1;
      residuals[i] = law.distance(e.G_I, e.G_II, e.sigma_GI, e.sigma_GII, G_Ic);
      finite &= std::isfinite(residuals[i]);
    }
    return finite;
  }

 private:
  using Base = ModelProblem<Model>;
  using Base::choice_, Base::targets_, Base::weights_;
  std::vector<EnergyPoint> points_;
  std::vector<FreeParameter> parameters_;
};

}  // namespace mixity
