// The sizes of the errors of axes and pull-off loads, and what uncertain estimates of errors add to the uncertainty of
// the parameters.
#include <algorithm>
#include <array>
#include <cmath>

#include "fitting/curve_objective.h"
#include "fitting/error_model.h"
#include "fitting/fitter.h"
#include "solver/descent.h"

namespace mixity {
namespace {

/// Covariances of the logarithms of the variances of T and of A, from the residuals of a fit; 0 for known ones. A
/// residual has the variance load_T^2 + load_A^2 = 1, so each independent square contributes half the products of these
/// parts to the information (Davidian & Carroll 1987, J. Am. Stat. Assoc. 82, 1079).
Eigen::Matrix2d covariance_of_sizes(const StandardErrors& errors, const PointIndices& used, bool T, bool A) {
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  const Eigen::Vector2d independent{std::sqrt(independence(errors.correlations.second)),
                                    std::sqrt(independence(errors.correlations.first))};
  for (const std::size_t i : used) {
    const Eigen::Vector2d part{std::pow(errors.load_T[i], 2), std::pow(errors.load_A[i], 2)};
    const Eigen::Vector2d counted = part.cwiseProduct(independent);
    information += 0.5 * counted * counted.transpose();
  }
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  if (T && A) {
    const double determinant = information(0, 0) * information(1, 1) - information(0, 1) * information(0, 1);
    if (determinant > 1e-9 * information(0, 0) * information(1, 1))
      covariance << information(1, 1) / determinant, -information(0, 1) / determinant, -information(0, 1) / determinant,
          information(0, 0) / determinant;
  } else if (T && information(0, 0) > 0) {
    covariance(0, 0) = 1 / information(0, 0);
  } else if (A && information(1, 1) > 0) {
    covariance(1, 1) = 1 / information(1, 1);
  }
  // The effect is linearised: beyond a factor of two in a variance, and where an axis hardly acts, it would be far too
  // large.
  constexpr double kMost = 0.7;
  for (const Eigen::Index axis : {0, 1})
    if (const double sd = std::sqrt(covariance(axis, axis)); sd > kMost) {
      covariance.row(axis) *= kMost / sd;
      covariance.col(axis) *= kMost / sd;
    }
  return covariance;
}

}  // namespace

/// The share of the expected distances that is subtracted from the residuals (take_expected_off).
std::optional<double> Fitter::share_taken_off(const std::vector<double>& x) const {
  const auto& objective = static_cast<const CurveObjective&>(*problem_);
  const auto nearest = objective.nearest(x);
  const auto expected = nearest ? objective.expected(x, *nearest) : std::nullopt;
  if (!expected) return std::nullopt;
  double product = 0, square = 0;
  for (std::size_t k = 0; k < expected->size(); ++k) {
    product += prepared_.errors->expected[prepared_.used[k]] * (*expected)[k];
    square += (*expected)[k] * (*expected)[k];
  }
  return square > 0 ? product / square : 0;
}

/// The parameters when the variance of one axis is larger by exp(step), including its effect on the expected distances.
/// `taken`: the share of these that is subtracted from the residuals. Empty if not found.
std::vector<double> Fitter::with_other_size(const std::vector<double>& x, bool of_T, double step, double taken) const {
  PreparedFit other = prepared_;
  other.errors = std::make_shared<StandardErrors>(*prepared_.errors);
  for (double& one : of_T ? other.errors->T : other.errors->A) one *= std::exp(step / 2);
  other.errors->expected.clear();
  const auto problem = make_problem(data_, options_, other);
  const auto& changed = static_cast<const CurveObjective&>(*problem);
  const auto after = changed.nearest(x);
  const auto then = after ? changed.expected(x, *after) : std::nullopt;
  if (!then) return {};
  other.errors->expected.assign(data_.points.size(), 0.0);
  for (std::size_t k = 0; k < then->size(); ++k) other.errors->expected[prepared_.used[k]] = taken * (*then)[k];
  SolverOptions quick;
  quick.engine = Engine::kernel;
  quick.last_digits = false;
  const auto with = make_problem(data_, options_, other);
  const auto minimum = descend(ProblemWithPriors(*with), x, quick);
  return minimum ? minimum->x : std::vector<double>();
}

/// Autocorrelated noise determines its own size poorly, and the distances expected from curvature depend on it. Adds
/// this uncertainty to errors and intervals.
void Fitter::widen_by_sizes_of_errors(const std::vector<double>& x) {
  constexpr double kStep = 0.1;
  const auto& errors = prepared_.errors;
  if (purpose_ != Purpose::shown || !errors || !errors->correlations.any() || errors->expected.empty() ||
      errors->load_A.empty() || prepared_.objective != Objective::curve)
    return;
  const auto scatter = [](ErrorSource source) { return source == ErrorSource::scatter; };
  const std::array<bool, 2> unknown_size{scatter(errors->source_T), scatter(errors->source_A)};
  if (!unknown_size[0] && !unknown_size[1]) return;
  const Eigen::Matrix2d covariance = covariance_of_sizes(*errors, prepared_.used, unknown_size[0], unknown_size[1]);
  const std::optional<double> taken = share_taken_off(x);
  if (!taken) return;
  std::array<std::vector<double>, 2> moved;
  for (const std::size_t axis : {0U, 1U}) {
    if (!unknown_size[axis]) continue;
    moved[axis] = with_other_size(x, axis == 0, kStep, *taken);
    if (moved[axis].empty()) return;
  }
  std::size_t k = 0;
  for (FittedParameter& one : result_.parameters) {
    if (one.held) continue;
    const std::size_t here = k++;
    if (!one.stderr_ || !one.value || one.at_bound || !(*one.stderr_ > 0)) continue;
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();
    for (const std::size_t axis : {0U, 1U})
      if (unknown_size[axis]) slope[axis] = (moved[axis][here] - x[here]) / kStep;
    slope *= problem_->parameters()[here].shown_slope(x[here]);
    const double factor = std::sqrt(1 + slope.dot(covariance * slope) / (*one.stderr_ * *one.stderr_));
    if (!std::isfinite(factor)) continue;
    *one.stderr_ *= factor;
    if (!one.interval) continue;
    if (one.interval->low)
      *one.interval->low = std::max(*one.value - factor * (*one.value - *one.interval->low), one.lower);
    if (one.interval->high)
      *one.interval->high = std::min(*one.value + factor * (*one.interval->high - *one.value), one.upper);
  }
}

/// Where only the ratios of stated errors are known, scales them to the residuals. Returns the change of the logarithm
/// of their factor.
double Fitter::size_stated_errors(NearestPlaces& nearest, double freedom) {
  StandardErrors& errors = *prepared_.errors;
  double squares = 0;
  for (const double r : nearest.residuals) squares += r * r;
  const double change = std::sqrt(squares / freedom);
  if (!errors.factor_is_free || !(freedom > 0 && change > 0)) return 0;
  errors.factor *= change;
  for (auto* const list : {&errors.T, &errors.A})
    for (double& one : *list) one *= change;
  for (auto* const model : {&errors.model_T, &errors.model_A})
    if (*model) *model = ErrorModel{(*model)->constant * change, (*model)->share * change};
  for (double& one : nearest.residuals) one /= change;
  return std::log(change);
}

/// Sets the factor on the relative errors of A that those of the axes have. Returns the change of its logarithm.
double Fitter::size_axes(const NearestPlaces& nearest) {
  if (nearest.axes.empty() || beside(data_)[prepared_.used[0]].sigma_q > 0) return 0;
  double squares = 0;
  for (const double r : nearest.axes) squares += r * r;
  // the axes' residuals determine about one parameter, the second coupling
  const double freedom = std::max(static_cast<double>(nearest.axes.size()) - 1, 1.0),
               before = prepared_.errors->axes_factor;
  // those of round contacts may all be equal: the error would fall to 0 round by round
  const double found = std::max(before * std::sqrt(squares / freedom), kLeastError);
  prepared_.errors->axes_factor = found;
  return std::log(found / before);
}

/// Sets the standard error of pull-off loads that state none. Returns the change of its logarithm.
double Fitter::size_pull_off(const NearestPlaces& nearest) {
  double squares = 0, count = 0;
  for (std::size_t i = 0; i < nearest.pull_off.size(); ++i) {
    if (data_.pull_off[i].sigma_P >= 0) continue;
    squares += nearest.pull_off[i] * nearest.pull_off[i];
    ++count;
  }
  // they determine about one parameter
  const double change = count > 0 ? std::sqrt(squares / std::max(count - 1, 1.0)) : 0;
  if (!(change > 0)) return 0;
  prepared_.errors->pull_off *= change;
  return std::log(change);
}

}  // namespace mixity
