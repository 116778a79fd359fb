#include "fitting/fit.h"

#include <algorithm>

#include "fitting/fitted_parameters.h"
#include "fitting/goodness.h"
#include "fitting/prepared_fit.h"
#include "fitting/robust_scale.h"
#include "fitting/starts.h"
#include "fitting/trial_areas.h"

namespace mixity {
namespace {

template <class Model>
AreaGoodness predict_areas(const Dataset& data, const std::vector<std::size_t>& used, const Trial<Model>& trial) {
  TrialAreas<Model> predicted(trial);
  AreaGoodness area;
  area.obstacle = LoadedContact<Model>(trial.parameters, 0).obstacle();
  std::vector<double> residuals, targets;
  for (const std::size_t i : used) {
    const Point& point = data.points[i];
    const TrialArea at_point = predicted.at(point.P, point.T);
    if (at_point.place != TrialArea::Place::equilibrium) {
      ++area.unpredicted;
      area.areas.emplace_back();
      continue;
    }
    const double A = at_point.value;
    area.areas.emplace_back(A);
    residuals.push_back((A - point.A) * data.display.area_scale);
    targets.push_back(point.A * data.display.area_scale);
  }
  area.predicted = targets.size();
  if (targets.empty()) return area;
  const Goodness fit = goodness(residuals, targets);
  area.r2 = fit.r2;
  area.rmse = fit.rmse;
  area.max_abs_residual = fit.max_abs_residual;
  return area;
}

/// 1/standard error of ln f (or f) minus the model's at the point's psi: through f and psi at once, from sigma_A and
/// sigma_T, or from the file's sigma_Gc.
template <class Model>
std::vector<double> toughness_weights(const Dataset& data, const FitOptions& options,
                                      const PreparedFit<Model>& prepared, const Parameters<Model>& p) {
  std::vector<double> weights;
  if (!data.has_loads && data.errors.empty())
    throw InputError(data.path, "needs a column sigma_Gc to weigh its points by");
  for (const std::size_t i : prepared.used) {
    const Point& point = data.points[i];
    const double ratio = data.toughness(i)->ratio;
    double error = data.errors_of(i).ratio / ratio;
    if (data.has_loads) {
      const double sigma_T = prepared.errors->T[i], sigma_A = prepared.errors->A[i];
      const auto r = ToughnessResiduals<Model>(p, point.P, 0)({point.P, point.T, point.A, sigma_T, sigma_A});
      double by_T = r->T, by_A = r->A;  // of ln f_model - ln f
      if (options.scale == Scale::linear) {
        // d(f_model - f) = f_model d(ln f_model - ln f) + (f_model - f) d(ln f), here over f
        const double a = radius_from_area(point.A), y = edge_load(a, point.P), y_A = 2 * a / pi<double>();
        const double square = y * y + point.T * point.T, growth = std::expm1(r->value);
        by_T = (1 + growth) * by_T + growth * 2 * point.T / square;
        by_A = (1 + growth) * by_A + growth * y_A * (2 * y / square - 1 / (y + point.P));
      }
      error = std::hypot(by_T * sigma_T, by_A * sigma_A);
    }
    if (!(error > 0))
      throw InputError(data.path, place_of(data, point, "sigma_Gc"),
                       "this point has no standard error (sigma_Gc is 0 or empty)");
    weights.push_back(1 / (options.scale == Scale::log ? error : error * ratio));
  }
  return weights;
}

/// How many points differ from each other, counted up to `enough`: rows that repeat one know nothing of its error.
std::size_t distinct_points(const Dataset& data, const std::vector<std::size_t>& used, std::size_t enough) {
  std::vector<std::size_t> distinct;
  const auto same = [&](std::size_t one, std::size_t other) {
    const Point &p = data.points[one], &q = data.points[other];
    if (data.has_loads) return p.P == q.P && p.T == q.T && p.A == q.A;
    const ToughnessPoint &f = data.converted[one], &g = data.converted[other];
    return f.mixity.sin == g.mixity.sin && f.mixity.cos == g.mixity.cos && f.ratio == g.ratio;
  };
  for (const std::size_t i : used) {
    if (distinct.size() == enough) break;
    if (std::none_of(distinct.begin(), distinct.end(), [&](std::size_t known) { return same(i, known); }))
      distinct.push_back(i);
  }
  return distinct.size();
}

template <class Model>
class Fitter {
 public:
  Fitter(const Dataset& data, const FitOptions& options, const std::vector<std::size_t>* points)
      : data_(data), options_(options), prepared_(prepare<Model>(data, options, points)) {}

  FitResult run() {
    describe();
    if (!options_.free.empty()) prepared_.start = jkr_start<Model>(data_, options_, prepared_);
    problem_ = make_problem<Model>(data_, options_, prepared_);
    const std::size_t p = problem_->parameters().size();
    if (const std::size_t distinct = distinct_points(data_, prepared_.used, p + 1); p > 0 && distinct <= p) {
      result_.status = FitStatus::not_identifiable;
      result_.message = too_few_points(distinct, prepared_.used.size(), p);
      return result_;
    }
    if (p > 0 && options_.objective != Objective::toughness && options_.near.empty())
      guesses_ = toughness_guesses<Model>(data_, options_, prepared_.used, p);
    std::vector<double> x;
    if (p == 0) {
      result_.status = FitStatus::ok;
      result_.message = "every parameter is held: nothing was fitted";
    } else {
      Verdict verdict;
      const FitResult described = result_;
      // An interval may come upon a lower place, from which to start again.
      for (int again = 0;; ++again) {
        result_ = described;
        verdict = find_minimum();
        result_.status = verdict.status;
        result_.message = verdict.message;
        if (!result_.has_values() || verdict.best.x.empty()) return result_;
        x = verdict.best.x;
        const std::vector<double> deeper = tell_parameters(cost(), verdict, options_, result_);
        if (deeper.empty() || again == kMostRestarts) break;
        guesses_.push_back(deeper);
      }
      tell_resampled(cost(), verdict, data_, options_, result_);
    }
    judge(x);
    return result_;
  }

 private:
  void describe() {
    result_.model = Model::info.key;
    result_.model_name = Model::info.name;
    result_.formula = Model::info.formula;
    result_.objective = options_.objective;
    result_.scale = options_.scale;
    result_.used = prepared_.used;
    result_.excluded = prepared_.excluded;
    result_.errors = prepared_.errors;
    for (std::size_t k = 0; k < prepared_.base.size(); ++k) {
      const ParameterInfo& info = Model::parameters[k];
      result_.parameters.push_back({std::string(info.name), {}, {}, info.lower, info.upper});
      result_.parameters[k].held = prepared_.held[k];
      if (prepared_.held[k]) result_.parameters[k].value = prepared_.base[k];
    }
    const FreeChoice<Model> choice = free_choice(data_, options_, prepared_);
    for (const FreeParameter& parameter : choice.parameters())
      if (parameter.start) {
        result_.parameters.push_back(
            {parameter.name, {}, {}, parameter.shown(parameter.lower), parameter.shown(parameter.upper)});
        result_.parameters.back().unit = parameter.unit;
      }
  }

  Verdict find_minimum() {
    robust_.reset();  // of the problem before
    Verdict verdict = minimise(*problem_, options_.near, guesses_);
    if (options_.objective == Objective::toughness && options_.weighted) {
      // The standard errors depend on the model: until they no longer change.
      double change = 0;
      for (int i = 0; i < 50; ++i) {
        const std::vector<double> before = verdict.best.x;
        const Parameters<Model> at = before.empty() ? prepared_.base : problem_->trial(before).parameters;
        problem_ =
            make_problem<Model>(data_, options_, prepared_, toughness_weights<Model>(data_, options_, prepared_, at));
        verdict = minimise(*problem_, options_.near, guesses_);
        if (verdict.best.x.empty()) break;
        if (before.empty()) continue;
        change = 0;
        for (std::size_t k = 0; k < before.size(); ++k)
          change = std::max(change, std::abs(verdict.best.x[k] - before[k]) / std::max(std::abs(before[k]), 1e-300));
        if (change <= 1e-12) break;
      }
      if (change > 1e-8 && (verdict.status == FitStatus::ok || verdict.status == FitStatus::multimodal)) {
        verdict.status = FitStatus::not_converged;
        verdict.message = "the weights, which depend on the parameters, did not settle";
        return verdict;
      }
    }
    if (options_.loss == Loss::none) return verdict;
    const double scale = options_.loss_scale.value_or(usual_scale(options_.loss));
    const bool known = problem_->known_errors();
    std::vector<double> x = verdict.best.x;
    if (x.empty() && !known) x = place_of_least_spread(*problem_);
    for (int i = 0; i < (known ? 1 : 3) && (known || !x.empty()); ++i) {
      const double unit = known ? 1.0 : spread(*problem_, x);
      if (!(unit > 0)) return verdict;  // no residuals to speak of
      result_.loss_scale = scale * unit;
      robust_.emplace(*problem_, options_.loss, result_.loss_scale);
      verdict = minimise(*robust_, options_.near, guesses_);
      x = verdict.best.x;
    }
    return verdict;
  }

  const LeastSquares& cost() const {
    if (robust_) return *robust_;
    return *problem_;
  }

  /// Goodness of fit in the fitted space and of the predicted areas.
  void judge(const std::vector<double>& x) {
    result_.residuals.resize(problem_->residual_count());
    if (result_.residuals.empty() || !problem_->evaluate(x, result_.residuals, {})) {
      result_.residuals.clear();
      result_.status = FitStatus::not_converged;
      result_.message = "the model is not finite at the used points";
      return;
    }
    const Goodness fit = goodness(result_.residuals, problem_->targets(), problem_->weights());
    result_.r2 = fit.r2;
    result_.rmse = fit.rmse;
    result_.max_abs_residual = fit.max_abs_residual;
    if (data_.has_loads) result_.area = predict_areas<Model>(data_, result_.used, problem_->trial(x));
  }

  static constexpr int kMostRestarts = 3;
  const Dataset& data_;
  const FitOptions& options_;
  PreparedFit<Model> prepared_;
  std::vector<std::vector<double>> guesses_;  // of the free parameters, beside those of the scan
  std::unique_ptr<ModelProblem<Model>> problem_;
  std::optional<RobustProblem> robust_;
  FitResult result_;
};

}  // namespace

FitOptions value_only(FitOptions options) {
  options.intervals = false;
  options.bootstrap = {};
  options.influence = false;
  options.profile_points = 0;
  options.progress = {};
  return options;
}

FitResult fit_model(const Dataset& data, std::string_view model, const FitOptions& options,
                    const std::vector<std::size_t>* points) {
  FitResult result;
  with_model(model, [&](auto chosen) { result = Fitter<decltype(chosen)>(data, options, points).run(); });
  return result;
}

}  // namespace mixity
