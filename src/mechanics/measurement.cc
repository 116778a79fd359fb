#include "mechanics/measurement.h"

#include "mechanics/vector_math.h"

namespace mixity {

MIXITY_LANES void toughness_ratios(const double* P, const double* T, const double* A, double* ratios, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) {
    const double a = radius_from_area(A[i]), y = edge_load(a, P[i]), ratio = toughness_ratio(y, T[i], a);
    ratios[i] = y > 0 ? ratio : -1.0;
  }
}

}  // namespace mixity
