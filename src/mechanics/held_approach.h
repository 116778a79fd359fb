// A contact whose approach is held in place of its normal load: the sphere is pressed to the approach Delta, through a
// machine of normal stiffness k, and then sheared. Dimensionless (contact.h; Delta in units of R/xi^2). The sphere's
// own approach under the load P is delta with P = 2 a delta - 2/3 a^3 (JKR: Maugis 2000, Contact, Adhesion and Rupture
// of Elastic Solids, chapter 4; shear does not change it at nu = 1/2), and P = k (Delta - delta). The edge load is
// therefore
//
//     y(a) = (4/3 m a^3 + a^2 - Delta)/(m + 1/(2 a)),  m = 1/k:   m = 0: 2 a (a^2 - Delta);   m -> inf: 4/3 a^3 - k
//     Delta
//
// and equilibrium y^2 + tau^2(y, T) = 8 pi a^3 as under a held load (equilibrium.h). The curve is explicit in a for
// every law (held_curve.h).
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "mechanics/contact_model.h"

namespace mixity {

struct HeldApproach {
  double approach;        // Delta
  double compliance = 0;  // m >= 0: of the machine, 1/k

  /// The edge load at the radius a, its first two derivatives in a, and those of value and slope in Delta and in m.
  struct EdgeLoad {
    double value, slope, bend;
    double by_approach, slope_by_approach, by_compliance, slope_by_compliance;
  };
  EdgeLoad edge_load(double a) const {
    const double m = compliance, cube = 4.0 / 3 * a * a * a, D = m + 0.5 / a, dD = -0.5 / (a * a);
    EdgeLoad y{};
    y.value = (m * cube + (a * a - approach)) / D;
    y.slope = (4 * m * a * a + 2 * a - y.value * dD) / D;
    y.bend = (8 * m * a + 2 - 2 * y.slope * dD - y.value / (a * a * a)) / D;
    y.by_approach = -1 / D;
    y.slope_by_approach = dD / (D * D);
    y.by_compliance = (cube - y.value) / D;
    y.slope_by_compliance = (4 * a * a - y.slope - y.by_compliance * dD) / D;
    return y;
  }
  /// 4/3 a^3 - y
  double load(double a) const { return (approach - a * a / 3) / (compliance + 0.5 / a); }
  /// The radius at which the edge load is y >= 0.
  double radius(double y) const;
  /// The radii at T = 0: the stable one, and the unstable one, which is 0 where there is none. Null below the approach
  /// of pull-off, and where a number is out of range.
  struct Unsheared {
    double stable, unstable;
  };
  std::optional<Unsheared> unsheared() const;
  bool in_range() const;
};

/// NaN unless the status is ok.
struct ApproachState {
  EquilibriumStatus status = EquilibriumStatus::invalid;
  double P = std::numeric_limits<double>::quiet_NaN(), a = P;
};

/// Where the stable branch from T = 0 ends: at a fold of T, or without one where the edge load falls to 0.
struct ApproachEnd {
  bool fold;
  double T, P, a;
};

struct ApproachStates {
  std::vector<ApproachState> at;     // in the order of the T
  std::optional<ApproachEnd> end{};  // of the first branch; null if no T lies beyond it
};

/// States at each T, 0 <= T <= kLargestLoad, of a contact that is loaded from T = 0 and follows its stable branch, and
/// after a jump a lower one: no_equilibrium beyond the last or below the approach of pull-off; invalid for parameters
/// or an approach out of range. Relative error of a below 1e-13 away from a fold.
ApproachStates under_held_approach(const ContactModel& model, std::span<const double> p, const HeldApproach& held,
                                   std::span<const double> T);

}  // namespace mixity
