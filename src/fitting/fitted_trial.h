// A finished fit as what it tried out: the model's parameters and the corrections to the experiment.
#pragma once

#include "fitting/fit.h"

namespace mixity {

/// Only for a fit all of whose parameters have values. `options`: those of the fit, for corrections that were not free.
template <class Model>
Trial<Model> fitted_trial(const Dataset& data, const FitResult& fit, const FitOptions& options) {
  Trial<Model> trial{{}, options.corrections};
  const double scales[] = {data.contact ? data.contact->toughness : 1, data.contact ? data.contact->modulus : 1,
                           data.display.force_scale, data.display.area_scale};
  for (const FittedParameter& parameter : fit.parameters) {
    for (std::size_t k = 0; k < trial.parameters.size(); ++k)
      if (parameter.name == Model::parameters[k].name) trial.parameters[k] = *parameter.value;
    for (const Correction correction : {kToughness, kModulus, kLoadOffset, kAreaOffset}) {
      if (parameter.name != kCorrectionNames[correction]) continue;
      const double value = *parameter.value / scales[correction];
      trial.corrections[correction] = correction == kToughness || correction == kModulus ? std::log(value) : value;
    }
  }
  return trial;
}

inline bool has_all_values(const FitResult& fit) {
  for (const FittedParameter& parameter : fit.parameters)
    if (!parameter.value) return false;
  return true;
}

}  // namespace mixity
