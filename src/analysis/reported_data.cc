#include "analysis/reported_data.h"

#include <algorithm>

#include "analysis/judgement.h"
#include "analysis/run.h"
#include "fitting/predicted_area.h"

namespace mixity {
namespace {

constexpr std::size_t kProfilePoints = 80;
constexpr double kParabolaUpTo = 0.5;  // of a run's largest T

}  // namespace

Analysis run_for_report(FitRequest request, const Progress& progress) {
  request.options.profile_points = kProfilePoints;
  constexpr double kAll = 0.9;  // of the time goes into the fits of all runs together
  Analysis result = run(request, stretch(progress, 0, kAll));
  const double share = (1 - kAll) / static_cast<double>(request.models.size());
  if (result.per_curve.empty() && result.data.has_loads && result.data.curves.size() > 1)
    for (const std::string& model : request.models) {
      const double before = kAll + share * static_cast<double>(result.per_curve.size());
      request.options.progress = stretch(progress, before, before + share);
      result.per_curve.push_back(fit_per_curve(result.data, model, request.options));
    }
  // the best model first, in every table and figure
  std::vector<FitResult> fits;
  std::vector<PerCurve> per_curve;
  for (const std::size_t i : by_merit(result)) {
    for (PerCurve& one : result.per_curve)
      if (one.model == result.fits[i].model) per_curve.push_back(std::move(one));
    fits.push_back(std::move(result.fits[i]));
  }
  result.fits = std::move(fits);
  result.per_curve = std::move(per_curve);
  if (progress) progress(1);
  return result;
}

ReportedData reported_data(const Analysis& result, const std::string& stem) {
  ReportedData data{result, stem, {}, {}, {}};
  if (result.data.has_loads) {
    const auto known = std::find_if(result.fits.begin(), result.fits.end(), has_all_values);
    std::vector<double> values;
    if (known != result.fits.end()) {
      data.sahli_model = known->model;
      const auto p = fitted_candidate(result.data, model_of(*known), *known, result.request.options).parameters;
      values.assign(p.begin(), p.end());
    }
    data.sahli = fit_sahli(result.data, kParabolaUpTo, data.sahli_model, values);
  }
  if (!result.request.peaks_path.empty()) data.peaks = load_peak_forces(result.request.peaks_path);
  if (data.peaks) data.predicted_peaks = predict_peaks(result, *data.peaks);
  return data;
}

}  // namespace mixity
