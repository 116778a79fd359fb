// Profile likelihood intervals of a fitted parameter, each end with its own status.
#pragma once

#include <limits>
#include <vector>

#include "solver/kernel.h"
#include "solver/results.h"

namespace mixity {

/// Ends in the solver's numbers (FreeParameter::shown converts them).
struct Interval {
  double confidence;
  double low, high;  // meaningless where open
  EndStatus low_status, high_status;
  /// All parameters at a cost lower than the supposed minimum, if the search found one; else empty.
  std::vector<double> deeper{};
};

/// The rise of the cost at which a value of one parameter is rejected: chi^2(1) if the standard errors are known, else
/// F(1, n - p) times the variance from the scatter. 0 < confidence < 1, n > p. `freedom`: that of the parameter's
/// variance, if lower.
double cost_allowance(double confidence, double sum_of_squares, std::size_t n, std::size_t p, bool known_errors,
                      double freedom = std::numeric_limits<double>::infinity());

/// The profile along one parameter: the cost minimised over the others.
class Profile {
 public:
  struct Value {
    double cost, slope;   // derivative in that parameter, to which the others do not contribute at the minimum
    bool settled = true;  // the minimum over the others was reached
  };

  /// `decrease`: tolerated excess of the cost over the minimum over the others; it is corrected to first order.
  Profile(const Problem& problem, const Minimum& best, double decrease, const SolverOptions& options = {});
  /// Restarts at the minimum, along parameter k; call it for each side of an interval.
  void begin(std::size_t k);
  /// Null if no finite cost was found. `share`: factor on `decrease`.
  std::optional<Value> operator()(double value, double share = 1);
  /// The same from these parameters, a minimum over the others at another value. Null unless the cost is below `above`.
  std::optional<Value> from(const std::vector<double>& x, double value, double above);
  /// How far from the minimum the parabola with its slope and curvature along parameter k has risen by that; not a
  /// positive number where it does not rise.
  double reach(std::size_t k, double rise);
  /// All parameters at the minimum found last.
  const std::vector<double>& point() const { return x_; }
  /// The cost there with its derivatives, if there are several parameters.
  const CostValue& cost() const { return last_.cost; }

 private:
  /// A minimum over the others, with the cost and its derivatives.
  struct Anchor {
    std::vector<double> x;
    CostValue cost;
  };
  /// The parameters beside k that can move from x and matter there.
  std::vector<Eigen::Index> others(std::size_t k, const std::vector<double>& x, const CostValue& cost) const;
  /// The others to first order from the anchor; not finite where they cannot be solved for.
  std::vector<double> along_tangent(const Anchor& anchor, double value) const;
  /// The others by interpolation between the nearest minima; the tangent's if that is not clearly better.
  std::vector<double> predicted(const Anchor& anchor, double value) const;
  std::optional<Kernel::Held> descend_from(const Anchor& anchor, double value, double decrease);
  Value take(const Kernel::Held& minimum, Anchor here);

  const Problem& problem_;
  std::size_t k_ = 0;
  double decrease_;
  Kernel kernel_;
  std::vector<double> x_;
  Anchor best_, last_;
  std::vector<std::vector<double>> found_;  // minima along parameter k
};

/// For each parameter the values between which the cost, minimised over the others, rises by at most `allowance`. An
/// end is `at_bound` if the bound is inside the interval, and `open` if a parameter with a start reaches its bound, or
/// the cost becomes infinite before it has risen. Ends are accurate to 1e-9 of their distance from the minimum.
std::vector<Interval> profile_intervals(const Problem& problem, const Minimum& best, double confidence,
                                        double allowance, const std::vector<std::optional<double>>& standard_errors,
                                        const Progress& progress = {}, const SolverOptions& options = {});

/// About `count` points from low to high, including the best; points without a finite cost are left out.
DrawnProfile draw_profile(const Problem& problem, const Minimum& best, std::size_t k, double low, double high,
                          std::size_t count, double allowance, double variance, const SolverOptions& options = {});

}  // namespace mixity
