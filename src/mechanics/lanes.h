// ln f of a one-parameter law for arrays of points: LaneValue of mechanics/model.h in a vectorised loop.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>

#include "mechanics/registry.h"

namespace mixity {

template <class Model>
concept HasLanes = requires(double p, LanePoint point) {
  Model::lane(p, point);
};

/// value[i] = ln f, slope[i] and curvature[i] its derivatives in the parameter at n points given by first[i], second[i]
/// (LanePoint). Absolute error of ln f some eps. Defined for the models of the registry that have lanes.
template <class Model>
void log_toughness_lanes(double parameter, const double* first, const double* second, std::size_t n, double* value,
                         double* slope, double* curvature);

/// One address for each model of the registry that has lanes, null for the others: taking them makes the instances that
/// a source file defines.
template <class Pointer, class Model, class Address>
constexpr Pointer lane_instance(Address address) {
  if constexpr (HasLanes<Model>)
    return address(Model{});
  else
    return nullptr;
}
template <class Pointer, class Address>
constexpr auto lane_instances(Address address) {
  return std::apply([&](auto... model) { return std::array{lane_instance<Pointer, decltype(model)>(address)...}; },
                    Models{});
}

}  // namespace mixity
