#include "fitting/options.h"

#include <algorithm>
#include <cmath>

#include "mechanics/contact_model.h"
#include "mechanics/laws/known_laws.h"

namespace mixity {

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
  for (const ContactModel& model : ContactModel::published()) keys.emplace_back(model.info().key);
  for (std::string& key : law_keys()) keys.push_back(std::move(key));
  return keys;
}

bool has_parameter(const std::vector<std::string>& models, std::string_view name) {
  return std::any_of(models.begin(), models.end(), [&](const std::string& key) {
    const auto model = ContactModel::find(key);
    return model && std::any_of(model->parameters().begin(), model->parameters().end(),
                                [&](const ParameterInfo& info) { return info.name == name; });
  });
}

std::string_view to_string(Objective objective) { return objective == Objective::toughness ? "toughness" : "curve"; }

std::optional<Objective> parse_objective(std::string_view text) {
  for (const Objective objective : {Objective::toughness, Objective::curve})
    if (text == to_string(objective)) return objective;
  return std::nullopt;
}

Objective default_objective(const Dataset& data) {
  const bool errors_of_energies = std::any_of(data.energies.begin(), data.energies.end(), [](const PointEnergies& e) {
    return e.sigma_GI >= 0 && e.sigma_GII >= 0;
  });
  return data.has_loads || errors_of_energies ? Objective::curve : Objective::toughness;
}

FitOptions value_only(FitOptions options) {
  options.intervals = false;
  options.checks = false;
  options.bootstrap = {};
  options.influence = false;
  options.profile_points = 0;
  options.progress = {};
  return options;
}

}  // namespace mixity
