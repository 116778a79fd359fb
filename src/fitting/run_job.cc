// A whole job, model after model.
#include "fitting/fit_definition.h"

namespace mixity {

JobResult run(const FitJob& job, const Overrides& overrides, const Progress& progress) {
  const PointUse use = job.options.objective == Objective::toughness ? PointUse::toughness : PointUse::areas;
  JobResult result{job, load_dataset(job.data_path, overrides, use), {}, {}, {}};
  // the comparison refits without each run, which takes about as long as the fits; so do fits of single runs
  const double steps = static_cast<double>(job.models.size() * (job.per_curve ? 3 : 2));
  double done = 0;
  const auto advance = [&](double by) {
    done += by;
    if (progress) progress(done / steps);
  };
  for (const std::string& model : job.models) {
    result.fits.push_back(fit_model(result.data, model, job.options));
    advance(1);
  }
  if (job.compare && job.models.size() > 1) result.comparison = compare_models(result.data, result.fits, job.options);
  advance(static_cast<double>(job.models.size()));
  if (job.per_curve)
    for (const std::string& model : job.models) {
      result.per_curve.push_back(fit_per_curve(result.data, model, job.options));
      advance(1);
    }
  return result;
}

}  // namespace mixity
