// A job: one data set, the models to fit to it and how, and what was published about them; and running it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "dataset/exclusion.h"
#include "dataset/pooled.h"
#include "fitting/comparison.h"
#include "fitting/fit.h"
#include "fitting/unsheared.h"

namespace mixity {

/// A published number of one model: a parameter, or "r2" (in the fitted space).
struct Published {
  std::string name;
  double value, tolerance;  // agreement means |found - value| <= tolerance, what the printed digits allow
};

struct FitJob {
  std::string path;                                // of its definition; empty: made of flags
  std::string data_path;                           // CSV, resolved against the definition's folder; the first of `runs`
  std::vector<RunFile> runs;                       // of a data set of several files; else empty
  std::string peaks_path;                          // CSV of peak forces, resolved likewise; empty: none
  std::vector<std::string> log_figures;            // SVG, likewise: of the log that the data were taken from
  std::vector<std::string> models{"a", "b", "c"};  // in the order to report
  FitOptions options;
  std::vector<std::string> free_parameters;  // of the models, said to be free: as all are that are not held
  Exclusion exclusion;
  Overrides constants;                 // of the experiment and its metadata, over those beside the data; each name once
  bool compare = true;                 // the models with each other: information criteria, error on loads left out
  bool per_curve = false;              // each loading run by itself, too
  std::vector<std::string> law_notes;  // what is to be said of the laws that the definition states
  std::map<std::string, std::vector<Published>> published;  // by model key
  std::string source;                                       // of the published numbers
  std::map<std::string, std::string> stated;                // options by name that are not left at their default
};

/// Every file that the job is made from, which no result may be written over: some may not be there.
std::vector<std::string> files_read(const FitJob& job);

struct Agreement {
  Published published;
  bool agrees;
};

/// Compares a fit with the published numbers of its model; a value that was not found does not agree.
std::vector<Agreement> compare(const FitResult& fit, const FitJob& job);

/// What a whole job yields.
struct JobResult {
  FitJob job;
  Dataset data;
  std::vector<FitResult> fits;
  std::vector<ComparedModel> comparison;     // empty with one model
  std::vector<PerCurve> per_curve;           // per model, if asked for
  std::optional<UnshearedTest> unsheared{};  // where there are areas without shear
};

/// Whether every fit can be believed, or is of a model that another one, which can, leaves far behind.
bool can_be_believed(const JobResult& result);

/// Why no model is named best: one that a criterion prefers is suspect, or they do not agree. Else empty.
std::string no_best_model(const JobResult& result);

/// Indices of the fits, the one that describes the data best first: of those whose AICc weight is at least a hundredth
/// of the largest one that can be believed, then by weight, those without a value last; by their order where nothing
/// tells them apart.
std::vector<std::size_t> by_merit(const JobResult& result);

/// What the job's fits are made with.
inline Objective objective_of(const JobResult& result) {
  return result.job.options.objective.value_or(default_objective(result.data));
}

/// Fits models side by side, on as many threads as the machine has. Tells `progress`, from any of them, how much is
/// done. Throws what load_dataset, exclude and fit_model throw.
JobResult run(const FitJob& job, const Progress& progress = {});
/// The same of a data set that is there already; the job's paths and constants are not used.
JobResult run(const FitJob& job, Dataset data, const Progress& progress = {});

}  // namespace mixity
