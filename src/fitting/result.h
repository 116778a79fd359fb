// The result of a fit, as plain numbers in the user's units.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/dataset.h"
#include "fitting/options.h"
#include "fitting/point_indices.h"
#include "fitting/standard_errors.h"
#include "solver/results.h"

namespace mixity {

/// An interval in the user's unit. A null end is open.
struct ShownInterval {
  std::string method;  // profile; jackknife: over the runs, Student's with one degree of freedom less than runs;
                       // explanations: the union over the causes that explain failed tests about as well; of a fit that
                       // is ok, with its own interval
  double confidence;
  std::optional<double> low, high;
  EndStatus low_status, high_status;
};

/// The prior of a constant in the user's unit: normal, or log-normal.
struct ShownPrior {
  double mean, standard_error;
  bool logarithmic;
};

struct FittedParameter {
  std::string name;
  std::optional<double> value;    // null if not identifiable
  std::optional<double> stderr_;  // null if held, at a bound, not identifiable
  double lower, upper;
  bool at_bound = false, held = false;
  std::optional<ShownInterval> interval{};
  std::optional<Bootstrapped> bootstrap{};  // in the user's unit
  std::string unit{};                       // empty: dimensionless
  std::optional<DrawnProfile> profile{};    // x in the user's unit; only on request
  std::optional<ShownPrior> prior{};        // only for an uncertain constant
};

/// The parameter of this name; null if there is none.
inline const FittedParameter* find_parameter(const std::vector<FittedParameter>& parameters, std::string_view name) {
  const auto found =
      std::find_if(parameters.begin(), parameters.end(), [&](const FittedParameter& one) { return one.name == name; });
  return found == parameters.end() ? nullptr : &*found;
}

/// How well the fitted model predicts the area at the points' loads, in the units of the file.
struct AreaGoodness {
  std::optional<double> r2;  // null if fewer than two points are predicted or all areas are equal
  double rmse = 0, max_abs_residual = 0;
  std::size_t predicted = 0;
  std::size_t unpredicted = 0;  // points beyond the last equilibrium of the fitted model
  std::vector<double> areas;    // per used point, dimensionless; NaN where unpredicted
  std::string_view obstacle{};  // why the law defines no area with these parameters; else empty

  bool predicts(std::size_t i) const { return !std::isnan(areas[i]); }
};

/// The paper's fit of the same data: ln(Gc/GIc) against psi, all points with the same weight.
struct PaperFit {
  FitStatus status = FitStatus::not_converged;
  std::vector<FittedParameter> parameters;
  std::optional<double> r2;
  std::size_t points = 0;

  /// Null for a constant of the experiment and for a parameter that is not identifiable.
  std::optional<double> value_of(std::string_view parameter) const {
    const FittedParameter* const found = find_parameter(parameters, parameter);
    return found ? found->value : std::nullopt;
  }
};

/// Whether the result of a test would move a parameter, or widen its 95 % interval, by more than a quarter of the
/// interval; with many points every test is significant. `change`: in standard errors.
inline bool moves_or_widens(double change, double widening) { return std::abs(change) > 1 || widening > 1.25; }

/// A constant that was fitted with a prior.
struct BudgetPart {
  std::string constant;
  double share;  // of the parameter's variance, 0..1
  double pull;   // deviation of the constant from its prior's mean, in standard errors of the prior
};

/// A constant that was taken as exact.
struct ExactConstant {
  std::string constant, unit;    // the user's unit
  std::optional<double> effect;  // change of the parameter for `step`
  double step;  // 5 % of the constant; of an offset, 1 % of the largest load, shear or area, in the user's unit; of a
                // change 0.01
  /// Score test of freeing the constant: the fall of chi^2, the fitted value, and the probability of so large a fall by
  /// chance. Null where the residuals do not depend on it.
  struct Score {
    double fall, value, p_value;
    double change = 0, widening = 1;  // of the first parameter then, in its standard errors; factor on that error
    bool matters() const { return moves_or_widens(change, widening); }
  };
  std::optional<Score> score;
};

/// Error budget of the first free parameter. Scatter and parts add up to 1; null and empty if it is held by a bound.
struct Budget {
  std::string parameter, unit;
  std::optional<double> scatter;
  std::vector<BudgetPart> parts;
  std::vector<ExactConstant> exact;
  double independent = 0;  // effective number of independent score tests, as some constants act alike
};

/// Tests of the residuals of each run in file order. z and correlations are near zero if the model and its errors are
/// right; points may have different variances. p-values: probability of a value this large by chance.
struct ResidualTests {
  struct Run {
    std::string curve;
    std::size_t points;
    double runs;         // z of the number of runs of one sign; below zero where neighbours are correlated
    double correlation;  // of neighbours
    double trend;        // z of the slope against T, or against psi
  };
  std::vector<Run> runs;                                               // only those of at least kLeastRun points
  double correlation = 0, correlation_p = 1, runs_p = 1, trend_p = 1;  // over all runs
  double widening = 1;  // standard error of a mean of the residuals, over that of independent ones
  /// Root mean square of the residuals, divided by the scatter of neighbouring points or of neighbouring residuals;
  /// null where that is not known.
  std::optional<double> over_scatter{}, over_neighbours{};
  /// Whether a run of mean length is worth fewer than three independent points: such strongly autocorrelated noise
  /// looks like differing runs, and like a wrong model.
  bool together = false;
  bool coarse = false;             // the resolution of the readings makes neighbours alike
  std::optional<double> course{};  // F of a course common to all runs (course.h); null with fewer than three
  double course_p = 1;
  bool shares_course = false;           // more than by chance
  double ends = 0, ends_p = 1;          // z of the residuals at the ends of the runs against the points before
  static constexpr double kEnd = 0.05;  // share of a run that is its end; at least one point
  static constexpr std::size_t kLeastRun = 8;

  /// Whether neighbours correlate beyond `chance`, and so that the interval would be wider. A filter averages over a
  /// few points, which an autoregressive memory describes only nearly: what remains is significant and harmless.
  bool neighbours_correlate(double chance) const {
    return !coarse && std::min(runs_p, correlation_p) < chance && moves_or_widens(0, widening);
  }
};

/// Points beyond the last equilibrium of the fitted model in one run.
struct BeyondEquilibrium {
  std::string curve;
  std::size_t points, first;  // number of points; index of the first in Dataset::points
};

/// A used point that lies farther from the fit than chance allows.
struct Outlier {
  std::size_t point;  // index into Dataset::points
  double size;        // its residual, model minus data, in standard errors
};

/// A few points with more than half of the weight, because the file states standard errors for them far below those of
/// the others. The weight of a point is one over the variance of its distance from the curve.
struct HeavyPoints {
  std::vector<std::size_t> points;  // indices into Dataset::points, in the order of the file
  double share;                     // of the total weight, 0.5..1
  std::string column;               // whose errors are smallest compared with those of the others
  double ratio;                     // of that error to the median of the column
};

/// Explanations with a difference in -2 ln L up to this do about as well.
inline constexpr double kAboutAsWell = 6;

/// Of measured axes: by what a/b has changed at the largest shear, of an ellipse beyond the fit, and the probability of
/// that by chance.
struct CircleTest {
  double ratio, p_value;
};

/// Whether pull-off loads leave the fit along the shear: F, 0 where that is too small to count, and its probability by
/// chance.
struct PullOffTest {
  double F, p_value;
};

/// Tests of the assumptions of the fit.
struct Consistency {
  std::optional<double> chi2_per_freedom, chi2_p;  // for known errors; with a robust loss from the median residual
  ResidualTests residuals;
  std::vector<BeyondEquilibrium> beyond;  // runs that have such points
  std::optional<HeavyPoints> heavy{};     // only in reported fits
  /// Whether the areas stay constant along each run within their scatter, as in a pinned contact (pinned.h).
  bool pinned = false;
  std::optional<CircleTest> circle{};     // null where no axes were measured
  std::optional<PullOffTest> pull_off{};  // null with few pull-off loads
};

/// Score test of the law: ln f may depart from the model's by a polynomial of order 2 in B = sin^2 psi that vanishes at
/// psi = 0. The fall of chi^2, the probability of such a fall by chance, and the change of the first parameter with the
/// departure, in its standard errors.
struct LawTest {
  double fall, p_value, change;
  bool matters() const { return moves_or_widens(change, 1); }
};

/// Score test of a quantity that may differ between the runs, from the fit's derivatives.
struct RunTest {
  std::string quantity, unit;  // the first parameter, or a constant of the experiment
  bool relative;               // its deviations are relative
  double directions;           // number of independent ways in which the runs may differ
  /// One way to differ: the fall of chi^2, its probability by chance, the size in `unit`, the resulting change of the
  /// first parameter in standard errors, and the factor on its standard error.
  struct Way {
    double fall = 0, p_value = 1, size = 0, change = 0, widening = 1;
    bool matters() const { return moves_or_widens(change, widening); }
  };
  Way all{};            // every run, by chance; size: standard deviation
  Way odd{}, drift{};   // odd: one run, p_value of the best; drift: over the order of the runs, size from first to last
  std::size_t run = 0;  // the odd run, index into Dataset::curves
};

/// A possible cause of failed tests, and the result of the fit with it.
struct Explanation {
  std::string cause, run;   // a constant, or a quantity that differs between runs; the run, if only one differs
  Message size, remedy;     // its estimated size; the options that fit it
  FittedParameter first{};  // the first free parameter in that fit
  double misfit;            // -2 ln L minus that of the best
};

/// The model's evidence; posterior mean, standard deviation and credible interval of its first free parameter.
struct ShownEvidence {
  std::string parameter;
  RangePrior prior;
  std::optional<double> prior_from;  // where a log-uniform one begins
  double confidence;
  Evidence evidence;
};

/// The explanation that the quantity fitted by run differs in one run alone, linearised at the deviations of that fit.
struct OneRun {
  std::size_t run;   // index into Dataset::curves
  double deviation;  // from the other runs, in the solver's numbers
  double misfit;  // -2 ln L with a spread of this run alone, each run being as likely; comparable with that of the fit
};

struct FitResult {
  std::string model, model_name, formula;
  Objective objective = Objective::toughness;
  Scale scale = Scale::log;
  FitStatus status = FitStatus::not_converged;
  Message message;
  std::vector<FittedParameter> parameters;
  PointIndices used;
  std::vector<Excluded> excluded;                        // usable points that this model cannot describe
  std::shared_ptr<const std::string> excluded_reason{};  // owns the text that `excluded` refers to
  std::optional<double> r2;                              // in the fitted space; null without scatter or without a fit
  std::optional<double> rmse, max_abs_residual;
  std::vector<double> residuals;  // per used point, model minus data; empty without a fit
  /// The residuals minus the expected distance and the prediction from earlier points, divided by their standard
  /// deviation: independent of each other. Equal to `residuals` where neighbours do not correlate.
  std::vector<double> innovations{};
  std::optional<AreaGoodness> area;  // null without loads or without a fit
  std::optional<PaperFit> paper;     // beside the objective curve, for data with loads
  /// The standard error of a residual, in its unit: 1 where errors are known, else a robust estimate that outliers
  /// hardly enlarge. 0 without a fit.
  double standard_error = 0;
  std::vector<Outlier> outliers;                   // in file order; only in reported fits
  bool known_errors = false;                       // the residuals are in units of known standard errors
  std::shared_ptr<const StandardErrors> errors{};  // of the points, if the objective uses them
  std::optional<double> sigma_factor;              // common factor on stated errors, from the scatter, where it is free
  std::vector<double> correlations;                // [p x p] of the free parameters in order; empty for a single one
  std::size_t free_parameters = 0;
  /// Sum of ln(variance) of the residuals, relative to proportional errors at the readings, plus ln of the determinant
  /// of their correlations; 0 for known, independent errors. -2 ln L is this plus the sum of squares.
  double log_variances = 0;
  double sum_of_squares = 0;               // of the (weighted) residuals, or of the robust loss
  std::optional<Budget> budget;            // of the first free parameter; null without one
  std::optional<ShownEvidence> evidence;   // null where intervals were not requested, or if not found
  std::optional<Consistency> consistency;  // only in reported fits
  std::vector<RunTest> run_tests;          // for curves with loads in two or more runs
  std::optional<LawTest> law{};            // the same, of circular contacts whose first parameter is free
  /// Where neighbours correlate: the misfit (causes.h) that independent errors and a free shape of the contact would
  /// have according to the linearised model.
  std::optional<double> shape_instead_of_memory{};
  std::optional<OneRun> one_run{};  // of a trial with a quantity by run and at least four runs
  /// Of a suspect fit: the best, and those that do about as well; of one that is ok: those that its interval includes.
  std::vector<Explanation> explanations;
  /// The cost with the constant free that explains the failed tests, if there is one.
  std::optional<double> explained{};
  std::string outdone_by{};  // of a suspect fit: the model that describes the same points far better
  std::optional<BootstrapResult> bootstrap;
  std::optional<Influence> influence;  // changes in the user's units; points as in `used`
  std::vector<double> axes_residuals;  // of ln(a/b) per used point, in standard errors, NaN where it was not measured;
                                       // empty unless axes are fitted
  std::size_t axes = 0;                // how many residuals are those of the axes of elliptic contacts
  std::vector<double> pull_off_residuals;  // of Dataset::pull_off in its order, in standard errors; empty without
  std::vector<double> pull_off_loads;      // of the model at the readings' shears, as they would be read; dimensionless
  std::size_t pull_off = 0;                // how many residuals are those of pull-off loads
  std::vector<std::string> run_names;      // names for Influence::runs
  double loss_scale = 0;                   // in units of the residuals; 0 without a robust loss
  double loss_freedom = 0;                 // fitted degrees of freedom of the loss `t`; 0 for other losses

  bool has_values() const { return status != FitStatus::not_identifiable; }
  /// The number of residuals: of the points, of the axes of elliptic contacts, and of pull-off loads.
  std::size_t rows() const { return used.size() + axes + pull_off; }
  /// Whether the data are pull-off loads without areas.
  bool of_pull_off_alone() const { return used.empty() && pull_off > 0; }
  /// Degrees of freedom: residuals minus free parameters, at least 0.
  std::size_t freedom() const { return rows() > free_parameters ? rows() - free_parameters : 0; }
};

/// The sum of squares as if all fits of these points had the same errors: -2 ln L is n ln(S/n), or S where the errors
/// are known.
inline double comparable_squares(const FitResult& fit) {
  if (fit.known_errors) return fit.sum_of_squares + fit.log_variances;
  return fit.sum_of_squares * std::exp(fit.log_variances / static_cast<double>(fit.rows()));
}

/// Whether all parameters have values.
inline bool has_all_values(const FitResult& fit) {
  return std::all_of(fit.parameters.begin(), fit.parameters.end(),
                     [](const FittedParameter& one) { return one.value.has_value(); });
}

/// Whether all parameters have values at a minimum.
inline bool has_minimum(const FitResult& fit) { return has_all_values(fit) && fit.status != FitStatus::not_converged; }

}  // namespace mixity
