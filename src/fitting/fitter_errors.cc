// Standard errors that depend on the fit: a fit and its errors are found in turn.
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "fitting/consistency.h"
#include "fitting/course.h"
#include "fitting/curve_objective.h"
#include "fitting/errors_ahead.h"
#include "fitting/fitted_errors.h"
#include "fitting/fitter.h"
#include "solver/descent.h"
#include "solver/linear_algebra.h"
#include "solver/robust.h"
#include "solver/verdict.h"
#include "statistics/distributions.h"
#include "statistics/student.h"

namespace mixity {
namespace {

/// Multiplies residuals by the square roots of their weights in the estimate of Student's scale.
void weigh_as_student(std::vector<double>& residuals) {
  if (!(spread(residuals) > 0)) return;
  const StudentErrors errors = student_errors(residuals, false);
  for (double& r : residuals) r *= std::sqrt((errors.freedom + 1) / (errors.freedom + std::pow(r / errors.scale, 2)));
}

/// Gives their memory back.
void drop(std::initializer_list<std::vector<double>*> lists) {
  for (std::vector<double>* const list : lists) *list = std::vector<double>();
}

}  // namespace

/// The minimum with self-consistent errors.
Verdict Fitter::minimum_with_its_errors() {
  constexpr int kMost = 3;
  constexpr double kSamePlace = 0.01;  // of chi^2: a tenth of a standard error, if the rounds ended early
  std::vector<double> x = !starting_.near.empty()      ? starting_.near
                          : !starting_.guesses.empty() ? starting_.guesses.back()
                                                       : std::vector<double>();
  for (int again = 1;; ++again) {
    if (x.empty() && !problem_->parameters().empty()) x = minimum_of(*problem_).best.x;
    const std::vector<double> start = x;
    bool described = settle_errors(x);
    if (!described && off_with_correlations_ && !independent_ && purpose_ != Purpose::tried) {
      independent_ = true;  // a few outliers can pass for correlated noise, under which the fit wanders off
      x = start;
      off_course_.reset();
      described = settle_errors(x);
    }
    if (x.empty() && !problem_->parameters().empty()) {  // the model is not defined at the guess
      x = minimum_of(*problem_).best.x;
      described = settle_errors(x);
    }
    if (given_up_) {
      Verdict verdict(x.size());
      verdict.message = "given up: it explains nothing";
      return verdict;
    }
    // The deviations of the runs are linearised here and are invalid elsewhere; a trial need not look elsewhere.
    const std::vector<double> near = starting_.near;
    if (described && (!options_.by_run.empty() || purpose_ == Purpose::tried)) starting_.near = x;
    Verdict verdict = minimum_of(*problem_);
    starting_.near = near;
    // The errors may have been found, or the residuals judged, in a basin that is not the lowest. Where they are as
    // before the rounds, those have begun at this minimum.
    const std::vector<double>& begun = described ? x : first_minimum_;
    std::vector<double> residuals(cost_->residual_count());
    const auto settled = begun.empty() ? std::nullopt : sum_of_squares(*cost_, begun, residuals);
    const double unit = verdict.best.sum_of_squares / static_cast<double>(std::max<std::size_t>(residuals.size(), 1));
    const bool elsewhere =
        settled && !verdict.best.x.empty() && verdict.best.sum_of_squares < *settled - kSamePlace * unit;
    const bool ends = !elsewhere || again == kMost;
    if (ends && !described && expects_distances(verdict.best.x)) return minimum_of(*problem_);
    if (ends) return verdict;
    x = verdict.best.x;
    if (described && leads_to_the_same_errors(x)) return verdict;
    restore_errors();
    off_course_.reset();
    off_with_correlations_ = independent_ = false;
  }
}

/// Whether the rounds, started again from x with the first errors, would begin at the minimum at which the last ones
/// began: then they would find the same. Of millions of points the errors are not kept for this test.
bool Fitter::leads_to_the_same_errors(const std::vector<double>& x) {
  constexpr double kSame = 1e-6;  // relative, or of the range: far above the rounding of a minimum
  if (prepared_.used.size() >= kManyPoints || first_minimum_.size() != x.size()) return false;
  StandardErrors settled = *prepared_.errors;
  std::unique_ptr<ModelProblem> with_settled = std::move(problem_);
  restore_errors();
  const auto minimum = descend(ProblemWithPriors(*problem_), x, options_of_refits());
  bool same = minimum.has_value();
  for (std::size_t k = 0; same && k < x.size(); ++k) {
    const double size = std::max(std::abs(first_minimum_[k]), problem_->parameters()[k].least_size());
    same = std::abs(minimum->x[k] - first_minimum_[k]) <= kSame * size;
  }
  *prepared_.errors = std::move(settled);
  problem_ = std::move(with_settled);
  return same;
}

/// Recomputes the errors as before the first fit; a copy for millions of points would take much memory.
void Fitter::restore_errors() {
  *prepared_.errors = errors_before_fit(data_, options_, prepared_.objective);
  problem_ = make_problem(data_, options_, prepared_);
}

/// Errors, expected distances and correlations that depend on the fit: starting at x, evaluates them at the fitted
/// curve, and estimates those that come from the scatter, until nothing changes. x: the minimum with them; emptied if
/// the model is not defined there. False, with the errors as before, where the model does not describe the data.
bool Fitter::settle_errors(std::vector<double>& x) {
  constexpr int kRounds = 40, kRoundsOfTrial = 8, kNextIterations = 15, kLast = 10, kLeaps = 4;
  // The rounds of each stage. The first fit, about which differing runs are linearised, may be far off.
  const bool by_run = !options_.by_run.empty(), many = prepared_.used.size() >= kManyPoints && !by_run;
  const bool known = StandardErrors::is_known(prepared_.errors->source_A) &&
                     StandardErrors::is_known(prepared_.errors->source_T);  // only neighbours are to be found
  const int more = by_run ? 6 : 0, weighting = (many || known ? 1 : 2) + more, choosing = 2 * weighting - more,
            refining = 12 + more;
  constexpr double kSettled = 1e-10;        // relative change of an error or a residual; an interval changes as much
  constexpr double kSettledOfTrial = 1e-5;  // an explanation shows four digits
  constexpr double kSettledFarOff = 1e-6;   // where the stated errors are far too small, an interval says no more
  constexpr double kLeap = 0.1;             // relative change in one of the last rounds
  constexpr double kLeft = 3e-4;      // of many points: standard errors by which all further rounds would move the fit
  constexpr double kEnough = 1e-4;    // of many points: standard errors to which a round finds the minimum
  constexpr double kFirst = 1e-5;     // else: the same in the first round
  constexpr double kNext = 0.1;       // and in others, in units of the errors' last relative change
  constexpr double kResolved = 1e-4;  // change of the errors to which a round finds correlations
  constexpr double kCreeps = 2e-3;  // the same along a ridge of their likelihood, where rounds change as much each time
  constexpr double kSteady = 0.5;   // of a round's change, that of the next
  constexpr double kHardlyLess = 0.8;  // the same where rounds creep
  constexpr double kSurely = 1e-6;
  constexpr double kFound = 0.01;        // of the spread between runs, by which a round moves their deviations
  constexpr double kWithFirst = 1.5;     // most by which chi^2 may fall when the errors are again the first ones
  constexpr double kSmallCourse = 0.25;  // in standard errors of a point: 6 % of the variance
  constexpr double kLargeCourse = 2;     // more than the wrong weights of the first errors cause
  StandardErrors& errors = *prepared_.errors;
  first_minimum_.clear();
  SolverOptions quick = options_of_refits();
  const double points = static_cast<double>(prepared_.used.size());
  const SolverOptions exactly;
  double last_change = 1, moved = 0;  // by the last round, at most: the parameters, in their standard errors
  const bool free = !problem_->parameters().empty();
  if (free && x.empty()) return true;
  ErrorModels models;
  ErrorsAhead ahead;
  bool ended = false;
  if (errors.source_T == ErrorSource::scatter) models.T = errors.model_T;
  if (errors.source_A == ErrorSource::scatter) models.A = errors.model_A;
  double largest = 0;  // change of the last rounds
  int leaps = 0;       // rounds in succession that leap although the models of the errors no longer change
  bool apart = false;  // the runs differ: each one's level is removed before errors are estimated
  const int most = (purpose_ == Purpose::tried ? kRoundsOfTrial : kRounds) + more;
  for (int round = 0; round < most; ++round) {
    const ProblemWithPriors cost(*problem_);
    if (free && (round == 0 || !by_run)) {  // else together with the deviations of the runs
      const double enough = (many         ? kEnough
                             : round == 0 ? kFirst
                                          : kNext * std::min(last_change, 1.0)) /
                            std::sqrt(points);
      quick.kernel_stationary = std::max(enough, exactly.kernel_stationary);
      quick.kernel_stationary_of_several = std::max(enough, exactly.kernel_stationary_of_several);
      quick.stationary = std::max(enough, exactly.stationary);
      const auto minimum = descend(cost, x, quick);
      if (!minimum) {
        if (round == 0) x.clear();
        return true;
      }
      x = minimum->x;
      if (round == 0) first_minimum_ = x;
      quick.most_iterations = quick.most_iterations_shown = kNextIterations;
    }
    std::vector<double> leverage;
    // With millions of points each array counts, and these are found anew below.
    const bool lean = many && !errors.correlations.any();
    if (lean) drop({&errors.load_T, &errors.load_A});
    auto nearest = nearest_and_leverages(x, leverage, lean);
    if (lean && nearest) drop({&errors.place_T, &errors.place_A});
    auto expected = nearest ? static_cast<const CurveObjective&>(*problem_).expected(x, *nearest) : std::nullopt;
    if (!expected) return true;
    double freedom = 0;
    for (const double one : leverage) freedom += 1 - one;
    double change = take_expected_off(*expected, freedom, *nearest);
    const double of_expected = change;
    expected.reset();
    change = std::max(change, std::abs(size_stated_errors(*nearest, freedom)));
    const double of_axes = size_axes(*nearest);
    change = std::max({change, std::abs(of_axes), std::abs(size_pull_off(*nearest))});
    if (by_run && !find_run_differences(x, *nearest, leverage, change)) return true;
    if (options_.loss == Loss::t) weigh_as_student(nearest->residuals);
    // A model that does not describe the data says nothing about their errors. With few runs, correlated noise cannot
    // be distinguished from a wrong model.
    const auto course =
        round <= choosing ? test_course(data_, prepared_.used, nearest->T, nearest->residuals) : std::nullopt;
    // A course far smaller than the scatter hardly adds to it, however significant it is.
    const double p_value = course && course->size > kSmallCourse ? course->p_value : 1;
    const bool shared = p_value < kChance, tried = purpose_ == Purpose::tried, first = round == 0 && !by_run;
    const bool surely = p_value < kSurely && (!first || course->size > kLargeCourse);
    const bool off = (round >= weighting && shared) || ((first || (tried && round >= more)) && surely) ||
                     (round == choosing && !course && models.correlations.any());
    if (off) {
      off_course_ = course;
      off_with_correlations_ = models.correlations.any();
      if (first)
        errors.expected.clear();  // nothing else has changed
      else
        restore_errors();
      // Its minimum, with these errors, is known to have this course; or it hardly scatters less with the first errors.
      given_up_ = options_.explanation_only &&
                  (first || exceeds(as_vector(nearest->residuals).squaredNorm(), freedom, kWithFirst));
      return false;
    }
    std::optional<ErrorModels> by_neighbours;  // what Stage::choosing would find, where it is known
    // Later rounds change chi^2, mostly by less than a tenth, but not by this factor; 0: not yet known.
    const double at_most = round == choosing      ? 1.25
                           : round == more        ? 2
                           : round == more + 1    ? 1.5
                           : by_run && round == 2 ? 4
                           : by_run && round == 1 ? 8
                                                  : 0;
    if (at_most > 0 && scatters_too_far(*nearest, leverage, models, at_most, round == choosing, by_neighbours)) {
      given_up_ = true;
      return false;
    }
    if (round < more) {  // with the errors from neighbours, until the runs are found
      if (!refresh_columns(x)) return true;
      problem_ = make_problem(data_, options_, prepared_);
      if (change < kFound) round = more - 1;
      continue;
    }
    std::vector<std::vector<double>> own;
    // A course common to all runs is not a difference between them.
    if (!by_run &&
        (apart || (round < choosing && round % weighting == 0 && (round > 0 || !(many || known)) && !shared)))
      own = take_runs_apart(x, *nearest, leverage, models, apart, by_neighbours);
    const Stage stage = round < weighting  ? Stage::weighting
                        : round < choosing ? Stage::choosing
                        : ended            ? Stage::ending
                                           : Stage::refining;
    const auto found = stage == Stage::choosing && by_neighbours && own.empty()
                           ? by_neighbours
                           : estimated_errors(*nearest, leverage, models, stage, own);
    if (!found) return true;
    change = std::max({change, std::abs(found->correlations.first - models.correlations.first),
                       std::abs(found->correlations.second - models.correlations.second)});
    models = round > choosing && (ended || !found->correlations.any()) ? ahead.next(models, *found) : *found;
    if (models.T) errors.model_T = models.T;
    if (models.A) errors.model_A = models.A;
    errors.run_factors = models.run_factors;
    errors.correlations = models.correlations;
    const bool far_off = known && !errors.factor_is_free && !models.correlations.any() && !many &&
                         chi_squared_p_value(as_vector(nearest->residuals).squaredNorm(), freedom) < kSurely;
    const double settled = tried ? kSettledOfTrial : far_off ? kSettledFarOff : kSettled;
    errors.freedom = known && !errors.factor_is_free ? 0 : freedom * independence(models.correlations);
    const double before = of_axes != 0 ? log_size_of_areas() : 0;
    change = std::max(change, evaluate_errors(data_, prepared_.used, std::move(*nearest), errors));
    if (of_axes != 0) errors.axes_factor *= std::exp(before - log_size_of_areas());
    nearest.reset();
    drop({&leverage});
    if (many && !errors.correlations.any()) drop({&errors.load_T});
    if (by_run && !refresh_columns(x)) return true;
    problem_ = make_problem(data_, options_, prepared_);
    // What all further rounds would change, if each changes as many times less as this one.
    const double ratio = change / std::exchange(last_change, change),
                 left = ratio < kSteady ? change * ratio / (1 - ratio) : change;
    const bool creeps = round > choosing + 1 && ratio > kHardlyLess;
    // Without correlations, later rounds differ from these in nothing but the size of their changes.
    const bool as_later = round > choosing || (!models.correlations.any() && round + (known ? 1 : 0) >= choosing);
    ended |= round + 1 >= refining || (round >= choosing && change < (creeps ? kCreeps : kResolved));
    if (left <= settled && as_later) break;
    if (many) {
      const double earlier = std::exchange(moved, std::max(change, of_expected * std::sqrt(points)));
      if (round >= (known && !models.correlations.any() ? weighting : choosing) && moved < earlier &&
          moved * moved <= kLeft * (earlier - moved))
        break;
    }
    // Errors that leap to and fro tell nothing of the data: rounding decides where they stop. Where the rounds settle,
    // no two in succession leap at the end.
    if (round >= most - kLast) largest = std::max(largest, change);
    leaps = round > refining && change > kLeap ? leaps + 1 : 0;
    const bool never = leaps == kLeaps || (round + 1 == most && largest > kLeap);
    if (never && purpose_ != Purpose::tried && !by_run) {
      restore_errors();
      return false;
    }
  }
  if (!free || !starting_.near.empty()) return true;
  if (many)
    starting_.guesses.clear();  // the rounds began at the best of them
  else if (!starting_.guesses.empty())
    starting_.guesses.pop_back();  // they began there
  starting_.guesses.push_back(x);
  return true;
}

/// The mean logarithm of the areas' standard errors.
double Fitter::log_size_of_areas() const {
  double sum = 0;
  for (const std::size_t i : prepared_.used) sum += std::log(prepared_.errors->A[i]);
  return sum / static_cast<double>(prepared_.used.size());
}

/// Subtracts the expected distances from the residuals. They are scaled to the noise that is found, at most to twice
/// the stated errors. Returns the largest change since the last call.
double Fitter::take_expected_off(const std::vector<double>& expected, double freedom, NearestPlaces& nearest) {
  constexpr double kMost = 4;
  std::vector<double>& list = prepared_.errors->expected;
  list.resize(data_.points.size(), 0.0);
  double squares = 0, change = 0;
  for (std::size_t i = 0; i < expected.size(); ++i)
    squares += std::pow(nearest.residuals[i] - list[prepared_.used[i]], 2);
  const double noise = freedom > 0 ? std::min(kMost, squares / freedom) : 1;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const std::size_t point = prepared_.used[i];
    const double last = std::exchange(list[point], noise * expected[i]);
    nearest.residuals[i] -= list[point];
    change = std::max(change, std::abs(list[point] - last));
  }
  return change;
}

/// For a model that seems not to describe the data: returns whether curvature within the errors of T may be the reason,
/// so that expected distances must be subtracted from the residuals. Sets these.
bool Fitter::expects_distances(const std::vector<double>& x) {
  if (x.empty() || purpose_ == Purpose::tried) return false;
  const auto& objective = static_cast<const CurveObjective&>(*problem_);
  auto nearest = objective.nearest(x);
  auto expected = nearest ? static_cast<const CurveObjective&>(*problem_).expected(x, *nearest) : std::nullopt;
  if (!expected) return false;
  double squares = 0, of_expected = 0;
  for (const double r : nearest->residuals) squares += r * r;
  drop({&nearest->residuals, &nearest->load_T, &nearest->load_A});  // with millions of points, each array counts
  const double noise = std::min(1.0, squares / static_cast<double>(expected->size()));
  for (double& one : *expected) of_expected += std::pow(one *= noise, 2);
  if (of_expected < kCurvatureMatters) return false;
  StandardErrors& errors = *prepared_.errors;
  keep_places(data_, prepared_.used, std::move(*nearest), errors);
  nearest.reset();
  errors.expected.resize(data_.points.size());
  for (std::size_t i = 0; i < expected->size(); ++i) errors.expected[prepared_.used[i]] = (*expected)[i];
  expected.reset();
  problem_ = make_problem(data_, options_, prepared_);
  return true;
}

}  // namespace mixity
