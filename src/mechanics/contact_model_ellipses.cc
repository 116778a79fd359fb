#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "mechanics/any_law.h"
#include "mechanics/contact_model.h"
#include "mechanics/elliptic_contact.h"
#include "mechanics/elliptic_model.h"
#include "mechanics/non_monotone_curve.h"

namespace mixity {

namespace {

/// Calls use(law, mode_II, mode_III) if the law has an elliptic contact with these parameters.
template <class Use>
void with_ellipse(const ContactModel& model, const AnyLaw& any, const EndParameters& parameters, double P,
                  const Use& use) {
  const double nu = parameters.poisson_ratio;
  if (!(nu >= 0 && nu <= 0.5) || !model.problem(parameters.mode_II, 0).empty() ||
      !model.problem(parameters.mode_III, 0).empty() || !model.obstacle(parameters.mode_II, P).empty())
    return;
  with_law(any, [&]<class Law>(const Law& law) {
    const Parameters<Law> mode_II = parameters_from<Law>(parameters.mode_II),
                          mode_III = parameters_from<Law>(parameters.mode_III);
    const bool monotone = !is_non_monotone(law, mode_II) && !is_non_monotone(law, mode_III);
    if (monotone && std::isfinite(law.small_shear(mode_II) + law.small_shear(mode_III))) use(law, mode_II, mode_III);
  });
}

}  // namespace

Ellipses ContactModel::ellipses(const EndParameters& parameters, double P, std::span<const double> T) const {
  if (is_elliptic()) return circle().ellipses(parameters, P, T);
  Ellipses result{std::vector<EllipseState>(T.size())};
  with_ellipse(*this, *law_, parameters, P, [&]<class Law>(const Law& law, const auto& mode_II, const auto& mode_III) {
    if (above_pull_off(P) < 0) {
      for (EllipseState& state : result.at) state.status = EquilibriumStatus::no_equilibrium;
      return;
    }
    EllipticContact<Law> contact(law, mode_II, mode_III, parameters.poisson_ratio, P);
    double most = 0;
    for (std::size_t i = 0; i < T.size(); ++i)
      if (T[i] >= 0 && T[i] <= kLargestLoad) {
        result.at[i] = contact.at(T[i]);
        most = std::max(most, T[i]);
      }
    result.end = contact.end(most);
  });
  return result;
}

std::optional<EllipseBranchEnd> ContactModel::ellipse_end(const EndParameters& parameters, double P,
                                                          Control control) const {
  if (is_elliptic()) return circle().ellipse_end(parameters, P, control);
  std::optional<EllipseBranchEnd> result;
  with_ellipse(*this, *law_, parameters, P, [&]<class Law>(const Law& law, const auto& mode_II, const auto& mode_III) {
    if (above_pull_off(P) < 0) return;
    EllipticContact<Law> contact(law, mode_II, mode_III, parameters.poisson_ratio, P);
    result = contact.end_under(control, contact.far_shear());
  });
  return result;
}

EllipseSlopes ContactModel::ellipse_slopes(const EndParameters& parameters, double P, std::span<const double> T,
                                           std::span<const EllipseState> at) const {
  if (is_elliptic()) return circle().ellipse_slopes(parameters, P, T, at);
  const std::size_t count = 3 + parameters.mode_II.size() + parameters.mode_III.size();
  const std::vector<double> none(count * at.size(), std::numeric_limits<double>::quiet_NaN());
  EllipseSlopes result{none, none};
  if (std::none_of(at.begin(), at.end(), [](const auto& one) { return one.status == EquilibriumStatus::ok; }))
    return result;
  with_law(*law_, [&]<class Law>(const Law& law) {
    const Parameters<Law> mode_II = parameters_from<Law>(parameters.mode_II),
                          mode_III = parameters_from<Law>(parameters.mode_III);
    const EllipticContact<Law> contact(law, mode_II, mode_III, parameters.poisson_ratio, P);
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (at[i].status != EquilibriumStatus::ok) continue;
      double *const a = &result.a[count * i], *const b = &result.b[count * i];
      contact.slopes(T[i], at[i].a, at[i].b, a, b);
      for (std::size_t k = 0; k < count; ++k) {
        a[k] *= at[i].a;
        b[k] *= at[i].b;
      }
    }
  });
  return result;
}

}  // namespace mixity
