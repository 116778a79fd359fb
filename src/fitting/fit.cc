#include "fitting/fit.h"

#include <algorithm>

#include "dataset/input_error.h"
#include "dataset/number_text.h"
#include "fitting/goodness.h"
#include "mechanics/equilibrium.h"

namespace mixity {
namespace {

/// What the metadata say of a parameter; null if nothing.
std::optional<double> stated_value(std::string_view parameter, const Metadata& metadata) {
  if (parameter == "r" && metadata.toughness && metadata.toughness_II)
    return *metadata.toughness_II / *metadata.toughness;
  return std::nullopt;
}

double held_value(const HeldParameter& held, const ParameterInfo& info, const Dataset& data) {
  const auto value = held.value ? held.value : stated_value(held.name, data.metadata);
  if (!value)
    throw InputError(data.path, "parameter '" + held.name +
                                    "' is to be held at the data set's own value, but the metadata state none" +
                                    (held.name == "r" ? " (r = toughness_II/toughness)" : ""));
  if (!(*value >= info.lower && *value <= info.upper))
    throw InputError(data.path, "parameter '" + held.name + "' is held at " + shortest(*value) +
                                    ", outside its range " + shortest(info.lower) + ".." + shortest(info.upper));
  return *value;
}

/// A model whose toughness is infinite at psi = pi/2 for every parameter in the interior of its range says nothing
/// about points there.
template <class Model>
bool describes(const Mixity<double>& mixity) {
  Parameters<Model> p;
  for (std::size_t i = 0; i < p.size(); ++i) p[i] = Model::parameters[i].typical;
  return std::isfinite(Model::log_toughness(p, mixity).value);
}

template <class Model>
AreaGoodness predict_areas(const Dataset& data, const std::vector<std::size_t>& used, const Parameters<Model>& p) {
  AreaGoodness area;
  std::vector<double> residuals, targets;
  std::optional<LoadedContact<Model>> contact;
  double load = 0;
  for (const std::size_t i : used) {
    const Point& point = data.points[i];
    if (!contact || point.P != load) contact.emplace(p, load = point.P);
    const Equilibrium equilibrium = contact->at(point.T);
    if (equilibrium.status != EquilibriumStatus::ok) {
      ++area.unpredicted;
      area.areas.emplace_back();
      continue;
    }
    const double A = area_from_radius(radius_from_edge_load(equilibrium.y, point.P));
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

template <class Model>
FitResult fit_model(const Dataset& data, const FitOptions& options) {
  FitResult result;
  result.model = Model::info.key;
  result.model_name = Model::info.name;
  result.formula = Model::info.formula;
  result.scale = options.scale;

  std::vector<ToughnessPoint> points;
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const Point& point = data.points[i];
    if (!describes<Model>(point.mixity)) {
      result.excluded.push_back({point.line, "model " + result.model + " has an infinite toughness at this psi"});
      continue;
    }
    points.push_back({point.mixity, point.ratio});
    result.used.push_back(i);
  }

  Parameters<Model> base{};
  std::array<bool, parameter_count<Model>> is_held{};
  for (std::size_t k = 0; k < base.size(); ++k) {
    const ParameterInfo& info = Model::parameters[k];
    result.parameters.push_back({std::string(info.name), {}, {}, info.lower, info.upper});
    base[k] = info.typical;
    for (const HeldParameter& held : options.hold)
      if (held.name == info.name) {
        base[k] = held_value(held, info, data);
        is_held[k] = true;
        result.parameters[k].held = true;
        result.parameters[k].value = base[k];
      }
  }

  const ToughnessObjective<Model> objective(std::move(points), options.scale, base, is_held);
  std::vector<double> x;
  if (!objective.parameters().empty()) {
    const Verdict verdict = minimise(objective);
    result.status = verdict.status;
    result.message = verdict.message;
    if (!result.has_values() || verdict.best.x.empty()) return result;
    x = verdict.best.x;
    for (std::size_t k = 0, j = 0; k < base.size(); ++k) {
      if (is_held[k]) continue;
      result.parameters[k].value = x[j];
      result.parameters[k].stderr_ = verdict.stderrs[j];
      result.parameters[k].at_bound = verdict.at_bound[j];
      ++j;
    }
  } else {
    result.status = FitStatus::ok;
    result.message = "every parameter is held: nothing was fitted";
  }

  result.residuals.resize(objective.residual_count());
  if (result.residuals.empty() || !objective.evaluate(x, result.residuals, {})) {
    result.residuals.clear();
    result.status = FitStatus::not_converged;
    result.message = "the model is not finite at the used points";
    return result;
  }
  const Goodness fit = goodness(result.residuals, objective.targets());
  result.r2 = fit.r2;
  result.rmse = fit.rmse;
  result.max_abs_residual = fit.max_abs_residual;
  if (data.has_loads) result.area = predict_areas<Model>(data, result.used, objective.all_parameters(x));
  return result;
}

}  // namespace

std::optional<HeldParameter> parse_held(std::string_view text) {
  const std::size_t equals = text.find('=');
  HeldParameter held{std::string(trim(text.substr(0, equals))), {}};
  if (held.name.empty()) return std::nullopt;
  if (equals == std::string_view::npos) return held;
  held.value = parse_number(text.substr(equals + 1));
  if (!held.value || !std::isfinite(*held.value)) return std::nullopt;
  return held;
}

std::vector<std::string> model_keys() {
  std::vector<std::string> keys;
  for_each_model([&](auto model) { keys.emplace_back(decltype(model)::info.key); });
  return keys;
}

bool has_parameter(const std::vector<std::string>& models, std::string_view name) {
  bool found = false;
  for (const std::string& key : models)
    with_model(key, [&](auto model) {
      for (const ParameterInfo& info : decltype(model)::parameters) found |= info.name == name;
    });
  return found;
}

FitResult fit_toughness(const Dataset& data, std::string_view model, const FitOptions& options) {
  FitResult result;
  with_model(model, [&](auto chosen) { result = fit_model<decltype(chosen)>(data, options); });
  return result;
}

}  // namespace mixity
