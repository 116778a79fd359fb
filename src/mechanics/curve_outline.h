// A coarse outline of an equilibrium curve in the plane of T and A, at the cost of a few square and cube roots a node.
// Along a ray T = t y the circle reads g(t) y^2 = 6 pi (y + P), where g = 1 + tau^2(1, t) does not depend on the load.
// One table of g therefore serves all loads, and each node lies on the curve without a search.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "mechanics/nearest_newton.h"

namespace mixity {

/// A point in the plane of T and A.
struct PlanePlace {
  double T, A;
};

template <class Law>
class RayTable {
 public:
  explicit RayTable(const nearest_detail::CurveFamily<Law>& family) : family_(family) {
    if (family.non_monotone) return;  // set_load makes its outline
    const double start = kFirst * (family.bounded ? std::min(1.0, std::sqrt(family.excess)) : 1.0);
    double t = 1;
    while (slope(t) > start && t > 1e-140) t /= 4;
    while (slope(4 * t) < start && t < 1e140) t *= 4;
    const double most = family.bounded ? std::min(kSteepest, 0.9999 * std::sqrt(family.excess)) : kSteepest;
    double ratio = 1.25;
    for (double q = slope(t); nodes_.size() < kMost; q = slope(t)) {
      nodes_.push_back({t, q});
      if (!(q < most) || t > 1e140) break;
      // neither tau/y nor T grows by too much from node to node
      while (ratio > 1.01 && slope(t * ratio) > 1.3 * q) ratio = 1 + 0.5 * (ratio - 1);
      t *= ratio;
      ratio = std::min(1 + 1.5 * (ratio - 1), 2.0);
    }
    if (family.bounded)
      for (; t < 1e12; t *= 4) nodes_.push_back({t, slope(t)});
    while (first_ + 2 < static_cast<int>(nodes_.size()) && nodes_[static_cast<std::size_t>(first_)].q < 200 * start)
      ++first_;
  }

  /// Sets the nodes 0..last() to the curve of the load P from JKR to `end`, both included.
  void set_load(double P, PlanePlace end) {
    P_ = P;
    end_ = end;
    if constexpr (kMayBeNonMonotone<Law>) {
      if (family_.non_monotone) return set_non_monotone_load();
    }
    const double bounded = above_pull_off(P) + P * family_.excess;
    asymptote_ = family_.bounded && bounded >= 0;
    along_rays_ = P >= 0 || asymptote_;
    last_ = along_rays_ ? static_cast<int>(nodes_.size()) - first_ + (asymptote_ ? 0 : 1) : kArcs;
    places_.resize(static_cast<std::size_t>(last_ + 1));
    if (!along_rays_) {
      for (int i = 0; i <= last_; ++i) places_[static_cast<std::size_t>(i)] = node(i);
      return;
    }
    places_.front() = node(0);
    const Node* const rays = nodes_.data() + first_;
    const std::size_t n = nodes_.size() - static_cast<std::size_t>(first_);
    in_vectors([&] { place_on_rays(rays, n, P, &places_[1]); });
    if (!asymptote_) places_.back() = node(last_);
  }
  const std::vector<PlanePlace>& places() const { return places_; }

  /// The point at u between nodes, exact to rounding. 0 <= u <= last().
  PlanePlace at(double u) const {
    const int i = std::min(static_cast<int>(u), last_ - 1);
    const double share = u - i;
    if constexpr (kMayBeNonMonotone<Law>) {
      if (family_.non_monotone) return i == 0 ? places_[0] : on_curve(coordinate(i) + share * kStep);
    }
    if (!along_rays_) {
      const double phi = pi<double>() * u / kArcs, y = centre() + circle_radius(P_) * std::cos(phi);
      const double tau = circle_radius(P_) * std::sin(phi);
      return place(tangential_load(family_.law, family_.p, y, tau), y);
    }
    if (share == 0 && i == 0) return node(0);
    if (share == 1 && i + 1 == last_) return node(last_);
    double t;
    if (i == 0)
      t = ray_of(1) * std::exp(1 - 1 / share);  // from T = 0
    else if (i + 1 == last_ && !asymptote_)
      t = ray_of(i) * std::exp(1 / (1 - share) - 1);  // to T/y infinite
    else
      t = ray_of(i) * std::pow(ray_of(i + 1) / ray_of(i), share);
    return on_ray({t, slope(t)}, true);
  }
  int last() const { return last_; }
  /// Whether the nodes lie close enough that T and A are monotone between them, but where the curve turns.
  bool is_along_rays() const { return along_rays_ && !family_.non_monotone; }

 private:
  // Under a non-monotone law node 0 is JKR, close to node 1; the others are uniform in the curve's coordinate.
  static constexpr double kFrom = -18, kTo = 38, kStep = 0.25;
  static double coordinate(int i) { return kFrom + kStep * (i - 1); }
  PlanePlace on_curve(double v) const {
    const CurvePosition at = curve_->position(curve_->pieces().front(), v);
    return place(curve_->tangential_load(at), at.y);
  }
  void set_non_monotone_load() {
    curve_.emplace(family_.law, family_.p, P_);
    last_ = static_cast<int>((kTo - kFrom) / kStep) + 1;
    places_ = {{0, area_from_radius(jkr_radius(P_))}};
    for (int i = 1; i <= last_; ++i) places_.push_back(on_curve(coordinate(i)));
  }

  struct Node {
    double t, q;  // T/y and tau/y
  };
  double centre() const { return 3 * pi<double>(); }
  double ray_of(int i) const { return nodes_[static_cast<std::size_t>(first_ + i - 1)].t; }

  PlanePlace node(int i) const {
    if (i == 0) return {0, area_from_radius(jkr_radius(P_))};
    if (along_rays_) {
      if (i == last_ && !asymptote_) return P_ > 0 ? end_ : PlanePlace{0, 0};
      return on_ray(nodes_[static_cast<std::size_t>(first_ + i - 1)], true);
    }
    const double S0 = circle_radius(P_);
    if (i == kArcs) return place(0, -2 * centre() * P_ / (centre() + S0));
    const double phi = pi<double>() * i / kArcs, y = centre() + S0 * std::cos(phi);
    const double tau = S0 * std::sin(phi);
    if constexpr (requires { family_.law.tangential_load(family_.p, y, tau); })
      return place(family_.law.tangential_load(family_.p, y, tau), y);
    const double t = ray(tau / y);
    return on_ray({t, slope(t)}, 2 * i <= kArcs);
  }

  PlanePlace place(double T, double y) const { return {T, area_from_edge_load(y, P_)}; }

  static constexpr double kFirst = 1e-4, kSteepest = 300;  // for tau/y
  static constexpr std::size_t kMost = 400;

  double slope(double t) const { return std::sqrt(std::max(family_.law.shear_term(family_.p, 1.0, t).value, 0.0)); }

  /// T/y at which tau/y = q, by interpolation of the logarithms.
  double ray(double q) const {
    auto above = std::lower_bound(nodes_.begin(), nodes_.end(), q, [](const Node& n, double x) { return n.q < x; });
    if (above == nodes_.begin()) ++above;
    if (above == nodes_.end()) --above;
    const Node &a = above[-1], &b = above[0];
    if (q < a.q && family_.small > 0 && std::isfinite(family_.small)) return q / std::sqrt(family_.small);
    return a.t * std::pow(b.t / a.t, std::log(q / a.q) / std::log(b.q / a.q));
  }

  PlanePlace on_ray(const Node& node, bool upper) const { return on_ray(node, P_, upper); }
  MIXITY_LOOP static PlanePlace on_ray(const Node& node, double P, bool upper) {
    const double centre = 3 * pi<double>();
    const double g = 1 + node.q * node.q, square = 2 * centre * (above_pull_off(P) + P * node.q * node.q);
    const double root = std::sqrt(square > 0 ? square : 0.0);
    const double y = upper ? (centre + root) / g : -2 * centre * P / (centre + root);
    const double cube = 0.75 * y * y * g / (2 * centre), a = cube_root(cube > 1e-140 ? cube : 1e-140);
    return {node.t * y, pi<double>() * a * a};
  }
  MIXITY_LOOP static void place_on_rays(const Node* rays, std::size_t n, double P, PlanePlace* __restrict to) {
    for (std::size_t i = 0; i < n; ++i) to[i] = on_ray(rays[i], P, true);
  }

  static constexpr int kArcs = 32;
  nearest_detail::CurveFamily<Law> family_;
  std::vector<Node> nodes_;
  int first_ = 0;  // the node at which tau/y begins to matter at loads that are not close to pull-off
  double P_ = 0;
  PlanePlace end_{};
  bool asymptote_ = false, along_rays_ = true;
  int last_ = 0;
  std::vector<PlanePlace> places_;
  std::optional<EquilibriumCurve<Law>> curve_;  // only under a non-monotone law
};

/// A segment of an outline that is nearer to a point than its neighbours, and the nearest point on it.
struct Approach {
  double distance;
  PlanePlace place;
  int segment;
};

/// The squared distance of a point from each segment of an outline, and where on the segment it is.
struct SegmentDistances {
  std::vector<double> square, share;
};

/// Without branches, so that the loop is vectorised.
MIXITY_LOOP void measure_segments(const PlanePlace* places, std::size_t n, PlanePlace point, double per_T, double per_A,
                                  double* __restrict square, double* __restrict share) {
  for (std::size_t i = 0; i < n; ++i) {
    const double x = (places[i].T - point.T) * per_T, z = (places[i].A - point.A) * per_A;
    const double dx = (places[i + 1].T - point.T) * per_T - x, dz = (places[i + 1].A - point.A) * per_A - z;
    const double length = dx * dx + dz * dz, along = -(x * dx + z * dz) / length;
    const double low = along > 0 ? along : 0.0, inside = low < 1 ? low : 1.0, part = length > 0 ? inside : 0.5;
    const double x_there = x + part * dx, z_there = z + part * dz;
    square[i] = x_there * x_there + z_there * z_there;
    share[i] = part;
  }
}

/// Finds the nearest `most` approaches of the polyline `places` to `point`, in ascending order of distance.
inline void approaches(std::span<const PlanePlace> places, PlanePlace point, double per_T, double per_A,
                       std::size_t most, SegmentDistances& segments, std::vector<Approach>& found) {
  found.clear();
  const std::size_t n = places.size() - 1;
  segments.square.resize(n);
  segments.share.resize(n);
  in_vectors(
      [&] { measure_segments(places.data(), n, point, per_T, per_A, segments.square.data(), segments.share.data()); });
  double before = std::numeric_limits<double>::infinity();
  bool nearing = true;
  const auto keep = [&](std::size_t segment) {  // the distance as its square, until all are found
    const PlanePlace &from = places[segment], &to = places[segment + 1];
    const double share = segments.share[segment];
    found.push_back({segments.square[segment],
                     {from.T + share * (to.T - from.T), from.A + share * (to.A - from.A)},
                     static_cast<int>(segment)});
  };
  for (std::size_t i = 0; i < n; ++i) {
    const double here = segments.square[i];
    if (here > before && nearing) keep(i - 1);
    nearing = here <= before;
    before = here;
  }
  if (nearing) keep(n - 1);
  constexpr double kFar = 1e-160;
  if (std::any_of(found.begin(), found.end(), [](const Approach& one) { return std::isinf(one.distance); }) &&
      per_T > kFar && per_A > kFar) {  // squares overflow
    approaches(places, point, kFar * per_T, kFar * per_A, most, segments, found);
    for (Approach& one : found) one.distance /= kFar;
    return;
  }
  for (Approach& one : found) one.distance = std::sqrt(one.distance);
  std::sort(found.begin(), found.end(), [](const Approach& a, const Approach& b) { return a.distance < b.distance; });
  if (found.size() > most) found.resize(most);
}

/// The nodes of an outline in descending order of area that enclose all segments which reach from `lowest` to
/// `highest`, and one segment more at either end.
inline std::span<const PlanePlace> nodes_of_areas(std::span<const PlanePlace> places, double lowest, double highest) {
  const auto first =
      std::partition_point(places.begin(), places.end(), [=](const PlanePlace& node) { return node.A > highest; });
  const auto last = std::partition_point(first, places.end(), [=](const PlanePlace& node) { return node.A >= lowest; });
  const auto begin = first - std::min<std::ptrdiff_t>(2, first - places.begin()),
             end = last + std::min<std::ptrdiff_t>(2, places.end() - last);
  return {begin, end};
}

/// The u in (low, high) that minimises distance(u), by golden section, to the square root of a rounding.
template <class Distance>
double golden_section(double low, double high, const Distance& distance) {
  const double golden = 0.5 * (std::sqrt(5.0) - 1);
  double one = high - golden * (high - low), other = low + golden * (high - low);
  double at_one = distance(one), at_other = distance(other);
  for (int i = 0; i < 50; ++i) {
    if (at_one < at_other) {
      high = other;
      other = one;
      at_other = at_one;
      at_one = distance(one = high - golden * (high - low));
    } else {
      low = one;
      one = other;
      at_one = at_other;
      at_other = distance(other = low + golden * (high - low));
    }
  }
  return at_one < at_other ? one : other;
}

}  // namespace mixity
