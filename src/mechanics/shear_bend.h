// How strongly tau^2(y, T) bends: bounds of its second derivatives, with which curve_distance.h proves that no other
// stretch of a curve is nearer. A model that has none here is searched as a whole instead.
#pragma once

#include <cmath>
#include <limits>

#include "mechanics/registry.h"

namespace mixity {

/// Upper bounds of |d^2 tau^2| over all y and T; infinite where nothing is known.
struct ShearBend {
  double TT = std::numeric_limits<double>::infinity(), yT = TT, yy = TT;
};

/// The second derivatives are homogeneous of degree 0. Over a way w, the larger of `narrow` times dT/(T + T_part y) and
/// narrow dy/(y + y_part T), the sums of moduli that curve_distance takes for them grow to (1 + 8 w)^2 of themselves at
/// most, up to w = 1/4: as much as y and T to the fourth power of opposite sign. `narrow` is infinite where nothing is
/// known.
struct ShearReach {
  double narrow = std::numeric_limits<double>::infinity(), y_part = 0, T_part = 0;
};

template <class Model>
ShearBend shear_bend(const Parameters<Model>& p) {
  const double l = p[0];
  if constexpr (Model::info.key == "c") {
    return {2 * l, 0, 0};
  } else if constexpr (Model::info.key == "a") {
    // With w = m T^2/y^2: 2 l (1 - 3w)/(1 + w)^3, 8 l sqrt(w^3/m)/(1 + w)^3 and 2 (l/m) w^2 (w - 3)/(1 + w)^3.
    const double m = 1 - l;
    if (!(m > 0)) return {2, 0, 0};
    return {2 * l, l / std::sqrt(m), 2 * l / m};
  } else if constexpr (Model::info.key == "b") {
    // In polar coordinates tau^2 = r^2 S(psi), S = (cos 2 k psi - cos 2 psi)/2, with the second derivatives 2 S, S' and
    // S'' + 2 S. |S| <= pi l/4, |S'| <= (1 + pi) l/2 and |S'' + 2 S| <= (2 + pi/2) l, which bounds the norm by their
    // sum.
    const double bound = 5.7 * l;
    return {bound, bound, bound};
  } else {
    return {};
  }
}

template <class Model>
ShearReach shear_reach(const Parameters<Model>& p) {
  if constexpr (Model::info.key == "a") {
    return {1, std::sqrt(1 - p[0]), 1};
  } else if constexpr (Model::info.key == "b" || Model::info.key == "c") {
    return {1, 1, 1};
  } else if constexpr (Model::info.key == "bk") {
    // B^eta near psi = pi/2 is exp(-eta cos^2 psi), and f turns from its slope to r where eta cos^2 psi = r.
    const double eta = p[1], narrow = std::sqrt(std::fmin(p[0], 1) / std::fmax(eta, 1));
    return {eta > 2 ? std::sqrt(eta) : 1, narrow, eta >= 2 ? narrow : 0};
  } else {
    return {};
  }
}

}  // namespace mixity
