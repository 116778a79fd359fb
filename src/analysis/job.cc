#include "analysis/job.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>

#include "base/number_text.h"
#include "base/side_by_side.h"
#include "fitting/consistency.h"

namespace mixity {

std::vector<std::string> files_read(const FitJob& job) {
  std::vector<std::string> files{job.data_path, metadata_path(job.data_path)};
  for (const RunFile& run : job.runs) files.insert(files.end(), {run.path, metadata_path(run.path)});
  if (!job.peaks_path.empty()) files.insert(files.end(), {job.peaks_path, metadata_path(job.peaks_path)});
  files.insert(files.end(), job.log_figures.begin(), job.log_figures.end());
  if (!job.path.empty()) files.push_back(job.path);
  return files;
}

std::vector<Agreement> compare(const FitResult& fit, const FitJob& job) {
  std::vector<Agreement> agreements;
  const auto published = job.published.find(fit.model);
  if (published == job.published.end()) return agreements;
  for (const Published& number : published->second) {
    std::optional<double> found;
    if (number.name == "r2") found = fit.r2;
    for (const FittedParameter& parameter : fit.parameters)
      if (parameter.name == number.name) found = parameter.value;
    agreements.push_back({number, found && std::abs(*found - number.value) <= number.tolerance});
  }
  return agreements;
}

namespace {

/// How far a job is, put together from parts that run side by side and may start again.
class Meter {
 public:
  Meter(const Progress& progress, std::vector<double> costs)
      : progress_(progress), costs_(std::move(costs)), done_(costs_.size()) {
    for (const double cost : costs_) whole_ += cost;
  }

  /// Null if nobody is told.
  Progress part(std::size_t i) {
    if (!progress_) return {};
    return [this, i](double fraction) {
      const std::lock_guard lock(mutex_);
      done_[i] = std::max(done_[i], fraction);
      progress_(std::inner_product(done_.begin(), done_.end(), costs_.begin(), 0.0) / whole_);
    };
  }

 private:
  const Progress& progress_;
  std::vector<double> costs_, done_;
  double whole_ = 0;
  std::mutex mutex_;
};

/// What the parts of a job cost, in refits: each model's fit, the comparison, each model's fits of single runs.
std::vector<double> costs(const FitJob& job, const Dataset& data) {
  const auto models = static_cast<double>(job.models.size()), runs = static_cast<double>(data.curves.size());
  constexpr double kFit = 10;  // the search for the minimum and the intervals
  const FitOptions& options = job.options;
  const double drawn = static_cast<double>(options.profile_points * (1 + options.free.size()));
  const double resampled = static_cast<double>(options.bootstrap.replicates) +
                           (options.influence ? static_cast<double>(data.points.size()) + runs : 0);
  std::vector<double> list(job.models.size(), kFit + drawn + resampled);
  list.push_back(job.compare ? models * runs : 0);
  list.resize(list.size() + (job.per_curve ? job.models.size() : 0), kFit);
  return list;
}

/// Areas without shear know nothing of the model: where they contradict the constants that fits take as stated, none of
/// these can be believed.
void tell_unsheared(JobResult& result) {
  constexpr double kHardly = 3e-4;  // one more test must not make false alarms more than one in a hundred
  if (!result.unsheared || !(result.unsheared->p_value < kHardly) || !result.job.options.free.empty()) return;
  if (objective_of(result) != Objective::curve || result.job.options.loss != Loss::none) return;
  for (FitResult& fit : result.fits)
    if (fit.status == FitStatus::ok) {
      fit.status = FitStatus::suspect;
      fit.message += (fit.message.empty() ? "" : "; ") +
                     std::string(
                         "the areas without shear do not agree with JKR and the constants as stated: check modulus, "
                         "toughness and the zeros of load and area, or state their standard errors");
    }
}

constexpr double kNearlyCertain = 0.999;  // an AICc weight

/// The fit that can be believed and leaves all others far behind by every criterion; null if there is none.
const ComparedModel* winner(const JobResult& result) {
  if (!preferences(result.comparison).agree()) return nullptr;
  for (const ComparedModel& one : result.comparison) {
    const auto fit = std::find_if(result.fits.begin(), result.fits.end(),
                                  [&](const FitResult& other) { return other.model == one.model; });
    if (one.weight.value_or(0) > kNearlyCertain && fit->status == FitStatus::ok) return &one;
  }
  return nullptr;
}

/// A fit that cannot be believed because another model is right says so, and so does one that passes its tests and is
/// left far behind. Not where a constant that is wrong would explain the points as well.
void tell_outdone(JobResult& result) {
  constexpr double kNearlyNone = 1e-6;  // AICc weight
  constexpr double kMuchBetter = 10;    // in AICc
  const ComparedModel* const best = winner(result);
  if (!best) return;
  for (FitResult& other : result.fits) {
    if (other.model == best->model) continue;
    const auto own = std::find_if(result.comparison.begin(), result.comparison.end(),
                                  [&](const ComparedModel& one) { return one.model == other.model; });
    const bool left_behind = other.status == FitStatus::ok && own->weight.value_or(1) < kNearlyNone;
    if (other.status != FitStatus::suspect && !left_behind) continue;
    const auto explained = information_explained(other);
    if (explained && explained->aicc && best->aicc && *explained->aicc < *best->aicc + kMuchBetter) {
      other.message += "; model " + best->model + " would explain the points as well";
      continue;
    }
    other.status = FitStatus::suspect;
    other.outdone_by = best->model;
    other.message = "model " + best->model + " describes these points far better (AICc weight above " +
                    shortest(kNearlyCertain) + ")";
  }
}

}  // namespace

std::vector<std::size_t> by_merit(const JobResult& result) {
  constexpr double kClose = 9.2;  // in AICc: a hundredth of the weight
  constexpr double kWorst = std::numeric_limits<double>::max();
  std::vector<double> above;  // AICc, of which weights far down are no more than 0
  double least = kWorst;
  for (const FitResult& fit : result.fits) {
    const auto entry = std::find_if(result.comparison.begin(), result.comparison.end(),
                                    [&](const ComparedModel& one) { return one.model == fit.model; });
    const double known = entry == result.comparison.end() ? 0 : entry->aicc.value_or(kWorst / 2);
    above.push_back(has_all_values(fit) ? known : kWorst);
    least = std::min(least, above.back());
  }
  std::vector<std::size_t> order(result.fits.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto doubted = [&](std::size_t i) {  // among those that are close
    return above[i] > least + kClose ? 2 : result.fits[i].status != FitStatus::ok ? 1 : 0;
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return doubted(i) != doubted(j) ? doubted(i) < doubted(j) : above[i] < above[j];
  });
  return order;
}

std::string no_best_model(const JobResult& result) {
  const Preferences preferred = preferences(result.comparison);
  for (const FitResult& fit : result.fits) {
    const bool named =
        fit.model == preferred.aicc || fit.model == preferred.evidence || fit.model == preferred.left_out;
    if (named && fit.status == FitStatus::suspect && fit.outdone_by.empty())
      return "the fit of " + fit.model + " is suspect, and no model is named best before that is mended";
  }
  if (preferred.agree()) return {};
  std::string text, separator = "the criteria disagree, and no model is named best: ";
  for (const auto& [criterion, model] :
       {std::pair("AICc prefers ", preferred.aicc), std::pair("the evidence ", preferred.evidence),
        std::pair("the loads left out ", preferred.left_out)}) {
    if (model.empty()) continue;
    text += separator + criterion + model;
    separator = ", ";
  }
  return text;
}

bool can_be_believed(const JobResult& result) {
  return std::all_of(result.fits.begin(), result.fits.end(),
                     [](const FitResult& fit) { return fit.status == FitStatus::ok || !fit.outdone_by.empty(); });
}

JobResult run(const FitJob& job, const Progress& progress) {
  return run(job, job.runs.empty() ? load_dataset(job.data_path, job.constants) : load_pooled(job.runs, job.constants),
             progress);
}

JobResult run(const FitJob& job, Dataset data, const Progress& progress) {
  JobResult result{job, std::move(data), {}, {}, {}};
  exclude(result.data, job.exclusion);
  const std::size_t models = job.models.size();
  Meter meter(progress, costs(job, result.data));
  // calls body(options), which tell of this part of the job.
  const auto part = [&](std::size_t i, const auto& body) {
    FitOptions options = job.options;
    options.progress = meter.part(i);
    body(options);
    if (options.progress) options.progress(1);
  };
  const auto for_each_of_the_models = [&](const auto& body) {
    std::atomic<std::size_t> next = 0;
    side_by_side(std::min(models, processors()), [&] {
      for (std::size_t i; (i = next++) < models;) body(i);
    });
  };
  result.fits.resize(models);
  for_each_of_the_models([&](std::size_t i) {
    part(i, [&](const FitOptions& options) { result.fits[i] = fit_and_test(result.data, job.models[i], options); });
  });
  for (FitResult& fit : result.fits)
    if (!job.options.checks)
      fit.message += (fit.message.empty() ? "" : "; ") + std::string("not checked for consistency (checks=false)");
  part(models, [&](const FitOptions& options) {
    if (job.compare && models > 1) result.comparison = compare_models(result.data, result.fits, options);
  });
  // what explains a failed test costs more than the fit: of models that are left behind not more than is needed
  const bool decided = winner(result) != nullptr;
  for_each_of_the_models([&](std::size_t i) {
    find_cause(result.data, result.fits[i], job.options, decided);
    part(i, [](const FitOptions&) {});  // whoever watches may want to stop
  });
  if (job.options.checks) result.unsheared = test_unsheared(result.data, job.options);
  tell_unsheared(result);
  tell_outdone(result);
  if (job.per_curve) {
    result.per_curve.resize(models);
    for_each_of_the_models([&](std::size_t i) {
      part(models + 1 + i, [&](const FitOptions& options) {
        result.per_curve[i] = fit_per_curve(result.data, job.models[i], options);
      });
    });
  }
  return result;
}

}  // namespace mixity
