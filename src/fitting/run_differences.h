// What differs from run to run: the model's first parameter, or a constant of the experiment.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fitting/prepare.h"
#include "solver/random_effects.h"

namespace mixity {

/// The used points of each run, as indices of the residuals; runs without any are left out.
struct UsedRuns {
  Groups groups;
  std::vector<std::size_t> runs;  // index into Dataset::curves of each
};
UsedRuns used_runs(const Dataset& data, std::span<const std::size_t> used);

/// The residuals of a fit linearised in its parameters and in quantities that may differ between runs.
struct RunRows {
  Eigen::MatrixXd J;      // rows of the data, then of the priors
  Eigen::VectorXd r;      // the same
  Eigen::MatrixXd Z, Zw;  // [data x quantities]: as the residuals are, and made independent of neighbours as J is
};
/// `x`: the solver's parameters of a fit of objective curve; `residuals`: of its points, less what is expected;
/// `quantities`: names of a model parameter or of constants; `unit`: standard error of a residual. Null where a value
/// is not finite.
std::optional<RunRows> run_rows(const Dataset& data, const FitOptions& options, const PreparedFit& prepared,
                                const std::vector<double>& x, const std::vector<double>& residuals,
                                const std::vector<std::string>& quantities, double unit);

/// The same of many points whose neighbours are independent: of each run a few rows with the same sums of squares and
/// products, one run after the other, so that no array has to hold those of all points.
struct SummedRows {
  RunRows rows;  // without Z
  Groups groups;
};
std::optional<SummedRows> summed_run_rows(const Dataset& data, const FitOptions& options, const PreparedFit& prepared,
                                          const std::vector<double>& x, const std::vector<double>& residuals,
                                          const std::vector<std::string>& quantities, double unit);

/// Quantities that are tested for differences: the first parameter that is fitted and toughness, modulus, area_scale
/// and load_offset.
std::vector<std::string> tested_quantities(const Dataset& data, const PreparedFit& prepared);

/// `freedom`: of errors whose size comes from the fit: F; null: chi^2.
RunTest run_test(const Dataset& data, const std::string& quantity, const GroupTest& test,
                 const std::vector<std::size_t>& runs, std::optional<double> freedom);

}  // namespace mixity
