#include "analysis/run.h"

#include <algorithm>
#include <limits>

#include "analysis/contact_shape.h"
#include "analysis/judgement.h"
#include "analysis/meter.h"
#include "base/threads.h"
#include "fitting/causes.h"
#include "fitting/comparison.h"
#include "fitting/consistency.h"

namespace mixity {
namespace {

/// Cost of the parts of a request, in refits: each model's fit, the comparison, each model's fits of single runs.
std::vector<double> costs(const FitRequest& request, const Dataset& data) {
  const auto models = static_cast<double>(request.models.size()), runs = static_cast<double>(data.curves.size());
  constexpr double kFit = 10;  // search for the minimum, and intervals
  const FitOptions& options = request.options;
  const double drawn = static_cast<double>(options.profile_points * (1 + options.free.size()));
  const double resampled = static_cast<double>(options.bootstrap.replicates) +
                           (options.influence ? static_cast<double>(data.points.size()) + runs : 0);
  std::vector<double> list(request.models.size(), kFit + drawn + resampled);
  list.push_back(request.compare ? models * runs : 0);
  list.resize(list.size() + (request.per_curve ? request.models.size() : 0), kFit);
  return list;
}

}  // namespace

Analysis run(const FitRequest& request, const Progress& progress) {
  return run(request,
             request.runs.empty() ? load_dataset(request.data_path, request.constants)
                                  : load_pooled(request.runs, request.constants),
             progress);
}

/// The options, with the free constants that drift and unsheared add.
FitOptions options_of(const FitRequest& request) {
  FitOptions options = request.options;
  const auto add = [&](Constant c) {
    if (std::find(options.free.begin(), options.free.end(), c) == options.free.end()) options.free.push_back(c);
  };
  for (const Constant c : request.drift) add(c == kModulus ? kModulusDrift : kToughnessDrift);
  if (request.exclusion.unsheared == Unsheared::own) add(kHysteresis);
  if (request.tied) options.hold.push_back(*request.tied);
  return options;
}

/// The options, with the errors of the points from the fit with the smallest AICc.
FitOptions with_errors_of_best(const Analysis& result) {
  FitOptions options = options_of(result.request);
  double least = std::numeric_limits<double>::infinity();
  for (const FitResult& fit : result.fits) {
    const auto criteria = fit.errors && fit.objective == Objective::curve ? information(fit) : std::nullopt;
    if (!criteria || !(criteria->aic < least)) continue;
    least = criteria->aic;
    options.errors = fit.errors;
  }
  return options;
}

Analysis run(const FitRequest& asked, Dataset data, const Progress& progress) {
  Analysis result{asked, std::move(data), {}, {}, {}};
  take_shape(result.request);
  FitRequest request = result.request;
  request.options = options_of(asked);
  exclude(result.data, request.exclusion);
  const std::size_t models = request.models.size();
  Meter meter(progress, costs(request, result.data));
  const auto part = [&](std::size_t i, const auto& body) {
    FitOptions options = request.options;
    options.progress = meter.part(i);
    body(options);
    if (options.progress) options.progress(1);
  };
  result.fits.resize(models);
  parallel_for(models, [&](std::size_t i) {
    part(i, [&](const FitOptions& options) { result.fits[i] = fit_and_test(result.data, request.models[i], options); });
  });
  for (FitResult& fit : result.fits)
    if (!request.options.checks)
      fit.message += (fit.message.empty() ? "" : "; ") + std::string("not checked for consistency (checks=false)");
  part(models, [&](const FitOptions& options) {
    if (request.compare && models > 1) result.comparison = compare_models(result.data, result.fits, options);
  });
  // Searching for the cause of a failed test costs more than the fit. The search is shorter if another model has won.
  std::optional<double> to_beat;
  if (const ComparedModel* const best = winner(result))
    for (const FitResult& fit : result.fits)
      if (fit.model == best->model) to_beat = misfit(fit);
  parallel_for(models, [&](std::size_t i) {
    find_cause(result.data, result.fits[i], request.options, to_beat);
    part(i, [](const FitOptions&) {});  // lets the callback stop the analysis
  });
  if (request.options.checks) result.unsheared = test_unsheared(result.data, with_errors_of_best(result));
  reject_for_unsheared_areas(result, request.options);
  name_misfit_of_units(result);
  reject_for_better_model(result);
  if (request.per_curve) {
    result.per_curve.resize(models);
    parallel_for(models, [&](std::size_t i) {
      part(models + 1 + i, [&](const FitOptions& options) {
        result.per_curve[i] = fit_per_curve(result.data, request.models[i], options);
      });
    });
  }
  return result;
}

std::vector<std::string> files_read(const Analysis& analysis) {
  const FitRequest& request = analysis.request;
  std::vector<std::string> files{request.data_path, metadata_path(request.data_path)};
  for (const RunFile& run : request.runs) files.insert(files.end(), {run.path, metadata_path(run.path)});
  if (!request.peaks_path.empty()) files.insert(files.end(), {request.peaks_path, metadata_path(request.peaks_path)});
  files.insert(files.end(), request.log_figures.begin(), request.log_figures.end());
  for (const std::string& one : {request.path, analysis.data.metadata.headings})
    if (!one.empty()) files.push_back(one);
  return files;
}

}  // namespace mixity
