// What a contact that is not circular would explain where neighbours correlate.
#include "fitting/causes.h"
#include "fitting/curve_objective.h"
#include "fitting/fitter.h"
#include "fitting/run_differences.h"
#include "fitting/whitening.h"
#include "solver/linear_algebra.h"

namespace mixity {

/// The misfit with independent errors of the present sizes and a free shape, both linearised. Priors are left out, so
/// that it is rather too small.
void Fitter::expect_shape(const std::vector<double>& x) {
  const StandardErrors& errors = *prepared_.errors;
  const bool curves = prepared_.objective == Objective::curve && data_.has_loads;
  const bool alone = problem_->residual_count() == prepared_.used.size();  // no rows of axes or pull-off loads
  if (!curves || !alone || !errors.correlations.any() || errors.runs.any()) return;
  std::vector<double> innovations(problem_->residual_count()), residuals;
  if (!static_cast<const CurveObjective&>(*problem_).evaluate_both(x, innovations, residuals)) return;
  const auto rows = run_rows(data_, options_, prepared_, x, residuals, {std::string(kConstantNames[kShape])}, 1);
  if (!rows) return;
  const Eigen::MatrixXd &J = rows->bare, &Z = rows->Z;
  const auto r = as_vector(residuals);
  const Eigen::Index p = J.cols();
  Eigen::MatrixXd H(p + 1, p + 1);
  H << J.transpose() * J, J.transpose() * Z, Z.transpose() * J, Z.transpose() * Z;
  Eigen::VectorXd gradient(p + 1);
  gradient << J.transpose() * r, Z.transpose() * r;
  const double squares = r.squaredNorm() - gradient.dot(solve_symmetric(H, gradient));
  const auto whitening = whitening_of(data_, prepared_.used, errors);
  const double log_variances = result_.log_variances - (whitening ? whitening->log_determinant() : 0);
  result_.shape_instead_of_memory = misfit(squares, log_variances, prepared_.used.size(), problem_->known_errors());
}

}  // namespace mixity
