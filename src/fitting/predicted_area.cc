#include "fitting/predicted_area.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "fitting/stated_constants.h"

namespace mixity {
namespace {

/// Relative width. A measured load equal to that of the fold lies on either side only by rounding.
constexpr double kFoldWidth = 1e-9;

/// Points with one load computed together: for a run of millions, the arrays would be larger than the points.
constexpr std::size_t kMostAtOnce = 1 << 16;

/// Appends the areas of one contact at shears >= 0. `scales`: one for each.
void add_areas(const ContactModel& model, std::span<const double> p, std::span<const ConstantsScale> scales,
               double load, std::span<const double> shears, std::vector<PredictedArea>& areas) {
  if (!model.obstacle(p, load).empty())
    return areas.resize(areas.size() + shears.size(), {PredictedArea::State::undefined, 0});
  if (!model.in_contact(load))
    return areas.resize(areas.size() + shears.size(),
                        {PredictedArea::State::below_pull_off, scales[0].measured_area(0)});
  const auto measured = [&](std::size_t i, double y) {
    const double a = model.holds_approach() ? model.held_at(load).radius(y) : radius_from_edge_load(y, load);
    return scales[i].measured_area(area_from_radius(a));
  };
  const Equilibria found = model.equilibria(p, load, shears);
  for (std::size_t i = 0; i < shears.size(); ++i) {
    if (found.at[i].status == EquilibriumStatus::ok) {
      areas.push_back({PredictedArea::State::equilibrium, measured(i, found.at[i].y), found.at[i].q});
      continue;
    }
    areas.push_back({shears[i] <= (1 + kFoldWidth) * found.last->T_bottom ? PredictedArea::State::equilibrium
                                                                          : PredictedArea::State::beyond_fold,
                     measured(i, found.last->y_bottom)});
  }
}

}  // namespace

ContactModel model_of(const Dataset& data, const FitResult& fit) {
  const auto model = ContactModel::find(fit.model);
  if (!model) throw std::invalid_argument("no model is called '" + fit.model + "'");
  return data.under_control(*model);
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

/// The areas of n points, one load after the other: take(i, area). `reading(i)`: load and shear; `scale(i)`: theirs.
template <class Reading, class Scale, class Take>
void each_area(const ContactModel& model, const Candidate& candidate, std::size_t n, const Reading& reading,
               const Scale& scale, const Take& take) {
  std::vector<double> shears;
  std::vector<ConstantsScale> scales;
  std::vector<PredictedArea> areas;
  for (std::size_t begin = 0; begin < n;) {
    const double load = scale(begin).load(reading(begin).first);
    shears.clear();
    scales.clear();
    areas.clear();
    for (std::size_t i = begin; i < n; ++i) {
      const auto [P, T] = reading(i);
      const ConstantsScale by = scale(i);
      if (shears.size() == kMostAtOnce || (i > begin && by.load(P) != load)) break;
      shears.push_back(std::abs(by.shear(T)));
      scales.push_back(by);
    }
    add_areas(at_scale(model, scales[0]), candidate.parameters, scales, load, shears, areas);
    for (std::size_t i = 0; i < areas.size(); ++i) take(begin + i, areas[i]);
    begin += areas.size();
  }
}

/// The same for points of a data set.
template <class Take>
void each_area(const ContactModel& model, const Candidate& candidate, const Dataset& data, const PointIndices& points,
               const Take& take) {
  const Scales scales(data, candidate.constants);
  const auto reading = [&](std::size_t i) {
    return std::pair(data.points[points[i]].P, data.shear_as_read(points[i]));
  };
  each_area(
      model, candidate, points.size(), reading, [&](std::size_t i) { return scales.of(points[i]); }, take);
}

}  // namespace

std::vector<PredictedArea> predicted_areas(const ContactModel& model, const Candidate& candidate,
                                           std::span<const double> P, std::span<const double> T) {
  const ConstantsScale scale(candidate.constants);
  std::vector<PredictedArea> areas(P.size());
  each_area(
      model, candidate, P.size(), [&](std::size_t i) { return std::pair(P[i], T[i]); },
      [&](std::size_t) { return scale; }, [&](std::size_t i, const PredictedArea& area) { areas[i] = area; });
  return areas;
}

std::vector<PredictedArea> predicted_areas(const ContactModel& model, const Candidate& candidate, const Dataset& data,
                                           const PointIndices& points) {
  std::vector<PredictedArea> areas(points.size());
  each_area(model, candidate, data, points, [&](std::size_t i, const PredictedArea& area) { areas[i] = area; });
  return areas;
}

namespace {

/// The goodness over those of n values for which `counts` is true.
template <class Residual, class Target, class Weight, class Counts>
Goodness goodness_of(std::size_t n, const Residual& residual, const Target& target, const Weight& weight,
                     const Counts& counts) {
  double sum = 0, weights = 0, squares = 0, scatter = 0;
  std::size_t count = 0;
  Goodness result;
  for (std::size_t i = 0; i < n; ++i) {
    if (!counts(i)) continue;
    sum += weight(i) * target(i);
    weights += weight(i) * weight(i);
    ++count;
  }
  const double mean = sum / weights;
  for (std::size_t i = 0; i < n; ++i) {
    if (!counts(i)) continue;
    const double off = target(i) - weight(i) * mean, r = residual(i);
    squares += r * r;
    scatter += off * off;
    result.max_abs_residual = std::fmax(result.max_abs_residual, std::abs(r));
  }
  result.rmse = std::sqrt(squares / static_cast<double>(count));
  // the mean of equal numbers differs from them by roundings
  constexpr double kEqual = 1e-24;
  if (count >= 2 && scatter > kEqual * mean * mean * weights) result.r2 = 1 - squares / scatter;
  return result;
}

}  // namespace

Goodness goodness(std::span<const double> residuals, std::span<const double> targets, std::span<const double> weights) {
  return goodness_of(
      targets.size(), [&](std::size_t i) { return residuals[i]; }, [&](std::size_t i) { return targets[i]; },
      [&](std::size_t i) { return weights.empty() ? 1.0 : weights[i]; }, [](std::size_t) { return true; });
}

AreaGoodness area_goodness(const Dataset& data, const PointIndices& used, const ContactModel& model,
                           const Candidate& candidate) {
  AreaGoodness area;
  area.obstacle = model.obstacle(candidate.parameters);
  area.areas.resize(used.size(), std::numeric_limits<double>::quiet_NaN());
  each_area(model, candidate, data, used, [&](std::size_t i, const PredictedArea& predicted) {
    if (predicted.state == PredictedArea::State::equilibrium)
      area.areas[i] = predicted.value;
    else
      ++area.unpredicted;
  });
  area.predicted = used.size() - area.unpredicted;
  if (area.predicted == 0) return area;
  const auto measured = [&](std::size_t i) { return data.points[used[i]].A; };
  const double scale = data.display.area_scale;
  const Goodness fit = goodness_of(
      used.size(), [&](std::size_t i) { return (area.areas[i] - measured(i)) * scale; },
      [&](std::size_t i) { return measured(i) * scale; }, [](std::size_t) { return 1.0; },
      [&](std::size_t i) { return area.predicts(i); });
  area.r2 = fit.r2;
  area.rmse = fit.rmse;
  area.max_abs_residual = fit.max_abs_residual;
  return area;
}

}  // namespace mixity
