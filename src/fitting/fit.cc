#include "fitting/fit.h"

#include <algorithm>
#include <stdexcept>

#include "fitting/budget.h"
#include "fitting/consistency.h"
#include "fitting/fitted_parameters.h"
#include "fitting/predicted_area.h"
#include "fitting/prepare.h"
#include "fitting/toughness_weights.h"
#include "solver/evidence.h"
#include "solver/prior.h"
#include "solver/robust.h"
#include "solver/solve.h"
#include "solver/verdict.h"

namespace mixity {
namespace {

/// How many points differ from each other, counted up to `enough`: rows that repeat one know nothing of its error.
std::size_t distinct_points(const Dataset& data, const std::vector<std::size_t>& used, std::size_t enough) {
  std::vector<std::size_t> distinct;
  const auto same = [&](std::size_t one, std::size_t other) {
    const Point &p = data.points[one], &q = data.points[other];
    if (data.has_loads) return p.P == q.P && p.shear() == q.shear() && p.A == q.A;
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

/// shown: a fit of its own, by Ceres. values: one of many, by the kernel, without what is only shown. tried: the same,
/// of an explanation that may be wrong, and is given up where it takes long.
enum class Purpose { shown, values, tried };

template <class Model>
class Fitter {
 public:
  /// `near`: where the minimum is looked for; null: anywhere.
  Fitter(const Dataset& data, const FitOptions& options, Purpose purpose, const std::vector<std::size_t>* points,
         const std::vector<FittedParameter>* near)
      : data_(data),
        options_(options),
        purpose_(purpose),
        prepared_(prepare<Model>(data, options, options.objective.value_or(default_objective(data)), points)),
        points_(points) {
    if (!options_.free.empty() && !near && data.has_loads)
      prepared_.start = jkr_start<Model>(data_, options_, prepared_);
    problem_ = make_problem<Model>(data_, options_, prepared_);
    describe();
    if (near) starting_.near = solver_values(*problem_, *near);
    if (purpose_ != Purpose::shown) {
      solver_.engine = Engine::kernel;
      solver_.last_digits = false;
    }
    if (purpose_ == Purpose::tried) solver_.most_iterations_shown = solver_.most_iterations;
  }

  FitResult run() {
    const std::size_t p = problem_->parameters().size(), unknown = p - prior_count(*problem_);
    if (const std::size_t distinct = distinct_points(data_, prepared_.used, unknown + 1);
        p > 0 && distinct <= unknown) {
      result_.status = FitStatus::not_identifiable;
      result_.message = too_few_points(distinct, prepared_.used.size(), unknown);
      return result_;
    }
    const bool as_the_paper = purpose_ == Purpose::shown || (p > 0 && starting_.near.empty());
    if (prepared_.objective == Objective::curve && data_.has_loads && as_the_paper) fit_as_the_paper();
    // how the time is shared, roughly: up to the minimum, and up to what is resampled
    const double found = options_.profile_points > 0 ? 0.1 : 0.4,
                 fitted = options_.bootstrap.replicates > 0 || options_.influence ? 0.1 : 1;
    tell(0.25 * found * fitted);
    std::vector<double> x;
    if (p == 0) {
      result_.status = FitStatus::ok;
      result_.message = "every parameter is held: nothing was fitted";
    } else {
      Verdict verdict;
      const FitResult described = result_;
      // An interval may come upon a lower cost, from which to start again.
      for (int again = 0;; ++again) {
        result_ = described;
        verdict = find_minimum();
        result_.status = verdict.status;
        result_.message = verdict.message;
        if (!result_.has_values() || verdict.best.x.empty()) return result_;
        x = verdict.best.x;
        const std::vector<double> deeper =
            tell_parameters(cost(), verdict, options_, stretch(options_.progress, found * fitted, fitted), result_);
        result_.known_errors = problem_->known_errors();
        result_.free_parameters = unknown;  // each of the others brings a residual of its own
        result_.sum_of_squares *= unit_ * unit_;
        if (deeper.empty() && purpose_ == Purpose::shown) tell_budget(x, verdict);
        if (deeper.empty() && checked()) tell_evidence(verdict);
        if (deeper.empty() || again == kMostRestarts) break;
        starting_.guesses.push_back(deeper);
      }
      tell(fitted);
      tell_resampled(cost(), verdict, data_, options_, stretch(options_.progress, fitted, 1), result_);
    }
    judge(x);
    if (checked() && p > 0) tell_consistency();
    doubt_what_is_unknown();
    return result_;
  }

 private:
  void tell(double fraction) const {
    if (options_.progress) options_.progress(fraction);
  }

  /// A value with an error beyond its whole range is none.
  void doubt_what_is_unknown() {
    for (const FittedParameter& one : result_.parameters) {
      if (result_.status != FitStatus::ok || !one.stderr_ || !(*one.stderr_ > one.upper - one.lower)) continue;
      result_.status = FitStatus::suspect;
      result_.message =
          "the data do not tell " + one.name +
          ": its standard error exceeds its whole range; check the sizes and units of sigma_T and sigma_A";
    }
  }

  bool checked() const { return purpose_ == Purpose::shown && options_.checks; }

  void describe() {
    result_.model = Model::info.key;
    result_.model_name = Model::info.name;
    result_.formula = Model::info.formula;
    result_.objective = prepared_.objective;
    result_.scale = scale_of(options_);
    result_.used = prepared_.used;
    result_.excluded = prepared_.excluded;
    result_.errors = prepared_.errors;
    for (std::size_t k = 0; k < prepared_.base.size(); ++k) {
      const ParameterInfo& info = Model::parameters[k];
      result_.parameters.push_back({std::string(info.name), {}, {}, info.lower, info.upper});
      result_.parameters[k].held = prepared_.held[k];
      if (prepared_.held[k]) result_.parameters[k].value = prepared_.base[k];
    }
    for (const FreeParameter& parameter : problem_->parameters())
      if (parameter.start) {
        result_.parameters.push_back(
            {parameter.name, {}, {}, parameter.shown(parameter.lower), parameter.shown(parameter.upper)});
        result_.parameters.back().unit = parameter.unit;
        if (parameter.prior > 0)
          result_.parameters.back().prior = {parameter.shown(*parameter.start),
                                             parameter.prior * parameter.shown_slope(*parameter.start),
                                             parameter.logarithmic};
      }
  }

  /// The paper's fit stands beside the result, and is a start for it.
  void fit_as_the_paper() {
    FitOptions options = value_only({});
    options.objective = Objective::toughness;
    options.hold = options_.hold;
    options.constants = prepared_.constants;
    const FitResult fit = Fitter(data_, options, Purpose::values, points_, nullptr).run();
    result_.paper = {fit.status, fit.parameters, fit.r2, fit.used.size()};
    if (const std::vector<double> x = solver_values(*problem_, fit.parameters); !x.empty())
      starting_.guesses.push_back(x);
  }

  Verdict find_minimum() {
    priors_.reset();  // of the problem before
    robust_.reset();
    Verdict verdict = minimum_of(*problem_);
    if (prepared_.objective == Objective::toughness && options_.weighted) {
      // The standard errors depend on the model: until they no longer change.
      double change = 0;
      for (int i = 0; i < 50; ++i) {
        const std::vector<double> before = verdict.best.x;
        const Parameters<Model> at = before.empty() ? prepared_.base : problem_->candidate(before).parameters;
        problem_ = make_problem<Model>(
            data_, options_, prepared_,
            toughness_weights<Model>(data_, scale_of(options_), prepared_.used, prepared_.errors, at));
        verdict = minimum_of(*problem_);
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
    if (x.empty() && !known) x = value_of_least_spread(*problem_);
    for (int i = 0; i < (known ? 1 : 3) && (known || !x.empty()); ++i) {
      const double unit = known ? 1.0 : spread(*problem_, x);
      if (!(unit > 0)) return verdict;  // no residuals to speak of
      result_.loss_scale = scale * unit;
      robust_.emplace(*problem_, options_.loss, result_.loss_scale);
      verdict = minimum_of(*robust_);
      x = verdict.best.x;
    }
    return verdict;
  }

  /// With what is known of the constants beforehand.
  Verdict minimum_of(const Problem& data) {
    if (prior_count(data) == 0) return solve(data, starting_, solver_);
    SolvedWithPriors solved = solve_with_priors(data, starting_, solver_);
    unit_ = solved.unit;
    priors_.emplace(data, unit_);
    return std::move(solved.verdict);
  }

  const Problem& cost() const {
    if (priors_) return *priors_;
    if (robust_) return *robust_;
    return *problem_;
  }

  /// A robust loss is no likelihood.
  void tell_evidence(const Verdict& verdict) {
    result_.evidence.reset();
    const bool wanted = options_.intervals && !robust_;
    const FreeParameter& first = cost().parameters()[0];
    if (!wanted || first.start || verdict.best.x.empty() || verdict.status == FitStatus::not_converged) return;
    const EvidenceOptions choice{options_.lambda_prior, options_.confidence,
                                 problem_->known_errors() ? 0
                                 : priors_                ? unit_
                                                          : 1};
    if (const auto found = evidence(cost(), verdict.best, verdict.standard_errors[0], choice))
      result_.evidence = {first.name, options_.lambda_prior, options_.confidence, *found};
  }

  /// What the constants of the experiment do to the parameter.
  void tell_budget(const std::vector<double>& x, const Verdict& verdict) {
    const bool scaled = prepared_.objective == Objective::toughness && scale_of(options_) == Scale::linear;
    if (scaled || data_.has_energies || verdict.status == FitStatus::not_converged ||
        verdict.at_bound.size() != x.size())
      return;
    PreparedFit<Model> all = prepared_;
    std::vector<double> beside = x;
    std::vector<ConstantStep> exact;
    double load = 0, shear = 0, area = 0;
    for (const std::size_t i : prepared_.used) {
      load = std::max(load, std::abs(data_.points[i].P));
      shear = std::max(shear, data_.points[i].shear());
      area = std::max(area, data_.points[i].A);
    }
    for (const Constant c : kAllConstants) {
      const bool fitted = std::any_of(prepared_.fitted.begin(), prepared_.fitted.end(),
                                      [&](const FittedConstant& one) { return one.constant == c; });
      if (fitted || (!data_.has_loads && c != kToughness)) continue;
      all.fitted.push_back({c, prepared_.constants[c], 0});
      const double size = c == kLoadOffset ? load : c == kShearOffset ? shear : area;
      exact.push_back({beside.size(), is_factor(c) ? std::log(1.05) : 0.01 * size});
      beside.push_back(prepared_.constants[c]);
    }
    all.start.clear();
    const auto data =
        make_problem<Model>(data_, options_, all, options_.weighted ? problem_->weights() : std::vector<double>{});
    const double freedom = static_cast<double>(data->residual_count()) - static_cast<double>(result_.free_parameters);
    const double unit = problem_->known_errors() ? 1 : priors_ ? unit_ : std::sqrt(result_.sum_of_squares / freedom);
    if (robust_)
      result_.budget =
          error_budget(RobustProblem(*data, options_.loss, result_.loss_scale), beside, unit, verdict.at_bound, exact);
    else
      result_.budget = error_budget(*data, beside, unit, verdict.at_bound, exact);
  }

  /// Whether the data are what the fit takes them for. Residuals of rounding alone are not tested.
  void tell_consistency() {
    const double rounding = 100 * residual_rounding(*problem_);
    const bool judged = result_.status == FitStatus::ok || result_.status == FitStatus::at_bound ||
                        result_.status == FitStatus::multimodal;
    if (!judged || result_.residuals.empty() || !(result_.sum_of_squares > rounding * rounding)) return;
    result_.consistency = test_consistency(data_, result_);
    if (result_.status == FitStatus::ok && !failed_test(result_).empty()) result_.status = FitStatus::suspect;
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
    if (data_.has_loads && purpose_ == Purpose::shown)
      result_.area = area_goodness<Model>(data_, result_.used, problem_->candidate(x));
  }

  static constexpr int kMostRestarts = 3;
  const Dataset& data_;
  const FitOptions& options_;
  Purpose purpose_;
  PreparedFit<Model> prepared_;
  const std::vector<std::size_t>* points_;
  StartingPoints starting_;
  SolverOptions solver_;
  std::unique_ptr<ModelProblem<Model>> problem_;
  std::optional<RobustProblem> robust_;
  std::optional<ProblemWithPriors> priors_;
  double unit_ = 1;  // of the residuals of the data beside the priors
  FitResult result_;
};

FitResult fit(const Dataset& data, std::string_view model, const FitOptions& options, Purpose purpose,
              const std::vector<std::size_t>* points, const std::vector<FittedParameter>* near) {
  FitResult result;
  const bool known = with_model(
      model, [&](auto chosen) { result = Fitter<decltype(chosen)>(data, options, purpose, points, near).run(); });
  if (!known) throw std::invalid_argument("there is no model '" + std::string(model) + "'");
  return result;
}

}  // namespace

FitResult fit_and_test(const Dataset& data, std::string_view model, const FitOptions& options,
                       const std::vector<std::size_t>* points) {
  return fit(data, model, options, Purpose::shown, points, nullptr);
}

void find_cause(const Dataset& data, FitResult& result, const FitOptions& options, bool left_behind) {
  if (!result.consistency) return;
  const Refit refit = [&](const FitOptions& with, const std::vector<std::size_t>& points,
                          const std::vector<FittedParameter>* near) {
    return fit(data, result.model, with, Purpose::tried, &points, near);
  };
  const auto [reason, explained] = diagnose(data, result, value_only(options), refit, left_behind);
  if (reason.empty()) return;
  result.explained = explained;
  result.message += (result.message.empty() ? "" : "; ") + reason;
}

FitResult fit_model(const Dataset& data, std::string_view model, const FitOptions& options,
                    const std::vector<std::size_t>* points) {
  FitResult result = fit_and_test(data, model, options, points);
  find_cause(data, result, options);
  return result;
}

FitResult refit_model(const Dataset& data, const FitResult& whole, const FitOptions& options,
                      const std::vector<std::size_t>& points) {
  const FitOptions values = value_only(options);
  // What bends at its minimum may have another elsewhere without a run.
  const bool smooth = std::all_of(whole.parameters.begin(), whole.parameters.end(), [](const FittedParameter& one) {
    return one.value && (one.held || one.at_bound || one.stderr_);
  });
  if (smooth) {
    FitResult near = fit(data, whole.model, values, Purpose::values, &points, &whole.parameters);
    if (near.status != FitStatus::not_converged) return near;
  }
  return fit(data, whole.model, values, Purpose::values, &points, nullptr);
}

}  // namespace mixity
