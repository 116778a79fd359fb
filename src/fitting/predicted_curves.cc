#include "fitting/predicted_curves.h"

#include <algorithm>
#include <cmath>

#include "dataset/display_units.h"
#include "fitting/predicted_area.h"
#include "mechanics/constant_shear.h"
#include "mechanics/sampling.h"

namespace mixity {
namespace {

constexpr double kChord = 2e-4;  // of the curve's size: a hundredth of a line's width

/// From the model's numbers to those of the reader's axes.
class Shown {
 public:
  Shown(const Dataset& data, const Constants& constants) : units_(data), scale_(constants) {}
  const ConstantsScale& scale() const { return scale_; }
  double P(double value) const { return (value / scale_.force - scale_.load_offset) * units_.force; }
  double T(double value) const { return value / scale_.force * units_.force; }
  double A(double value) const { return scale_.measured_area(value) * units_.area; }
  double a(double value) const { return value / std::sqrt(scale_.area) * units_.radius; }
  double u(double value) const { return value / scale_.area * units_.displacement; }

 private:
  DrawnUnits units_;
  ConstantsScale scale_;
};

template <class Model>
DrawnCurve curve_of(const Dataset& data, const FitOptions& options, const FitResult& fit, double load, double T_most,
                    Points points) {
  const Candidate<Model> candidate = fitted_candidate<Model>(data, fit, options);
  const Shown shown(data, candidate.constants);
  const double P = shown.scale().load(load), most = shown.scale().shear(T_most);
  const LoadedContact<Model> contact(candidate.parameters, P);
  if (!contact.obstacle().empty() || !contact.in_contact()) return {};
  const EquilibriumCurve<Model> curve(candidate.parameters, P);
  DrawnCurve drawn;
  if (curve.uncoupled()) {
    const double a = jkr_radius(P);
    for (const double T : {0.0, most})
      drawn.points.push_back({shown.T(T), shown.A(area_from_radius(a)), shown.u(0.75 * T / a), true});
    return drawn;
  }
  const std::vector<PhiRange> drawable{drawable_ranges(curve, most).front()};
  for (const CurvePoint& q :
       points == Points::fewest ? sample_adaptive(curve, drawable, kChord) : sample_halved(curve, drawable, kChord))
    drawn.points.push_back({shown.T(q.T), shown.A(q.A), shown.u(q.u), q.dT >= 0});
  for (const Control::Kind kind : {Control::Kind::load, Control::Kind::displacement})
    for (const Fold& fold : find_folds(curve, {kind}))
      if (fold.place.maximum)
        drawn.folds.push_back({kind, shown.T(fold.T), shown.A(fold.A), shown.u(fold.u),
                               std::string(to_string(fold.jumps_to)),
                               fold.area_after > 0 ? shown.A(fold.area_after) : 0});
  return drawn;
}

template <class Model>
DrawnRadii radii_of(const Dataset& data, const FitOptions& options, const FitResult& fit, double T, double P_most,
                    std::size_t points) {
  const Candidate<Model> candidate = fitted_candidate<Model>(data, fit, options);
  const Shown shown(data, candidate.constants);
  DrawnRadii drawn;
  const std::string_view obstacle = Model::equilibrium_domain(candidate.parameters);
  if (!obstacle.empty()) return drawn;
  const double shear = shown.scale().shear(T), load = shown.scale().load(P_most);
  // Far enough that the load passes P_most: y of JKR there, which shear only lowers
  const double largest = 1.05 * (3 * pi<double>() + circle_radius(std::max(load, 0.0)));
  for (std::size_t i = 1; i <= points; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(points);
    const ConstantShearPoint q = constant_shear_point<Model>(candidate.parameters, shear, largest * part * part);
    if (!std::isfinite(q.P) || q.P > load) continue;
    const bool stable = q.dP_dy > 0;
    // the two parts share the point where they meet
    if (stable && drawn.stable.empty() && !drawn.unstable.empty()) drawn.stable.push_back(drawn.unstable.back());
    (stable ? drawn.stable : drawn.unstable).emplace_back(shown.P(q.P), shown.a(q.a));
  }
  return drawn;
}

}  // namespace

DrawnCurve drawn_curve(const Dataset& data, const FitOptions& options, const FitResult& fit, double load, double T_most,
                       Points points) {
  DrawnCurve drawn;
  with_model(fit.model,
             [&](auto model) { drawn = curve_of<decltype(model)>(data, options, fit, load, T_most, points); });
  return drawn;
}

DrawnRadii drawn_radii(const Dataset& data, const FitOptions& options, const FitResult& fit, double T, double P_most,
                       std::size_t points) {
  DrawnRadii drawn;
  with_model(fit.model, [&](auto model) { drawn = radii_of<decltype(model)>(data, options, fit, T, P_most, points); });
  return drawn;
}

std::vector<std::pair<double, double>> drawn_toughness(const Dataset& data, const FitResult& fit, double last_psi,
                                                       double most, std::size_t steps) {
  std::vector<std::pair<double, double>> points;
  with_model(fit.model, [&](auto chosen) {
    using Model = decltype(chosen);
    const Parameters<Model> p = fitted_candidate<Model>(data, fit, {}).parameters;
    for (std::size_t i = 0; i <= steps; ++i) {
      const double psi = last_psi * static_cast<double>(i) / static_cast<double>(steps);
      const double f = std::exp(Model::log_toughness(p, mixity_from_angle(psi)).value);
      if (f <= most) points.emplace_back(psi, f);
    }
  });
  return points;
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
  FitResult moved = fit;
  for (FittedParameter& parameter : moved.parameters) {
    if (parameter.held) continue;
    if (!parameter.interval) return std::nullopt;
    const auto end = high ? parameter.interval->high : parameter.interval->low;
    if (!end) return std::nullopt;
    parameter.value = *end;
    return moved;
  }
  return std::nullopt;
}

}  // namespace mixity
