#include "fitting/energy_objective.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/input_error.h"
#include "base/stop.h"
#include "dataset/energies.h"
#include "fitting/standard_errors.h"

namespace mixity {

std::vector<EnergyPoint> energy_points(const Dataset& data, const PointIndices& used) {
  double largest = 0;
  for (const PointEnergies& e : data.energies) largest = std::max({largest, e.G_I, e.G_II});
  std::vector<EnergyPoint> points;
  std::vector<std::size_t> series;  // the numbers that occur, in order
  const bool apart = series_have_toughness(data);
  for (const std::size_t i : used) {
    const std::size_t curve = apart ? data.points[i].curve : 0;
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

std::vector<FreeParameter> series_toughness(const Dataset& data, const std::vector<EnergyPoint>& points,
                                            const PointIndices& used, double prior) {
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

EnergyObjective::EnergyObjective(const std::vector<EnergyPoint>& points, FreeChoice choice,
                                 const std::vector<FreeParameter>& toughness)
    : WeightedProblem(std::move(choice)), parameters_(choice_.parameters()) {
  parameters_.insert(parameters_.end(), toughness.begin(), toughness.end());
  for (const auto& [energies, series] : points) {
    G_I_.push_back(energies.G_I);
    G_II_.push_back(energies.G_II);
    sigma_I_.push_back(energies.sigma_GI);
    sigma_II_.push_back(energies.sigma_GII);
    series_.push_back(series);
    targets_.push_back(energies.G_I / energies.sigma_GI);
    weights_.push_back(1 / energies.sigma_GI);
  }
}

double EnergyObjective::data_norm() const {
  double square = 0;
  for (std::size_t i = 0; i < G_I_.size(); ++i)
    square += std::pow(G_I_[i] / sigma_I_[i], 2) + std::pow(G_II_[i] / sigma_II_[i], 2);
  return std::sqrt(square);
}

std::vector<double> EnergyObjective::toughness_at(std::span<const double> x) const {
  std::vector<double> G_Ic(G_I_.size(), 1.0);
  if (toughness_is_free())
    for (std::size_t i = 0; i < G_Ic.size(); ++i) G_Ic[i] = std::exp(x[choice_.size() + series_[i]]);
  return G_Ic;
}

EnergyPoints EnergyObjective::points_at(const std::vector<double>& toughness) const {
  return {G_I_, G_II_, sigma_I_, sigma_II_, toughness};
}

bool EnergyObjective::evaluate(std::span<const double> x, std::span<double> residuals,
                               std::span<double> jacobian) const {
  may_go_on();
  const std::size_t n = G_I_.size(), p = model_parameters(), width = parameters_.size(), of_model = choice_.size();
  const std::vector<double> G_Ic = toughness_at(x);
  std::vector<double> by_toughness(n), by_parameter(jacobian.empty() ? 0 : n * p);
  model().energy_distances(candidate(x).parameters, points_at(G_Ic), {residuals.first(n), by_toughness, by_parameter});
  bool finite = true;
  for (std::size_t i = 0; i < n; ++i) {
    finite &= std::isfinite(residuals[i]);
    if (jacobian.empty()) continue;
    const std::span<double> row = jacobian.subspan(i * width, width);
    std::fill(row.begin(), row.end(), 0.0);
    for (std::size_t k = 0; k < of_model; ++k) row[k] = by_parameter[i * p + choice_.of_model()[k]];
    if (toughness_is_free()) row[of_model + series_[i]] = by_toughness[i];
    for (const double value : row) finite &= std::isfinite(value);
  }
  return finite;
}

bool EnergyObjective::evaluate_roughly(std::span<const double> x, std::span<double> residuals) const {
  const std::vector<double> G_Ic = toughness_at(x);
  model().rough_energy_distances(candidate(x).parameters, points_at(G_Ic), residuals);
  return std::all_of(residuals.begin(), residuals.end(), [](double r) { return std::isfinite(r); });
}

}  // namespace mixity
