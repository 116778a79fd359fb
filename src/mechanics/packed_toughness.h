// Evaluates ln f of a one-parameter law at many points in one vectorised loop.
#pragma once

#include <cstddef>

#include "mechanics/registry.h"

namespace mixity {

template <class Law>
concept HasPackedForm = requires(const Law& law, double p, PackedPoint<double> point) {
  law.packed_form(p, point);
};

/// value[i] = ln f, slope[i] and curvature[i] its derivatives in the parameter, at the n points {first[i], second[i]}.
/// Absolute error of ln f a few eps.
template <class Law>
void packed_log_toughness(Law law, double parameter, const double* first, const double* second, std::size_t n,
                          double* value, double* slope, double* curvature);

}  // namespace mixity
