#include "fitting/predicted_area.h"

#include <cmath>
#include <stdexcept>

#include "fitting/stated_constants.h"

namespace mixity {
namespace {

/// Relative. A measured load that equals that of the fold lies on either side by rounding alone.
constexpr double kFoldWidth = 1e-9;

/// Appends the areas of one contact, at shears that are not negative. `scales`: one for each.
void add_areas(const ContactModel& model, std::span<const double> p, std::span<const ConstantsScale> scales,
               double load, std::span<const double> shears, std::vector<PredictedArea>& areas) {
  if (!model.obstacle(p, load).empty())
    return areas.resize(areas.size() + shears.size(), {PredictedArea::State::undefined, 0});
  if (above_pull_off(load) < 0)
    return areas.resize(areas.size() + shears.size(),
                        {PredictedArea::State::below_pull_off, scales[0].measured_area(0)});
  const auto measured = [&](std::size_t i, double y) {
    return scales[i].measured_area(area_from_radius(radius_from_edge_load(y, load)));
  };
  const Equilibria found = model.equilibria(p, load, shears);
  for (std::size_t i = 0; i < shears.size(); ++i) {
    if (found.at[i].status == EquilibriumStatus::ok) {
      areas.push_back({PredictedArea::State::equilibrium, measured(i, found.at[i].y)});
      continue;
    }
    areas.push_back({shears[i] <= (1 + kFoldWidth) * found.last->T_bottom ? PredictedArea::State::equilibrium
                                                                          : PredictedArea::State::beyond_fold,
                     measured(i, found.last->y_bottom)});
  }
}

}  // namespace

ContactModel model_of(const FitResult& fit) {
  const auto model = ContactModel::find(fit.model);
  if (!model) throw std::invalid_argument("no model is called '" + fit.model + "'");
  return *model;
}

Constants constants_of(const Dataset& data, const FitOptions& options, const std::vector<FittedParameter>& parameters) {
  Constants constants = constants_of(data, options);
  for (const Constant c : kAllConstants)
    if (const FittedParameter* const found = find_parameter(parameters, kConstantNames[c])) {
      const double value = *found->value / unit_of(data, c).scale;
      constants[c] = is_factor(c) ? std::log(value) : value;
    }
  return constants;
}

Candidate fitted_candidate(const Dataset& data, const ContactModel& model, const FitResult& fit,
                           const FitOptions& options) {
  const std::span<const ParameterInfo> infos = model.parameters();
  ParameterValues values = ParameterValues::zeros(infos.size());
  for (std::size_t k = 0; k < infos.size(); ++k)
    if (const FittedParameter* const found = find_parameter(fit.parameters, infos[k].name)) values[k] = *found->value;
  return {values, constants_of(data, options, fit.parameters)};
}

namespace {

std::vector<PredictedArea> areas_of(const ContactModel& model, const Candidate& candidate, std::span<const double> P,
                                    std::span<const double> T, std::span<const ConstantsScale> scales) {
  std::vector<PredictedArea> areas;
  areas.reserve(P.size());
  std::vector<double> shears;
  for (std::size_t begin = 0; begin < P.size();) {
    const double load = scales[begin].load(P[begin]);
    shears.clear();
    std::size_t end = begin;
    for (; end < P.size() && (end == begin || scales[end].load(P[end]) == load); ++end)
      shears.push_back(std::abs(scales[end].shear(T[end])));
    add_areas(model, candidate.parameters, scales.subspan(begin, end - begin), load, shears, areas);
    begin = end;
  }
  return areas;
}

}  // namespace

std::vector<PredictedArea> predicted_areas(const ContactModel& model, const Candidate& candidate,
                                           std::span<const double> P, std::span<const double> T) {
  return areas_of(model, candidate, P, T, std::vector(P.size(), ConstantsScale(candidate.constants)));
}

std::vector<PredictedArea> predicted_areas(const ContactModel& model, const Candidate& candidate, const Dataset& data,
                                           const std::vector<std::size_t>& points) {
  std::vector<double> P, T;
  std::vector<ConstantsScale> scales;
  const Scales of(data, candidate.constants);
  for (const std::size_t i : points) {
    scales.push_back(of.of(i));
    P.push_back(data.points[i].P);
    T.push_back(data.shear_as_read(i));
  }
  return areas_of(model, candidate, P, T, scales);
}

Goodness goodness(std::span<const double> residuals, std::span<const double> targets, std::span<const double> weights) {
  double sum = 0, weight = 0, squares = 0, scatter = 0;
  Goodness result;
  const auto weight_of = [&](std::size_t i) { return weights.empty() ? 1.0 : weights[i]; };
  for (std::size_t i = 0; i < targets.size(); ++i) {
    sum += weight_of(i) * targets[i];
    weight += weight_of(i) * weight_of(i);
  }
  const double mean = sum / weight;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    const double off = targets[i] - weight_of(i) * mean;
    squares += residuals[i] * residuals[i];
    scatter += off * off;
    result.max_abs_residual = std::fmax(result.max_abs_residual, std::abs(residuals[i]));
  }
  result.rmse = std::sqrt(squares / static_cast<double>(residuals.size()));
  if (targets.size() >= 2 && scatter > 0) result.r2 = 1 - squares / scatter;
  return result;
}

AreaGoodness area_goodness(const Dataset& data, const std::vector<std::size_t>& used, const ContactModel& model,
                           const Candidate& candidate) {
  AreaGoodness area;
  area.obstacle = model.obstacle(candidate.parameters);
  std::vector<double> residuals, targets;
  for (const PredictedArea& predicted : predicted_areas(model, candidate, data, used)) {
    const double measured = data.points[used[area.areas.size()]].A;
    if (predicted.state != PredictedArea::State::equilibrium) {
      ++area.unpredicted;
      area.areas.emplace_back();
      continue;
    }
    area.areas.emplace_back(predicted.value);
    residuals.push_back((predicted.value - measured) * data.display.area_scale);
    targets.push_back(measured * data.display.area_scale);
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
