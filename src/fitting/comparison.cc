#include "fitting/comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/threads.h"
#include "fitting/common_constants.h"
#include "fitting/predicted_area.h"
#include "fitting/prepare.h"
#include "statistics/distributions.h"

namespace mixity {
namespace {

Information criteria(double sum_of_squares, std::size_t n, std::size_t parameters, bool known_errors) {
  const auto points = static_cast<double>(n), k = static_cast<double>(parameters + (known_errors ? 0 : 1));
  const double deviance = known_errors ? sum_of_squares : points * std::log(sum_of_squares / points);
  Information result{deviance + 2 * k, deviance + k * std::log(points), {}};
  if (points > k + 1) result.aicc = result.aic + 2 * k * (k + 1) / (points - k - 1);
  return result;
}

/// Sum of squared area errors at points of one run; adds those beyond the fold to `beyond`. Null where the law defines
/// no area.
std::optional<double> squared_area_errors(const Dataset& data, const std::vector<std::size_t>& run,
                                          const ContactModel& model, const Candidate& candidate, std::size_t& beyond) {
  const std::vector<PredictedArea> areas = predicted_areas(model, candidate, data, run);
  double sum = 0;
  for (std::size_t i = 0; i < run.size(); ++i) {
    if (areas[i].state == PredictedArea::State::undefined) return std::nullopt;
    beyond += areas[i].state == PredictedArea::State::beyond_fold;
    const double error = (areas[i].value - data.points[run[i]].A) * data.display.area_scale;
    sum += error * error;
  }
  return sum;
}

}  // namespace

std::vector<std::optional<double>> probabilities(const std::vector<FitResult>& fits) {
  std::size_t points = 0;
  for (const FitResult& one : fits) points = std::max(points, one.used.size());
  const auto comparable = [&](const FitResult& one) { return one.used.size() == points; };
  std::vector<std::optional<double>> found(fits.size());
  double highest = -std::numeric_limits<double>::infinity(), sum = 0;
  for (const FitResult& one : fits) {
    if (!comparable(one)) continue;
    if (!one.evidence) return found;
    highest = std::max(highest, one.evidence->evidence.log_evidence);
  }
  for (const FitResult& one : fits)
    if (comparable(one)) sum += std::exp(one.evidence->evidence.log_evidence - highest);
  for (std::size_t i = 0; i < fits.size(); ++i)
    if (comparable(fits[i])) found[i] = std::exp(fits[i].evidence->evidence.log_evidence - highest) / sum;
  return found;
}

std::optional<Information> information(const FitResult& fit) {
  if (!has_all_values(fit) || fit.residuals.empty() || !(fit.sum_of_squares > 0)) return std::nullopt;
  if (fit.loss_scale > 0 && !fit.known_errors) return std::nullopt;
  return criteria(fit.sum_of_squares, fit.used.size(), fit.free_parameters, fit.known_errors);
}

std::optional<Information> information_explained(const FitResult& fit) {
  if (!fit.explained || !(*fit.explained > 0)) return std::nullopt;
  return criteria(*fit.explained, fit.used.size(), fit.free_parameters + 1, fit.known_errors);
}

std::optional<LeftOut> leave_one_load_out(const Dataset& data, const FitResult& whole, const FitOptions& options) {
  constexpr std::size_t kMostRuns = 200;
  if (!data.has_loads || data.curves.size() < 2 || data.curves.size() > kMostRuns || !has_all_values(whole))
    return std::nullopt;
  const ContactModel model = model_of(whole);
  std::vector<std::vector<std::size_t>> runs = points_by_curve(data);
  std::erase_if(runs, [](const auto& run) { return run.empty(); });
  std::vector<std::optional<LeftOut::Run>> left_out(runs.size());
  std::vector<double> squares(runs.size());
  parallel_for(runs.size(), [&](std::size_t r) {
    if (options.progress) options.progress(static_cast<double>(r) / static_cast<double>(runs.size()));
    const std::size_t curve = data.points[runs[r].front()].curve;
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < data.points.size(); ++i)
      if (data.points[i].curve != curve) others.push_back(i);
    const FitResult without = refit_model(data, whole, options, others);
    if (!has_all_values(without) || without.status == FitStatus::not_converged) return;
    LeftOut::Run run{data.curves[curve], data.curve_loads[curve], 0, runs[r].size(), 0};
    const auto sum =
        squared_area_errors(data, runs[r], model, fitted_candidate(data, model, without, options), run.beyond_fold);
    if (!sum) return;
    squares[r] = *sum;
    run.rmse_area = std::sqrt(*sum / static_cast<double>(run.points));
    left_out[r] = std::move(run);
  });
  LeftOut result{0, 0, {}};
  std::size_t predicted = 0;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (!left_out[r]) return std::nullopt;
    result.rmse_area += squares[r];
    result.beyond_fold += left_out[r]->beyond_fold;
    predicted += runs[r].size();
    result.runs.push_back(std::move(*left_out[r]));
  }
  if (predicted == 0) return std::nullopt;
  result.rmse_area = std::sqrt(result.rmse_area / static_cast<double>(predicted));
  return result;
}

std::vector<ComparedModel> compare_models(const Dataset& data, const std::vector<FitResult>& fits,
                                          const FitOptions& options) {
  std::vector<ComparedModel> compared;
  std::size_t most = 0;
  for (const FitResult& one : fits) most = std::max(most, one.used.size());
  double lowest = std::numeric_limits<double>::infinity();
  const auto models = static_cast<double>(fits.size());
  FitOptions of_one = options;
  for (const FitResult& one : fits) {
    const auto before = static_cast<double>(compared.size());
    of_one.progress = stretch(options.progress, before / models, (before + 1) / models);
    ComparedModel entry{one.model, {}, {}, {}, leave_one_load_out(data, one, of_one)};
    const auto criteria_of_fit = one.used.size() == most ? information(one) : std::nullopt;
    if (criteria_of_fit) {
      entry.aicc = criteria_of_fit->aicc;
      entry.bic = criteria_of_fit->bic;
    }
    if (entry.aicc) lowest = std::min(lowest, *entry.aicc);
    compared.push_back(entry);
  }
  double sum = 0;
  for (const ComparedModel& entry : compared)
    if (entry.aicc) sum += std::exp(0.5 * (lowest - *entry.aicc));
  for (ComparedModel& entry : compared)
    if (entry.aicc) entry.weight = std::exp(0.5 * (lowest - *entry.aicc)) / sum;
  const auto probable = probabilities(fits);
  for (std::size_t i = 0; i < fits.size(); ++i) compared[i].probability = probable[i];
  return compared;
}

bool Preferences::agree() const {
  std::string preferred;
  for (const std::string& one : {aicc, evidence, left_out}) {
    if (one.empty()) continue;
    if (preferred.empty()) preferred = one;
    if (one != preferred) return false;
  }
  return true;
}

Preferences preferences(const std::vector<ComparedModel>& compared) {
  // the model that a number is largest of; empty unless two models have it
  const auto largest = [&](auto number_of) {
    const ComparedModel* best = nullptr;
    std::size_t known = 0;
    for (const ComparedModel& one : compared) {
      const std::optional<double> number = number_of(one);
      known += number.has_value();
      if (number && (!best || *number > *number_of(*best))) best = &one;
    }
    return known > 1 ? best->model : std::string();
  };
  return {largest([](const ComparedModel& one) { return one.weight; }),
          largest([](const ComparedModel& one) { return one.probability; }), largest([](const ComparedModel& one) {
            return one.left_out ? std::optional(-one.left_out->rmse_area) : std::nullopt;
          })};
}

namespace {

/// Whether runs share constants that are fitted. Of energies each series has a toughness of its own.
bool share_constants(const Dataset& data, const FitOptions& options) {
  return !data.has_energies && !fitted_constants(data, options).empty();
}

bool has_minimum(const FitResult& fit) { return has_all_values(fit) && fit.status != FitStatus::not_converged; }

/// One set of parameters for all of `fits` against one for each.
void test_runs(const FitResult& pooled, double separate, std::size_t parameters, std::size_t n, PerCurve& result) {
  if (!has_minimum(pooled)) {
    result.untested = "no one value for all runs was found";
  } else if (parameters == pooled.free_parameters) {
    result.untested = "every parameter is held";
  } else if (!(separate > 0)) {
    result.untested = "the runs have no scatter";
  } else {
    const bool known = pooled.known_errors;
    const double freedom = static_cast<double>(parameters - pooled.free_parameters);
    const double rest = static_cast<double>(n - parameters), gain = std::max(pooled.sum_of_squares - separate, 0.0);
    PerCurve::Test test{known, 0, freedom, rest, 0, {}, {}};
    if (known) {
      test.statistic = gain;
      test.p_value = chi_squared_p_value(gain, freedom);
    } else {
      test.statistic = gain / freedom / (separate / rest);
      test.p_value = fisher_p_value(test.statistic, freedom, rest);
    }
    test.aicc_pooled = criteria(pooled.sum_of_squares, n, pooled.free_parameters, known).aicc;
    test.aicc_separate = criteria(separate, n, parameters, known).aicc;
    result.test = test;
  }
}

/// The errors of a run's own parameters hold those of the constants that it shares.
void take_errors(const std::vector<FittedParameter>& own, FitResult& fit) {
  for (const FittedParameter& joint : own)
    for (FittedParameter& one : fit.parameters) {
      if (one.name != joint.name) continue;
      one.stderr_ = joint.stderr_;
      one.interval = joint.interval;
    }
}

}  // namespace

PerCurve fit_per_curve(const Dataset& data, std::string_view model, const FitOptions& options) {
  PerCurve result;
  result.model = model;
  FitOptions own = value_only(options);
  own.intervals = options.intervals;
  own.checks = options.checks;
  const bool shared = share_constants(data, options);
  if (shared) {
    const FitResult whole = fit_model(data, model, value_only(options));
    if (!has_minimum(whole)) {
      result.untested = "the constants that all runs share were not found";
      return result;
    }
    own.intervals = own.checks = false;  // of all runs together
    own.free.clear();
    own.constants = with_fitted(options.constants.value_or(stated_constants(data)), data, whole.parameters);
  }
  std::vector<std::vector<std::size_t>> runs;  // that have points
  std::vector<std::size_t> tested;             // points of runs that have a value of their own
  std::vector<std::vector<std::size_t>> tested_runs;
  std::vector<FitResult> tested_fits;
  double separate = 0;
  std::size_t parameters = 0, n = 0;
  bool known = false;
  const auto by_curve = points_by_curve(data);
  for (std::size_t c = 0; c < by_curve.size(); ++c) {
    if (by_curve[c].empty()) continue;
    if (options.progress) options.progress(static_cast<double>(c) / static_cast<double>(by_curve.size()));
    CurveFit one{data.curves[c], data.has_loads ? data.curve_loads[c] : 0.0, fit_model(data, model, own, &by_curve[c])};
    runs.push_back(by_curve[c]);
    if (has_minimum(one.fit)) {
      ++result.fitted;
      separate += one.fit.sum_of_squares;
      parameters += one.fit.free_parameters;
      n += one.fit.used.size();
      known = one.fit.known_errors;
      tested.insert(tested.end(), by_curve[c].begin(), by_curve[c].end());
      tested_runs.push_back(by_curve[c]);
      tested_fits.push_back(one.fit);
    }
    result.curves.push_back(std::move(one));
  }
  const auto untested = [&](const char* reason) {
    result.untested = reason;
    return result;
  };
  if (result.fitted < 2) return untested("fewer than two runs have a value of their own");
  if (n <= parameters) return untested("too few points");
  if (options.loss != Loss::none && !known)
    return untested("a robust loss in units of the scatter is another cost for each run");
  FitOptions of_all = own;
  if (shared) {
    const auto joint = fit_common_constants(data, model, options, *own.constants, tested_runs, tested_fits);
    if (!joint) return untested("the constants that all runs share were not found");
    own.constants = joint->constants;
    for (std::size_t c = 0, next = 0; c < runs.size(); ++c) {
      FitResult& fit = result.curves[c].fit;
      const bool is_tested = has_minimum(fit);
      fit = fit_model(data, model, own, &runs[c]);
      if (is_tested) take_errors(joint->own[next++], fit);
    }
    separate = joint->sum_of_squares;
    parameters = joint->free_parameters;
    of_all = options;
  }
  test_runs(fit_model(data, model, value_only(of_all), &tested), separate, parameters, n, result);
  return result;
}

}  // namespace mixity
