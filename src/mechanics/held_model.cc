#include "mechanics/held_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/constant_shear.h"
#include "mechanics/held_branches.h"
#include "mechanics/held_residual.h"
#include "mechanics/non_monotone_curve.h"

namespace mixity {
namespace {

template <class Law>
std::string_view law_obstacle(const Law& law, const Parameters<Law>& p) {
  if (const std::string_view why = contact_obstacle(law, p, 0); !why.empty()) return why;
  if (!is_non_monotone(law, p) && std::isfinite(law.small_shear(p))) return {};
  return "a held approach needs a law whose shear term grows with T from T = 0 on";
}

/// Calls use(curve, i) for each point i, with the HeldCurve of its approach and parameters; or null in its place, and
/// whether its approach and parameters are in range.
template <class Use>
void each_point(const AnyLaw& any, std::span<const Values> parameters, Values approach, std::size_t n, const Use& use) {
  with_law(any, [&]<class Law>(const Law& law) {
    for (std::size_t begin = 0; begin < n;) {
      const Parameters<Law> p = parameters_at<Law>(parameters, begin);
      std::size_t end = begin + 1;
      while (end < n && approach[end] == approach[begin] && parameters_at<Law>(parameters, end) == p) ++end;
      const HeldApproach held{approach[begin], any.held->compliance};
      const bool valid = law_obstacle(law, p).empty() && held.in_range();
      std::optional<HeldCurve<Law>> curve;
      if (const auto of = valid ? held.unsheared() : std::nullopt) curve.emplace(law, p, held, *of);
      use(curve ? &*curve : nullptr, begin, end, valid);
      begin = end;
    }
  });
}

/// Returns visit(curve) if there is a contact, else `otherwise`.
template <class Result, class Visit>
Result with_curve(const AnyLaw& any, ParameterSpan p, double approach, Result otherwise, const Visit& visit) {
  return with_law(any, p, [&]<class Law>(const Law& law, const Parameters<Law>& values) -> Result {
    const HeldApproach held{approach, any.held->compliance};
    const auto of = law_obstacle(law, values).empty() ? held.unsheared() : std::nullopt;
    if (!of) return std::move(otherwise);
    return visit(HeldCurve<Law>(law, values, held, *of));
  });
}

/// The states of a contact that is loaded from T = 0, at one T after the other.
template <class Law>
class Followed {
 public:
  explicit Followed(const HeldCurve<Law>& curve) : curve_(curve), branches_(curve, {Control::Kind::load}) {}
  const std::vector<HeldStretch>& stretches() const { return branches_.stretches(); }
  /// Radius and edge load; null beyond the last equilibrium.
  std::optional<typename HeldCurve<Law>::State> at(double T) const {
    if (T == 0 || curve_.uncoupled()) return curve_.at(0);
    const auto u = branches_.first_at(T);
    return u ? std::optional(curve_.at(*u)) : std::nullopt;
  }

 private:
  const HeldCurve<Law>& curve_;
  HeldBranches<Law> branches_;
};

EquilibriumStatus status_without(bool valid, double T) {
  return valid && T >= 0 && T <= kLargestLoad ? EquilibriumStatus::no_equilibrium : EquilibriumStatus::invalid;
}

}  // namespace

ContactModel ContactModel::at_held_approach(double compliance) const {
  const AnyLaw& own = *law_;
  return ContactModel(std::make_shared<const AnyLaw>(AnyLaw{own.value, own.info, own.parameters, own.ellipse,
                                                            std::make_shared<const HeldModel>(HeldModel{compliance})}));
}

ContactModel ContactModel::of_loads() const {
  const AnyLaw& own = *law_;
  return own.held
             ? ContactModel(std::make_shared<const AnyLaw>(AnyLaw{own.value, own.info, own.parameters, own.ellipse}))
             : *this;
}

bool ContactModel::holds_approach() const { return law_->held != nullptr; }

bool ContactModel::has_compliance() const { return law_->held && law_->held->compliance > 0; }

HeldApproach ContactModel::held_at(double approach) const {
  return {approach, law_->held ? law_->held->compliance : std::numeric_limits<double>::infinity()};
}

bool ContactModel::in_contact(double P) const {
  return law_->held ? held_at(P).unsheared().has_value() : above_pull_off(P) >= 0;
}

ContactState ContactModel::state(double P, double T, double y) const {
  return contact_state(law_->held ? held_at(P).load(held_at(P).radius(y)) : P, T, y);
}

double ContactModel::load(double P, double a) const { return law_->held ? held_at(P).load(a) : P; }

double ContactModel::unsheared_radius(double P) const {
  return law_->held ? held_at(P).unsheared()->stable : jkr_radius(P);
}

ApproachStates under_held_approach(const ContactModel& model, ParameterSpan p, const HeldApproach& held,
                                   std::span<const double> T) {
  ApproachStates result{std::vector<ApproachState>(T.size())};
  if (!model.problem(p).empty()) return result;
  const ContactModel under = model.at_held_approach(held.compliance);
  if (!under.obstacle(p, held.approach).empty()) return result;
  const Equilibria found = under.equilibria(p, held.approach, T);
  double most = 0;
  for (std::size_t i = 0; i < T.size(); ++i) {
    ApproachState& one = result.at[i];
    one.status = found.at[i].status;
    if (T[i] >= 0 && T[i] <= kLargestLoad) most = std::max(most, T[i]);
    if (one.status != EquilibriumStatus::ok) continue;
    one.a = held.radius(found.at[i].y);
    one.P = held.load(one.a);
  }
  if (!found.first || found.first->T_bottom >= most) return result;
  const double a = held.radius(found.first->y_bottom);
  result.end = ApproachEnd{found.first->ends_in_fold, found.first->T_bottom, held.load(a), a};
  return result;
}

namespace held {

std::string_view obstacle(const AnyLaw& any, ParameterSpan p, double approach) {
  return with_law(any, p, [&](const auto& law, const auto& values) -> std::string_view {
    if (const std::string_view why = law_obstacle(law, values); !why.empty()) return why;
    return HeldApproach{approach, any.held->compliance}.in_range() ? "" : "the approach is out of range";
  });
}

void areas(const AnyLaw& law, std::span<const Values> p, Values approach, Values T, std::span<double> A,
           std::span<EquilibriumStatus> status) {
  each_point(law, p, approach, A.size(), [&](auto* const curve, std::size_t begin, std::size_t end, bool valid) {
    std::optional<Followed<std::decay_t<decltype(curve->law())>>> followed;
    if (curve) followed.emplace(*curve);
    for (std::size_t i = begin; i < end; ++i) {
      const double shear = std::abs(T[i]);
      A[i] = std::numeric_limits<double>::quiet_NaN();
      status[i] = status_without(valid, shear);
      if (!followed || status[i] == EquilibriumStatus::invalid) continue;
      const auto state = followed->at(shear);
      if (!state) continue;
      A[i] = area_from_radius(state->a);
      status[i] = EquilibriumStatus::ok;
    }
  });
}

/// From G(a, T) = 0: da/dp = -G_p/G_a.
void area_slopes(const AnyLaw& law, std::span<const Values> p, Values approach, Values T, std::span<const double> A,
                 std::span<const std::span<double>> slopes) {
  each_point(law, p, approach, A.size(), [&](auto* const curve, std::size_t begin, std::size_t end, bool) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!curve || !(A[i] > 0)) continue;
      const double a = radius_from_area(A[i]), y = curve->held().edge_load(a).value, shear = std::abs(T[i]);
      if (!(y >= 0)) continue;
      const auto G = curve->slopes({a, y, 0, shear});
      const auto by_law =
          equilibrium_gradient(curve->law(), curve->parameters(), curve->held().load(a), shear, y).parameters;
      for (std::size_t k = 0; k < slopes.size(); ++k) slopes[k][i] = -by_law[k] / G.a * 2 * pi<double>() * a;
    }
  });
}

void tangential_loads(const AnyLaw& law, std::span<const Values> p, Values approach, Values A, std::span<double> T) {
  each_point(law, p, approach, T.size(), [&](auto* const curve, std::size_t begin, std::size_t end, bool) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!curve || !(A[i] > 0)) continue;
      const double a = radius_from_area(A[i]), y = curve->held().edge_load(a).value;
      const double square = 8 * pi<double>() * a * a * a - y * y;
      if (!(y > 0) || square < -8 * std::numeric_limits<double>::epsilon() * y * y) continue;
      const double found = tangential_load(curve->law(), curve->parameters(), y, std::sqrt(std::max(square, 0.0)));
      if (std::isfinite(found)) T[i] = found;
    }
  });
}

Equilibria equilibria(const AnyLaw& law, ParameterSpan p, double approach, std::span<const double> T) {
  Equilibria found;
  const bool valid = obstacle(law, p, approach).empty();
  for (const double shear : T) found.at.push_back({status_without(valid, shear)});
  with_curve(law, p, approach, 0, [&](const auto& curve) {
    const Followed followed(curve);
    bool beyond = false;
    for (std::size_t i = 0; i < T.size(); ++i) {
      if (found.at[i].status == EquilibriumStatus::invalid) continue;
      const auto state = followed.at(T[i]);
      if (state) found.at[i] = {EquilibriumStatus::ok, state->y};
      beyond |= !state;
    }
    const auto branch = [&](const HeldStretch& one) {
      return StableBranch{curve.at(one.begin).y, one.from, curve.at(one.end).y, one.to, one.ends_in_fold};
    };
    if (followed.stretches().empty()) return 0;
    found.first = branch(followed.stretches().front());
    if (beyond) found.last = branch(followed.stretches().back());
    return 0;
  });
  return found;
}

double first_stable_end(const AnyLaw& law, ParameterSpan p, double approach) {
  return with_curve(law, p, approach, 0.0, [](const auto& curve) {
    const Followed followed(curve);
    return followed.stretches().empty() ? std::numeric_limits<double>::infinity() : followed.stretches().front().to;
  });
}

std::vector<Fold> folds(const AnyLaw& law, ParameterSpan p, double approach, Control control) {
  return with_curve(law, p, approach, std::vector<Fold>(), [&](const auto& curve) {
    const HeldBranches branches(curve, control);
    std::vector<Fold> list;
    const auto& stretches = branches.stretches();
    for (const auto& [u, maximum] : branches.folds()) {
      const auto state = curve.at(u);
      Fold& fold = list.emplace_back();
      fold.control = control;
      fold.place = {0, u, {state.y, 0, 0}, state.T, maximum};
      fold.T = state.T;
      fold.u = 0.75 * state.T / state.a;
      fold.A = area_from_radius(state.a);
      fold.psi = phase_angle(mixity_from_loads(state.y, state.T));
      fold.jumps_to = Jump::off_contact;
      const double value = branches.driving(state);
      for (const HeldStretch& one : stretches) {
        const bool beyond = maximum ? one.begin >= u : one.end <= u;
        if (!beyond || !(value >= one.from && value <= one.to)) continue;
        const auto after = branches.first_at(value, static_cast<std::size_t>(&one - stretches.data()));
        fold.jumps_to = maximum ? Jump::lower_branch : Jump::upper_branch;
        fold.area_after = area_from_radius(curve.at(after.value_or(one.end)).a);
        if (maximum) break;
      }
      if (fold.jumps_to == Jump::off_contact && approach > 0) {
        fold.jumps_to = Jump::hertz;
        fold.area_after = area_from_radius(curve.held().radius(0));
      }
      fold.area_lost = fold.A - fold.area_after;
    }
    return list;
  });
}

SampledCurve curve(const AnyLaw& law, ParameterSpan p, double approach, const CurveSampling& sampling) {
  return with_curve(law, p, approach, SampledCurve{{}, false}, [&](const auto& curve) {
    constexpr double kTiny = 1e-7;  // the first part of the curve, of which T is linear in u
    constexpr int kParts = 4;       // between two nodes
    SampledCurve sampled{{}, curve.uncoupled()};
    const auto add = [&](double u) {
      const auto s = curve.at(u);
      const auto G = curve.slopes(curve.at(std::max(u, kTiny)));
      const double pace = curve.radius_per_u(std::max(u, kTiny)), da = u > 0 ? pace : 0;
      const double dT = -G.a / G.T * pace, square = s.y * s.y + s.T * s.T, dy = curve.held().edge_load(s.a).slope * da;
      sampled.points.push_back({u, s.y, s.T, s.a, area_from_radius(s.a), 0.75 * s.T / s.a, std::atan2(s.T, s.y),
                                square / (8 * pi<double>() * s.a * s.a * s.a), dy, dT, da, 2 * pi<double>() * s.a * da,
                                0.75 * (dT - s.T * da / s.a) / s.a, (s.y * dT - s.T * dy) / square, 0});
    };
    if (sampled.uncoupled) {
      const double a = curve.top(), y = curve.held().edge_load(a).value;
      sampled.points.push_back({0, y, 0, a, area_from_radius(a), 0, 0, 1, 0, 1, 0, 0, 0.75 / a, 1 / y, 0});
      return sampled;
    }
    const auto& nodes = curve.nodes();
    constexpr double kFarther = 10;  // than the scale on which the contact shrinks
    const double coupling = curve.law().small_shear(curve.parameters());
    const double most =
        sampling.T_most.value_or(kFarther * std::sqrt(8 * pi<double>() * std::pow(curve.top(), 3) / coupling));
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
      for (int k = 0; k < kParts; ++k) {
        const double u = nodes[i].u + (nodes[i + 1].u - nodes[i].u) * k / kParts;
        if (curve.at(u).T <= most) add(u);
      }
    // without the end where the contact has vanished
    if (nodes.back().state.T <= most && nodes.back().state.a > 0) add(nodes.back().u);
    return sampled;
  });
}

/// Delta in place of P, and its derivative in y.
std::vector<ConstantShearPoint> at_constant_shear(const AnyLaw& any, ParameterSpan p, double T,
                                                  std::span<const double> y) {
  return with_law(any, p, [&]<class Law>(const Law& law, const Parameters<Law>& values) {
    std::vector<ConstantShearPoint> points;
    const double m = any.held->compliance;
    for (const double edge_load : y) {
      const ConstantShearPoint under_load = constant_shear_point(law, values, T, edge_load);
      const double a = under_load.a, a_slope = (under_load.dP_dy + 1) / (4 * a * a);
      points.push_back({edge_load, m * (4.0 / 3 * a * a * a - edge_load) + a * a - edge_load / (2 * a), a,
                        (4 * m * a * a + 2 * a + edge_load / (2 * a * a)) * a_slope - m - 0.5 / a});
    }
    return points;
  });
}

std::optional<double> shear_sensitivity(const AnyLaw& any, ParameterSpan p, double A0) {
  return with_law(any, p, [&]<class Law>(const Law& law, const Parameters<Law>& values) -> std::optional<double> {
    if (!law_obstacle(law, values).empty()) return std::nullopt;
    const double a = radius_from_area(A0), y = std::sqrt(8 * pi<double>() * a) * a, m = any.held->compliance;
    const HeldApproach held{m * (4.0 / 3 * a * a * a - y) + a * a - y / (2 * a), m};
    const double alpha =
        2 * pi<double>() * a * law.small_shear(values) / (2 * y * held.edge_load(a).slope - 24 * pi<double>() * a * a);
    return alpha > 0 ? std::optional(alpha) : std::nullopt;
  });
}

bool curve_distances(const AnyLaw& any, ParameterSpan p, const PlanePoints& points, bool derivatives,
                     CurveDistances& out) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const std::size_t n = points.P.size(), count = p.size();
  const bool loads = !points.q.empty();
  return with_law(any, p, [&]<class Law>(const Law& law, const Parameters<Law>& values) {
    if (!law_obstacle(law, values).empty()) return false;
    std::optional<HeldCurve<Law>> curve;
    HeldApproach before{kNone, kNone};
    for (std::size_t i = 0; i < n; ++i) {
      const HeldApproach held{points.P[i], points.compliance.empty() ? any.held->compliance : points.compliance[i]};
      if (held.approach != before.approach || held.compliance != before.compliance) {
        const auto of = held.unsheared();
        if (!of) return false;
        curve.emplace(law, values, held, *of);
        before = held;
      }
      const bool loaded = loads && std::isfinite(points.q[i]);
      const HeldReading reading{std::abs(points.T[i]), points.A[i],       loaded ? points.q[i] : 0,
                                points.sigma_T[i],     points.sigma_A[i], loaded ? points.sigma_q[i] : kNone};
      if (!(reading.T <= kLargestLoad) || !(reading.A > 0) || !(reading.sigma_T > 0) || !(reading.sigma_A > 0) ||
          !(reading.sigma_P > 0))
        return false;
      HeldResidual<Law> residual(*curve, reading);
      if (!out.place_A.empty()) {
        out.place_T[i] = residual.state().T;
        out.place_A[i] = area_from_radius(residual.state().a);
      }
      if (!out.place_q.empty()) out.place_q[i] = held.load(residual.state().a);
      out.r[i] = residual.value()[0];
      if (loads) out.axes.r[i] = loaded ? residual.value()[1] : 0;
      if (!std::isfinite(out.r[i])) return false;
      if (!derivatives) continue;
      residual.differentiate();
      const double sign = std::copysign(1.0, points.T[i]);
      const auto set = [&](std::span<double> first, std::span<double> second, const std::array<double, 2>& d,
                           double by = 1) {
        if (!first.empty()) first[i] = by * d[0];
        if (loads && !second.empty()) second[i] = loaded ? by * d[1] : 0;
      };
      set(out.dP, out.axes.dP, residual.by_approach());
      set(out.dT, out.axes.dT, residual.by_T(), sign);
      set(out.dA, out.axes.dA, residual.by_A());
      set(out.dm, out.axes.dm, residual.by_compliance());
      if (loads) {
        set(out.axes.of_sigma_T, out.axes.own_sigma_T, residual.by_sigma_T());
        set(out.axes.of_sigma_A, out.axes.own_sigma_A, residual.by_sigma_A());
        set(out.axes.of_q, out.axes.own_q, residual.by_P());
        set(out.axes.of_sigma_q, out.axes.own_sigma_q, residual.by_sigma_P());
      }
      for (std::size_t k = 0; k < count; ++k) {
        const auto d = residual.by_law(k);
        out.parameters[i * count + k] = d[0];
        if (loads) out.axes.parameters[i * count + k] = loaded ? d[1] : 0;
        if (!std::isfinite(d[0])) return false;
      }
      if (!std::isfinite(out.dP[i]) || !std::isfinite(out.dA[i])) return false;
    }
    return true;
  });
}

}  // namespace held
}  // namespace mixity
