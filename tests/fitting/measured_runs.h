// Synthetic loading runs of model c in mN and mm^2, with noise in T and A, whose constants can be wrong.
#pragma once

#include <map>
#include <string>

#include "fitting/options.h"
#include "fitting/synthetic_runs.h"

namespace mixity {

/// Six loads, 1 % of noise in T and A; `errors`: of the constants, in SI.
inline Dataset measured_runs(unsigned seed, std::map<std::string, double, std::less<>> errors = {},
                             std::size_t points = 15, double upto = 0.9) {
  SeededNoise noise(seed, 0.01), shear(seed + 1000, 0.01);
  Dataset data = synthetic_runs("c", {0.15}, {-1, 0.5, 2, 5, 12, 30}, points, upto, noise);
  for (Point& point : data.points) point.T *= 1 + shear();
  data.contact = Contact{0.01, 2e6, 0.03};
  data.metadata.radius = 0.01;
  data.metadata.modulus = 2e6;
  data.metadata.toughness = 0.03;
  data.metadata.load_offset = data.metadata.shear_offset = data.metadata.area_offset = 0;
  data.metadata.area_scale = 1;
  data.metadata.standard_errors = std::move(errors);
  data.display.force_scale = data.contact->force_unit();
  data.display.area_scale = data.contact->area_unit();
  return data;
}

/// What the errors of measured_runs are.
inline FitOptions stated_errors() {
  return {.sigma_T = *parse_quantity("1%"), .sigma_A = *parse_quantity("1%"), .intervals = false};
}

}  // namespace mixity
