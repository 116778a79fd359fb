// Points along a curve for drawing: uniform in phi, or as few as a given chord error allows.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mechanics/equilibrium.h"

namespace mixity {

/// How far curves that run to infinite T are drawn, in units of shear_scale.
inline constexpr double kFarthestDrawn = 10;

/// The range of phi over which a piece is drawn: to its end, or to T_most where T becomes infinite. On a very short
/// piece (model a, P just below 0) it ends earlier, where rounding of phi and y causes an error of 1e-4 T_most in T.
struct PhiRange {
  double from, to;
};

template <class Law>
std::vector<PhiRange> drawable_ranges(const EquilibriumCurve<Law>& curve, double T_most) {
  if (curve.uncoupled()) return {{0, 0}};
  std::vector<PhiRange> ranges;
  for (const CurvePiece& piece : curve.pieces()) {
    PhiRange range{curve.phi_begin(piece), curve.phi_end(piece)};
    const auto drawable = [&](double phi) {
      const CurvePoint q = curve.point(phi);
      const double blur = 4.4e-16 * (phi + q.y / std::abs(q.dy));  // the rounding of phi and that of y
      return q.T < T_most && std::abs(q.dT) * blur < 1e-4 * T_most;
    };
    // T is monotone between the asymptote and a point inside the piece beyond every fold
    const auto cut = [&](double inside, double asymptote) {
      for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (inside + asymptote);
        (drawable(middle) ? inside : asymptote) = middle;
      }
      return inside;
    };
    const double middle = 0.5 * (range.from + range.to);
    if (piece.end == CurveEnd::asymptote) range.to = cut(middle, range.to);
    if (piece.from_asymptote) range.from = cut(middle, range.from);
    ranges.push_back(range);
  }
  return ranges;
}

/// A natural scale of T: its value at the top of the circle if tau^2 = small_shear T^2 throughout.
template <class Law>
double shear_scale(const EquilibriumCurve<Law>& curve) {
  const double w = curve.law().small_shear(curve.parameters());
  return circle_radius(curve.load()) / (w > 0 && std::isfinite(w) ? std::sqrt(w) : 1.0);
}

/// Samples n >= 2 points uniformly in phi on each range.
template <class Law>
std::vector<CurvePoint> sample_uniform(const EquilibriumCurve<Law>& curve, const std::vector<PhiRange>& ranges,
                                       std::size_t n) {
  std::vector<CurvePoint> points;
  for (const PhiRange& range : ranges)
    for (std::size_t i = 0; i < n; ++i)
      points.push_back(curve.point(i + 1 == n ? range.to
                                              : range.from + (range.to - range.from) * static_cast<double>(i) /
                                                                 static_cast<double>(n - 1)));
  return points;
}

/// Measures distances in the plane of T and A, each as a fraction of its largest value on a curve.
struct ChordPlane {
  double T_range = 0, A_range = 0;

  explicit ChordPlane(const std::vector<CurvePoint>& points) {
    for (const CurvePoint& p : points) {
      T_range = std::max(T_range, p.T);
      A_range = std::max(A_range, p.A);
    }
    if (!(T_range > 0)) T_range = 1;
  }
  /// The distance from the segment between a and b, not from the line through them: a curve may turn back at a fold.
  double distance(const CurvePoint& a, const CurvePoint& b, const CurvePoint& point) const {
    const double dx = (b.T - a.T) / T_range, dy = (b.A - a.A) / A_range, length = std::hypot(dx, dy);
    const double x = (point.T - a.T) / T_range, y = (point.A - a.A) / A_range;
    const double along = length > 0 ? std::clamp((x * dx + y * dy) / (length * length), 0.0, 1.0) : 0;
    return std::hypot(x - along * dx, y - along * dy);
  }
};

/// Points on the curve whose polyline stays within `chord` of it (ChordPlane). From each point it takes the longest
/// step that satisfies this, which needs the fewest points of all polylines with vertices on the curve. The distance is
/// measured at 15 points of each step; the peak of the parabola through three of them gives its maximum to 1 %.
template <class Law>
std::vector<CurvePoint> sample_adaptive(const EquilibriumCurve<Law>& curve, const std::vector<PhiRange>& ranges,
                                        double chord) {
  const ChordPlane plane(sample_uniform(curve, ranges, 65));
  const auto stays_within = [&](const CurvePoint& a, double to) {
    const CurvePoint b = curve.point(to);
    std::array<double, 17> off{};  // 0 at both ends
    constexpr std::size_t kLast = off.size() - 1;
    for (std::size_t i = 1; i < kLast; ++i) {
      off[i] = plane.distance(a, b, curve.point(a.phi + (to - a.phi) * static_cast<double>(i) / kLast));
      if (off[i] > 0.99 * chord) return false;
    }
    for (std::size_t i = 1; i < kLast; ++i) {
      const double bend = 2 * off[i] - off[i - 1] - off[i + 1], slope = off[i + 1] - off[i - 1];
      if (bend > 0 && std::abs(slope) < 2 * bend && off[i] + slope * slope / (8 * bend) > 0.99 * chord) return false;
    }
    return true;
  };
  std::vector<CurvePoint> points;
  for (const PhiRange& range : ranges) {
    points.push_back(curve.point(range.from));
    double step = (range.to - range.from) / 64;
    while (points.back().phi < range.to) {
      const CurvePoint here = points.back();
      const double left = range.to - here.phi;
      if (stays_within(here, range.to)) {
        points.push_back(curve.point(range.to));
        break;
      }
      step = std::min(step, left);
      while (step < left && stays_within(here, here.phi + step)) step = std::min(2 * step, left);
      double low = 0, high = step;  // low stays within, high does not
      while (high - low > 1e-3 * high) {
        const double middle = 0.5 * (low + high);
        (stays_within(here, here.phi + middle) ? low : high) = middle;
      }
      step = std::max(low, 1e-12);
      points.push_back(curve.point(here.phi + step));
    }
  }
  return points;
}

/// Like sample_adaptive at a hundredth of the cost, with about three times as many points: even steps are halved until
/// their midpoints stay within the chord.
template <class Law>
std::vector<CurvePoint> sample_halved(const EquilibriumCurve<Law>& curve, const std::vector<PhiRange>& ranges,
                                      double chord) {
  constexpr std::size_t kFirst = 17;
  constexpr int kMostHalvings = 12;
  const std::vector<CurvePoint> first = sample_uniform(curve, ranges, kFirst);
  const ChordPlane plane(first);
  std::vector<CurvePoint> points;
  // adds the points after a, up to b
  const auto add = [&](const auto& again, const CurvePoint& a, const CurvePoint& b, int halvings) -> void {
    const CurvePoint middle = curve.point(0.5 * (a.phi + b.phi));
    if (!(middle.phi > a.phi && middle.phi < b.phi)) return points.push_back(b);
    // with the midpoint added, a smooth curve is four times closer than the midpoint was; at an end it is hardly closer
    if (halvings == 0 || plane.distance(a, b, middle) <= chord) {
      points.push_back(middle);
      return points.push_back(b);
    }
    again(again, a, middle, halvings - 1);
    again(again, middle, b, halvings - 1);
  };
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (i % kFirst == 0)
      points.push_back(first[i]);
    else
      add(add, first[i - 1], first[i], kMostHalvings);
  }
  return points;
}

}  // namespace mixity
