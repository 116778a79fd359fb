// Results of the solver, as plain numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/enum_names.h"

namespace mixity {

/// suspect: a minimum was found, but a test shows that its interval is not reliable; no such test is in the solver.
enum class FitStatus { ok, suspect, at_bound, not_identifiable, multimodal, not_converged };
constexpr std::string_view to_string(FitStatus status) {
  constexpr std::string_view kNames[] = {"ok",         "suspect",      "at_bound", "not_identifiable",
                                         "multimodal", "not_converged"};
  return name_among(kNames, status);
}

/// Where a descent ended.
struct Minimum {
  std::vector<double> x;
  double sum_of_squares;
  double stationarity;  // fraction of |r| along the columns of J for parameters that can move; 0 at a minimum
  bool stationary;      // within SolverOptions::stationary, or within rounding of the data
  bool slow = false;    // of one parameter: Newton's method needed many steps
};

/// Where the descents from all starts ended.
struct FoundMinima {
  std::vector<Minimum> list;  // distinct, lowest first; the first one by the engine of the options
  double least = std::numeric_limits<double>::infinity();  // the lowest cost found, including the starts
  std::vector<std::vector<double>> dearest{};              // highest costs of the search, see Starts
  bool started = false;                                    // false: the cost is nowhere finite
};

/// A minimum and the judgement on it.
struct Verdict {
  Verdict() = default;
  explicit Verdict(std::size_t parameters) : at_bound(parameters), standard_errors(parameters) {}

  FitStatus status = FitStatus::not_converged;
  std::string message{};                                 // one sentence; empty if ok
  Minimum best{};                                        // meaningless if not_identifiable
  std::vector<bool> at_bound{};                          // per parameter
  std::vector<std::optional<double>> standard_errors{};  // null at a bound, if not identifiable, or without scatter
  std::vector<Minimum> others{};                         // further local minima, best first
  std::vector<double> correlations{};                    // [p x p] of the parameters with a standard error; else empty
};

/// Status of one end of an interval.
enum class EndStatus { found, at_bound, open };
constexpr std::string_view to_string(EndStatus status) {
  return status == EndStatus::found ? "found" : status == EndStatus::at_bound ? "at_bound" : "open";
}

/// A profile for drawing: the rise of the cost above its minimum in units of the error variance (known, or from the
/// scatter); for a parabola ((x - best)/standard error)^2.
struct DrawnProfile {
  std::vector<std::pair<double, double>> points;  // solver value x, rise; x ascending
  double level = 0;                               // the rise at an interval's end: allowance/variance
};

/// One parameter's bootstrap distribution: interval, standard deviation, and bias of the estimate (mean of the
/// replicates minus the fit). The interval is from percentiles; for whole runs, if there are at least two per parameter
/// plus two, it is studentised, unless the parameter is at a bound (Efron 1979; Cameron, Gelbach & Miller 2008, Rev.
/// Econ. Stat. 90, 414).
struct Bootstrapped {
  double low, high, standard_deviation, bias;
};

struct BootstrapResult {
  std::size_t replicates = 0;
  std::uint64_t seed = 0;
  bool of_runs = false;                  // whole runs were drawn, not points
  std::size_t failed = 0;                // replicates without a minimum, left out
  std::vector<Bootstrapped> parameters;  // empty if fewer than half of the replicates have a minimum
};

/// The effect of one point, or of one whole run, on the fit.
struct PointInfluence {
  double leverage;             // diagonal of J (J'J)^-1 J', 0..1
  double cooks_distance;       // r^2 h/(p s^2 (1 - h)^2)
  std::vector<double> change;  // of each parameter when the point is left out and the rest refitted; empty if that
                               // fit fails
};
struct Influence {
  std::vector<PointInfluence> points;
  std::vector<std::vector<double>> runs;  // change of each parameter when the run is left out; empty if that fit fails
};

/// `log_evidence`: natural logarithm, without factors that depend on the data alone and are common to all models of the
/// same points. The others are mean, standard deviation and equal-tailed credible interval of parameter 0.
struct Evidence {
  double log_evidence, mean, standard_deviation, low, high;
};

}  // namespace mixity
