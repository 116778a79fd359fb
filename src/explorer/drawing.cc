#include "explorer/drawing.h"

#include <cmath>
#include <stdexcept>

#include "dataset/display_units.h"
#include "fitting/predicted_curves.h"
#include "mechanics/contact.h"
#include "mechanics/held_approach.h"
#include "mechanics/regime_map.h"

namespace mixity::explorer {
namespace {

constexpr double kMilli = 1e-3, kSquareMilli = 1e-6, kMicro = 1e-6;
constexpr std::size_t kPoints = 100;  // in a curve drawn while a slider moves

/// A data set without points, which provides constants and units.
Dataset of_constants(const Json& request) {
  Dataset data;
  const Contact contact{request.at("radius"), request.at("modulus"), request.at("toughness")};
  if (!in_range(contact.radius) || !in_range(contact.modulus) || !in_range(contact.toughness) || !contact.usable())
    throw std::invalid_argument("radius, modulus and toughness must be positive numbers");
  data.contact = contact;
  data.has_loads = true;
  data.metadata.radius = contact.radius;
  data.metadata.modulus = contact.modulus;
  data.metadata.toughness = contact.toughness;
  data.display = {"mN", "mm^2", "mJ/m^2", contact.force_unit() / kMilli, contact.area_unit() / kSquareMilli, 1};
  return data;
}

FitResult as_chosen(const ContactModel& model, const std::vector<double>& parameters) {
  FitResult fit;
  fit.model = model.info().key;
  fit.status = FitStatus::ok;
  for (const ParameterInfo& info : model.parameters()) {
    const double value = parameters.at(fit.parameters.size());
    fit.parameters.push_back({std::string(info.name), value, {}, info.lower, info.upper});
  }
  return fit;
}

Json curve(const DrawnCurve& drawn) {
  return {{"T", list_of(drawn.points, &DrawnPoint::T)},
          {"A", list_of(drawn.points, &DrawnPoint::A)},
          {"u", list_of(drawn.points, &DrawnPoint::u)},
          {"stable", list_of(drawn.points, &DrawnPoint::stable)}};
}

Json fold(const DrawnFold& drawn) {
  return {{"control", to_string(drawn.control)},
          {"T", drawn.T},
          {"A", drawn.A},
          {"u", drawn.u},
          {"jumps_to", drawn.jumps_to},
          {"area_after", drawn.area_after}};
}

/// The stable state at the load and shear.
Json state(const ContactModel& model, const std::vector<double>& parameters, const DisplayUnits& units, double P,
           double T) {
  double A = 0;
  EquilibriumStatus status{};
  model.areas_at(parameters, P, {&T, 1}, {&A, 1}, {&status, 1});
  if (status != EquilibriumStatus::ok) return nullptr;
  Json told{{"A", A * units.area_scale}};
  if (const auto toughness = toughness_of_area(P, T, A)) {
    told["psi"] = toughness->psi();
    told["f"] = toughness->ratio;
  }
  return told;
}

/// The contact with the approach that it has at the load P without shear held in place of P, by a rigid machine.
Json held_approach(const ContactModel& model, const std::vector<double>& parameters, const Contact& contact,
                   const DisplayUnits& units, double P, double T_here, double T_most) {
  const double a = jkr_radius(P);
  const HeldApproach held{P / (2 * a) + a * a / 3};  // P = 2 a delta - 2/3 a^3
  std::vector<double> T;
  for (std::size_t i = 0; i <= kPoints; ++i) T.push_back(T_most * static_cast<double>(i) / kPoints);
  T.push_back(T_here);
  const ApproachStates found = under_held_approach(model, parameters, held, T);
  Json told{{"approach", held.approach * contact.displacement_unit() / kMicro}, {"curve", Json::array()}};
  const auto place = [&](double at, double load, double radius) {
    return Json{at * units.force_scale, area_from_radius(radius) * units.area_scale, load * units.force_scale};
  };
  for (std::size_t i = 0; i < T.size(); ++i)
    if (found.at[i].status == EquilibriumStatus::ok)
      (i <= kPoints ? told["curve"] : told["state"]).push_back(place(T[i], found.at[i].P, found.at[i].a));
  if (!found.end) return told;
  if (found.end->T <= T_most) told["curve"].push_back(place(found.end->T, found.end->P, found.end->a));
  told["end"] = {{"at", place(found.end->T, found.end->P, found.end->a)}, {"fold", found.end->fold}};
  return told;
}

}  // namespace

ContactModel model_of(const std::string& key) {
  const auto model = ContactModel::find(key);
  if (!model) throw std::invalid_argument("no model is called '" + key + "'");
  return *model;
}

Json drawn_models(const Json& request) {
  const Dataset data = of_constants(request);
  const DisplayUnits& units = data.display;
  const auto load = [&](const char* name) { return request.at(name).get<double>() / units.force_scale; };
  const double P = load("P"), T = std::abs(load("T")), T_most = load("T_most"), P_most = load("P_most");
  Json all = Json::array();
  for (const Json& one : request.at("models")) {
    const std::string key = one.at("model");
    const ContactModel model = model_of(key);
    const auto parameters = one.at("parameters").get<std::vector<double>>();
    const FitResult fit = as_chosen(model, parameters);
    const Json toughness = drawn_toughness(data, fit, 0.5 * pi<double>(), 1e4, kPoints);
    if (const std::string problem = model.problem(parameters, P); !problem.empty()) {
      all.push_back({{"model", key}, {"problem", problem}, {"toughness", toughness}});
      continue;
    }
    const DrawnCurve drawn = drawn_curve(data, {}, fit, P, T_most);
    const DrawnRadii radii = drawn_radii(data, {}, fit, T, P_most, kPoints);
    all.push_back({{"model", key},
                   {"curve", curve(drawn)},
                   {"folds", list_of(drawn.folds, fold)},
                   {"radii", {{"stable", radii.stable}, {"unstable", radii.unstable}}},
                   {"toughness", toughness},
                   {"state", state(model, parameters, units, P, T)},
                   {"regime", std::string(regime_text(model.regime(parameters, P).value().regime))}});
    if (request.value("held", false))
      all.back()["held"] = held_approach(model, parameters, *data.contact, units, P, T, T_most);
  }
  return all;
}

}  // namespace mixity::explorer
