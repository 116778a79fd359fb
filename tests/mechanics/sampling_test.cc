// Polylines of the curve: within the chord error of it, with few points, over all of its pieces.
#include "mechanics/sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

namespace mixity {
namespace sampling_test {

struct Place {
  double x, y;
};

/// Points of each piece in the plane of T and A, each as a fraction of its largest value in `scale`.
struct Scale {
  double T = 0, A = 0;
  explicit Scale(const std::vector<CurvePoint>& points) {
    for (const CurvePoint& q : points) {
      T = std::max(T, q.T);
      A = std::max(A, q.A);
    }
    if (T == 0) T = 1;
  }
  Place at(const CurvePoint& q) const { return {q.T / T, q.A / A}; }
};

double distance(const Place& p, const Place& a, const Place& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

/// Largest distance of the curve from the polyline, at `n` places of every step.
template <class Model>
double chord_error(const EquilibriumCurve<Model>& curve, const std::vector<CurvePoint>& points, const Scale& scale,
                   int n) {
  double worst = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (points[i + 1].phi <= points[i].phi) continue;
    const bool gap = curve.pieces().size() == 2 && points[i].phi < curve.phi_end(curve.pieces()[0]) &&
                     points[i + 1].phi > curve.phi_begin(curve.pieces()[1]);
    if (gap) continue;  // from one piece to the next
    for (int j = 1; j < n; ++j) {
      const CurvePoint q = curve.point(points[i].phi + (points[i + 1].phi - points[i].phi) * j / n);
      worst = std::max(worst, distance(scale.at(q), scale.at(points[i]), scale.at(points[i + 1])));
    }
  }
  return worst;
}

template <class Model>
std::string name(const EquilibriumCurve<Model>& curve) {
  std::ostringstream text;
  text.precision(17);
  text << Model::info.key << " p0=" << curve.parameters()[0] << " P=" << curve.load();
  return text.str();
}

constexpr double kFarthest = 10;

template <class Model>
std::vector<PhiRange> ranges_of(const EquilibriumCurve<Model>& curve) {
  return drawable_ranges(curve, kFarthest * shear_scale(curve));
}

/// Calls check(curve) for curves of every kind: Hertz, pull-off, asymptote, two pieces, folds in pairs.
template <class Check>
void for_curves(Check check) {
  for (const double P : {-4.7, -1.0, -1e-3, 1e-3, 1.0, 5.5, 30.4, 1e3}) {
    for (const double lambda : {1e-6, 0.0023, 0.15, 0.9, 1.0}) {
      check(EquilibriumCurve(PapangeloCiavarella{}, {lambda}, P));
      check(EquilibriumCurve(WatersGuduru{}, {lambda}, P));
      check(EquilibriumCurve(WatersGuduru{}, {2 * lambda}, P));
    }
    for (const double lambda : {1e-3, 0.15, 0.5, 0.9, 0.999, 1.0}) check(EquilibriumCurve(Johnson{}, {lambda}, P));
    check(EquilibriumCurve(BenzeggaghKenane{}, {1.774, 2.284}, P));
  }
}

TEST(AdaptiveSampling, StaysWithinTheChordError) {
  for_curves([](const auto& curve) {
    const auto ranges = ranges_of(curve);
    const Scale scale(sample_uniform(curve, ranges, 65));
    for (const double chord : {1e-2, 1e-3, 1e-4}) {
      const auto points = sample_adaptive(curve, ranges, chord);
      // 37 places fall between the 15 that the sampler looked at; its 1 % reserve is for what lies there
      EXPECT_LE(chord_error(curve, points, scale, 37), chord)
          << name(curve) << " chord " << chord << " with " << points.size() << " points";
    }
  });
}

/// From each point the longest step is taken, so no other polyline with vertices on the curve needs fewer points but
/// for the 1 % reserve; uniform ones need many more where the curvature is not spread evenly.
TEST(AdaptiveSampling, NeedsFewerPointsThanUniformSampling) {
  std::size_t adaptive = 0, uniform = 0;
  for_curves([&](const auto& curve) {
    const auto ranges = ranges_of(curve);
    const Scale scale(sample_uniform(curve, ranges, 65));
    const std::size_t n = sample_adaptive(curve, ranges, 1e-3).size();
    std::size_t needed = 2;
    while (chord_error(curve, sample_uniform(curve, ranges, needed), scale, 17) > 1e-3) needed += 1 + needed / 32;
    EXPECT_LE(n, needed * ranges.size() + 1) << name(curve);
    adaptive += n;
    uniform += needed * ranges.size();
  });
  EXPECT_GT(static_cast<double>(uniform), 1.5 * static_cast<double>(adaptive)) << adaptive << ' ' << uniform;
}

/// A smooth curve of total bend B needs about sqrt(L B/(8 chord)) segments: a hundredfold finer chord, tenfold points.
TEST(AdaptiveSampling, PointsGrowAsTheInverseRootOfTheChord) {
  const EquilibriumCurve curve(PapangeloCiavarella{}, {0.15}, 3);
  const auto count = [&](double chord) {
    return static_cast<double>(sample_adaptive(curve, ranges_of(curve), chord).size());
  };
  EXPECT_LE(count(1e-3), 40);  // a quarter of an ellipse and a bit: pi/2/sqrt(8e-3) = 18
  EXPECT_NEAR(count(1e-6) / count(1e-4), 10, 1.5);
}

TEST(AdaptiveSampling, GoesFromTheBeginningToTheEndOfEveryPiece) {
  for_curves([](const auto& curve) {
    const auto ranges = ranges_of(curve);
    ASSERT_EQ(ranges.size(), curve.pieces().size());
    const auto points = sample_adaptive(curve, ranges, 1e-2);
    EXPECT_EQ(points.front().phi, 0);
    EXPECT_EQ(points.back().phi, ranges.back().to);
    for (std::size_t i = 0; i < ranges.size(); ++i)
      for (const double end : {ranges[i].from, ranges[i].to})
        EXPECT_TRUE(std::any_of(points.begin(), points.end(), [&](const CurvePoint& q) { return q.phi == end; }))
            << end;
    for (std::size_t i = 1; i < points.size(); ++i) EXPECT_GT(points[i].phi, points[i - 1].phi);
  });
}

TEST(HalvedSampling, StaysWithinTheChordErrorFromEndToEnd) {
  for_curves([](const auto& curve) {
    const auto ranges = ranges_of(curve);
    const Scale scale(sample_uniform(curve, ranges, 17));
    for (const double chord : {1e-2, 2e-4}) {
      const auto points = sample_halved(curve, ranges, chord);
      EXPECT_LE(chord_error(curve, points, scale, 37), chord)
          << name(curve) << " chord " << chord << " with " << points.size() << " points";
      EXPECT_LE(points.size(), 500u) << name(curve);
      EXPECT_EQ(points.front().phi, 0);
      EXPECT_EQ(points.back().phi, ranges.back().to);
      for (std::size_t i = 1; i < points.size(); ++i) EXPECT_GT(points[i].phi, points[i - 1].phi);
    }
  });
}

TEST(UniformSampling, IsUniformInPhiAndMeetsBothEnds) {
  for_curves([](const auto& curve) {
    const auto ranges = ranges_of(curve);
    const auto points = sample_uniform(curve, ranges, 21);
    ASSERT_EQ(points.size(), 21 * ranges.size());
    for (std::size_t r = 0; r < ranges.size(); ++r) {
      const double from = ranges[r].from, to = ranges[r].to;
      EXPECT_EQ(points[21 * r].phi, from) << name(curve);
      EXPECT_EQ(points[21 * r + 20].phi, to) << name(curve);
      for (std::size_t i = 0; i < 21; ++i)
        EXPECT_NEAR(points[21 * r + i].phi, from + (to - from) * static_cast<double>(i) / 20, 1e-15 * to);
    }
  });
}

/// What runs to infinity is drawn up to T_most: T lies below it at the cut, and above it a few roundings of phi on.
/// Only on a sliver of a piece, where phi and y no longer fix T, it ends before.
TEST(DrawableRanges, ReachTheEndOrTheLargestLoad) {
  int cuts = 0, slivers = 0;
  for_curves([&](const auto& curve) {
    const double most = kFarthest * shear_scale(curve);
    const auto ranges = ranges_of(curve);
    const auto expect_cut = [&](double phi, double further) {
      EXPECT_LE(curve.point(phi).T, most * (1 + 1e-15)) << name(curve);
      const CurvePoint next = curve.point(phi + (further - phi > 0 ? 2e-15 : -2e-15) * phi);
      const bool sliver = std::abs(next.dT) * 2e-16 * (phi + next.y / std::abs(next.dy)) > 1e-5 * most;
      EXPECT_TRUE(next.T >= most || sliver) << name(curve) << ' ' << next.T << ' ' << most;
      slivers += sliver;
      ++cuts;
    };
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const CurvePiece& piece = curve.pieces()[i];
      if (piece.end == CurveEnd::asymptote)
        expect_cut(ranges[i].to, 4);
      else
        EXPECT_EQ(ranges[i].to, curve.phi_end(piece)) << name(curve);
      if (piece.from_asymptote)
        expect_cut(ranges[i].from, 0);
      else
        EXPECT_EQ(ranges[i].from, 0) << name(curve);
    }
  });
  EXPECT_GT(cuts, 40);
  EXPECT_LE(slivers, 6);  // P = -1e-3
}

TEST(DrawableRanges, OfAnUncoupledContactAreOnePoint) {
  const EquilibriumCurve curve(PapangeloCiavarella{}, {0.0}, 1);
  const auto ranges = ranges_of(curve);
  ASSERT_EQ(ranges.size(), 1u);
  EXPECT_EQ(ranges[0].from, ranges[0].to);
  EXPECT_EQ(sample_adaptive(curve, ranges, 1e-3).size(), 1u);
}

/// The sampler ends, with numbers, however extreme the curve: at most what a chord of 1e-3 can need.
TEST(AdaptiveSampling, EndsAtAnyExtreme) {
  const auto check = [](const auto& curve) {
    const auto points = sample_adaptive(curve, ranges_of(curve), 1e-3);
    EXPECT_GE(points.size(), 1u) << name(curve);
    EXPECT_LE(points.size(), 400u) << name(curve);
    for (const CurvePoint& q : sample_halved(curve, ranges_of(curve), 1e-3))
      EXPECT_TRUE(std::isfinite(q.T) && std::isfinite(q.A)) << name(curve) << " phi " << q.phi;
    for (const CurvePoint& q : points)
      EXPECT_TRUE(std::isfinite(q.T) && std::isfinite(q.A) && std::isfinite(q.u)) << name(curve) << " phi " << q.phi;
  };
  for (const double P : {-4.71238898038469, -4.7123889803799, -1e-12, -1e-300, 0.0, 1e-300, 1e-12, 1e8})
    for (const double q : {0.0, 1e-300, 1e-16, 1e-12, 1e-8, 8.0 / 9, 1 - 1e-12, 1 - 1e-15, 1.0}) {
      check(EquilibriumCurve(Johnson{}, {q}, P));
      check(EquilibriumCurve(WatersGuduru{}, {2 * q}, P));
      check(EquilibriumCurve(PapangeloCiavarella{}, {q}, P));
    }
}

}  // namespace sampling_test
}  // namespace mixity
