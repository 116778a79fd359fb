// The kernel: Newton's method for one parameter, damped Gauss-Newton for several, on sums over the residuals. For the
// many fits behind profiles, resampling and loads left out; the fit that is shown comes from Ceres (descent.h), and
// tests hold the two together.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "solver/options.h"
#include "solver/problem.h"
#include "solver/results.h"

namespace mixity {

/// A value to descend from, and the box of a grid that its basin fills as far as a search can tell: a minimum known
/// inside is that basin's. Without a box (empty) nothing is known of it.
struct Start {
  std::vector<double> x, low{}, high{};
  bool in_bracket = false;  // of one parameter: at both ends of the box the cost falls inwards
};

/// One for each thread: it owns its scratch arrays. The problem must outlive it.
class Kernel {
 public:
  explicit Kernel(const Problem& problem, const SolverOptions& options = {});

  /// The minimum reached from `start`. Weights: one per residual, or empty: 1. Parameter number `held`, if any, stays
  /// where it starts. Null if the cost is not finite there.
  std::optional<Minimum> descend(std::span<const double> start, std::span<const double> weights = {},
                                 std::optional<std::size_t> held = {});

  /// The same from what a search found: of one parameter in a bracket not beyond its ends; of several in steps that are
  /// no longer than the box, which grows as the parameter does.
  std::optional<Minimum> explore(const Start& start);

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
  /// Learns what serves near x; restore() forgets all that was learnt later.
  void keep(std::span<const double> x) {
    at(x);
    cost_->keep();
  }
  void restore() { cost_->restore(); }
  /// The cost where the last descent started.
  double first_cost() const { return first_; }
  /// The cost at the end of the last descent.
  const CostValue& last() const { return here_; }
  bool exact_curvature() const { return cost_->exact_curvature(); }

 private:
  /// Evaluates the cost where a descent starts. False if it is not finite.
  bool begin(std::span<const double> x, std::span<const double> weights);
  /// Not beyond low and high: `known` to be beyond a minimum, or bounds.
  Minimum newton(double x, double low, double high, bool known, std::span<const double> weights);
  /// `reach`: null, or what limits the steps.
  Minimum gauss_newton(std::vector<double> x, std::span<const double> weights, std::optional<std::size_t> held,
                       const Start* reach);
  /// Whether the step from x is longer than the box.
  bool too_long(const std::vector<double>& x, const Start& reach) const;
  /// The damped step of the open parameters, and half of what it lowers the cost by.
  double find_step(double damping);
  /// Which parameters may move from x, and how far from zero their gradient is.
  double stationarity(const std::vector<double>& x, std::optional<std::size_t> held);

  const Problem& problem_;
  SolverOptions options_;
  std::unique_ptr<Cost> cost_;
  CostValue here_, there_;
  double first_ = 0, rounding_;     // that of |r|
  std::vector<Eigen::Index> open_;  // parameters that may move
  Eigen::VectorXd step_;            // of these
  double enough_ = 0;               // a decrease of the cost that is not worth a step
};

}  // namespace mixity
