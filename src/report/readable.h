// A fitted parameter in the unit that a reader would choose.
#pragma once

#include "dataset/units.h"
#include "fitting/result.h"

namespace mixity {

/// MPa rather than Pa, by the size of the value; the drawn profile stays as it is.
inline FittedParameter readable(FittedParameter parameter) {
  if (!parameter.value || parameter.unit.empty()) return parameter;
  const ReadableUnit shown = readable_unit(*parameter.value, parameter.unit);
  const auto scale = [&](std::optional<double>& value) {
    if (value) *value *= shown.factor;
  };
  scale(parameter.value);
  scale(parameter.stderr_);
  parameter.lower *= shown.factor;
  parameter.upper *= shown.factor;
  if (parameter.interval) {
    scale(parameter.interval->low);
    scale(parameter.interval->high);
  }
  if (parameter.bootstrap)
    for (double* value : {&parameter.bootstrap->low, &parameter.bootstrap->high,
                          &parameter.bootstrap->standard_deviation, &parameter.bootstrap->bias})
      *value *= shown.factor;
  if (parameter.prior) {
    parameter.prior->mean *= shown.factor;
    parameter.prior->standard_error *= shown.factor;
  }
  parameter.unit = shown.unit;
  return parameter;
}

}  // namespace mixity
