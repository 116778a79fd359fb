// ln f of a one-parameter law for arrays of points: LaneValue of mechanics/model.h in a vectorised loop.
#pragma once

#include <cstddef>

#include "mechanics/registry.h"

namespace mixity {

template <class Model>
concept HasLanes = requires(double p, LanePoint<double> point) {
  Model::lane(p, point);
};

/// value[i] = ln f, slope[i] and curvature[i] its derivatives in the parameter at n points given by first[i], second[i]
/// (LanePoint). Absolute error of ln f some eps. Defined for the models of the registry that have lanes.
template <class Model>
void log_toughness_lanes(double parameter, const double* first, const double* second, std::size_t n, double* value,
                         double* slope, double* curvature);

}  // namespace mixity
