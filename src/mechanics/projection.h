// The point of an equilibrium curve nearest to a measured one, in the plane of T and A, each in units of its standard
// error. Regular at a fold, where A at given T is not.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "mechanics/sampling.h"

namespace mixity {

template <class Model>
class Projection {
 public:
  /// The curve that starts from JKR, down to its end or to where T first reaches T_most. Keeps a polyline of it, from
  /// which each search starts.
  Projection(const EquilibriumCurve<Model>& curve, double T_most) : curve_(curve) {
    PhiRange range = drawable_ranges(curve_, T_most).front();
    for (int i = 1; i <= kNodes; ++i) {
      const double phi = at(range, i);
      if (curve_.point(phi).T <= T_most) continue;
      double low = at(range, i - 1), high = phi;
      for (int j = 0; j < 40; ++j) {
        const double middle = 0.5 * (low + high);
        (curve_.point(middle).T <= T_most ? low : high) = middle;
      }
      range.to = low;
      break;
    }
    nodes_.push_back(curve_.point(range.from));
    int first = 1;
    if (!(nodes_.front().dT > 0)) {
      while (first < kNodes && !(curve_.point(at(range, first)).T > 1e-6 * T_most)) ++first;
      add_corner(curve_.point(at(range, first)));
    }
    const double A_step = 4 * nodes_.front().A / kNodes;
    for (int i = first; i <= kNodes; ++i) add(curve_.point(at(range, i)), 4 * T_most / kNodes, A_step, 6);
  }

  /// T of the last point of the polyline: T_most, or less where the curve ends or doubles no longer resolve it.
  double last_T() const { return nodes_.back().T; }

  /// True if a nearest point is the first or the last of the curve. A search for the first, which is a corner for bk
  /// with eta < 1, comes as close as it likes.
  bool is_end(const CurvePoint& q) const {
    const double first = nodes_.front().phi;
    return q.phi <= first + 1e-9 * (nodes_[1].phi - first) || q.phi == nodes_.back().phi;
  }

  /// The nearest point. T >= 0, A > 0, standard errors > 0.
  CurvePoint nearest(double T, double A, double sigma_T, double sigma_A) const {
    const Target target{T, A, sigma_T, sigma_A};
    // Every segment that is nearer than its neighbours on the same stretch between folds, or as near.
    std::vector<Candidate> candidates;
    double least = std::numeric_limits<double>::infinity();
    Candidate before;
    bool nearing = true;
    for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
      if (is_fold(i)) {
        if (nearing) candidates.push_back(before);
        before = {};
        nearing = true;
      }
      const Candidate here = target.segment(nodes_[i], nodes_[i + 1], i);
      if (here.distance > before.distance && nearing) candidates.push_back(before);
      nearing = here.distance <= before.distance;
      least = std::min(least, here.distance);
      before = here;
    }
    if (nearing) candidates.push_back(before);
    CurvePoint best = nodes_.front();
    double best_distance = target.distance(best);
    for (const Candidate& candidate : candidates) {
      // A segment lies closer to its arc than ten standard errors, or than ten times the least distance.
      if (candidate.distance > 10 * least + 10) continue;
      const CurvePoint q = refine(target, candidate);
      if (target.distance(q) <= best_distance) {
        best = q;
        best_distance = target.distance(q);
      }
    }
    return best;
  }

 private:
  struct Candidate {
    double distance = std::numeric_limits<double>::infinity();
    std::size_t segment = 0;
    double share = 0.5;  // of the segment, 0..1
  };

  /// A measured point and its distances, in standard errors.
  struct Target {
    double T, A, sigma_T, sigma_A;

    double x(const CurvePoint& q) const { return (q.T - T) / sigma_T; }
    double y(const CurvePoint& q) const { return (q.A - A) / sigma_A; }
    double distance(const CurvePoint& q) const { return std::hypot(x(q), y(q)); }
    Candidate segment(const CurvePoint& p, const CurvePoint& q, std::size_t index) const {
      const double x0 = x(p), y0 = y(p), dx = x(q) - x0, dy = y(q) - y0, square = dx * dx + dy * dy;
      const double t = square > 0 ? std::clamp(-(x0 * dx + y0 * dy) / square, 0.0, 1.0) : 0.5;
      return {std::hypot(x0 + t * dx, y0 + t * dy), index, t};
    }
  };

  /// Newton on half the slope of the squared distance, between the neighbours of the segment but not over a fold.
  CurvePoint refine(const Target& target, const Candidate& candidate) const {
    const std::size_t i = candidate.segment, last = nodes_.size() - 1;
    double low = nodes_[i > 0 && !is_fold(i) ? i - 1 : i].phi;
    double high = nodes_[i + 1 < last && !is_fold(i + 1) ? i + 2 : i + 1].phi;
    const double ends[] = {low, high};
    bool tried[] = {false, false};
    // Not from the very start, where bk with eta < 1 has dT = dA = 0.
    const double share = std::clamp(candidate.share, 0.02, 0.98);
    CurvePoint q = curve_.point(nodes_[i].phi + share * (nodes_[i + 1].phi - nodes_[i].phi));
    double last_phi = 0, last_slope = 0, least_slope = std::numeric_limits<double>::infinity();
    int stalled = 0;
    for (int step = 0; step < 60; ++step) {
      const double x = target.x(q), y = target.y(q), dx = q.dT / target.sigma_T, dy = q.dA / target.sigma_A;
      const double slope = x * dx + y * dy, size = std::hypot(dx, dy);
      if (!(std::abs(slope) > 1e-11 * size * std::hypot(x, y))) break;  // moves the distance by 1e-22 of itself
      (slope > 0 ? high : low) = q.phi;
      if (!(low < high)) break;
      // The secant through the last two slopes takes the curvature that Gauss-Newton leaves out.
      double next = q.phi - slope / (size * size);
      if (step > 0 && slope != last_slope) {
        const double secant = q.phi - slope * (q.phi - last_phi) / (slope - last_slope);
        if (secant > low && secant < high) next = secant;
      }
      last_phi = q.phi;
      last_slope = slope;
      // Towards an asymptote steps from either side may creep for hundreds of turns.
      stalled = std::abs(slope) < 0.5 * least_slope ? 0 : stalled + 1;
      least_slope = std::min(least_slope, std::abs(slope));
      if (stalled == 2) {
        next = 0.5 * (low + high);
        stalled = 0;
      }
      if (!(next > low && next < high)) {
        // An end itself is tried once, where it is no place at which both derivatives vanish.
        const int end = next <= low ? 0 : 1;
        const bool try_end = (end == 0 ? low : high) == ends[end] && !tried[end] && (end == 1 || nodes_[0].dT > 0);
        tried[end] |= try_end;
        next = try_end ? ends[end] : 0.5 * (low + high);
      }
      if (std::abs(next - q.phi) <= 4e-16 * q.phi) break;
      q = curve_.point(next);
    }
    return q;
  }

  bool is_fold(std::size_t node) const { return std::find(folds_.begin(), folds_.end(), node) != folds_.end(); }

  static constexpr int kNodes = 24;

  static double at(const PhiRange& range, int i) {
    return i == kNodes ? range.to : range.from + (range.to - range.from) * i / kNodes;
  }

  /// From a corner (bk with eta < 1) the curve falls along A before it turns along T, all within a step of phi: appends
  /// nodes before q, the first that T tells from 0, each at about half of the next one's T, down to 1e-9 of it.
  void add_corner(CurvePoint q) {
    const double from = nodes_.front().phi;
    std::vector<CurvePoint> down;
    for (int i = 0; i < 30; ++i) {
      const double power = (q.phi - from) * q.dT / q.T;  // T as a power of phi
      const double phi = from + (q.phi - from) * std::pow(0.5, 1 / power);
      if (!(power > 0 && phi > from && phi < q.phi)) break;
      down.push_back(q = curve_.point(phi));
    }
    nodes_.insert(nodes_.end(), down.rbegin(), down.rend());
  }

  /// Appends q, and before it what keeps the steps of the polyline short where phi alone leaves them long.
  void add(const CurvePoint& q, double T_step, double A_step, int depth) {
    const CurvePoint before = nodes_.back();
    const bool far = std::abs(q.T - before.T) > T_step || std::abs(q.A - before.A) > A_step;
    if (far && depth > 0) {
      add(curve_.point(0.5 * (before.phi + q.phi)), T_step, A_step, depth - 1);
      add(q, T_step, A_step, depth - 1);
    } else {
      if (before.dT * q.dT < 0) add_fold(before.phi, q.phi, before.dT > 0);
      nodes_.push_back(q);
    }
  }

  /// Where T turns is a node, so that each segment belongs to one stretch of the curve.
  void add_fold(double low, double high, bool rises) {
    for (int i = 0; i < 50; ++i) {
      const double middle = 0.5 * (low + high);
      ((curve_.point(middle).dT > 0) == rises ? low : high) = middle;
    }
    nodes_.push_back(curve_.point(0.5 * (low + high)));
    folds_.push_back(nodes_.size() - 1);
  }

  EquilibriumCurve<Model> curve_;
  std::vector<CurvePoint> nodes_;
  std::vector<std::size_t> folds_;  // indices of nodes where T has an extremum
};

}  // namespace mixity
