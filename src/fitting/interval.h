// Confidence intervals of a fitted parameter, each end with its own validity.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "fitting/minimise.h"
#include "fitting/single_cost.h"

namespace mixity {

enum class EndStatus { found, at_bound, open };
std::string_view to_string(EndStatus status);

/// Ends as the solver counts (FreeParameter::shown makes them a reader's).
struct Interval {
  double confidence;
  double low, high;  // meaningless where open
  EndStatus low_status, high_status;
  std::vector<double>
      deeper{};  // all parameters where the cost turned out lower than at the minimum, which then is none
};

/// How much the cost may rise above its minimum before a value of one parameter is rejected: chi^2(1) where the
/// standard errors are known, else F(1, n - p) times the variance that the scatter shows.
double cost_allowance(double confidence, double sum_of_squares, std::size_t n, std::size_t p, bool known_errors);

/// Profile likelihood: the values of parameter k up to which the cost, minimised over the others, stays within
/// `allowance` of the minimum. An end is `at_bound` where the cost is still within it at the parameter's bound, and
/// `open` where a correction's range ends first or the cost, still within it, stops being finite. Ends to 1e-8 of the
/// distance, mostly far better.
Interval profile_interval(const LeastSquares& problem, const Minimum& best, std::size_t k, double confidence,
                          double allowance, std::optional<double> standard_error);

/// The same for a problem with one free parameter: `sum_of_squares` at its minimum x, |r| known to `rounding`.
Interval profile_interval(SingleCost& cost, const FreeParameter& parameter, double x, double sum_of_squares,
                          double confidence, double allowance, double rounding = 0);

/// The cost profiled along parameter k: minimised over the others, from the best known values of those.
class Profile {
 public:
  Profile(const LeastSquares& problem, const Minimum& best, std::size_t k);
  /// Null if no finite cost was found.
  std::optional<double> operator()(double value);
  /// All parameters at the minimum last found.
  std::vector<double> place() const;

 private:
  const LeastSquares& problem_;
  std::size_t k_;
  double value_ = 0;
  std::vector<double> others_;  // where the last minimum lay
};

/// The profile for drawing: how far the cost lies above its minimum, in units of the errors' variance (known, or as the
/// scatter shows it), so that it is ((x - best)/standard error)^2 for a parabola.
struct DrawnProfile {
  std::vector<std::pair<double, double>> points;  // x as the solver counts, rise; x rising
  double level = 0;                               // the rise at an interval's end: allowance/variance
};

/// About `count` points from low to high, best among them; those without a finite cost are left out.
DrawnProfile draw_profile(const LeastSquares& problem, const Minimum& best, std::size_t k, double low, double high,
                          std::size_t count, double allowance, double variance);

}  // namespace mixity
