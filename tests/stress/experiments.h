// Random experiments of loads and areas, fitted with the objective curve, with and without a freed constant: the cost
// that the program says is the lowest against a brute-force scan of it. The curve's points come from EquilibriumCurve,
// which the tests of mechanics judge; nothing of the fitting, nor of the distances that it uses, is used.
#pragma once

#include "fitting/synthetic_runs.h"
#include "stress/curve_cost.h"
#include "stress/fits.h"

namespace mixity::stress {

struct Experiment {
  Dataset data;
  FitOptions options;
  std::string what;
  std::vector<double> truth;  // the parameters the data were made with
};

/// Points of up to three runs under T from 0 to beyond the fold, where the area is the fold's, with scatter.
template <class Model>
Experiment random_experiment(Random& random) {
  Experiment result;
  Parameters<Model> p{};
  do
    for (std::size_t k = 0; k < p.size(); ++k) {
      const ParameterInfo& info = Model::parameters[k];
      const double choice = uniform(random);
      p[k] = p.size() == 2  ? log_uniform(random, 0.5, 5)
             : choice < 0.1 ? info.lower
             : choice < 0.2 ? info.upper
                            : info.lower + (info.upper - info.lower) * log_uniform(random, 1e-4, 1);
    }
  while (!Model::equilibrium_domain(p).empty());
  const double noise = log_uniform(random, 1e-6, 0.1);
  const int runs = 1 + static_cast<int>(random() % 3), per_run = 1 + static_cast<int>(log_uniform(random, 1, 20));
  std::normal_distribution<double> normal;
  Dataset& data = result.data;
  data.path = data.name = "random";
  data.has_loads = true;
  std::string loads;
  for (int run = 0; run < runs; ++run) {
    const double P = uniform(random, -4, 30);
    const LoadedContact contact(Model{}, p, P);
    const double last = std::min(contact.last_load(), 20 * circle_radius(P));
    data.curves.push_back(shortest(P));
    data.curve_loads.push_back(P);
    loads += " " + shortest(P);
    for (int i = 0; i < per_run; ++i) {
      const double T = last * (chance(random, 0.1) ? 1 + 0.1 * uniform(random) : uniform(random));
      const Equilibrium found = contact.at(T);
      const double y = found.status == EquilibriumStatus::ok ? found.y : contact.branches().back().y_bottom;
      const double A = area_from_radius(radius_from_edge_load(y, P)), sigma_A = noise * A, sigma_T = noise * last;
      const double A_measured = std::max(A + sigma_A * normal(random), 0.1 * A);
      const auto line = data.points.size() + 2, curve_index = static_cast<std::size_t>(run);
      data.points.push_back({line, curve_index, P, T + sigma_T * normal(random), A_measured});
      data.errors.push_back({sigma_T, sigma_A, 0});
    }
  }
  data.rows = data.points.size();
  result.options.objective = Objective::curve;
  result.options.fitted_errors = false;  // the scan is of bare distances
  // with a constant freed the condition number of the normal matrix goes up: factor and lambda move areas alike
  if (p.size() == 1 && chance(random, 0.2)) result.options.free = {kToughness};
  result.truth.assign(p.begin(), p.end());
  result.what = std::string(Model::info.key);
  for (const double value : p) result.what += " " + shortest(value);
  result.what += " P=" + loads + " noise " + rounded(noise, 3) + ", " + std::to_string(data.rows) + " points" +
                 (result.options.free.empty() ? "" : ", freed");
  return result;
}

/// What is wrong with the fit; `error` in standard errors.
template <class Model>
std::string wrong_with_experiment(const Experiment& experiment, const FitResult& fit, double& error) {
  error = 0;
  if (const std::string wrong = wrong_with_numbers(fit); !wrong.empty()) return wrong;
  if (fit.status == FitStatus::not_converged) return "";
  const bool freed = !experiment.options.free.empty();
  std::vector<double> places;
  if (Model::parameters.size() == 1 && !freed) places = places_to(Model::parameters[0].upper, 12);
  if (fit.status == FitStatus::not_identifiable) {
    if (places.empty() || experiment.data.points.size() < 2) return "";
    double least = HUGE_VAL, most = 0;
    for (const double x : places) {
      const double cost = curve_cost<Model>(experiment.data, {x}, 0);
      least = std::min(least, cost);
      if (cost < HUGE_VAL) most = std::max(most, cost);
    }
    // chi^2 of one parameter at 95 %, and a tenth for what either has not seen; a flat bottom is no value
    return most > 1.1 * (least + 3.85) && fit.message.text().find("every value") != std::string::npos
               ? "costs from " + shortest(least) + " to " + shortest(most) + " are called all the same"
               : "";
  }
  Parameters<Model> p{};
  for (std::size_t k = 0; k < p.size(); ++k) p[k] = *fit.parameters[k].value;
  const double factor = freed ? std::log(*fit.parameters.back().value) : 0,
               found = curve_cost<Model>(experiment.data, p, factor);
  // the cost that the program reports is the one this file computes: to 1e-6 of a chi^2 of one, or of itself
  if (!(std::abs(found - fit.sum_of_squares) <= 1e-6 * (1 + found)))
    return "the cost is " + shortest(found) + ", reported " + shortest(fit.sum_of_squares);
  // Lower places: the truth's, over the whole range of the only parameter, around the place found of two.
  Place lowest{{}, found};
  const auto see = [&](const Parameters<Model>& q, double log_factor) {
    const double cost = curve_cost<Model>(experiment.data, q, log_factor);
    if (cost < lowest.cost) lowest = {{q[0], q.back(), log_factor}, cost};
    return cost;
  };
  Parameters<Model> truth;
  std::copy(experiment.truth.begin(), experiment.truth.end(), truth.begin());
  see(truth, 0);
  if (p.size() == 1 && !freed) {
    std::vector<double> costs;
    for (const double x : places) costs.push_back(see({x}, 0));
    const std::size_t best = static_cast<std::size_t>(std::min_element(costs.begin(), costs.end()) - costs.begin());
    golden([&](double x) { return see({x}, 0); }, places[best ? best - 1 : 0],
           places[std::min(best + 1, places.size() - 1)], 40);
  } else {
    for (double step = 0.1; step > 1e-6; step *= 0.5)
      for (int direction = 0; direction < 9; ++direction) {
        Parameters<Model> q = p;
        const double one = step * (direction % 3 - 1), two = step * (direction / 3 - 1);
        q[0] *= 1 + one;
        if (p.size() == 2) q.back() *= 1 + two;
        for (std::size_t k = 0; k < q.size(); ++k)
          q[k] = std::clamp(q[k], Model::parameters[k].lower, Model::parameters[k].upper);
        see(q, freed ? factor + two : 0);
      }
  }
  const double excess = found - lowest.cost;
  error = std::sqrt(std::max(excess, 0.0));
  // A thousandth of a standard error, and what rounding does to distances of many.
  if (excess <= 1e-6 + 1e-9 * found) return "";
  std::string place;
  for (const double x : lowest.x) place += " " + shortest(x);
  return "the cost is " + shortest(lowest.cost) + " at" + place + ", " + shortest(found) + " at the value found, " +
         shortest(p[0]) + " " + shortest(factor);
}

template <class Model>
void one_experiment(Random& random, Tally& tally) {
  const Experiment made = random_experiment<Model>(random);
  constexpr std::string_view kModel = Model::info.key;
  judge_fit(
      tally, made.what, [&] { return fit_model(made.data, kModel, made.options); },
      [&](const FitResult& fit, double& error) { return wrong_with_experiment<Model>(made, fit, error); });
}

inline Tally random_experiments(std::uint64_t seed, std::size_t cases) {
  return random_cases("fits of curves", seed, cases, [](Random& random, Tally& tally) {
    for_each_model([&](auto model) { one_experiment<decltype(model)>(random, tally); });
  });
}

}  // namespace mixity::stress
