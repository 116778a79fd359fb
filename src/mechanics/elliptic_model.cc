#include "mechanics/elliptic_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/elliptic_contact.h"
#include "mechanics/elliptic_curve.h"
#include "mechanics/elliptic_residual.h"
#include "mechanics/non_monotone_curve.h"

namespace mixity {
namespace {

std::shared_ptr<const AnyLaw> made(const ContactModel& circle, std::shared_ptr<const AnyLaw> law, bool equal) {
  auto model = std::make_shared<EllipticModel>();
  const ModelInfo& info = circle.info();
  model->circle = law;
  model->equal = equal;
  model->key = std::string(info.key) + std::string(equal ? kEqualEllipse : kEllipse);
  model->name = std::string(info.name) + ", elliptic contact";
  model->formula = std::string(info.formula) + " at the ends of both axes";
  const std::vector<std::string> endings =
      equal ? std::vector<std::string>{""} : std::vector<std::string>{"_II", "_III"};
  for (const std::string& ending : endings)
    for (const ParameterInfo& one : law->parameters) model->names.push_back(std::string(one.name) + ending);
  model->names.emplace_back(kPoissonRatio);
  for (std::size_t i = 0; i < model->names.size(); ++i) {
    const bool of_law = i + 1 < model->names.size();
    ParameterInfo one = of_law ? law->parameters[i % law->parameters.size()] : ParameterInfo{{}, 0, 0.5, 0.5};
    one.name = model->names[i];
    model->parameters.push_back(one);
  }
  model->info = {model->key, model->name, model->formula};
  return std::make_shared<const AnyLaw>(AnyLaw{law->value, model->info, model->parameters, model});
}

/// Calls visit(law, mode_II, mode_III, poisson_ratio).
template <class Visit>
auto with_ends(const EllipticModel& model, ParameterSpan p, const Visit& visit) {
  const EndParameters ends = elliptic::ends_of(model, p);
  return with_law(*model.circle, [&]<class Law>(const Law& law) {
    return visit(law, parameters_from<Law>(ends.mode_II), parameters_from<Law>(ends.mode_III), ends.poisson_ratio);
  });
}

ParameterValues parameters_of_point(std::span<const Values> values, std::size_t i) {
  ParameterValues p = ParameterValues::zeros(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) p[k] = values[k][i];
  return p;
}

}  // namespace

std::shared_ptr<const AnyLaw> elliptic_law(std::string_view key) {
  const bool equal = key.ends_with(kEqualEllipse);
  const std::string_view ending = equal ? kEqualEllipse : kEllipse;
  if (!key.ends_with(ending)) return nullptr;
  const auto circle = ContactModel::find(key.substr(0, key.size() - ending.size()));
  return circle ? circle->of_ellipses(equal) : nullptr;
}

std::shared_ptr<const AnyLaw> ContactModel::of_ellipses(bool equal) const {
  return law_->ellipse ? nullptr : made(*this, law_, equal);
}

namespace elliptic {

EndParameters ends_of(const EllipticModel& model, ParameterSpan p) {
  const std::size_t n = model.circle->parameters.size();
  return {p.first(n), model.equal ? p.first(n) : p.subspan(n, n), p.back()};
}

std::string_view obstacle(const EllipticModel& model, ParameterSpan p, double P) {
  if (!(p.back() >= 0 && p.back() <= 0.5)) return "poisson_ratio must lie between 0 and 0.5";
  return with_ends(model, p, [&](const auto& law, const auto& II, const auto& III, double) -> std::string_view {
    for (const auto* const one : {&II, &III})
      if (const std::string_view why = contact_obstacle(law, *one, P); !why.empty()) return why;
    const bool monotone = !is_non_monotone(law, II) && !is_non_monotone(law, III);
    if (monotone && std::isfinite(law.small_shear(II) + law.small_shear(III))) return {};
    return "an elliptic contact needs a law whose shear term grows with T from T = 0 on";
  });
}

void make_continuous(const EllipticModel& model, std::span<double> p) {
  const std::size_t n = model.circle->parameters.size();
  with_law(*model.circle, [&]<class Law>([[maybe_unused]] const Law& law) {
    for (std::size_t k = 0; k + 1 < p.size(); k += n) {
      const std::span<double> one = p.subspan(k, n);
      if constexpr (requires { law.continuous(parameters_from<Law>(one)); }) {
        const auto next = law.continuous(parameters_from<Law>(one));
        std::copy_n(next.begin(), n, one.begin());
      }
    }
  });
}

namespace {

/// Calls use(contact, i, valid) for each point i, with the EllipticContact of its load and parameters: null where there
/// is an obstacle, which makes the point not valid, and below pull-off.
template <class Use>
void each_point(const EllipticModel& model, std::span<const Values> parameters, Values P, std::size_t n,
                const Use& use) {
  for (std::size_t begin = 0; begin < n;) {
    const ParameterValues p = parameters_of_point(parameters, begin);
    std::size_t end = begin + 1;
    while (end < n && P[end] == P[begin] && parameters_of_point(parameters, end) == p) ++end;
    const bool valid = obstacle(model, {p.data(), p.size()}, P[begin]).empty();
    with_ends(model, {p.data(), p.size()}, [&]<class Law>(const Law& law, const auto& II, const auto& III, double nu) {
      std::optional<EllipticContact<Law>> contact;
      if (valid && above_pull_off(P[begin]) >= 0) contact.emplace(law, II, III, nu, P[begin]);
      for (std::size_t i = begin; i < end; ++i) use(contact ? &*contact : nullptr, i, valid);
    });
    begin = end;
  }
}

}  // namespace

namespace {

/// Calls use(i, state) for each point.
template <class Use>
void each_state(const EllipticModel& model, std::span<const Values> p, Values P, Values T, std::size_t n,
                const Use& use) {
  each_point(model, p, P, n, [&](auto* const contact, std::size_t i, bool valid) {
    const double shear = std::abs(T[i]);
    EllipseState state{valid && shear <= kLargestLoad ? EquilibriumStatus::no_equilibrium : EquilibriumStatus::invalid};
    if (contact && shear <= kLargestLoad) state = contact->at(shear);
    use(i, state);
  });
}

}  // namespace

void areas(const EllipticModel& model, std::span<const Values> p, Values P, Values T, std::span<double> A,
           std::span<EquilibriumStatus> status) {
  each_state(model, p, P, T, A.size(), [&](std::size_t i, const EllipseState& state) {
    A[i] = pi<double>() * state.a * state.b;
    status[i] = state.status;
  });
}

void semi_axes(const EllipticModel& model, std::span<const Values> p, Values P, Values T, std::span<double> a,
               std::span<double> b) {
  each_state(model, p, P, T, a.size(), [&](std::size_t i, const EllipseState& state) {
    a[i] = state.a;
    b[i] = state.b;
  });
}

void area_slopes(const EllipticModel& model, std::span<const Values> p, Values P, Values T, std::span<const double> A,
                 std::span<const std::span<double>> slopes) {
  const std::size_t half = model.circle->parameters.size();
  std::vector<double> of_a(3 + 2 * half), of_b(of_a.size());
  each_point(model, p, P, A.size(), [&](auto* const contact, std::size_t i, bool) {
    if (!contact || !(A[i] > 0)) return;
    const EllipseState state = contact->at(std::abs(T[i]));
    if (state.status != EquilibriumStatus::ok) return;
    contact->slopes(std::abs(T[i]), state.a, state.b, of_a.data(), of_b.data());
    const auto slope = [&](std::size_t k) { return A[i] * (of_a[2 + k] + of_b[2 + k]); };
    for (std::size_t k = 0; k + 1 < slopes.size(); ++k)
      slopes[k][i] = model.equal ? slope(k) + slope(half + k) : slope(k);
    slopes.back()[i] = slope(2 * half);
  });
}

void tangential_loads(const EllipticModel& model, std::span<const Values> parameters, Values P, Values A,
                      std::span<double> T) {
  for (std::size_t i = 0; i < T.size(); ++i) {
    const ParameterValues p = parameters_of_point(parameters, i);
    if (!obstacle(model, {p.data(), p.size()}, P[i]).empty() || above_pull_off(P[i]) < 0 || !(A[i] > 0)) continue;
    with_ends(model, {p.data(), p.size()}, [&]<class Law>(const Law& law, const auto& II, const auto& III, double nu) {
      T[i] = EllipticCurve<Law>(law, II, III, nu, P[i], kLargestLoad).shear_at(A[i]);
    });
  }
}

Equilibria equilibria(const EllipticModel& model, ParameterSpan p, double P, std::span<const double> T) {
  Equilibria found;
  const bool valid = obstacle(model, p, P).empty(), in_contact = valid && above_pull_off(P) >= 0;
  with_ends(model, p, [&]<class Law>(const Law& law, const auto& II, const auto& III, double nu) {
    std::optional<EllipticContact<Law>> contact;
    if (in_contact) contact.emplace(law, II, III, nu, P);
    bool beyond = false;
    for (const double shear : T) {
      Equilibrium& one = found.at.emplace_back(Equilibrium{valid && shear >= 0 && shear <= kLargestLoad
                                                               ? EquilibriumStatus::no_equilibrium
                                                               : EquilibriumStatus::invalid});
      if (!contact || one.status == EquilibriumStatus::invalid) continue;
      const EllipseState state = contact->at(shear);
      one.status = state.status;
      if (state.status == EquilibriumStatus::ok) {
        one.y = edge_load(std::sqrt(state.a * state.b), P);
        one.q = std::log(state.a / state.b);
      }
      beyond |= state.status == EquilibriumStatus::no_equilibrium;
    }
    if (!beyond || !contact) return;
    const auto end = contact->end(kLargestLoad);
    if (end)
      found.last = StableBranch{3 * pi<double>() + circle_radius(P), 0, edge_load(std::sqrt(end->a * end->b), P),
                                end->T, end->kind == EllipseEnd::fold};
  });
  return found;
}

double first_stable_end(const EllipticModel& model, ParameterSpan p, double P) {
  if (!obstacle(model, p, P).empty() || above_pull_off(P) < 0) return 0;
  return with_ends(model, p, [&]<class Law>(const Law& law, const auto& II, const auto& III, double nu) {
    EllipticContact<Law> contact(law, II, III, nu, P);
    const auto end = contact.end(contact.far_shear());
    return end ? end->T : std::numeric_limits<double>::infinity();
  });
}

namespace {

std::optional<EllipseBranchEnd> end_under(const EllipticModel& model, ParameterSpan p, double P, Control control) {
  if (!obstacle(model, p, P).empty() || above_pull_off(P) < 0) return {};
  return with_ends(model, p, [&]<class Law>(const Law& law, const auto& II, const auto& III, double nu) {
    EllipticContact<Law> contact(law, II, III, nu, P);
    return contact.end_under(control, contact.far_shear());
  });
}

}  // namespace

std::optional<EllipseBranchEnd> closing(const EllipticModel& model, ParameterSpan p, double P, Control control) {
  const auto end = end_under(model, p, P, control);
  return end && end->kind != EllipseEnd::fold ? end : std::nullopt;
}

std::vector<Fold> folds(const EllipticModel& model, ParameterSpan p, double P, Control control) {
  std::vector<Fold> list;
  const auto end = end_under(model, p, P, control);
  if (!end || end->kind != EllipseEnd::fold) return list;
  const double y = edge_load(std::sqrt(end->a * end->b), P), A = pi<double>() * end->a * end->b,
               after = P > 0 ? area_from_radius(hertz_radius(P)) : 0;
  Fold& fold = list.emplace_back();
  fold.control = control;
  fold.place.position.y = y;
  fold.place.T = fold.T = end->T;
  fold.place.maximum = true;
  fold.u = end->u;
  fold.A = A;
  fold.psi = std::atan2(end->T, y);
  fold.jumps_to = P > 0 ? Jump::hertz : Jump::off_contact;
  fold.area_after = after;
  fold.area_lost = A - after;
  return list;
}

SampledCurve curve(const EllipticModel& model, ParameterSpan p, double P, const CurveSampling& sampling) {
  SampledCurve sampled{{}, false};
  if (!obstacle(model, p, P).empty() || above_pull_off(P) < 0) return sampled;
  with_ends(model, p, [&]<class Law>(const Law& law, const auto& II, const auto& III, double nu) {
    const EllipticEquations<Law> equations(law, II, III, nu, P);
    sampled.uncoupled = equations.uncoupled();
    const double most = sampling.T_most.value_or(sampled.uncoupled ? 0 : equations.far_shear());
    sampled.points = EllipticCurve<Law>(law, II, III, nu, P, most).sampled(most);
  });
  return sampled;
}

/// A falls by alpha T^2: from both equations at T = 0.
std::optional<double> shear_sensitivity(const EllipticModel& model, ParameterSpan p, double P) {
  if (!obstacle(model, p, P).empty()) return std::nullopt;
  return with_ends(model, p, [&]<class Law>(const Law& law, const auto& II, const auto& III, double nu) {
    const EllipticEquations<Law> equations(law, II, III, nu, P);
    const auto r = equations.residuals(equations.edge_load_at(0), 0, 0);
    const double w = equations.edge_load_at(0) + P, w_S = -equations.solved_at_S(r, r.S).first;
    const double alpha = -2 * area_from_edge_load(w - P, P) / (3 * w) * w_S;
    return alpha > 0 ? std::optional(alpha) : std::nullopt;
  });
}

bool curve_distances(const EllipticModel& model, ParameterSpan p, const PlanePoints& points, bool derivatives,
                     CurveDistances& out) {
  if (!obstacle(model, p, 0).empty()) return false;
  const std::size_t n = points.P.size(), count = p.size(), half = model.circle->parameters.size();
  const bool axes = !points.q.empty();
  constexpr double kNone = std::numeric_limits<double>::infinity();
  double T_most = 0;
  for (std::size_t i = 0; i < n; ++i) T_most = std::max(T_most, std::abs(points.T[i]) + 10 * points.sigma_T[i]);
  if (!(T_most <= kLargestLoad)) return false;
  return with_ends(model, p, [&]<class Law>(const Law& law, const auto& II, const auto& III, double nu) {
    std::optional<EllipticNearest<Law>> curve;
    for (std::size_t i = 0; i < n; ++i) {
      const double P = points.P[i];
      if (i == 0 || P != points.P[i - 1]) {
        if (!(above_pull_off(P) >= 0) || !(std::abs(P) <= kLargestLoad)) return false;
        curve.emplace(law, II, III, nu, P, T_most);
      }
      const bool sided = axes && std::isfinite(points.q[i]);
      const EllipticReading reading{std::abs(points.T[i]),      points.A[i],       sided ? points.q[i] : 0,
                                    points.sigma_T[i],          points.sigma_A[i], sided ? points.sigma_q[i] : kNone,
                                    sided ? points.slant[i] : 0};
      if (!(reading.A > 0) || !(reading.sigma_T > 0) || !(reading.sigma_A > 0) || !(reading.sigma_q > 0)) return false;
      const auto near = curve->nearest(reading);
      const double sign = std::copysign(1.0, points.T[i]);
      if (!out.place_A.empty()) {
        out.place_T[i] = near.spot.T;
        out.place_A[i] = near.spot.A;
      }
      if (!out.place_q.empty()) out.place_q[i] = near.spot.q;
      EllipticResidual<Law> residual(*curve, P, near, reading);
      out.r[i] = residual.value()[0];
      if (axes) out.axes.r[i] = sided ? residual.value()[1] : 0;
      if (!std::isfinite(out.r[i])) return false;
      if (!derivatives) continue;
      residual.differentiate();
      const auto set = [&](std::span<double> first, std::span<double> second, const std::array<double, 2>& d) {
        first[i] = d[0];
        if (axes) second[i] = sided ? d[1] : 0;
      };
      set(out.dP, out.axes.dP, residual.by(0));
      const auto of_T = residual.by_T();
      set(out.dT, out.axes.dT, {sign * of_T[0], sign * of_T[1]});
      set(out.dA, out.axes.dA, residual.by_A());
      if (axes) {
        set(out.axes.of_sigma_T, out.axes.own_sigma_T, residual.by_sigma_T());
        set(out.axes.of_sigma_A, out.axes.own_sigma_A, residual.by_sigma_A());
      }
      std::fill_n(&out.parameters[i * count], count, 0.0);
      if (axes) std::fill_n(&out.axes.parameters[i * count], count, 0.0);
      for (std::size_t k = 1; k < residual.count(); ++k) {
        const std::size_t at = k == residual.count() - 1 ? count - 1 : model.equal ? (k - 1) % half : k - 1;
        const auto d = residual.by(k);
        out.parameters[i * count + at] += d[0];
        if (sided) out.axes.parameters[i * count + at] += d[1];
      }
      for (std::size_t k = 0; k < count; ++k)
        if (!std::isfinite(out.parameters[i * count + k])) return false;
    }
    return true;
  });
}

}  // namespace elliptic
}  // namespace mixity
