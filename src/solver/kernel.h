// The kernel: Newton's method for one parameter and damped Gauss-Newton for several, on sums over the residuals. It
// makes the many fits of profiles, resampling and cross-validation. The reported fit comes from Ceres (descent.h);
// tests check that both agree.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "solver/options.h"
#include "solver/problem.h"
#include "solver/results.h"

namespace mixity {

/// Where a descent starts, and the box of the search grid around it, taken for its basin; empty: no box.
struct Start {
  std::vector<double> x, low{}, high{};
  bool in_bracket = false;  // for one parameter: the cost falls inwards at both ends of the box
};

/// A kernel serves one thread: it owns its scratch arrays. The problem must outlive it.
class Kernel {
 public:
  explicit Kernel(const Problem& problem, const SolverOptions& options = {});

  /// The minimum reached from `start`. Weights: one per residual; empty: 1. Parameter number `held`, if any, keeps its
  /// start value. Null if the cost is not finite there.
  std::optional<Minimum> descend(std::span<const double> start, std::span<const double> weights = {},
                                 std::optional<std::size_t> held = {});

  /// The same from a start found by a search. A single parameter in a bracket stays inside it; steps of several are at
  /// most as long as the box, which grows with the parameter.
  std::optional<Minimum> explore(const Start& start);

  /// The same with parameter number `held` fixed, until the next step would lower the cost by at most `decrease`. That
  /// step is not taken; cost and slope (in the held parameter) include it to first order. `next`: x after that step.
  struct Held {
    std::vector<double> x;
    double cost, slope;
    bool settled;
    std::vector<double> next;
  };
  std::optional<Held> descend_held(std::span<const double> start, std::size_t held, double decrease);

  /// Evaluates the cost at x into last().
  const CostValue& at(std::span<const double> x);
  /// Evaluates at x and saves the memory (Cost::keep) for restore().
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
  /// Newton's method between low and high, which are bounds or, if `known`, enclose a minimum.
  Minimum newton(double x, double low, double high, bool known, std::span<const double> weights);
  /// `reach`: the box that limits the steps, or null.
  Minimum gauss_newton(std::vector<double> x, std::span<const double> weights, std::optional<std::size_t> held,
                       const Start* reach);
  /// Whether the step from x is longer than the box.
  bool too_long(const std::vector<double>& x, const Start& reach) const;
  /// `change`: of the gradient by a step. Where it is much more than Gauss-Newton's curvature tells, which neglects
  /// that of the residuals, steps swing about the minimum: the next one has the secant's curvature along this one
  /// (Dennis & Schnabel 1983, Numerical Methods for Unconstrained Optimization, 10.3), and true is returned.
  bool add_curvature(const Eigen::VectorXd& step, const Eigen::VectorXd& change);
  /// Sets the damped step of the open parameters; returns half of the decrease of the cost that it predicts.
  double find_step(double damping);
  /// Finds the parameters that can move from x; returns the largest of their relative gradients.
  double stationarity(const std::vector<double>& x, std::optional<std::size_t> held);

  const Problem& problem_;
  SolverOptions options_;
  std::unique_ptr<Cost> cost_;
  CostValue here_, there_;
  double first_ = 0, rounding_;     // rounding error of |r|
  std::vector<Eigen::Index> open_;  // parameters that can move
  Eigen::VectorXd step_;            // of the open parameters
  Eigen::VectorXd along_;           // the curvature times the last step
  double secant_ = 0;               // times along_ along_', added to the curvature
  double enough_ = 0;               // steps that lower the cost by less are not taken
};

}  // namespace mixity
