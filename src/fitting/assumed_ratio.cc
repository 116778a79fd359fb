#include "fitting/assumed_ratio.h"

#include <cmath>
#include <optional>
#include <string>

#include "base/number_text.h"

namespace mixity {

Message ratio_of_errors_matters(const Dataset& data, const FitResult& fit, const FitOfValues& refit) {
  constexpr double kFactor = 10, kShare = 0.25;  // of the interval, as for other tests
  const FittedParameter& first = fit.parameters[0];
  if (fit.objective != Objective::curve || !data.has_energies || !data.errors.empty() || !first.stderr_) return {};
  const double half = 1.96 * *first.stderr_, low = first.interval ? first.interval->low.value_or(first.lower) : -half,
               high = first.interval ? first.interval->high.value_or(first.upper) : half;
  std::string values;
  bool matters = false;
  for (const double factor : {1 / kFactor, kFactor}) {
    Dataset other = data;
    for (PointEnergies& energies : other.energies) {
      energies.sigma_GI = 1;
      energies.sigma_GII = factor;
    }
    const FitResult found = refit(other);
    if (!found.has_values() || !found.parameters[0].value) return {};
    const double value = *found.parameters[0].value;
    matters = matters || std::abs(value - *first.value) > kShare * (high - low);
    values += (values.empty() ? "" : ", ") + rounded(value, 3) + " if those of G_II are " +
              (factor < 1 ? "a tenth of" : "ten times") + " those of G_I";
  }
  if (!matters) return {};
  return "no standard errors of G_I and G_II are stated, and equal ones are assumed; " + first.name + " is " + values +
         ": state them in columns sigma_GI and sigma_GII";
}

}  // namespace mixity
