#include "fitting/unsheared.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "dataset/pull_off.h"
#include "fitting/prepare.h"
#include "fitting/stated_constants.h"
#include "solver/prior.h"
#include "solver/solve.h"
#include "statistics/distributions.h"

namespace mixity {
namespace {

std::vector<std::size_t> unsheared_points(const Dataset& data) {
  const PointPlaces places(data);
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < data.points.size(); ++i)
    if (places.at(i).unsheared) list.push_back(i);
  return list;
}

/// The p-value of chi2. `of_errors`: degrees of freedom of the estimated errors; 0: they are known.
double beyond(double chi2, std::size_t freedom, double of_errors) {
  if (freedom == 0) return 1;
  const auto n = static_cast<double>(freedom);
  return of_errors > 0 ? fisher_p_value(chi2 / n, n, of_errors) : chi_squared_p_value(chi2, n);
}

/// Sum of the squared residuals at x, each limited to nine, so that no single point decides.
double chi_squared(const Problem& problem, std::span<const double> x) {
  constexpr double kMost = 9;
  std::vector<double> residuals(problem.residual_count());
  double sum = 0;
  if (!problem.evaluate(x, residuals, {})) return std::numeric_limits<double>::infinity();
  for (const double r : residuals) sum += std::min(r * r, kMost);
  return sum;
}

std::unique_ptr<ModelProblem> problem_of(const Dataset& data, const PreparedFit& prepared) {
  auto problem = make_problem(data, {}, prepared);
  problem->set_known_errors(true);  // as stated, or as neighbouring points scatter
  return problem;
}

}  // namespace

std::optional<UnshearedTest> test_unsheared(const Dataset& data, const FitOptions& options) {
  if (!data.has_loads || data.points.empty()) return std::nullopt;
  if (!data.pull_off.empty()) return test_unsheared(without_pull_off(data), options);
  const std::vector<std::size_t> points = unsheared_points(data);
  FitOptions as_stated;
  as_stated.sigma_T = options.sigma_T;
  as_stated.sigma_A = options.sigma_A;
  as_stated.errors = options.errors;
  as_stated.constants = constants_of(data, options);
  const double of_errors = options.errors ? options.errors->freedom : 0;
  const ContactModel any_model = ContactModel::find("c").value();  // without shear every law equals JKR
  PreparedFit prepared = prepare(data, any_model, as_stated, Objective::curve, &points);
  prepared.held.assign(prepared.held.size(), true);
  const auto stated = problem_of(data, prepared);
  std::vector<double> residuals(stated->residual_count());
  if (residuals.empty() || residuals.size() < points.size() || !stated->evaluate({}, residuals, {}))
    return std::nullopt;
  UnshearedTest test;
  std::set<double> loads;
  for (const std::size_t i : points) loads.insert(data.curve_loads[data.points[i].curve]);
  test.points = points.size();
  test.loads = loads.size();
  test.chi2 = chi_squared(*stated, {});
  // Uncertain constants may differ from their stated values: uses the minimum with their priors.
  if (const auto known = options.constants ? std::vector<FittedConstant>{} : uncertain_constants(data);
      !known.empty()) {
    prepared.fitted = known;
    const auto uncertain = problem_of(data, prepared);
    const Verdict verdict = solve_with_priors(*uncertain).verdict;
    if (verdict.status == FitStatus::ok) test.chi2 = chi_squared(ProblemWithPriors(*uncertain), verdict.best.x);
  }
  // loads that were measured beside a held approach have residuals of their own
  test.p_value = beyond(test.chi2, residuals.size(), of_errors);
  for (const Constant constant : {kModulus, kToughness, data.holds_approach() ? kApproachOffset : kLoadOffset}) {
    FitOptions freed = as_stated;
    freed.free = {constant};
    prepared.fitted = fitted_constants(data, freed);
    const auto problem = problem_of(data, prepared);
    const Verdict verdict = solve(*problem, {}, {});
    if (verdict.status != FitStatus::ok || !verdict.standard_errors[0]) continue;
    const FreeParameter& parameter = problem->parameters()[0];
    const double x = verdict.best.x[0], chi2 = chi_squared(*problem, verdict.best.x);
    test.implied.push_back({parameter.name, parameter.unit, parameter.shown((*as_stated.constants)[constant]),
                            parameter.shown(x), *verdict.standard_errors[0] * std::abs(parameter.shown_slope(x)), chi2,
                            beyond(chi2, residuals.size() - 1, of_errors)});
  }
  return test;
}

}  // namespace mixity
