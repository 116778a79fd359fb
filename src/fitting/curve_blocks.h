// The blocks of points that a CurveObjective handles at a time.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <numeric>
#include <span>
#include <vector>

#include "fitting/curve_objective.h"

namespace mixity {

inline constexpr std::size_t kBlock = 512;  // points whose arrays stay in the processor's cache
inline constexpr std::size_t kBlocksOfAPart = 64;

/// Arrays of a block: the points as scaled, where they are near to, their distances with derivatives, and their places.
struct CurveObjective::Workspace {
  static constexpr std::size_t kArrays = 13;
  Workspace(std::size_t n, std::size_t parameters) : values(new double[n * (kArrays + parameters)]), size(n) {}
  std::span<double> array(std::size_t which, std::size_t n) { return {values.get() + which * size, n}; }
  PointArrays points(std::size_t n) {
    return {array(0, n), array(1, n), array(2, n), array(3, n), array(4, n), array(5, n), array(6, n)};
  }
  std::unique_ptr<double[]> values;
  std::size_t size;
};

/// The indices of a block of points, given by their ranks.
struct CurveObjective::Indices {
  Indices(const CurveObjective& of, std::size_t begin, std::size_t n) {
    if (!of.order_.empty()) {
      list = std::span(of.order_).subspan(begin, n);
    } else {
      std::iota(own.begin(), own.begin() + n, static_cast<std::uint32_t>(begin));
      list = std::span(own).first(n);
    }
  }
  std::array<std::uint32_t, kBlock> own;
  std::span<const std::uint32_t> list;
};

/// Readings of the axes of a block, or of its loads at held approaches, their residuals, and the derivatives of these.
struct CurveObjective::OfAxes {
  std::vector<double> q, sigma_q, slant, r, dP, dT, dA, parameters, of_sigma_T, of_sigma_A, own_sigma_T, own_sigma_A;
  std::vector<double> dm, of_q, own_q, of_sigma_q, own_sigma_q;  // of loads

  void add(const CurveObjective& of, const MeasuredPoints& points, std::size_t begin, std::size_t n, std::size_t p,
           PlanePoints& plane, CurveDistances& out) {
    for (std::size_t i = 0; i < n; ++i) {
      const MeasuredAxes& one = (*points.axes)[of.index_of(begin + i)];
      q.push_back(one.q);
      sigma_q.push_back(one.sigma_q);
      slant.push_back(one.slant);
    }
    for (std::vector<double>* const list : {&r, &dP, &dT, &dA, &of_sigma_T, &of_sigma_A, &own_sigma_T, &own_sigma_A})
      list->resize(n);
    parameters.resize(n * p);
    plane.q = q;
    plane.sigma_q = sigma_q;
    plane.slant = slant;
    out.axes = {r, dP, dT, dA, parameters, of_sigma_T, of_sigma_A, own_sigma_T, own_sigma_A};
    if (!of.model().holds_approach()) return;
    for (std::vector<double>* const list : {&dm, &of_q, &own_q, &of_sigma_q, &own_sigma_q}) list->resize(n);
    out.axes.dm = dm;
    out.axes.of_q = of_q;
    out.axes.own_q = own_q;
    out.axes.of_sigma_q = of_sigma_q;
    out.axes.own_sigma_q = own_sigma_q;
  }
};

/// Of a held approach: the machine's compliance at each point of a block, and derivatives in it.
struct CurveObjective::OfApproach {
  std::vector<double> compliance, dm;

  /// Scales the loads that were measured beside the approach, too.
  void add(const CurveObjective& of, const Constants& constants, const MeasuredPoints& points, std::size_t begin,
           std::size_t n, OfAxes& loads, PlanePoints& plane, CurveDistances& out) {
    const bool varies = of.varies_ || has_changes(constants);
    ConstantsScale scale(constants);
    dm.resize(n);
    out.dm = dm;
    for (std::size_t i = 0; i < n; ++i) {
      if (varies) scale = ConstantsScale(constants, points.at(of.index_of(begin + i)).place);
      compliance.push_back(of.model().held_at(0).compliance * scale.compliance);
      if (loads.q.empty()) continue;
      loads.q[i] = scale.load_beside(loads.q[i]);
      loads.sigma_q[i] *= scale.force;
    }
    plane.compliance = compliance;
  }
};

}  // namespace mixity
