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
      turn.radius = std::min(turn.radius, std::sqrt((x + dx) * (x + dx) + (z + dz) * (z + dz)) / (2 * sine));
    }
    x = dx;
    z = dz;
  }
  return turn;
}

/// The extent of a segment and its neighbours in T and A together.
inline double size_of(const std::vector<PlanePlace>& outline, int segment, double per_T, double per_A) {
  const int last = static_cast<int>(outline.size()) - 1;
  const PlanePlace &from = outline[static_cast<std::size_t>(std::max(segment - 1, 0))],
                   &to = outline[static_cast<std::size_t>(std::min(segment + 2, last))];
  return std::abs(to.T - from.T) * per_T + std::abs(to.A - from.A) * per_A;
}

/// A lower bound of a point's distance from the curve along a segment and its neighbours: that from the boxes of their
/// nodes, between which T and A are monotone; 0 beside a node at which one turns. Of outlines with nodes along rays.
inline double least_distance(const std::vector<PlanePlace>& outline, int segment, PlanePlace point, double per_T,
                             double per_A) {
  const int last = static_cast<int>(outline.size()) - 1;
  const auto place = [&](int k) { return outline[static_cast<std::size_t>(std::clamp(k, 0, last))]; };
  double least = std::numeric_limits<double>::infinity();
  for (int k = std::max(segment - 1, 0); k < std::min(segment + 2, last); ++k) {
    const auto outside = [&](double PlanePlace::*axis) {
      const double before = place(k - 1).*axis, from = place(k).*axis, to = place(k + 1).*axis,
                   after = place(k + 2).*axis;
      const bool monotone = (to - from) * (from - before) >= 0 && (to - from) * (after - to) >= 0;
      return monotone ? std::max({std::min(from, to) - point.*axis, point.*axis - std::max(from, to), 0.0}) : 0.0;
    };
    least = std::min(least, std::hypot(outside(&PlanePlace::T) * per_T, outside(&PlanePlace::A) * per_A));
  }
  return least;
}

}  // namespace mixity
