// Profile likelihood intervals of a fitted parameter, each end with its own validity.
#pragma once

#include <vector>

#include "solver/kernel.h"
#include "solver/results.h"

namespace mixity {

/// Ends as the solver counts (FreeParameter::shown makes them a reader's).
struct Interval {
  double confidence;
  double low, high;  // meaningless where open
  EndStatus low_status, high_status;
  /// All parameters where the cost turned out lower than at the minimum, which then is none; else empty.
  std::vector<double> deeper{};
};

/// How much the cost may rise above its minimum before a value of one parameter is rejected: chi^2(1) where the
/// standard errors are known, else F(1, n - p) times the variance that the scatter shows. 0 < confidence < 1, n > p.
double cost_allowance(double confidence, double sum_of_squares, std::size_t n, std::size_t p, bool known_errors);

/// The cost profiled along one parameter: minimised over the others, from the best known values of those.
class Profile {
 public:
  struct Value {
    double cost, slope;  // slope in that parameter: the others move none of it where they are at their best
  };

  /// `decrease`: how far above the others' minimum the cost may be where first order is enough to tell it.
  Profile(const Problem& problem, const Minimum& best, double decrease, const SolverOptions& options = {});
  /// Begins anew, at the minimum, along parameter k: each side of an interval does.
  void begin(std::size_t k);
  /// Null if no finite cost was found. `share`: of the decrease, how much more or less is enough here.
  std::optional<Value> operator()(double value, double share = 1);
  /// All parameters at the minimum last found.
  const std::vector<double>& point() const { return x_; }
  /// Of several parameters: the cost there with its derivatives.
  const CostValue& cost() const { return last_.cost; }

 private:
  /// A minimum over the others, and the cost there with its derivatives.
  struct Anchor {
    std::vector<double> x;
    CostValue cost;
  };
  std::optional<Kernel::Held> descend_from(const Anchor& anchor, double value, double decrease);

  const Problem& problem_;
  std::size_t k_ = 0;
  double decrease_;
  Kernel kernel_;
  std::vector<double> x_;
  Anchor best_, last_;
};

/// The values of parameter k up to which the cost, minimised over the others, stays within `allowance` of the minimum.
/// An end is `at_bound` where the cost is still within it at the parameter's bound, and `open` where a merely wide
/// range ends first or the cost, still within it, stops being finite. Ends to 1e-9 of the distance, mostly far better.
Interval profile_interval(const Problem& problem, const Minimum& best, std::size_t k, double confidence,
                          double allowance, std::optional<double> standard_error, const SolverOptions& options = {});

/// Of each parameter.
std::vector<Interval> profile_intervals(const Problem& problem, const Minimum& best, double confidence,
                                        double allowance, const std::vector<std::optional<double>>& standard_errors,
                                        const Progress& progress = {}, const SolverOptions& options = {});

/// About `count` points from low to high, best among them; those without a finite cost are left out.
DrawnProfile draw_profile(const Problem& problem, const Minimum& best, std::size_t k, double low, double high,
                          std::size_t count, double allowance, double variance, const SolverOptions& options = {});

}  // namespace mixity
