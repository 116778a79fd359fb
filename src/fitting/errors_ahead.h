// Where rounds that estimate the errors at the fit, and fit with these errors, lead.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "fitting/error_model.h"

namespace mixity {

/// Rounds come nearer to the errors at which they end by a constant factor, often by only a half. The combination of
/// the last two with the least change is as near as many further ones (Anderson 1965, J. ACM 12, 547; Walker & Ni 2011,
/// SIAM J. Numer. Anal. 49, 1715). Of more than two the rounding of the likelihood's maxima would decide.
class ErrorsAhead {
 public:
  /// The errors to begin the next round with. `from`: those with which the last round began; `to`: those it found.
  ErrorModels next(const ErrorModels& from, const ErrorModels& to);

 private:
  struct Round {
    Eigen::VectorXd found, change;  // logarithms of sizes; inverse hyperbolic tangents of correlations
  };
  std::optional<Round> last_;
};

}  // namespace mixity
