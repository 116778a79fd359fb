// Random contacts over the whole domain and its edges: every area against the printed equation in 50 digits.
#pragma once

#include <array>
#include <cmath>
#include <random>

#include "base/number_text.h"
#include "mechanics/area_judge.h"
#include "mechanics/batch.h"
#include "stress/tally.h"

namespace mixity::stress {

using Random = std::mt19937_64;

inline double uniform(Random& random, double low = 0, double high = 1) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
inline double log_uniform(Random& random, double low, double high) {
  return low * std::pow(high / low, uniform(random));
}
inline bool chance(Random& random, double p) { return uniform(random) < p; }

/// A third at or next to a bound, a third over the logarithm of the distance from one, the rest anywhere.
inline double random_parameter(Random& random, const ParameterInfo& info) {
  const double width = std::min(info.upper, 20.0) - info.lower;
  const bool from_below = chance(random, 0.5);
  if (chance(random, 0.1)) return from_below ? info.lower : info.lower + width;
  const double distance = chance(random, 0.5) ? log_uniform(random, 1e-16, 1) * width : uniform(random) * width;
  return from_below ? info.lower + distance : info.lower + width - distance;
}

/// From pull-off to 1e8: next to pull-off, next to 0, of order one, large.
inline double random_load(Random& random) {
  const double pull_off = -1.5 * pi<double>();
  switch (random() % 5) {
    case 0:
      return pull_off * (1 - log_uniform(random, 1e-15, 1));
    case 1:
      return chance(random, 0.3) ? 0.0 : log_uniform(random, 1e-300, 1e-3) * (chance(random, 0.5) ? 1 : -1);
    case 2:
      return log_uniform(random, 1, 1e8);
    default:
      return uniform(random, pull_off * 0.999, 40);
  }
}

/// As parts of where the contact first loses stability, or of a natural scale if it never does; or any double.
inline double random_shear(Random& random, double scale) {
  switch (random() % 7) {
    case 6:
      return std::exp2(uniform(random, -1074, 498));  // from the least double to kLargestLoad
    case 0:
      return chance(random, 0.2) ? 0.0 : scale * log_uniform(random, 1e-300, 1e-2);
    case 1:
      return scale * (1 - log_uniform(random, 1e-16, 0.1));
    case 2:
      return scale * (1 + log_uniform(random, 1e-16, 0.1));
    case 3:
      return scale * log_uniform(random, 1, 1e12);
    default:
      return scale * uniform(random);
  }
}

/// Four loads T on one contact, each alone and all as an array.
template <class Model>
void one_contact(Random& random, Tally& tally) {
  Parameters<Model> p{};
  for (std::size_t k = 0; k < p.size(); ++k) p[k] = random_parameter(random, Model::parameters[k]);
  const double P = random_load(random);
  std::string where = std::string(Model::info.key);
  for (const double value : p) where += " " + shortest(value);
  where += " P=" + shortest(P);
  const LoadedContact contact(Model{}, p, P);
  if (!contact.obstacle().empty()) {  // only a law that may have several equilibria is allowed to decline
    ++tally.cases;
    if (Model::equilibrium_domain(p).empty()) tally.fail(where + ": " + std::string(contact.obstacle()));
    return;
  }
  if (!contact.in_contact()) return tally.fail(where + ": no contact above pull-off");
  const double fold = tally.timed(where + " (folds)", [&] { return contact.branches().front().T_bottom; });
  const double w = Model::small_shear(p);
  const double scale = std::isfinite(fold) ? fold : circle_radius(P) / std::sqrt(w > 0 && w < 1e9 ? w : 1.0);
  std::array<double, 4> loads{}, areas{};
  std::array<Equilibrium, 4> alone;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const double T = std::min(random_shear(random, scale), kLargestLoad);
    loads[i] = T;
    const std::string here = where + " T=" + shortest(T);
    ++tally.cases;
    const Equilibrium& found = alone[i] = tally.timed(here, [&] { return contact.at(T); });
    tally.answered += found.status == EquilibriumStatus::ok;
    double error = 0;
    const std::string wrong = wrong_with_area(contact, Judge<Model>{p, P, T}, found, error);
    if (!wrong.empty()) tally.fail(here + ": " + wrong);
    // Towards a fold errors grow as the condition number; the worst of those elsewhere says how good the solver is.
    if (error > tally.worst_error && found.y > 0 && Judge<Model>{p, P, T}.condition(found.y) < 3)
      tally.see_error(error, here);
  }
  predict_areas(LoadedContact(Model{}, p, P), loads, areas);
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const Equilibrium& found = alone[i];
    const double A = found.status == EquilibriumStatus::ok ? contact_state(P, loads[i], found.y).A : 0;
    // Both within 4e-15 of the truth, or of what the condition leaves.
    if (std::abs(areas[i] - A) <= 8e-15 * A) continue;
    const double condition = found.y > 0 ? Judge<Model>{p, P, loads[i]}.condition(found.y) : 1;
    if (!(std::abs(areas[i] - A) <= std::min(2 * (4e-15 + 8e-16 * condition), 4e-5) * A))
      tally.fail(where + " T=" + shortest(loads[i]) + ": " + shortest(areas[i]) + " in an array, alone " + shortest(A));
  }
}

/// At least `cases` areas of all models, from a random stream of their own.
inline Tally random_contacts(std::uint64_t seed, std::size_t cases) {
  return random_cases("areas", seed, cases, [](Random& random, Tally& tally) {
    for_each_model([&](auto model) { one_contact<decltype(model)>(random, tally); });
  });
}

}  // namespace mixity::stress
