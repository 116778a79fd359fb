// Random experiments of loads and areas, fitted with the objectives area and curve, with and without a freed constant:
// the cost that the program says is the lowest against a brute-force scan of it. Areas come from LoadedContact::at and
// the curve's points from EquilibriumCurve, which contacts.h and the tests of mechanics judge; nothing of the fitting
// is used.
#pragma once

#include <map>

#include "fitting/synthetic_runs.h"
#include "mechanics/sampling.h"
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
  const bool curve = chance(random, 0.5);
  const double noise = log_uniform(random, 1e-6, 0.1);
  const int runs = 1 + static_cast<int>(random() % 3), per_run = 1 + static_cast<int>(log_uniform(random, 1, 20));
  std::normal_distribution<double> normal;
  Dataset& data = result.data;
  data.path = data.name = "random";
  data.has_loads = true;
  std::string loads;
  for (int run = 0; run < runs; ++run) {
    const double P = uniform(random, -4, 30);
    const LoadedContact<Model> contact(p, P);
    const double last = std::min(contact.last_load(), 20 * circle_radius(P));
    data.curves.push_back(shortest(P));
    data.curve_loads.push_back(P);
    loads += " " + shortest(P);
    for (int i = 0; i < per_run; ++i) {
      const double T = last * (chance(random, 0.1) ? 1 + 0.1 * uniform(random) : uniform(random));
      const Equilibrium found = contact.at(T);
      const double y = found.status == EquilibriumStatus::ok ? found.y : contact.branches().back().y_bottom;
      const double A = area_from_radius(radius_from_edge_load(y, P)), sigma_A = noise * A, sigma_T = noise * last;
      const double T_measured = curve ? std::max(T + sigma_T * normal(random), 0.0) : T;
      const double A_measured = std::max(A + sigma_A * normal(random), 0.1 * A);
      const auto line = data.points.size() + 2, curve_index = static_cast<std::size_t>(run);
      data.points.push_back({line, curve_index, P, T_measured, A_measured});
      data.errors.push_back({curve ? sigma_T : 0, sigma_A, 0});
    }
  }
  data.rows = data.points.size();
  result.options.objective = curve ? Objective::curve : Objective::area;
  // with a constant freed the condition number of the normal matrix goes up: factor and lambda move areas alike
  if (p.size() == 1 && chance(random, 0.2)) result.options.free = {kToughness};
  result.truth.assign(p.begin(), p.end());
  result.what = std::string(Model::info.key);
  for (const double value : p) result.what += " " + shortest(value);
  result.what += " P=" + loads + " noise " + rounded(noise, 3) + ", " + std::to_string(data.rows) + " points, " +
                 std::string(to_string(result.options.objective)) + (result.options.free.empty() ? "" : ", freed");
  return result;
}

/// Where the curve first reaches T, or its end: what lies beyond is far from all points.
template <class Model>
double phi_of_shear(const EquilibriumCurve<Model>& curve, const PhiRange& range, double T) {
  constexpr int kPlaces = 60;
  for (int i = 1; i <= kPlaces; ++i) {
    double high = range.from + (range.to - range.from) * i / kPlaces;
    if (curve.point(high).T <= T) continue;
    double low = range.from + (range.to - range.from) * (i - 1) / kPlaces;
    for (int j = 0; j < 50; ++j) {
      const double middle = 0.5 * (low + high);
      (curve.point(middle).T <= T ? low : high) = middle;
    }
    return low;
  }
  return range.to;
}

/// Sum of squares at x, the model's parameters and ln of the factor on the toughness.
template <class Model>
double experiment_cost(const Experiment& experiment, const Parameters<Model>& p, double log_factor) {
  const double force = std::exp(-log_factor), area = std::exp(-2.0 / 3 * log_factor);
  const bool curve = experiment.options.objective == Objective::curve;
  double T_most = 0, sum = 0;
  const Dataset& data = experiment.data;
  for (std::size_t k = 0; k < data.points.size(); ++k)
    T_most = std::max(T_most, force * (data.points[k].T + 10 * data.errors[k].T));
  std::map<double, std::pair<LoadedContact<Model>, std::vector<CurvePoint>>> of_load;
  for (std::size_t k = 0; k < data.points.size(); ++k) {
    const Point& point = data.points[k];
    const double P = point.P * force, T = point.T * force, A = point.A * area;
    const double sigma_T = data.errors[k].T * force, sigma_A = data.errors[k].A * area;
    auto found = of_load.find(P);
    if (found == of_load.end()) {
      found = of_load.emplace(P, std::pair(LoadedContact<Model>(p, P), std::vector<CurvePoint>{})).first;
      if (!found->second.first.obstacle().empty() || !found->second.first.in_contact()) return HUGE_VAL;
      if (curve) {
        const EquilibriumCurve<Model> whole(p, P);
        PhiRange range = drawable_ranges(whole, 2 * T_most).front();
        range.to = phi_of_shear(whole, range, 2 * T_most);
        constexpr int kPlaces = 300;
        std::vector<CurvePoint>& line = found->second.second;
        for (int i = 0; i <= kPlaces; ++i) {
          line.push_back(whole.point(range.from + (range.to - range.from) * i / kPlaces));
          if (i < 2) continue;
          // Where T turns is a place of its own: on either side of it a load is passed.
          const auto last = line.end() - 1;
          const double before = last[-1].T - last[-2].T, now = last->T - last[-1].T;
          if (before * now >= 0) continue;
          const auto turned = [&](double phi) { return before > 0 ? -whole.point(phi).T : whole.point(phi).T; };
          const CurvePoint turn = whole.point(golden(turned, last[-2].phi, last->phi, 60).x[0]);
          line.insert(turn.phi < last[-1].phi ? last - 1 : last, turn);
        }
      }
    }
    const LoadedContact<Model>& contact = found->second.first;
    const std::vector<CurvePoint>& line = found->second.second;
    const Equilibrium at = contact.at(T);
    const double y = at.status == EquilibriumStatus::ok ? at.y : contact.branches().back().y_bottom;
    double distance = std::abs(area_from_radius(radius_from_edge_load(y, P)) - A) / sigma_A;
    const EquilibriumCurve<Model> whole(p, P);
    if (curve && !whole.uncoupled()) {
      const auto from = [&](const CurvePoint& q) { return std::hypot((q.T - T) / sigma_T, (q.A - A) / sigma_A); };
      distance = HUGE_VAL;
      for (std::size_t i = 0; i < line.size(); ++i) {
        const bool lowest = (i == 0 || from(line[i]) <= from(line[i - 1])) &&
                            (i + 1 == line.size() || from(line[i]) <= from(line[i + 1]));
        if (!lowest) continue;
        distance = std::min(distance, from(line[i]));
        for (const std::size_t beside : {i ? i - 1 : 0, std::min(i + 1, line.size() - 1)})
          distance = std::min(
              distance, golden([&](double phi) { return from(whole.point(phi)); },
                               std::min(line[i].phi, line[beside].phi), std::max(line[i].phi, line[beside].phi), 55)
                            .cost);
      }
    }
    sum += distance * distance;
  }
  return sum;
}

/// Where to look for the lowest cost of a law of one parameter: between rising `places`, and as close as one likes
/// below each value at which a point passes the last fold, where basins of areas may be as narrow.
template <class Model>
std::vector<double> with_folds_passed(const Dataset& data, std::vector<double> places) {
  const std::vector<double> coarse = places;
  for (const double P : data.curve_loads) {
    const auto last_load = [&](double x) {
      const LoadedContact<Model> contact({x}, P);
      return contact.obstacle().empty() && contact.in_contact() ? contact.last_load() : 0.0;
    };
    std::vector<double> loads;
    for (const double x : coarse) loads.push_back(last_load(x));
    for (const Point& point : data.points)
      for (std::size_t k = 1; k < coarse.size() && point.P == P; ++k) {
        if ((point.T > loads[k - 1]) == (point.T > loads[k])) continue;
        double low = coarse[k - 1], high = coarse[k];
        for (int i = 0; i < 50; ++i) {
          const double middle = 0.5 * (low + high);
          ((point.T > last_load(middle)) == (point.T > loads[k]) ? high : low) = middle;
        }
        for (double share = 0.25; share > 1e-14; share *= 0.25) places.push_back(high * (1 - share));
        places.push_back(high);
      }
  }
  std::sort(places.begin(), places.end());
  return places;
}

/// What is wrong with the fit; `error` in standard errors.
template <class Model>
std::string wrong_with_experiment(const Experiment& experiment, const FitResult& fit, double& error) {
  error = 0;
  if (const std::string wrong = wrong_with_numbers(fit); !wrong.empty()) return wrong;
  if (fit.status == FitStatus::not_converged) return "";
  const bool freed = !experiment.options.free.empty(), curve = experiment.options.objective == Objective::curve;
  std::vector<double> places;
  if (Model::parameters.size() == 1 && !freed) {
    places = places_to(Model::parameters[0].upper, curve ? 12 : 60);
    if (!curve) places = with_folds_passed<Model>(experiment.data, std::move(places));
  }
  if (fit.status == FitStatus::not_identifiable) {
    if (places.empty() || experiment.data.points.size() < 2) return "";
    double least = HUGE_VAL, most = 0;
    for (const double x : places) {
      const double cost = experiment_cost<Model>(experiment, {x}, 0);
      least = std::min(least, cost);
      if (cost < HUGE_VAL) most = std::max(most, cost);
    }
    // chi^2 of one parameter at 95 %, and a tenth for what either has not seen; a flat bottom is no value
    return most > 1.1 * (least + 3.85) && fit.message.find("every value") != std::string::npos
               ? "costs from " + shortest(least) + " to " + shortest(most) + " are called all the same"
               : "";
  }
  Parameters<Model> p{};
  for (std::size_t k = 0; k < p.size(); ++k) p[k] = *fit.parameters[k].value;
  const double factor = freed ? fit.solution.back() : 0, found = experiment_cost<Model>(experiment, p, factor);
  // the cost that the program reports is the one this file computes: to 1e-6 of a chi^2 of one, or of itself
  if (!(std::abs(found - fit.sum_of_squares) <= 1e-6 * (1 + found)))
    return "the cost is " + shortest(found) + ", reported " + shortest(fit.sum_of_squares);
  // Lower places: the truth's, over the whole range of the only parameter, around the place found of two.
  Place lowest{{}, found};
  const auto see = [&](const Parameters<Model>& q, double log_factor) {
    const double cost = experiment_cost<Model>(experiment, q, log_factor);
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
  // Next to a fold passed, the last bits of the value may be worth more than that.
  double last_bits = 0;
  for (int bits = -8; bits <= 8 && !places.empty(); ++bits) {
    const double x = std::clamp(p[0] * (1 + bits * 1.1e-16), Model::parameters[0].lower, Model::parameters[0].upper);
    last_bits = std::max(last_bits, std::abs(experiment_cost<Model>(experiment, {x}, 0) - found));
  }
  // A thousandth of a standard error, and what rounding does to distances of many.
  if (excess <= 1e-6 + 1e-9 * found + last_bits) return "";
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
  return random_cases("fits of areas and curves", seed, cases, [](Random& random, Tally& tally) {
    for_each_model([&](auto model) { one_experiment<decltype(model)>(random, tally); });
  });
}

}  // namespace mixity::stress
