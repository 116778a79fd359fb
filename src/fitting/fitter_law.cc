// Whether the points follow another law than the model's.
#include <cmath>

#include "fitting/curve_objective.h"
#include "fitting/fitter.h"
#include "fitting/run_differences.h"
#include "fitting/stated_constants.h"
#include "mechanics/measurement.h"
#include "solver/linear_algebra.h"
#include "statistics/distributions.h"

namespace mixity {
namespace {

/// B, B^2 with B = sin^2 psi, over d ln f/d parameter 0; 0 without shear.
Eigen::MatrixXd departures_over_parameter(const ContactModel& model, const ParameterValues& parameters,
                                          const std::vector<Mixity<double>>& at) {
  const std::size_t n = at.size(), p = model.parameters().size();
  std::vector<double> log_f(n), gradient(n * p);
  model.log_toughness(std::span<const double>(parameters.begin(), p), at, log_f, gradient);
  Eigen::MatrixXd ratio = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(n), 2);
  for (std::size_t i = 0; i < n; ++i) {
    const double B = at[i].sin * at[i].sin;
    if (B > 0 && gradient[i * p] != 0)
      ratio.row(static_cast<Eigen::Index>(i)) << B / gradient[i * p], B * B / gradient[i * p];
  }
  return ratio;
}

}  // namespace

/// To first order a residual depends on the law through ln f at the nearest place of the curve alone: its derivative
/// with another quantity of the law follows from that with the first parameter. Null for contacts other than circles
/// under a load, and where more than areas is fitted.
std::optional<Eigen::MatrixXd> Fitter::columns_of_law(const std::vector<double>& x, const RunRows& rows) const {
  const bool circles = !prepared_.model.is_elliptic() && !data_.holds_approach(),
             areas = problem_->residual_count() == prepared_.used.size();
  if (purpose_ != Purpose::shown || !circles || !areas || prepared_.held[0]) return std::nullopt;
  const auto nearest = static_cast<const CurveObjective&>(*problem_).nearest(x);
  if (!nearest) return std::nullopt;
  const Candidate at = problem_->candidate(x);
  const Scales scales(data_, at.constants);
  std::vector<Mixity<double>> places;
  for (std::size_t i = 0; i < nearest->T.size(); ++i) {
    const std::size_t point = prepared_.used[i];
    const ConstantsScale by = scales.of(point);
    const auto place =
        toughness_of_area(by.load(data_.points[point].P), by.shear(nearest->T[i]), by.true_area(nearest->A[i]));
    places.push_back(place ? place->mixity : Mixity<double>{1, 0});
  }
  Eigen::MatrixXd columns = departures_over_parameter(prepared_.model, at.parameters, places);
  columns.array().colwise() *= rows.bare.col(0).array();
  return columns.allFinite() ? std::optional(std::move(columns)) : std::nullopt;
}

/// `columns`: decorrelated like the rows. `freedom`: of errors whose size comes from the fit; null: known.
void Fitter::test_law(const RunRows& rows, const Eigen::MatrixXd& columns, std::optional<double> freedom) {
  constexpr double kLeast = 1e-8;  // of a direction that the parameters leave: rounding
  const Eigen::Index p = rows.J.cols(), n = columns.rows();
  const Eigen::VectorXd sizes = columns.colwise().norm();
  if (!(sizes.minCoeff() > 0)) return;
  const Eigen::MatrixXd Z = columns * sizes.cwiseInverse().asDiagonal(), H = rows.J.transpose() * rows.J,
                        both = rows.J.topRows(n).transpose() * Z, with = solve_columns(H, both),
                        S = Z.transpose() * Z - both.transpose() * with;
  const Eigen::VectorXd u = Z.transpose() * rows.r.head(n) - with.transpose() * (rows.J.transpose() * rows.r);
  const SquareAlong found = square_along(S, u, kLeast);
  const double q = found.directions;
  if (!(q > 0) || (freedom && !(*freedom > q))) return;
  const double p_value =
      freedom ? fisher_p_value(found.square / q, q, *freedom - q) : chi_squared_p_value(found.square, q);
  const double change = with.row(0) * solve_any(S, u),
               variance = solve_columns(H, Eigen::MatrixXd::Identity(p, p))(0, 0);
  result_.law = LawTest{found.square, p_value, change / std::sqrt(variance)};
}

}  // namespace mixity
