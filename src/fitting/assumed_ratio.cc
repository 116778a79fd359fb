#include "fitting/assumed_ratio.h"

#include <string>

#include "base/number_text.h"

namespace mixity {

Message ratio_of_errors_matters(const Dataset& data, const FitResult& fit, const FitOfValues& refit) {
  constexpr double kFactor = 10;
  const FittedParameter& first = fit.parameters[0];
  if (fit.objective != Objective::curve || !data.has_energies || !data.errors.empty() || !first.stderr_) return {};
  Dataset other = data;
  std::string values;
  bool matters = false;
  for (const double factor : {1 / kFactor, kFactor}) {
    for (PointEnergies& energies : other.energies) {
      energies.sigma_GI = 1;
      energies.sigma_GII = factor;
    }
    const FitResult found = refit(other);
    if (!found.has_values() || !found.parameters[0].value) return {};
    const double value = *found.parameters[0].value;
    matters = matters || moves_or_widens((value - *first.value) / *first.stderr_, 1);
    values += (values.empty() ? "" : ", ") + rounded(value, 3) + " if those of G_II are " +
              (factor < 1 ? "a tenth of" : "ten times") + " those of G_I";
  }
  if (!matters) return {};
  return "no standard errors of G_I and G_II are stated, and equal ones are assumed; " + first.name + " is " + values +
         ": state them in columns sigma_GI and sigma_GII";
}

}  // namespace mixity
