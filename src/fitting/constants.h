// Constants of the experiment in the residuals of a fit.
#pragma once

#include "dataset/constants.h"

namespace mixity {

/// Derivatives of a residual; `in` gives that in a constant, by the chain rule through ConstantsScale.
struct ResidualSlopes {
  double by_P, by_T, by_A;                  // in P, T and A as scaled
  double log_sigma_T = 0, log_sigma_A = 0;  // in the logarithms of their errors

  double in(Constant constant, double P, double T, double A, const ConstantsScale& scale) const {
    const double by_force = by_P * P + by_T * T + log_sigma_T, by_area = by_A * A + log_sigma_A;
    switch (constant) {
      case kToughness:
        return -by_force - 2.0 / 3 * by_area;
      case kModulus:
        return 2.0 / 3 * by_area;
      case kRadius:
        return -by_force - 4.0 / 3 * by_area;
      case kAreaScale:
        return by_area;
      case kLoadOffset:
        return by_P * scale.force;
      case kShearOffset:
        return by_T * scale.force;
      case kAreaOffset:
        break;
    }
    return by_A * scale.area;
  }
};

}  // namespace mixity
