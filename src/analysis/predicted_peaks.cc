#include "analysis/predicted_peaks.h"

#include <algorithm>
#include <cmath>

#include "fitting/predicted_curves.h"
#include "fitting/prediction.h"

namespace mixity {
namespace {

/// Dimensionless T at the jump under load control, as it would be measured; null if there is none.
std::optional<double> jump(const Analysis& result, const FitResult& fit, double load) {
  const auto predicted = predict_jump_of(result.data, fit, result.request.options, load);
  return predicted ? predicted->T.value : std::nullopt;
}

}  // namespace

std::vector<const PeakForce*> first_of_loads(const PeakForces& peaks, std::optional<double> PeakForce::*value) {
  std::vector<const PeakForce*> first;
  for (const PeakForce& row : peaks.rows)
    if (row.*value && std::none_of(first.begin(), first.end(), [&](const PeakForce* one) { return one->P == row.P; }))
      first.push_back(&row);
  std::sort(first.begin(), first.end(), [](const PeakForce* one, const PeakForce* other) { return one->P < other->P; });
  return first;
}

std::vector<PredictedPeaks> predict_peaks(const Analysis& result, const PeakForces& peaks) {
  std::vector<PredictedPeaks> list;
  const Dataset& data = result.data;
  if (!data.has_loads || data.contact.has_value() == peaks.force_unit.empty()) return list;
  const double load_unit = data.contact ? data.contact->force_unit() / parse_unit(peaks.force_unit)->factor : 1;
  // T/A_Hertz for dimensionless T and A; in kPa if there are units
  const double stress_unit = data.contact ? data.contact->force_unit() / data.contact->area_unit() / 1e3 : 1;
  for (const FitResult* fit : fits_with_values(result.fits)) {
    PredictedPeaks predicted{fit->model, {}};
    const auto low = at_interval_end(*fit, false), high = at_interval_end(*fit, true);
    std::vector<double> ratios;
    for (const PeakForce* row : first_of_loads(peaks, &PeakForce::peak)) {
      const double P = row->P / load_unit, stress = stress_unit / area_from_radius(std::cbrt(0.75 * P));
      const auto T = jump(result, *fit, P);
      if (!T) continue;
      const double one = low ? jump(result, *low, P).value_or(*T) : *T,
                   other = high ? jump(result, *high, P).value_or(*T) : *T;
      predicted.loads.push_back({row->P, *T * stress, std::min(one, other) * stress, std::max(one, other) * stress});
      ratios.push_back(*row->peak / predicted.loads.back().stress);
    }
    if (const auto n = static_cast<double>(ratios.size()); n > 1) {
      double mean = 0, squares = 0;
      for (const double ratio : ratios) mean += ratio / n;
      for (const double ratio : ratios) squares += (ratio - mean) * (ratio - mean);
      predicted.ratio = mean;
      predicted.ratio_error = std::sqrt(squares / (n * (n - 1)));
    }
    if (!predicted.loads.empty()) list.push_back(std::move(predicted));
  }
  return list;
}

}  // namespace mixity
