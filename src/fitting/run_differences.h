// Quantities that differ from run to run: the model's first parameter, or a constant of the experiment.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/threads.h"
#include "fitting/point_indices.h"
#include "fitting/prepare.h"
#include "solver/random_effects.h"

namespace mixity {

/// The used points of each run, as indices into the residuals; runs without points are left out.
struct UsedRuns {
  Groups groups;
  std::vector<std::size_t> runs;  // index into Dataset::curves of each
};
UsedRuns used_runs(const Dataset& data, const PointIndices& used);

/// The same for many points: needs no memory for them where the runs follow one another as they are numbered.
class PointsByRun {
 public:
  PointsByRun(const Dataset& data, const PointIndices& used);
  std::size_t runs() const { return runs_.size(); }
  std::size_t run(std::size_t g) const { return runs_[g]; }  // index into Dataset::curves
  std::size_t size(std::size_t g) const { return begins_[g + 1] - begins_[g]; }
  /// The k-th point of a run, as an index into `used`.
  std::size_t at(std::size_t g, std::size_t k) const {
    return order_.empty() ? begins_[g] + k : order_[begins_[g] + k];
  }
  /// Calls body(g) for each run; of many points, on several threads.
  template <class Body>
  void for_each_run(const Body& body) const {
    if (begins_.back() >= kManyPoints) return parallel_for(runs(), body);
    for (std::size_t g = 0; g < runs(); ++g) body(g);
  }

 private:
  std::vector<std::size_t> runs_, begins_;
  std::vector<std::uint32_t> order_;
};

/// The residuals of a fit linearised in its parameters and in quantities that may differ between runs.
struct RunRows {
  Eigen::MatrixXd J;       // rows of the data, then of the priors
  Eigen::VectorXd r;       // in the same order
  Eigen::MatrixXd Z, Zw;   // [data x quantities]: as the residuals are; decorrelated like J
  Eigen::MatrixXd bare{};  // J of the data as the residuals are
};
/// `x`: the solver's parameters in a fit with objective curve; `residuals`: its residuals minus the expected ones;
/// `quantities`: names of a model parameter or of constants; `unit`: standard error of a residual. Null where a value
/// is not finite.
std::optional<RunRows> run_rows(const Dataset& data, const FitOptions& options, const PreparedFit& prepared,
                                const std::vector<double>& x, const std::vector<double>& residuals,
                                const std::vector<std::string>& quantities, double unit);

/// The same for many points whose neighbours are independent: a few rows for each run with the same sums of squares and
/// products, one run after the other, so that no array has to hold those of all points. They do not depend on the
/// number of threads.
struct SummedRows {
  RunRows rows;  // without Z
  Groups groups;
};
std::optional<SummedRows> summed_run_rows(const Dataset& data, const FitOptions& options, const PreparedFit& prepared,
                                          const PointsByRun& points, const std::vector<double>& x,
                                          const std::vector<double>& residuals,
                                          const std::vector<std::string>& quantities, double unit);

/// Quantities tested for differences: the first fitted parameter, toughness, modulus, area_scale and load_offset.
std::vector<std::string> tested_quantities(const Dataset& data, const PreparedFit& prepared);

/// `freedom`: degrees of freedom of errors whose size comes from the fit (F test); null: chi^2 test.
RunTest run_test(const Dataset& data, const std::string& quantity, const GroupTest& test,
                 const std::vector<std::size_t>& runs, std::optional<double> freedom);

}  // namespace mixity
