#include "fitting/predicted_curves.h"

#include <algorithm>
#include <cmath>

#include "dataset/display_units.h"
#include "fitting/predicted_area.h"
#include "fitting/pull_off_rows.h"

namespace mixity {
namespace {

constexpr double kChord = 2e-4;  // of the curve's size: a hundredth of a line's width

/// Converts the model's numbers to those on the axes.
class Shown {
 public:
  Shown(const Dataset& data, const Constants& constants, double sign_of_shear = 1)
      : units_(data), scale_(constants), sign_(sign_of_shear) {}
  const ConstantsScale& scale() const { return scale_; }
  double shear(double measured) const { return std::abs(scale_.shear(sign_ * measured)); }
  double force(double load) const { return (load / scale_.force - scale_.load_offset) * units_.force; }
  double P(double value) const { return scale_.measured_load(value) * units_.held; }
  double T(double value) const { return sign_ * scale_.measured_shear(sign_ * value) * units_.force; }
  double A(double value) const { return scale_.measured_area(value) * units_.area; }
  double a(double value) const {
    return std::sqrt(std::max(value * value / scale_.area - scale_.area_offset / pi<double>(), 0.0)) * units_.radius;
  }
  double u(double value) const { return value / scale_.displacement * units_.displacement; }

 private:
  DrawnUnits units_;
  ConstantsScale scale_;
  double sign_;
};

}  // namespace

DrawnCurve drawn_curve(const Dataset& data, const FitOptions& options, const FitResult& fit, double load, double T_most,
                       double sign_of_shear) {
  const Candidate candidate = fitted_candidate(data, model_of(data, fit), fit, options);
  const ContactModel model = at_scale(model_of(data, fit), ConstantsScale(candidate.constants));
  const Shown shown(data, candidate.constants, sign_of_shear);
  const double P = shown.scale().load(load), most = shown.shear(T_most);
  const CurveSampling sampling{
      .rule = CurveSampling::Rule::soonest, .chord = kChord, .T_most = most, .first_range_only = true};
  const SampledCurve curve = model.curve(candidate.parameters, P, sampling);
  DrawnCurve drawn;
  if (curve.uncoupled) {
    const double a = model.unsheared_radius(P);
    for (const double T : {0.0, most})
      drawn.points.push_back(
          {shown.T(T), shown.A(area_from_radius(a)), shown.u(0.75 * T / a), true, shown.force(model.load(P, a))});
    return drawn;
  }
  for (const CurvePoint& q : curve.points)
    drawn.points.push_back({shown.T(q.T), shown.A(q.A), shown.u(q.u), q.dT >= 0, shown.force(model.load(P, q.a))});
  for (const Control::Kind kind : {Control::Kind::load, Control::Kind::displacement})
    for (const Fold& fold : model.folds(candidate.parameters, P, {kind}))
      if (fold.place.maximum)
        drawn.folds.push_back({kind, shown.T(fold.T), shown.A(fold.A), shown.u(fold.u),
                               std::string(to_string(fold.jumps_to)),
                               fold.area_after > 0 ? shown.A(fold.area_after) : 0});
  return drawn;
}

std::vector<StableState> stable_states(const Dataset& data, const FitOptions& options, const FitResult& fit,
                                       std::size_t run, std::size_t points) {
  const Candidate candidate = fitted_candidate(data, model_of(data, fit), fit, options);
  const ContactModel model = at_scale(model_of(data, fit), ConstantsScale(candidate.constants));
  const ConstantsScale scale(candidate.constants);
  const double P = scale.load(data.curve_loads[run]);
  double measured = 0;
  for (const Point& point : data.points)
    if (point.curve == run) measured = std::max(measured, std::abs(scale.shear(data.sign_of_shear(run) * point.T)));
  double end = model.first_stable_end(candidate.parameters, P);
  if (std::isinf(end)) end = 1.2 * measured;
  std::vector<double> shears;
  for (std::size_t i = 0; i < points; ++i) {
    const double rest = 1 - static_cast<double>(i) / static_cast<double>(points - 1);
    shears.push_back(end * (1 - rest * rest));
  }
  std::vector<StableState> states;
  const Equilibria found = model.equilibria(candidate.parameters, P, shears);
  for (std::size_t i = 0; i < points; ++i) {
    if (found.at[i].status != EquilibriumStatus::ok) continue;
    const ContactState state = model.state(P, shears[i], found.at[i].y);
    const double sign = data.sign_of_shear(run);
    states.push_back(
        {sign * scale.measured_shear(sign * state.T), scale.measured_area(state.A), state.psi, state.f, found.at[i].q});
  }
  return states;
}

std::vector<std::pair<double, double>> drawn_axes(const Dataset& data, const FitOptions& options, const FitResult& fit,
                                                  std::size_t run, std::size_t points) {
  std::vector<std::pair<double, double>> drawn;
  if (!model_of(data, fit).is_elliptic()) return drawn;
  for (const StableState& state : stable_states(data, options, fit, run, points))
    drawn.emplace_back(std::abs(state.T), std::exp(state.q));
  return drawn;
}

std::vector<std::pair<double, double>> drawn_pull_off(const Dataset& data, const FitOptions& options,
                                                      const FitResult& fit, HeldShear held, double most,
                                                      std::size_t points) {
  const ContactModel model = model_of(data, fit);
  const Candidate candidate = fitted_candidate(data, model, fit, options);
  const ConstantsScale scale(candidate.constants);
  std::vector<double> as_read(points), shear(points);
  std::vector<PullOff> found(points);
  for (std::size_t i = 0; i < points; ++i) {
    as_read[i] = most * static_cast<double>(i) / static_cast<double>(points - 1);
    shear[i] = std::abs(held_shear(scale, held, as_read[i]));
  }
  model.pull_off(candidate.parameters, held, shear, found, {});
  std::vector<std::pair<double, double>> drawn;
  for (std::size_t i = 0; i < points; ++i)
    if (std::isfinite(found[i].P)) drawn.emplace_back(as_read[i], scale.measured_load(found[i].P));
  return drawn;
}

DrawnRadii drawn_radii(const Dataset& data, const FitOptions& options, const FitResult& fit, double T, double P_most,
                       std::size_t points) {
  const Candidate candidate = fitted_candidate(data, model_of(data, fit), fit, options);
  const ContactModel model = at_scale(model_of(data, fit), ConstantsScale(candidate.constants));
  const Shown shown(data, candidate.constants);
  DrawnRadii drawn;
  if (!model.obstacle(candidate.parameters).empty()) return drawn;
  const double load = shown.scale().load(P_most);
  // The largest y up to the load P_most: that of JKR, since shear lowers it.
  const double a = model.holds_approach() && model.in_contact(load) ? model.unsheared_radius(load) : 0;
  const double largest = 1.05 * (model.holds_approach() ? std::sqrt(8 * pi<double>() * a) * a
                                                        : 3 * pi<double>() + circle_radius(std::max(load, 0.0)));
  std::vector<double> edge_loads;
  for (std::size_t i = 1; i <= points; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(points);
    edge_loads.push_back(largest * part * part);
  }
  for (const ConstantShearPoint& q : model.at_constant_shear(candidate.parameters, shown.shear(T), edge_loads)) {
    if (!std::isfinite(q.P) || q.P > load) continue;
    const bool stable = q.dP_dy > 0;
    // the two parts share the point where they meet
    if (stable && drawn.stable.empty() && !drawn.unstable.empty()) drawn.stable.push_back(drawn.unstable.back());
    (stable ? drawn.stable : drawn.unstable).emplace_back(shown.P(q.P), shown.a(q.a));
  }
  return drawn;
}

std::vector<std::pair<double, double>> toughness_curve(const ContactModel& model, std::span<const double> p,
                                                       double last_psi, double most, std::size_t steps) {
  std::vector<double> psi(steps + 1), log_f(steps + 1);
  std::vector<Mixity<double>> at;
  for (std::size_t i = 0; i <= steps; ++i) {
    psi[i] = last_psi * static_cast<double>(i) / static_cast<double>(steps);
    at.push_back(mixity_from_angle(psi[i]));
  }
  model.log_toughness(p, at, log_f, {});
  std::vector<std::pair<double, double>> points;
  for (std::size_t i = 0; i <= steps; ++i)
    if (!std::isnan(log_f[i])) points.emplace_back(psi[i], std::min(std::exp(log_f[i]), most));
  return points;
}

std::vector<std::pair<double, double>> drawn_toughness(const Dataset& data, const FitResult& fit, double last_psi,
                                                       double most, std::size_t steps) {
  const ContactModel model = model_of(data, fit);
  return toughness_curve(model, fitted_candidate(data, model, fit, {}).parameters, last_psi, most, steps);
}

std::vector<const FitResult*> fits_with_values(const std::vector<FitResult>& all) {
  std::vector<const FitResult*> fits;
  for (const FitResult& fit : all)
    if (has_all_values(fit)) fits.push_back(&fit);
  return fits;
}

double largest_shear(const Dataset& data) {
  double largest = 0;
  for (const Point& point : data.points) largest = std::max(largest, point.shear());
  return largest;
}

std::optional<double> stated_strength(const Dataset& data) {
  if (!data.metadata.shear_strength || !data.contact) return std::nullopt;
  return *data.metadata.shear_strength / data.contact->stress_unit();
}

const FittedParameter* leading_parameter(const FitResult& fit) {
  for (const FittedParameter& parameter : fit.parameters)
    if (!parameter.held) return &parameter;
  return nullptr;
}

std::optional<FitResult> at_interval_end(const FitResult& fit, bool high) {
  const FittedParameter* const leading = leading_parameter(fit);
  if (!leading || !leading->interval) return std::nullopt;
  const auto end = high ? leading->interval->high : leading->interval->low;
  if (!end) return std::nullopt;
  FitResult moved = fit;
  moved.parameters[static_cast<std::size_t>(leading - fit.parameters.data())].value = *end;
  return moved;
}

}  // namespace mixity
