// The batch engine's solver: one parameter, safeguarded Newton. For the many fits behind a scan, a bootstrap or a
// jackknife; the fit that is shown comes from Ceres (minimise.h), and tests hold the two together.
#pragma once

#include <optional>
#include <vector>

#include "fitting/minimise.h"
#include "fitting/single_cost.h"

namespace mixity {

struct SingleFit {
  FitStatus status = FitStatus::not_converged;  // as minimise() would judge, but for multimodal near one start
  double x = 0, sum_of_squares = 0;
  std::optional<double> standard_error;
  std::vector<double> others;  // further local minima, if the whole range was scanned
};

/// The lowest minimum in the range: the cost and its slope are scanned, and every minimum that the slopes bracket is
/// refined. `cost` is the problem's.
SingleFit solve_single(SingleCost& cost, const LeastSquares& problem);

/// The minimum that Newton's method reaches from `start`. `points`: how many carry weight.
SingleFit solve_single_near(SingleCost& cost, const FreeParameter& parameter, std::size_t points, double start,
                            std::span<const double> weights = {});

}  // namespace mixity
