#include "mechanics/laws/law_bend.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/constants.h"

namespace mixity {
LawBend bend_of(const Taylor& f, double psi, double s, double c) {
  // along y at fixed T: psi' = -s, psi'' = 2 s c
  const Taylor along{f.value, -s * f.first, s * s * f.second + 2 * s * c * f.first}, y{c, 1, 0};
  const Taylor tau2 = (y * y + Taylor(s * s)) / along - y * y;
  const double m1 = std::abs(tau2.first), m2 = std::abs(tau2.second);
  // what is far less than the others is rounding, and does not count beside them
  const double TT = (2 * (tau2.value + c * m1) + c * c * m2) / (s * s), least = 1e-3 * (TT + 1e-3);
  return {psi, std::log(TT), std::log(std::max((m1 + c * m2) / s, least)),
          std::log(std::max(m2 + m1 / (c + s), least))};
}

ShearBend bend_everywhere(std::span<const LawBend> bends) {
  const auto bound = [&](double LawBend::*sum) {
    const LawBend &first = bends[0], &second = bends[1], &last = bends.back(), &before = bends[bends.size() - 2];
    if (!(first.*sum <= second.*sum + 0.01 && last.*sum <= before.*sum + 0.01))
      return std::numeric_limits<double>::infinity();
    double most = -std::numeric_limits<double>::infinity();
    for (const LawBend& one : bends) most = std::max(most, one.*sum);
    return 2 * std::exp(most);
  };
  return {bound(&LawBend::TT), bound(&LawBend::yT), bound(&LawBend::yy)};
}

/// How fast the sums change with dT/(T + T_part y) where T < y, and with dy/(y + y_part T) where y < T: the larger the
/// part, the further a step reaches.
ShearReach reach_of(std::span<const LawBend> bends) {
  constexpr double kAllowed = 4.4;  // of d ln(sum) for a way of 1: (1 + 8 w)^2 is exp(2 * 4.4 w) at w = 1/4
  ShearReach reach{1, 0, 0};
  for (const bool steep : {false, true}) {
    double& chosen = steep ? reach.y_part : reach.T_part;
    for (const double part : {1.0, 0.3, 0.1, 0.03, 0.01, 0.0}) {
      double fastest = 0;
      for (std::size_t i = 0; i + 1 < bends.size(); ++i) {
        const LawBend &one = bends[i], &next = bends[i + 1];
        const double psi = 0.5 * (one.psi + next.psi);
        if ((psi > 0.25 * pi<double>()) != steep) continue;
        const double near = steep ? std::cos(psi) : std::sin(psi), far = steep ? std::sin(psi) : std::cos(psi);
        const double way = (next.psi - one.psi) / (far * (near + part * far));
        for (const double change : {next.TT - one.TT, next.yT - one.yT, next.yy - one.yy})
          if (!(std::abs(change) <= fastest * way)) fastest = std::abs(change) / way;
      }
      chosen = part;
      if (2 * fastest <= kAllowed) break;
      if (part == 0) reach.narrow = std::max(reach.narrow, 2 * fastest / kAllowed);
    }
  }
  return reach;
}

}  // namespace mixity
