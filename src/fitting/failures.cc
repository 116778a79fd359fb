#include <algorithm>
#include <cmath>
#include <map>

#include "base/number_text.h"
#include "base/units.h"
#include "fitting/causes.h"
#include "fitting/circularity.h"
#include "fitting/consistency.h"
#include "fitting/pull_off_course.h"
#include "mechanics/contact_model.h"
#include "statistics/distributions.h"

namespace mixity {

double residual_unit(const FitResult& fit) {
  if (fit.loss_freedom > 0) return fit.loss_scale / std::sqrt(fit.loss_freedom);
  if (fit.known_errors || fit.freedom() == 0) return 1;
  return std::sqrt(fit.sum_of_squares / static_cast<double>(fit.freedom()));
}

double mean_correlation(const FitResult& fit) {
  if (!fit.errors || !fit.errors->correlations.any() || fit.used.empty()) return 0;
  double sum = 0;
  for (const std::size_t i : fit.used)
    sum += std::pow(fit.errors->load_A[i], 2) * fit.errors->correlations.first +
           std::pow(fit.errors->load_T[i], 2) * fit.errors->correlations.second;
  return sum / static_cast<double>(fit.used.size());
}

double independent_points(const FitResult& fit) {
  const double r = mean_correlation(fit);
  return static_cast<double>(fit.used.size()) * (1 - r) / (1 + r);
}

namespace {

/// Of the score tests of which this is true, the constant of the most significant one; null if there is none. Of
/// constants that act alike it is the first: their p-values differ by rounding.
template <class Asks>
const ExactConstant* most_significant(const FitResult& fit, const Asks& asks) {
  constexpr double kRounding = 1e-6;  // rounding of the nearest points, times the largest falls
  const ExactConstant* most = nullptr;
  if (fit.budget)
    for (const ExactConstant& one : fit.budget->exact)
      if (one.score && asks(one) && (!most || one.score->p_value < (1 - kRounding) * most->score->p_value)) most = &one;
  return most;
}

/// Contacts that shear become ellipses, whose areas exceed those of circles under the law of mode II. Such a radius is
/// expected: its test has one side, and does not count among those of other constants.
bool reads_too_large(const ExactConstant& one) {
  return one.constant == kConstantNames[kShape] && one.score && one.score->value > 0;
}

}  // namespace

double p_value_of(const ExactConstant& one) {
  return reads_too_large(one) ? 0.5 * one.score->p_value : one.score->p_value;
}

bool is_nearly_wrong(const ExactConstant& one, double tests) {
  constexpr double kNearly = 0.1;
  return one.score && one.score->p_value * tests < kNearly && moves_or_widens(one.score->change, 1);
}

const ExactConstant* nearly_wrong_constant(const FitResult& fit) {
  return most_significant(fit, [&](const ExactConstant& one) {
    return is_nearly_wrong(one, reads_too_large(one) ? 0.5 : fit.budget->independent);
  });
}

const ExactConstant* wrong_constant(const FitResult& fit) {
  const ExactConstant* const worst = most_significant(fit, [&](const ExactConstant& one) {
    return one.score->matters() && asks_to_be_free(*one.score, fit.budget->independent);
  });
  if (!worst) return nullptr;
  // If the stated errors are too small whatever the constant, smaller falls of chi^2 do not count.
  const bool too_small = fit.known_errors && fit.consistency && fit.consistency->chi2_p.value_or(1) < kChance;
  if (too_small &&
      chi_squared_p_value(worst->score->fall / *fit.consistency->chi2_per_freedom, 1) * fit.budget->independent >=
          kChance)
    return nullptr;
  return worst;
}

std::vector<std::size_t> sliding_points(const FitResult& fit) {
  constexpr double kFarOff = 4;         // standard errors of a residual
  constexpr std::size_t kByChance = 2;  // points there that chance allows
  std::vector<std::size_t> beyond;
  if (!fit.area || fit.area->areas.size() != fit.used.size()) return beyond;
  for (std::size_t i = 0; i < fit.used.size(); ++i)
    if (!fit.area->predicts(i) && std::abs(fit.residuals[i]) > kFarOff * residual_unit(fit))
      beyond.push_back(fit.used[i]);
  if (beyond.size() <= kByChance) beyond.clear();
  return beyond;
}

/// Of these points, the one at the smallest shear in each run.
std::vector<std::size_t> first_of_runs(const Dataset& data, const std::vector<std::size_t>& points) {
  std::map<std::size_t, std::size_t> first;
  for (const std::size_t i : points) {
    const auto [known, is_new] = first.emplace(data.points[i].curve, i);
    if (!is_new && data.points[i].shear() < data.points[known->second].shear()) known->second = i;
  }
  std::vector<std::size_t> list;
  for (const auto& [run, i] : first) list.push_back(i);
  return list;
}

/// For runs too short for the other tests. Noise with proportions other than assumed shows in the residuals of
/// neighbours, too. A wrong model gives ratios of 4 to 8 with six points a run.
bool is_far(const ResidualTests& tests) {
  constexpr double kFarOff = 2.5, kFarFromNeighbours = 1.5;
  return tests.over_scatter.value_or(0) > kFarOff && tests.over_neighbours.value_or(0) > kFarFromNeighbours;
}

const BudgetPart* far_from_stated(const FitResult& fit) {
  constexpr double kFarFromStated = 4;  // standard errors of a prior
  if (fit.budget)
    for (const BudgetPart& part : fit.budget->parts)
      if (std::abs(part.pull) > kFarFromStated) return &part;
  return nullptr;
}

Message failed_test(const Dataset& data, const FitResult& fit, bool constants) {
  if (const BudgetPart* part = far_from_stated(fit))
    return part->constant + " lies " + rounded(std::abs(part->pull), 2) + " of its standard errors " +
           (part->pull < 0 ? "below" : "above") + " what was stated: check it";
  if (const auto sliding = sliding_points(fit); !sliding.empty())
    return "points lie beyond the last equilibrium: cut the runs at the onset of sliding" +
           cut_at(first_of_runs(data, sliding), data, fit);
  if (pull_off_departs(fit))
    return "the pull-off loads leave the fit as T grows (F = " + rounded(fit.consistency->pull_off->F, 3) +
           "): they and the areas have different values of the parameters, or a reading is off; fit each file alone";
  if (fit.consistency && fit.consistency->pinned)
    return "the areas stay constant along each run within their errors; a pinned contact would look the same, so the "
           "runs do not determine the parameters";
  if (axes_leave_fit(fit) && is_elliptic(fit.model))
    return "the axes leave the fit as T grows: at the largest shear a/b is " +
           rounded(fit.consistency->circle->ratio, 3) +
           " of what it says; the model, a coupling that is held or the direction of the axes is wrong";
  if (axes_leave_fit(fit))
    return "the contact is no circle: a/b changes to " + rounded(fit.consistency->circle->ratio, 3) +
           " of its value without shear; " + Remedy::set("shape", "ellipse") + " fits both axes";
  if (const ExactConstant* wrong = constants ? wrong_constant(fit) : nullptr) {
    const ReadableUnit shown = readable_unit(wrong->score->value, wrong->unit);
    return wrong->constant + " looks wrong: near " + rounded(wrong->score->value * shown.factor, 2) +
           (wrong->unit.empty() ? "" : " " + shown.unit) + " the points would lie closer to the curve";
  }
  if (runs_differ(fit, kChance)) {
    const RunTest& most = *std::min_element(fit.run_tests.begin(), fit.run_tests.end(),
                                            [](const auto& x, const auto& y) { return x.all.p_value < y.all.p_value; });
    return most.quantity + " differs between the runs (p = " + rounded(most.all.p_value, 2) + ")";
  }
  if (!fit.consistency) return {};
  const Consistency& tests = *fit.consistency;
  if (tests.chi2_p && *tests.chi2_p < kChance && moves_or_widens(0, std::sqrt(*tests.chi2_per_freedom)))
    return "the scatter is larger than the stated errors (chi^2 per degree of freedom " +
           rounded(*tests.chi2_per_freedom, 3) + "): check " + data.names_of_errors();
  if (is_far(tests.residuals))
    return "the points lie " + rounded(*tests.residuals.over_scatter, 2) +
           " times as far from the curve as neighbours scatter: the model or a constant is wrong";
  if (tests.residuals.shares_course)
    return "all runs leave the curve in the same way as T grows (F = " + rounded(*tests.residuals.course, 3) +
           "): the model or a constant is wrong";
  if (tests.residuals.together)
    return "whole runs lie above or below the curve (neighbours correlate by " + rounded(mean_correlation(fit), 2) +
           "): the runs differ, or the model or a constant is wrong";
  if (tests.residuals.ends_p < kChance)
    return "the ends of the runs lie off the curve (z = " + rounded(tests.residuals.ends, 2) +
           "): points past the onset of sliding?";
  if (tests.residuals.neighbours_correlate(kChance))
    return "residuals of neighbouring points resemble each other (correlation " +
           rounded(tests.residuals.correlation, 2) +
           "): the model or a constant is wrong, or the points are not independent (" + Remedy::set("bootstrap") +
           " with " + Remedy::set("resample", "curves") + ")";
  if (tests.residuals.trend_p < kChance)
    return "residuals follow a trend along the runs: the model or a constant is wrong";
  // The sizes and the memory of correlated noise are known poorly, and this test takes them as known.
  const bool correlate = fit.errors && fit.errors->correlations.any();
  if (fit.law && fit.law->p_value < (correlate ? kHardly : kChance) && fit.law->matters())
    return "the points follow another law: a smooth change of f(psi) would lower chi^2 by " +
           rounded(fit.law->fall, 3) + " (p = " + rounded(fit.law->p_value, 2) + ")";
  return {};
}

}  // namespace mixity
