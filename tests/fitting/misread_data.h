// The data of Mergel et al. as instruments would read them that are off by a stated constant.
#pragma once

#include <string>
#include <vector>

#include "dataset/dataset.h"

namespace mixity {

/// Readings from which the stated constants make those of `right`.
struct Misread {
  std::string constant;
  Dataset data;
};

inline Dataset mergel(const Overrides& constants = {}) {
  return load_dataset(MIXITY_ROOT "/data/mergel2018.csv", constants);
}

inline std::vector<Misread> misread_mergel() {
  std::vector<Misread> all{{"load_offset", mergel({{"load_offset", "-4 mN"}})},
                           {"shear_offset", mergel({{"shear_offset", "-3 mN"}})},
                           {"area_scale", mergel({{"area_scale", "1.0309278350515463"}})},
                           {"area_offset", mergel({{"area_offset", "0.01 mm^2"}})}};
  for (Misread& one : all) {
    const ConstantsScale by(one.data.stated_constants());
    for (Point& point : one.data.points) {
      point.P = by.measured_load(point.P);
      point.T = by.measured_shear(point.T);
      point.A = by.measured_area(point.A);
    }
    for (double& load : one.data.curve_loads) load = by.measured_load(load);
  }
  return all;
}

}  // namespace mixity
