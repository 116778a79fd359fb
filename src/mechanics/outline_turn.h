// How an outline turns, and how far its segments are from a point, in the plane of T and A in units of their errors.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include "mechanics/curve_outline.h"

namespace mixity {

/// Three successive segments of an outline.
struct Turn {
  double lowest, highest;  // areas
  double sine, radius;     // the larger sine of their two angles, the smaller radius of a circle through three nodes
};

/// About a segment, 0 <= segment < number of nodes - 1. The curve is even in T: before T = 0 it is mirrored.
inline Turn turn_of(const std::vector<PlanePlace>& outline, int segment, double per_T, double per_A) {
  const int last = static_cast<int>(outline.size()) - 1;
  const auto node = [&](int k) {
    const PlanePlace place = outline[static_cast<std::size_t>(std::min(std::abs(k), last))];
    return k < 0 ? PlanePlace{-place.T, place.A} : place;
  };
  const PlanePlace nodes[] = {node(segment - 1), node(segment), node(segment + 1), node(segment + 2)};
  Turn turn{nodes[3].A, std::max(nodes[0].A, nodes[1].A), 0, std::numeric_limits<double>::infinity()};
  double x = 0, z = 0;
  for (int k = 0; k < 3; ++k) {
    const double dx = (nodes[k + 1].T - nodes[k].T) * per_T, dz = (nodes[k + 1].A - nodes[k].A) * per_A;
    if (k > 0) {
      const double length = std::sqrt((x * x + z * z) * (dx * dx + dz * dz));
      const double sine = x * dx + z * dz > 0 ? std::abs(x * dz - z * dx) / length : 1.0;
      turn.sine = std::max(turn.sine, sine);
      turn.radius = std::min(turn.radius, std::sqrt(std::pow(x + dx, 2) + std::pow(z + dz, 2)) / (2 * sine));
    }
    x = dx;
    z = dz;
  }
  return turn;
}

/// A lower bound of a point's distance from the curve along a segment and its neighbours: that from the boxes of their
/// nodes. T and A are monotone between nodes; beside a node at which one turns, the boxes are wider by as much as the
/// widest segment beside.
inline double least_distance(const std::vector<PlanePlace>& outline, int segment, PlanePlace point, double per_T,
                             double per_A) {
  const int last = static_cast<int>(outline.size()) - 1;
  const auto beyond = [&](int k, double PlanePlace::*axis) {
    const auto step = [&](int of) {
      return outline[static_cast<std::size_t>(of + 1)].*axis - outline[static_cast<std::size_t>(of)].*axis;
    };
    const double here = step(k), before = k > 0 ? step(k - 1) : here, after = k + 1 < last ? step(k + 1) : here;
    const bool turns = !(here * before > 0 && here * after > 0);
    return turns ? std::max({std::abs(before), std::abs(here), std::abs(after)}) : 0.0;
  };
  const auto outside = [&](int k, double PlanePlace::*axis) {
    const double one = outline[static_cast<std::size_t>(k)].*axis, other = outline[static_cast<std::size_t>(k + 1)].*axis;
    return std::max({std::min(one, other) - point.*axis, point.*axis - std::max(one, other), beyond(k, axis)}) -
           beyond(k, axis);
  };
  double least = std::numeric_limits<double>::infinity();
  for (int k = std::max(segment - 1, 0); k < std::min(segment + 2, last); ++k)
    least = std::min(least, std::hypot(outside(k, &PlanePlace::T) * per_T, outside(k, &PlanePlace::A) * per_A));
  return least;
}

}  // namespace mixity
