// The kernel: Newton's method for one parameter, damped Gauss-Newton for several, on sums over the residuals. For the
// many fits behind profiles, resampling and loads left out; the fit that is shown comes from Ceres (descent.h), and
// tests hold the two together.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "solver/results.h"
#include "solver/options.h"
#include "solver/problem.h"

namespace mixity {

/// One for each thread: it owns its scratch arrays. The problem must outlive it.
class Kernel {
 public:
  explicit Kernel(const Problem& problem, const SolverOptions& options = {});

  /// The minimum reached from `start`. Weights: one per residual, or empty: 1. Parameter number `held`, if any, stays
  /// where it starts. Null if the cost is not finite there.
  std::optional<Minimum> descend(std::span<const double> start, std::span<const double> weights = {},
                                 std::optional<std::size_t> held = {});

  /// The same for the only parameter from x, and not beyond low and high, where the cost falls inwards.
  std::optional<Minimum> descend_within(double low, double x, double high);

  /// The same with parameter number `held` at its start, to where the next step would lower the cost by `decrease` at
  /// most: the cost and its slope in that parameter are those behind that step, to first order.
  struct Held {
    std::vector<double> x;
    double cost, slope;
    bool settled;
  };
  std::optional<Held> descend_held(std::span<const double> start, std::size_t held, double decrease);

  /// Evaluates the cost at x, too, into last().
  const CostValue& at(std::span<const double> x);
  /// The cost where the last descent started.
  double first_cost() const { return first_; }
  /// The cost at the end of the last descent.
  const CostValue& last() const { return here_; }
  bool exact_curvature() const { return cost_->exact_curvature(); }

 private:
  /// Not beyond low and high: `known` to be beyond a minimum, or bounds.
  Minimum newton(double x, double low, double high, bool known, std::span<const double> weights);
  Minimum gauss_newton(std::vector<double> x, std::span<const double> weights, std::optional<std::size_t> held);
  /// The damped step of the open parameters, and half of what it lowers the cost by.
  double find_step(double damping);
  /// Which parameters may move from x, and how far from zero their gradient is.
  double stationarity(const std::vector<double>& x, std::optional<std::size_t> held);

  const Problem& problem_;
  SolverOptions options_;
  std::unique_ptr<Cost> cost_;
  CostValue here_, there_;
  double first_ = 0, rounding_;  // that of |r|
  std::vector<Eigen::Index> open_;  // parameters that may move
  Eigen::VectorXd step_;            // of these
  double enough_ = 0;               // a decrease of the cost that is not worth a step
};

}  // namespace mixity
