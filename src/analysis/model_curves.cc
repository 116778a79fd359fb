#include "analysis/model_curves.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/threads.h"
#include "base/units.h"
#include "fitting/predicted_area.h"

namespace mixity {
namespace {

constexpr std::size_t kMostRuns = 8;

std::vector<std::size_t> shown_runs(const Dataset& data) {
  std::vector<std::size_t> runs(data.curve_loads.size());
  std::iota(runs.begin(), runs.end(), std::size_t{0});
  std::stable_sort(runs.begin(), runs.end(),
                   [&](std::size_t i, std::size_t j) { return data.curve_loads[i] > data.curve_loads[j]; });
  return spread(runs, kMostRuns);
}

/// `front`: the fit whose toughness the points are drawn with; or null.
ToughnessRange toughness_range(const Dataset& data, const FitResult* front) {
  ToughnessRange range;
  const std::vector<double> over =
      front ? over_fitted_toughness(data, *front) : std::vector<double>(data.curves.size(), 1);
  for (std::size_t i = 0; i < data.points.size(); ++i)
    if (const auto toughness = data.toughness(i)) {
      const double ratio = toughness->ratio * over[data.points[i].curve];
      range.last_psi = std::max(range.last_psi, toughness->psi());
      range.largest = std::max(range.largest, ratio);
      range.least = std::min(range.least, ratio);
    }
  range.last_psi = std::min(1.05 * range.last_psi, 0.5 * pi<double>());
  range.logarithmic = range.largest > 20;
  range.most = (range.logarithmic ? 3 : 1.15) * range.largest;
  return range;
}

/// Computed in loads of the contact; loads in and out are those measured.
ModelMap map_of(const Dataset& data, const ContactModel& model, const FittedParameter& lambda,
                const ConstantsScale& scale) {
  ModelMap map;
  std::vector<double> loads;
  for (const double P : data.curve_loads) loads.push_back(scale.load(P));
  const ParameterInfo& info = model.parameters()[0];
  const auto [least, most] = std::minmax_element(loads.begin(), loads.end());
  const double margin = 0.1 * (*most - *least) + 0.5;
  map.frame.P_low = std::max(*least - margin, -1.5 * pi<double>() * 0.999);
  map.frame.P_high = *most + margin;
  map.frame.high = info.upper;
  map.frame.logarithmic = *lambda.value > 0 && *lambda.value < 0.05 * info.upper;
  map.frame.low = map.frame.logarithmic ? std::max(0.1 * *lambda.value, 1e-6) : info.lower;
  std::optional<double> tau0 = stated_strength(data);
  if (tau0) *tau0 *= data.metadata.shear_weight();  // in shears of the model
  const ParameterValues fitted{*lambda.value};
  RegimeMap regimes(model, fitted, map.frame, tau0);
  while (regimes.add_line()) continue;
  map.regions = regimes.regions();
  for (RegimeRegion& region : map.regions)
    for (auto& [P, value] : region.outline) P = scale.measured_load(P);
  for (double* const end : {&map.frame.P_low, &map.frame.P_high}) *end = scale.measured_load(*end);
  for (const double P : loads) {
    const auto report = model.regime(fitted, P, tau0);
    map.runs.push_back(report ? std::optional(report->regime) : std::nullopt);
  }
  return map;
}

ModelCurves curves_of(const Analysis& result, const FiguredModels& figured, const FitResult& fit) {
  const Dataset& data = result.data;
  const FitOptions& options = result.request.options;
  const auto toughness = [&](const FitResult& one) {
    return drawn_toughness(data, one, figured.toughness.last_psi, 10 * figured.toughness.most);
  };
  ModelCurves curves{&fit, {}, {}, {}, toughness(fit)};
  const auto low = at_interval_end(fit, false), high = at_interval_end(fit, true);
  if (low && high) curves.toughness_band = {toughness(*low), toughness(*high)};
  if (!data.has_loads || data.curve_loads.empty()) return curves;
  for (const std::size_t run : figured.runs) {
    const auto curve = [&](const FitResult& one) {
      return drawn_curve(data, options, one, data.curve_loads[run], kWidestArea * figured.T_data,
                         data.sign_of_shear(run));
    };
    curves.areas.push_back(curve(fit));
    if (low && high) curves.area_band.emplace_back(curve(*low), curve(*high));
  }
  for (const double T : figured.shears)
    if (T > 0) curves.radii.push_back(drawn_radii(data, options, fit, T, figured.P_most));
  const ContactModel model = model_of(data, fit);
  if (model.parameters().size() == 1 && !model.holds_approach())  // regimes are those of held loads
    curves.map = map_of(data, model, fit.parameters.front(),
                        ConstantsScale(fitted_candidate(data, model, fit, options).constants));
  return curves;
}

}  // namespace

std::vector<std::size_t> spread(const std::vector<std::size_t>& items, std::size_t n) {
  if (items.size() <= n) return items;
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < n; ++i) chosen.push_back(items[i * (items.size() - 1) / (n - 1)]);
  return chosen;
}

std::vector<double> over_fitted_toughness(const Dataset& data, const FitResult& fit) {
  std::vector<double> factors(data.curves.size(), 1);
  const FittedParameter* const of_all = find_parameter(fit.parameters, kConstantNames[kToughness]);
  const auto size = [](const std::string& unit) { return unit.empty() ? 1 : parse_unit(unit).value().factor; };
  // what a ratio of 1 is, in J/m^2
  const double whole = data.display.energy.empty() ? data.metadata.toughness.value_or(1)
                                                   : data.display.energy_scale * size(data.display.energy);
  for (std::size_t run = 0; run < factors.size() && !data.has_loads; ++run) {
    const FittedParameter* const own = find_parameter(fit.parameters, "toughness(" + data.curves[run] + ")");
    const FittedParameter* const found = own ? own : of_all;
    if (found && found->value) factors[run] = whole / (*found->value * size(found->unit));
  }
  return factors;
}

FiguredModels figured_models(const Analysis& result) {
  const Dataset& data = result.data;
  FiguredModels figured;
  figured.runs = shown_runs(data);
  const std::vector<const FitResult*> fits = fits_with_values(result.fits);
  figured.toughness = toughness_range(data, fits.empty() ? nullptr : fits.front());
  if (data.has_loads && !data.curve_loads.empty()) {
    figured.T_data = largest_shear(data);
    for (const double part : {0.25, 0.5, 0.75, 1.0}) figured.shears.push_back(part * figured.T_data);
    const auto [least, most] = std::minmax_element(data.curve_loads.begin(), data.curve_loads.end());
    figured.P_most = *most + 0.1 * (*most - *least) + 1;
  }
  figured.models.resize(fits.size());
  parallel_for(fits.size(), [&](std::size_t i) { figured.models[i] = curves_of(result, figured, *fits[i]); });
  return figured;
}

}  // namespace mixity
