#include "mechanics/vector_math.h"
// after the declarations of the vector forms

#include "mechanics/lanes.h"

namespace mixity {
namespace {

template <class Model>
MIXITY_LOOP void loop(double parameter, const double* __restrict first, const double* __restrict second, std::size_t n,
                      double* __restrict value, double* __restrict slope, double* __restrict curvature) {
  for (std::size_t i = 0; i < n; ++i) {
    const LaneValue<double> lane = Model::lane(parameter, LanePoint<double>{first[i], second[i]});
    value[i] = Model::kLogSign * std::log(lane.argument);
    slope[i] = lane.slope;
    curvature[i] = lane.curvature;
  }
}

template <class Model>
MIXITY_WIDE void wide(double parameter, const double* first, const double* second, std::size_t n, double* value,
                      double* slope, double* curvature) {
  loop<Model>(parameter, first, second, n, value, slope, curvature);
}

}  // namespace

template <class Model>
void log_toughness_lanes(double parameter, const double* first, const double* second, std::size_t n, double* value,
                         double* slope, double* curvature) {
  if (MIXITY_HAS_WIDE) return wide<Model>(parameter, first, second, n, value, slope, curvature);
  loop<Model>(parameter, first, second, n, value, slope, curvature);
}

namespace {
[[gnu::used]] const auto lane_instances = each_model([](auto model) {
  if constexpr (HasLanes<decltype(model)>)
    return &log_toughness_lanes<decltype(model)>;
  else
    return nullptr;
});
}  // namespace

}  // namespace mixity
