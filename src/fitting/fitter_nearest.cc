// What a round of fitter_errors.cc knows of the points at a fit: their nearest places and leverages, and the errors
// that these make likely.
#include <algorithm>
#include <cmath>

#include "base/threads.h"
#include "fitting/curve_objective.h"
#include "fitting/fitted_errors.h"
#include "fitting/fitter.h"
#include "solver/linear_algebra.h"
#include "solver/problem.h"

namespace mixity {

/// The nearest places, and the leverages of the data's residuals. Null where they are not defined. `lean`: the places
/// may take the memory of those in the errors.
std::optional<NearestPlaces> Fitter::nearest_and_leverages(const std::vector<double>& x, std::vector<double>& leverage,
                                                           bool lean) const {
  constexpr std::size_t kPart = 1 << 15;
  const std::size_t n = prepared_.used.size(), rows = problem_->residual_count(), p = x.size();
  std::vector<double> jacobian(rows * p);
  const auto& objective = static_cast<const CurveObjective&>(*problem_);
  NearestPlaces from;
  if (lean && prepared_.used.are_all(data_.points.size()) && !objective.has_places()) {
    from.T = std::move(prepared_.errors->place_T);
    from.A = std::move(prepared_.errors->place_A);
  }
  auto nearest = objective.nearest(x, jacobian, std::move(from));
  if (!nearest || x.empty()) {
    leverage.assign(n, 0.0);
    return nearest;
  }
  std::vector<double> weights;  // of the priors, 0 without one
  for (const FreeParameter& one : problem_->parameters()) weights.push_back(one.prior > 0 ? 1 / one.prior : 0);
  const auto J = as_matrix(jacobian, p);
  if (n < kManyPoints) {
    Eigen::MatrixXd all(J.rows() + J.cols(), J.cols());
    all << J, Eigen::MatrixXd(as_vector(weights).asDiagonal());
    const Eigen::VectorXd found = leverages(std::move(all));
    leverage.assign(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(n));
    return nearest;
  }
  const auto rows_of = [&](std::size_t part) {
    return J.middleRows(static_cast<Eigen::Index>(part * kPart),
                        static_cast<Eigen::Index>(std::min(kPart, n - part * kPart)));
  };
  std::vector<Eigen::MatrixXd> products((n + kPart - 1) / kPart);  // sums of fixed parts do not depend on the threads
  parallel_for(products.size(), [&](std::size_t part) { products[part] = rows_of(part).transpose() * rows_of(part); });
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(J.cols(), J.cols());
  for (const Eigen::MatrixXd& one : products) H += one;
  H.diagonal() += as_vector(weights).cwiseAbs2();
  const Eigen::MatrixXd inverse = solve_columns(H, Eigen::MatrixXd::Identity(H.rows(), H.cols()));
  if (!inverse.allFinite()) return std::nullopt;
  if (p == 1) {  // in place
    leverage = std::move(jacobian);
    parallel_for(products.size(), [&](std::size_t part) {
      for (std::size_t i = part * kPart; i < std::min(n, (part + 1) * kPart); ++i)
        leverage[i] *= inverse(0, 0) * leverage[i];
    });
    return nearest;
  }
  leverage.resize(n);
  parallel_for(products.size(), [&](std::size_t part) {
    const Eigen::VectorXd found = (rows_of(part) * inverse).cwiseProduct(rows_of(part)).rowwise().sum();
    std::copy(found.begin(), found.end(), leverage.begin() + static_cast<std::ptrdiff_t>(part * kPart));
  });
  return nearest;
}

std::optional<ErrorModels> Fitter::estimated_errors(const NearestPlaces& nearest, const std::vector<double>& leverage,
                                                    const ErrorModels& before, Stage stage,
                                                    const std::vector<std::vector<double>>& own) const {
  constexpr double kLeast = 1e-9;      // of the largest reading: below any noise
  constexpr std::size_t kFewest = 12;  // points needed to distinguish the parts of their errors
  const PointIndices& used = prepared_.used;
  const StandardErrors& errors = *prepared_.errors;
  const bool all = used.size() == errors.T.size();
  const std::vector<double> some_T = all ? std::vector<double>() : of_points(errors.T, used),
                            some_A = all ? std::vector<double>() : of_points(errors.A, used);
  const std::vector<double>&sigma_T = all ? errors.T : some_T, &sigma_A = all ? errors.A : some_A;
  double T = 0, A = 0;
  for (const std::size_t i : used) {
    T = std::max(T, data_.points[i].shear());
    A = std::max(A, data_.points[i].A);
  }
  const bool few = used.size() < kFewest;
  const auto known = [&](ErrorSource source) {
    return few || StandardErrors::is_known(source) || source == ErrorSource::assumed;
  };
  const auto rounding = [](double step) { return step / std::sqrt(12.0); };
  return estimate_errors(data_, used, nearest, leverage,
                         {sigma_T, known(errors.source_T), std::max(kLeastError * T, rounding(errors.step_T))},
                         {sigma_A, known(errors.source_A), std::max(kLeast * A, rounding(errors.step_A))}, before,
                         stage, own, !independent_);
}

}  // namespace mixity
