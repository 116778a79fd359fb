#include <algorithm>
#include <cmath>

#include "mechanics/any_law.h"
#include "mechanics/contact_model.h"
#include "mechanics/curve_distance.h"
#include "mechanics/elliptic_model.h"
#include "mechanics/energy_plane.h"
#include "mechanics/held_model.h"
#include "mechanics/sensitivity.h"

namespace mixity {

/// From the equilibrium function F of sensitivity.h: -ln((y^2 + tau^2)/(6 pi (y + P))).
bool ContactModel::toughness_residuals(ParameterSpan p, std::span<const double> P, std::span<const double> T,
                                       std::span<const double> A, const ToughnessResiduals& out) const {
  if (law_->ellipse) return false;
  if (law_->held) return under_loads(P, T, A, p, out);
  return with_law(*law_, p, [&](const auto& law, const auto& values) {
    for (std::size_t i = 0; i < P.size(); ++i) {
      if (!(A[i] > 0)) return false;
      const double a = radius_from_area(A[i]), y = edge_load(a, P[i]), sum = y + P[i];
      if (!(y > 0)) return false;
      const auto F = equilibrium_gradient(law, values, P[i], std::abs(T[i]), y);
      out.value[i] = -std::log(F.held / (6 * pi<double>() * sum));
      for (std::size_t k = 0; k < p.size(); ++k) out.parameters[i * p.size() + k] = -F.parameters[k] / F.held;
      // F = held - 6 pi sum, and dsum/dA = 2 a/pi
      const double growth = 2 * a / pi<double>();
      out.A[i] = growth / sum - (F.A + 6 * pi<double>() * growth) / F.held;
      out.T[i] = -std::copysign(F.T, T[i]) / F.held;
      out.P[i] = -F.P / F.held;
    }
    return true;
  });
}

/// Under a held approach: at the load that the approach has at each area.
bool ContactModel::under_loads(std::span<const double> approach, std::span<const double> T, std::span<const double> A,
                               ParameterSpan p, const ToughnessResiduals& out) const {
  std::vector<double> P;
  for (std::size_t i = 0; i < A.size(); ++i) P.push_back(A[i] > 0 ? load(approach[i], radius_from_area(A[i])) : 0);
  if (!of_loads().toughness_residuals(p, P, T, A, out)) return false;
  for (std::size_t i = 0; i < A.size(); ++i) {
    const double a = radius_from_area(A[i]);
    const HeldApproach::EdgeLoad y = held_at(approach[i]).edge_load(a);
    out.A[i] += out.P[i] * (4 * a * a - y.slope) / (2 * pi<double>() * a);
    out.P[i] *= -y.by_approach;
  }
  return true;
}

bool ContactModel::curve_distances(ParameterSpan p, const PlanePoints& points, Search search, bool derivatives,
                                   CurveDistances& out) const {
  if (law_->held) return held::curve_distances(*law_, p, points, derivatives, out);
  if (law_->ellipse) return elliptic::curve_distances(*law_->ellipse, p, points, derivatives, out);
  return with_law(*law_, p, [&](const auto& law, const auto& values) {
    return mixity::curve_distances(law, values, points, search, derivatives, out);
  });
}

void ContactModel::energy_distances(ParameterSpan p, const EnergyPoints& points, const EnergyDistances& out) const {
  with_law(*law_, p, [&](const auto& law, const auto& values) {
    const EnergyCurve curve(law, values);
    for (std::size_t i = 0; i < points.G_I.size(); ++i) {
      const auto r = curve.distance(points.G_I[i], points.G_II[i], points.sigma_I[i], points.sigma_II[i],
                                    points.G_Ic[i], !out.parameters.empty());
      out.value[i] = r.value;
      out.log_toughness[i] = r.log_toughness;
      if (out.parameters.empty()) continue;
      std::copy(r.parameters.begin(), r.parameters.end(),
                out.parameters.begin() + static_cast<std::ptrdiff_t>(i * p.size()));
    }
  });
}

void ContactModel::rough_energy_distances(ParameterSpan p, const EnergyPoints& points, std::span<double> out) const {
  with_law(*law_, p, [&](const auto& law, const auto& values) {
    const EnergyPolygon polygon(law, values);
    for (std::size_t i = 0; i < points.G_I.size(); ++i)
      out[i] = polygon.distance(points.G_I[i], points.G_II[i], points.sigma_I[i], points.sigma_II[i], points.G_Ic[i]);
  });
}

}  // namespace mixity
