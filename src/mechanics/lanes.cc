#include <array>
#include <cmath>
#include <tuple>

// The vector forms of these in the C library, which compilers use by themselves only with -ffast-math.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__)
extern "C" {
__attribute__((simd("notinbranch"))) double log(double) noexcept;
__attribute__((simd("notinbranch"))) double tan(double) noexcept;
}
#endif

#include "mechanics/lanes.h"

namespace mixity {
namespace {

template <class Model>
inline __attribute__((always_inline)) void loop(double parameter, const double* __restrict first,
                                                const double* __restrict second, std::size_t n,
                                                double* __restrict value, double* __restrict slope,
                                                double* __restrict curvature) {
  for (std::size_t i = 0; i < n; ++i) {
    const LaneValue lane = Model::lane(parameter, {first[i], second[i]});
    value[i] = Model::kLogSign * std::log(lane.argument);
    slope[i] = lane.slope;
    curvature[i] = lane.curvature;
  }
}

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
template <class Model>
__attribute__((target("avx2"))) void wide(double parameter, const double* first, const double* second, std::size_t n,
                                          double* value, double* slope, double* curvature) {
  loop<Model>(parameter, first, second, n, value, slope, curvature);
}
#endif

template <class Model>
void any(double parameter, const double* first, const double* second, std::size_t n, double* value, double* slope,
         double* curvature) {
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
  if (__builtin_cpu_supports("avx2")) return wide<Model>(parameter, first, second, n, value, slope, curvature);
#endif
  loop<Model>(parameter, first, second, n, value, slope, curvature);
}

}  // namespace

template <class Model>
void log_toughness_lanes(double parameter, const double* first, const double* second, std::size_t n, double* value,
                         double* slope, double* curvature) {
  any<Model>(parameter, first, second, n, value, slope, curvature);
}

// One instance for each model of the registry that has lanes: their addresses make them.
namespace {
using LaneLoop = void (*)(double, const double*, const double*, std::size_t, double*, double*, double*);

template <class Model>
constexpr LaneLoop instance() {
  if constexpr (HasLanes<Model>)
    return &log_toughness_lanes<Model>;
  else
    return nullptr;
}

[[gnu::used]] const auto instances =
    std::apply([](auto... model) { return std::array{instance<decltype(model)>()...}; }, Models{});
}  // namespace

}  // namespace mixity
