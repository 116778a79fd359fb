#include <cmath>

#include "mechanics/contact_model.h"

namespace mixity {

std::vector<std::string> parameter_names(std::string_view model) {
  std::vector<std::string> names;
  if (const auto found = ContactModel::find(model))
    for (const ParameterInfo& info : found->parameters()) names.emplace_back(info.name);
  return names;
}

std::vector<std::pair<double, double>> parameter_bounds(std::string_view model) {
  std::vector<std::pair<double, double>> bounds;
  if (const auto found = ContactModel::find(model))
    for (const ParameterInfo& info : found->parameters()) bounds.emplace_back(info.lower, info.upper);
  return bounds;
}

namespace {
std::string problem_at(const std::optional<ContactModel>& model, std::string_view key, std::span<const double> p,
                       double P) {
  return model ? model->problem(p, P) : "no model is called '" + std::string(key) + "'";
}
}  // namespace

std::string parameters_problem(std::string_view model, std::span<const double> parameters) {
  return problem_at(ContactModel::find(model), model, parameters, 0);
}

void areas(std::string_view model, std::span<const Values> parameters, Values P, Values T, std::span<double> A,
           std::span<EquilibriumStatus> status) {
  if (const auto found = ContactModel::find(model)) return found->areas(parameters, P, T, A, status);
  std::fill(A.begin(), A.end(), std::nan(""));
  std::fill(status.begin(), status.end(), EquilibriumStatus::invalid);
}

void area_slopes(std::string_view model, std::span<const Values> parameters, Values P, Values T,
                 std::span<const double> A, std::span<const std::span<double>> slopes) {
  if (const auto found = ContactModel::find(model)) found->area_slopes(parameters, P, T, A, slopes);
}

void toughness_ratios(std::string_view model, std::span<const Values> parameters, Values psi, std::span<double> f) {
  if (const auto found = ContactModel::find(model)) found->toughness_ratios(parameters, psi, f);
}

void tangential_loads(std::string_view model, std::span<const Values> parameters, Values P, Values A,
                      std::span<double> T) {
  if (const auto found = ContactModel::find(model)) found->tangential_loads(parameters, P, A, T);
}

FoldsOrProblem folds_of(std::string_view key, std::span<const double> parameters, double P, Control control) {
  const auto model = ContactModel::find(key);
  std::string problem = problem_at(model, key, parameters, P);
  if (!problem.empty()) return {{}, problem};
  return {model->folds(parameters, P, control), {}};
}

RegimeOrProblem regime_of(std::string_view key, std::span<const double> parameters, double P,
                          std::optional<double> tau0) {
  if (tau0 && !(*tau0 > 0)) return {{}, "the shear strength must be positive"};
  const auto model = ContactModel::find(key);
  std::string problem = problem_at(model, key, parameters, P);
  if (!problem.empty()) return {{}, problem};
  return {model->regime(parameters, P, tau0), {}};
}

std::optional<double> critical_load_of(std::string_view key, std::span<const double> parameters) {
  const auto model = ContactModel::find(key);
  if (!problem_at(model, key, parameters, 0).empty()) return std::nullopt;
  return model->critical_load(parameters);
}

CurveOrProblem curve_of(std::string_view key, std::span<const double> parameters, double P, std::size_t points) {
  const auto model = ContactModel::find(key);
  std::string problem = problem_at(model, key, parameters, P);
  if (!problem.empty()) return {{}, problem};
  return {model->curve(parameters, P, {.points = points}).points, {}};
}

}  // namespace mixity
