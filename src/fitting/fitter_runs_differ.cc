// Tests whether runs differ in quantities that are not fitted by run.
#include <algorithm>
#include <cmath>

#include "fitting/causes.h"
#include "fitting/consistency.h"
#include "fitting/curve_objective.h"
#include "fitting/fitted_errors.h"
#include "fitting/fitter.h"
#include "fitting/run_differences.h"
#include "statistics/distributions.h"

namespace mixity {
namespace {

constexpr std::size_t kMostRuns = 200;  // the cost grows with its cube

/// Spreads so large that they act as no prior: far more than any run determines.
Eigen::VectorXd free_spreads(const RunRows& rows, const Groups& groups) {
  constexpr double kFree = 1e3;
  Eigen::VectorXd spread(rows.Zw.cols());
  for (Eigen::Index q = 0; q < spread.size(); ++q) {
    double most = 0;
    for (const auto& group : groups) most = std::max(most, rows.Zw(group, q).squaredNorm());
    spread[q] = most > 0 ? kFree / std::sqrt(most) : 0;
  }
  return spread;
}

/// Whether a deviation of each run in one of the quantities explains the residuals beyond chance. `rest`: how many
/// residuals there are more than parameters.
bool any_differs(const RunRows& rows, const Groups& groups, double rest) {
  const std::vector<double> course(groups.size(), 1.0);
  bool differ = false;
  const GroupedRows grouped = grouped_rows(rows.J, rows.r, rows.Zw, groups);
  for (Eigen::Index q = 0; q < rows.Zw.cols(); ++q) {
    const auto test = test_groups(grouped, course, q);
    if (!test || !(test->fall > 0) || !(rest > test->directions)) continue;
    const double left = (rows.r.squaredNorm() - test->fall) / (rest - test->directions);
    differ |= fisher_p_value(test->fall / test->directions / left, test->directions, rest - test->directions) < kChance;
  }
  return differ;
}

/// Removes from the rows of the data what is fitted by run.
void take_off(const GroupWhitening& by_run, RunRows& rows) {
  const auto data = static_cast<std::size_t>(rows.Zw.rows());
  by_run.apply({rows.r.data(), data});
  for (Eigen::Index k = 0; k < rows.J.cols(); ++k) by_run.apply({rows.J.col(k).data(), data});
  for (Eigen::Index k = 0; k < rows.Zw.cols(); ++k) by_run.apply({rows.Zw.col(k).data(), data});
}

}  // namespace

/// Where runs differ, leaves the remainder after each run has its own first parameter and scale of the areas; otherwise
/// these would be taken for autocorrelated noise. Returns their columns.
std::vector<std::vector<double>> Fitter::take_runs_apart(const std::vector<double>& x, NearestPlaces& nearest,
                                                         std::vector<double>& leverage, const ErrorModels& models,
                                                         bool& apart, std::optional<ErrorModels>& by_neighbours) const {
  const PointsByRun in_runs(data_, prepared_.used);
  const bool may_be_memory = prepared_.errors->correlations.any() && !apart;
  if (in_runs.runs() < 2 || in_runs.runs() > kMostRuns || may_be_memory) return {};
  const std::vector<std::string> names{tested_quantities(data_, prepared_).front(),
                                       std::string(kConstantNames[kAreaScale])};
  if (prepared_.used.size() >= kManyPoints && !apart && !prepared_.errors->correlations.any()) {
    const auto sums = summed_run_rows(data_, options_, prepared_, in_runs, x, nearest.residuals, names, 1);
    const double rest = static_cast<double>(prepared_.used.size() + prior_count(*problem_) - x.size());
    if (!sums || !any_differs(sums->rows, sums->groups, rest)) return {};
  }
  const std::size_t points = nearest.residuals.size();
  std::vector<double> residuals = nearest.residuals;
  residuals.insert(residuals.end(), nearest.axes.begin(), nearest.axes.end());
  residuals.insert(residuals.end(), nearest.pull_off.begin(), nearest.pull_off.end());
  const auto rows = run_rows(data_, options_, prepared_, x, residuals, names, 1);
  if (!rows) return {};
  Groups groups = used_runs(data_, prepared_.used).groups;
  const Groups of_points = groups;
  if (!nearest.axes.empty()) add_rows_of_axes(groups);
  if (!apart) apart = differ_more_than_neighbours(*rows, groups, nearest, leverage, models, by_neighbours);
  if (!apart) return {};
  const Eigen::VectorXd spread = free_spreads(*rows, groups);
  const auto probable = most_probable(grouped_rows(rows->J, rows->r, rows->Zw, groups), spread);
  if (!probable) return {};
  // The rows of axes move the parameters, too. Elsewhere x is a minimum of the points, and a step about a model that
  // does not describe them would lead far off.
  if (!nearest.axes.empty()) {
    const Eigen::VectorXd moved = rows->bare * probable->step;
    for (std::size_t i = 0; i < points; ++i) nearest.residuals[i] += moved[static_cast<Eigen::Index>(i)];
  }
  std::vector<std::vector<double>> own;
  for (Eigen::Index q = 0; q < spread.size(); ++q) {
    own.emplace_back(rows->Z.col(q).begin(), rows->Z.col(q).begin() + static_cast<std::ptrdiff_t>(points));
    for (std::size_t g = 0; g < groups.size(); ++g)
      for (const std::size_t i : of_points[g])
        nearest.residuals[i] += rows->Z(static_cast<Eigen::Index>(i), q) * probable->deviations[g][q];
  }
  const Eigen::VectorXd shares = shares_of_noise(rows->J, rows->Zw, groups, spread);
  for (std::size_t i = 0; i < leverage.size(); ++i) leverage[i] = 1 - shares[static_cast<Eigen::Index>(i)];
  return own;
}

/// Whether a deviation of each run explains the residuals beyond chance and better than correlated neighbours, whose
/// errors are then in `by_neighbours`.
bool Fitter::differ_more_than_neighbours(const RunRows& rows, const Groups& groups, const NearestPlaces& nearest,
                                         const std::vector<double>& leverage, const ErrorModels& models,
                                         std::optional<ErrorModels>& by_neighbours) const {
  const double rest = static_cast<double>(rows.r.size() - rows.J.cols());
  if (!any_differs(rows, groups, rest)) return false;
  if (!by_neighbours) by_neighbours = estimated_errors(nearest, leverage, models, Stage::choosing, {});
  if (!by_neighbours || !by_neighbours->correlations.any()) return true;
  constexpr double kEnough = 1e-3;  // of a spread; ln L, which decides, is stationary there
  // In units of the scatter within the runs. That of neighbours is the likelihood of the points alone, without axes.
  const auto n = static_cast<Eigen::Index>(nearest.residuals.size());
  const Groups of_points = used_runs(data_, prepared_.used).groups;
  const GroupedRows whole = grouped_rows(rows.J, rows.r, rows.Zw, groups);
  const auto within = most_probable(whole, free_spreads(rows, groups));
  if (!within) return false;
  Eigen::VectorXd left = rows.r + rows.J * within->step;
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (const std::size_t i : groups[g])
      left[static_cast<Eigen::Index>(i)] += rows.Zw.row(static_cast<Eigen::Index>(i)).dot(within->deviations[g]);
  const double unit = left.norm() / std::sqrt(std::max(rest - static_cast<double>(2 * groups.size()), 1.0));
  const auto spreads = restricted_spreads(grouped_rows(rows.J / unit, rows.r / unit, rows.Zw / unit, groups), kEnough);
  if (!spreads) return false;
  const GroupWhitening whitening(rows.Zw.topRows(n) / unit, spreads->spread, of_points);
  std::vector<double> r(rows.r.begin(), rows.r.begin() + n);
  whitening.apply(r);
  const double count = static_cast<double>(n),
               of_runs = -(count * std::log(as_vector(r).squaredNorm() / count) + whitening.log_determinant()) / 2;
  // Of two that do about as well, correlated neighbours are believed, unless they correlate along a large part of a
  // run.
  constexpr double kLargePart = 0.25;
  const double rho = std::max(by_neighbours->correlations.first, by_neighbours->correlations.second),
               alike = 1 / (1 - rho), points = count / static_cast<double>(groups.size()),
               sooner = alike < kLargePart * points ? kAboutAsWell / 2 : -kAboutAsWell / 2;
  return of_runs > by_neighbours->log_likelihood + sooner;
}

/// Leaving out each run in turn gives the error of the first parameter without a model of the noise. If the resulting
/// interval is wider by more than half, it is the one shown.
void Fitter::widen_by_jackknife(const RunRows& rows, const Groups& groups) {
  constexpr std::size_t kFewest = 4;  // runs: with fewer, the estimate itself is too uncertain
  constexpr double kByChance = 0.01, kLeastScatter = 1e-3;
  // Where neighbours correlate, the profile depends on an estimate of that, too.
  const double wider = prepared_.errors->correlations.any() ? 1 : 1.5;
  const auto first = std::find_if(result_.parameters.begin(), result_.parameters.end(),
                                  [](const FittedParameter& one) { return !one.held; });
  if (groups.size() < kFewest || first == result_.parameters.end() || !first->interval || !first->stderr_) return;
  ShownInterval& shown = *first->interval;
  const auto error = jackknife_error(rows.J, rows.r, groups);
  if (!error || !shown.low || !shown.high || problem_->parameters()[0].start) return;
  // The contribution of constants is the same in all runs.
  const double scatter = result_.budget && result_.budget->scatter ? *result_.budget->scatter : 1;
  const auto beyond = [&](double size, double freedom) {
    return size * std::sqrt(fisher_quantile(shown.confidence, 1, freedom));
  };
  const double half = std::hypot(beyond(*error, static_cast<double>(groups.size() - 1)),
                                 beyond(*first->stderr_ * std::sqrt(std::max(1 - scatter, 0.0)), 1e6));
  if (!(2 * half > wider * (*shown.high - *shown.low))) return;
  // Few runs scatter much by chance: with both axes measured the noise of the points is known well enough to tell.
  const double freedom = static_cast<double>(groups.size() - 1),
               beside = std::pow(*error / *first->stderr_, 2) / std::max(scatter, kLeastScatter);
  if (result_.axes > 0 && chi_squared_p_value(freedom * beside, freedom) > kByChance) return;
  shown = {"jackknife",
           shown.confidence,
           std::max(*first->value - half, first->lower),
           std::min(*first->value + half, first->upper),
           EndStatus::found,
           EndStatus::found};
}

/// The rows of axes belong to the runs of their points.
void Fitter::add_rows_of_axes(Groups& groups) const {
  const auto& objective = static_cast<const CurveObjective&>(*problem_);
  for (std::vector<std::size_t>& group : groups)
    for (std::size_t k = 0, points = group.size(); k < points; ++k)
      if (const std::size_t row = objective.row_of_axes(group[k]); row > 0) group.push_back(row);
}

/// The last quantity fitted by run in one run alone. Deviations of all runs would have to be as large as that of an odd
/// run, which is unlikely the better the others determine the quantity. `rows`: without deviations, in units of `unit`.
std::optional<OneRun> Fitter::one_run(RunRows rows, const Groups& groups, Eigen::Index quantity, double unit) const {
  constexpr std::size_t kFewest = 4;  // runs: with fewer, none can be called odd
  const auto neighbours = neighbours_of(data_, prepared_.used, *prepared_.errors);
  const auto by_run = whitening_of_runs(data_, prepared_.used, *prepared_.errors, neighbours);
  if (groups.size() < kFewest || !by_run) return std::nullopt;
  StandardErrors errors = *prepared_.errors;
  errors.runs.spreads.pop_back();
  errors.runs.columns.pop_back();
  const auto others = whitening_of_runs(data_, prepared_.used, errors, neighbours);
  if (others) take_off(*others, rows);
  const GroupedRows grouped = grouped_rows(rows.J, rows.r, rows.Zw.col(quantity), groups);
  const auto test = test_groups(grouped, std::vector<double>(groups.size(), 1.0));
  const auto alike = most_probable(grouped, Eigen::VectorXd::Zero(1));
  if (!test || !alike) return std::nullopt;
  const auto largest = std::max_element(test->groups.begin(), test->groups.end(),
                                        [](const auto& x, const auto& y) { return x.fall < y.fall; });
  const bool known = problem_->known_errors();
  const double fall = largest->fall * unit * unit,
               squares = (rows.r + rows.J * alike->step).squaredNorm() * unit * unit - fall,
               variance = known ? 1 : squares / static_cast<double>(result_.rows());
  if (!(squares > 0 && fall > variance)) return std::nullopt;
  const double log_variances =
      result_.log_variances - by_run->log_determinant() + (others ? others->log_determinant() : 0);
  // The most likely spread of that run makes its deviation as large as expected.
  const double of_spread = 1 + std::log(fall / variance), of_choice = 2 * std::log(static_cast<double>(groups.size()));
  return OneRun{used_runs(data_, prepared_.used).runs[static_cast<std::size_t>(largest - test->groups.begin())],
                largest->value, misfit(squares, log_variances, result_.rows(), known) + of_spread + of_choice};
}

/// Tests each quantity that is not fitted by run: does it differ in one run, in all, or with their order?
void Fitter::test_runs(const std::vector<double>& x) {
  result_.run_tests.clear();
  const bool curves = prepared_.objective == Objective::curve && data_.has_loads && prepared_.errors;
  const PointsByRun in_runs(data_, prepared_.used);
  if (!curves || in_runs.runs() < 2 || in_runs.runs() > kMostRuns || robust_) return;
  std::vector<double> innovations(problem_->residual_count()), residuals;
  if (!static_cast<const CurveObjective&>(*problem_).evaluate_both(x, innovations, residuals)) return;
  const std::vector<double> of_axes(innovations.begin() + static_cast<std::ptrdiff_t>(residuals.size()),
                                    innovations.end());
  innovations = std::vector<double>();  // of millions of points each array counts
  const std::vector<double> off = taken_off(data_, prepared_.used, *prepared_.errors);
  for (std::size_t i = 0; i < off.size(); ++i) residuals[i] -= off[i];
  residuals.insert(residuals.end(), of_axes.begin(), of_axes.end());
  const std::vector<std::string> tested = tested_quantities(data_, prepared_);
  const bool known = problem_->known_errors();
  const double rest = static_cast<double>(residuals.size()) - static_cast<double>(result_.free_parameters),
               scatter = rest > 0 ? std::sqrt(result_.sum_of_squares / rest) : 1;
  // Stated errors that are too small are not a difference between the runs.
  const double unit = known ? std::max(1.0, scatter) : scatter;
  const bool judged_by_scatter = !known || scatter > 1;
  if (!(unit > 0)) return;
  std::optional<RunRows> rows;
  Groups groups;
  if (residuals.size() >= kManyPoints && of_axes.empty() && !prepared_.errors->correlations.any() &&
      !prepared_.errors->runs.any()) {
    if (auto sums = summed_run_rows(data_, options_, prepared_, in_runs, x, residuals, tested, unit)) {
      rows = std::move(sums->rows);
      groups = std::move(sums->groups);
    }
  } else {
    rows = run_rows(data_, options_, prepared_, x, residuals, tested, unit);
    groups = used_runs(data_, prepared_.used).groups;
    if (result_.axes > 0) add_rows_of_axes(groups);  // pull-off loads belong to no run
  }
  if (!rows) return;
  const auto of_law = rows->bare.size() > 0 ? columns_of_law(x, *rows) : std::nullopt;
  const auto of_trial = std::find(tested.begin(), tested.end(), options_.by_run.empty() ? "" : options_.by_run.back());
  if (purpose_ == Purpose::tried && of_trial != tested.end())
    result_.one_run = one_run(*rows, groups, of_trial - tested.begin(), unit);
  // Removes what is already fitted by run.
  const auto neighbours = neighbours_of(data_, prepared_.used, *prepared_.errors);
  const auto by_run = whitening_of_runs(data_, prepared_.used, *prepared_.errors, neighbours);
  if (by_run) take_off(*by_run, *rows);
  if (of_law) {
    Eigen::MatrixXd columns = *of_law;
    for (Eigen::Index k = 0; k < columns.cols(); ++k) {
      if (neighbours) neighbours->apply({columns.col(k).data(), prepared_.used.size()});
      if (by_run) by_run->apply({columns.col(k).data(), prepared_.used.size()});
    }
    test_law(*rows, columns, judged_by_scatter ? std::optional(rest) : std::nullopt);
  }
  widen_by_jackknife(*rows, groups);
  std::vector<std::size_t> runs;
  for (std::size_t g = 0; g < in_runs.runs(); ++g) runs.push_back(in_runs.run(g));
  std::vector<double> course;
  for (const std::size_t run : runs)
    course.push_back(static_cast<double>(run) / static_cast<double>(data_.curves.size() - 1) - 0.5);
  const GroupedRows grouped = grouped_rows(rows->J, rows->r, rows->Zw, groups);
  for (std::size_t q = 0; q < tested.size(); ++q) {
    const auto test = test_groups(grouped, course, static_cast<Eigen::Index>(q));
    if (!test || !(test->directions > 0)) continue;
    const double freedom = rest - test->directions;
    if (!judged_by_scatter || freedom > 0)
      result_.run_tests.push_back(
          run_test(data_, tested[q], *test, runs, judged_by_scatter ? std::optional(freedom) : std::nullopt));
  }
}

}  // namespace mixity
