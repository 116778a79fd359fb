#include "fitting/comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/threads.h"
#include "fitting/predicted_area.h"

namespace mixity {
namespace {

/// Sum of squared area errors at the points of one run; adds the number beyond the fold to `beyond`. Null where the law
/// defines no area.
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

std::size_t most_points(const std::vector<FitResult>& fits) {
  std::size_t most = 0;
  for (const FitResult& one : fits) most = std::max(most, one.rows());
  return most;
}

/// Exponentials of these logarithms, normalised to the sum 1; null stays null.
std::vector<std::optional<double>> shares(std::vector<std::optional<double>> values) {
  double highest = -std::numeric_limits<double>::infinity(), sum = 0;
  for (const auto& one : values) highest = std::max(highest, one.value_or(highest));
  for (auto& one : values)
    if (one) {
      *one = std::exp(*one - highest);
      sum += *one;
    }
  for (auto& one : values)
    if (one) *one /= sum;
  return values;
}

/// Whether a model is not far behind all that have an evidence, by AICc.
bool may_win(const FitResult& fit, const std::vector<FitResult>& fits) {
  constexpr double kFarBehind = 20;  // in AICc: a weight of 5e-5
  const auto aicc = [](const FitResult& one) {
    const auto known = information(one);
    return known ? known->aicc : std::nullopt;
  };
  const auto own = aicc(fit);
  return own && std::all_of(fits.begin(), fits.end(), [&](const FitResult& one) {
           const auto others = one.evidence ? aicc(one) : std::nullopt;
           return !others || *own < *others + kFarBehind;
         });
}

}  // namespace

std::vector<std::optional<double>> probabilities(const std::vector<FitResult>& fits) {
  const std::size_t most = most_points(fits);
  std::vector<std::optional<double>> logarithms;
  for (const FitResult& one : fits) {
    const bool comparable = one.rows() == most && one.evidence;
    logarithms.push_back(comparable ? std::optional(one.evidence->evidence.log_evidence) : std::nullopt);
  }
  const auto known =
      std::count_if(logarithms.begin(), logarithms.end(), [](const auto& one) { return one.has_value(); });
  const bool lacks_a_rival = std::any_of(fits.begin(), fits.end(), [&](const FitResult& one) {
    return one.rows() == most && !one.evidence && may_win(one, fits);
  });
  if ((known < 2 && fits.size() > 1) || lacks_a_rival) return std::vector<std::optional<double>>(fits.size());
  return shares(std::move(logarithms));
}

std::vector<std::vector<std::size_t>> runs_with_points(const Dataset& data) {
  auto runs = points_by_curve(data);
  std::erase_if(runs, [](const auto& run) { return run.empty(); });
  return runs;
}

Information information(double sum_of_squares, std::size_t n, std::size_t parameters, bool known_errors) {
  const auto points = static_cast<double>(n), k = static_cast<double>(parameters + (known_errors ? 0 : 1));
  const double deviance = known_errors ? sum_of_squares : points * std::log(sum_of_squares / points);
  Information result{deviance + 2 * k, deviance + k * std::log(points), {}};
  if (points > k + 1) result.aicc = result.aic + 2 * k * (k + 1) / (points - k - 1);
  return result;
}

std::optional<Information> information(const FitResult& fit) {
  if (!has_all_values(fit) || fit.residuals.empty() || !(fit.sum_of_squares > 0)) return std::nullopt;
  // Each model has its own loss.
  if (fit.loss_scale > 0 && (!fit.known_errors || fit.loss_freedom > 0)) return std::nullopt;
  return information(comparable_squares(fit), fit.rows(), fit.free_parameters, fit.known_errors);
}

std::optional<Information> information_explained(const FitResult& fit) {
  if (!fit.explained) return std::nullopt;
  return information(*fit.explained, fit.rows(), fit.free_parameters + 1, fit.known_errors);
}

std::optional<LeftOut> leave_one_load_out(const Dataset& data, const FitResult& whole, const FitOptions& options) {
  constexpr std::size_t kMostRuns = 200;
  if (!data.has_loads || data.curves.size() < 2 || data.curves.size() > kMostRuns || !has_all_values(whole))
    return std::nullopt;
  const ContactModel model = model_of(data, whole);
  const auto runs = runs_with_points(data);
  std::vector<std::optional<LeftOut::Run>> left_out(runs.size());
  std::vector<double> squares(runs.size());
  parallel_for(runs.size(), [&](std::size_t r) {
    if (options.progress) options.progress(static_cast<double>(r) / static_cast<double>(runs.size()));
    const std::size_t curve = data.points[runs[r].front()].curve;
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < data.points.size(); ++i)
      if (data.points[i].curve != curve) others.push_back(i);
    const FitResult without = refit_model(data, whole, options, others);
    if (!has_minimum(without)) return;
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
  std::vector<std::optional<double>> logarithms;  // of Akaike weights
  const std::size_t most = most_points(fits);
  const auto models = static_cast<double>(fits.size());
  FitOptions of_one = options;
  for (const FitResult& one : fits) {
    const auto before = static_cast<double>(compared.size());
    of_one.progress = stretch(options.progress, before / models, (before + 1) / models);
    ComparedModel entry{one.model, {}, {}, {}, leave_one_load_out(data, one, of_one)};
    if (const auto criteria = one.rows() == most ? information(one) : std::nullopt) {
      entry.aicc = criteria->aicc;
      entry.bic = criteria->bic;
    }
    logarithms.push_back(entry.aicc ? std::optional(-0.5 * *entry.aicc) : std::nullopt);
    compared.push_back(std::move(entry));
  }
  const auto weights = shares(std::move(logarithms)), probable = probabilities(fits);
  for (std::size_t i = 0; i < fits.size(); ++i) {
    compared[i].weight = weights[i];
    compared[i].probability = probable[i];
  }
  return compared;
}

bool Preferences::agree() const {
  const auto lists = {&aicc, &evidence, &left_out};
  const auto in_all = [&](const std::string& model) {
    return std::all_of(lists.begin(), lists.end(), [&](const std::vector<std::string>* list) {
      return list->empty() || std::find(list->begin(), list->end(), model) != list->end();
    });
  };
  return std::all_of(lists.begin(), lists.end(), [&](const std::vector<std::string>* list) {
    return list->empty() || std::any_of(list->begin(), list->end(), in_all);
  });
}

Preferences preferences(const std::vector<ComparedModel>& compared) {
  constexpr double kTie = 1e-3;  // relative
  // the models with the largest number; none unless two models have one
  const auto largest = [&](auto number_of) {
    std::optional<double> best;
    std::size_t known = 0;
    for (const ComparedModel& one : compared) {
      const std::optional<double> number = number_of(one);
      known += number.has_value();
      if (number && (!best || *number > *best)) best = number;
    }
    std::vector<std::string> models;
    for (const ComparedModel& one : compared)
      if (const std::optional<double> number = number_of(one); known > 1 && number)
        if (*best - *number <= kTie * std::abs(*best)) models.push_back(one.model);
    return models;
  };
  return {largest([](const ComparedModel& one) { return one.weight; }),
          largest([](const ComparedModel& one) { return one.probability; }), largest([](const ComparedModel& one) {
            return one.left_out ? std::optional(-one.left_out->rmse_area) : std::nullopt;
          })};
}

}  // namespace mixity
