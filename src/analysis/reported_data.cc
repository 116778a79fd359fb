#include "analysis/reported_data.h"

#include <algorithm>
#include <atomic>
#include <set>
#include <utility>

#include "analysis/judgement.h"
#include "analysis/result_names.h"
#include "analysis/run.h"
#include "base/threads.h"
#include "fitting/predicted_area.h"

namespace mixity {
namespace {

constexpr std::size_t kProfilePoints = 80;
constexpr double kParabolaUpTo = 0.5;  // of a run's largest T

/// `analyse` runs the request, on the data of its files or on others.
template <class Analyse>
Analysis run_with(FitRequest request, const Progress& progress, const Analyse& analyse) {
  request.options.profile_points = kProfilePoints;
  constexpr double kAll = 0.9;  // share of the time taken by the fits of all runs together
  Analysis result = analyse(request, stretch(progress, 0, kAll));
  if (result.per_curve.empty() && result.data.has_loads && result.data.curves.size() > 1) {
    const std::vector<std::string>& models = request.models;
    result.per_curve.resize(models.size());
    std::atomic<std::size_t> done = 0;
    parallel_for(models.size(), [&](std::size_t i) {
      result.per_curve[i] = fit_per_curve(result.data, models[i], request.options);
      const double share = static_cast<double>(++done) / static_cast<double>(models.size());
      if (progress) progress(kAll + (1 - kAll) * share);
    });
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

}  // namespace

Analysis run_for_report(FitRequest request, const Progress& progress) {
  return run_with(std::move(request), progress,
                  [](const FitRequest& with, const Progress& part) { return run(with, part); });
}

Analysis run_for_report(FitRequest request, const Dataset& data, const Progress& progress) {
  return run_with(std::move(request), progress,
                  [&](const FitRequest& with, const Progress& part) { return run(with, data, part); });
}

ReportedData reported_data(const Analysis& result, const std::string& stem) {
  ReportedData data{result, stem, figured_models(result)};
  if (result.data.has_loads) {
    const auto known = std::find_if(result.fits.begin(), result.fits.end(), has_all_values);
    std::vector<double> values;
    if (known != result.fits.end()) {
      data.sahli_model = known->model;
      const auto p =
          fitted_candidate(result.data, model_of(result.data, *known), *known, result.request.options).parameters;
      values.assign(p.begin(), p.end());
    }
    data.sahli = fit_sahli(result.data, kParabolaUpTo, data.sahli_model, values);
  }
  if (!result.request.peaks_path.empty()) data.peaks = load_peak_forces(result.request.peaks_path);
  if (data.peaks) data.predicted_peaks = predict_peaks(result, *data.peaks);
  data.answer = answer_of(result);
  return data;
}

std::vector<ReportedData> reported_data(std::vector<Analysis>& results) {
  const auto rank = [](const Analysis& one) {
    return std::pair(one.data.metadata.provenance == Provenance::reconstructed, !one.data.has_loads);
  };
  std::stable_sort(results.begin(), results.end(),
                   [&](const Analysis& one, const Analysis& other) { return rank(one) < rank(other); });
  make_names_unique(results);
  std::vector<ReportedData> data;
  data.reserve(results.size());
  std::set<std::string> taken;
  for (const Analysis& result : results) data.push_back(reported_data(result, file_stem(result, taken)));
  return data;
}

}  // namespace mixity
