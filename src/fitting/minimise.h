// Finding the minimum of a least-squares problem, and judging it: two passes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fitting/least_squares.h"

namespace mixity {

enum class FitStatus { ok, at_bound, not_identifiable, multimodal, not_converged };
std::string_view to_string(FitStatus status);

/// A point the solver ended at.
struct Minimum {
  std::vector<double> x;
  double sum_of_squares;
  double stationarity;  // largest |J_k' r|/(|J_k| |r|) over the parameters that are free to move; 0 is exact
  bool stationary;      // within 1e-8, or within rounding of the data
};

struct Verdict {
  FitStatus status;
  std::string message;                         // one sentence; empty if ok
  Minimum best;                                // meaningless if not_identifiable
  std::vector<bool> at_bound;                  // per parameter
  std::vector<std::optional<double>> stderrs;  // null at a bound, if not identifiable, or without degrees of freedom
  std::vector<Minimum> others;                 // further local minima, best first
  std::vector<double> correlations;            // [p x p] of the parameters that have a standard error; else empty
};

/// Why a fit of more parameters than different points, less one, has no result.
std::string too_few_points(std::size_t distinct, std::size_t points, std::size_t parameters);

/// How far above the least sum of squares a fit counts as no worse: chi^2 of one parameter at 95 %, in units of the
/// known errors or of the scatter. Needs more residuals than parameters.
double fit_tolerance(const LeastSquares& problem, double least);

/// Scans the whole range of the parameters without a start (one or two), the others at theirs, descends with Ceres from
/// every local minimum of the scan, and judges the best.
/// Given `near`, the scan is left out and the descent starts there: for refits of almost the same data. It starts from
/// `guesses`, too.
Verdict minimise(const LeastSquares& problem, const std::vector<double>& near = {},
                 const std::vector<std::vector<double>>& guesses = {});

/// The version of Ceres.
std::string_view solver_version();

/// Ceres from one start, polished to a zero of the gradient. Null if no finite cost was found from there.
std::optional<Minimum> descend(const LeastSquares& problem, const std::vector<double>& start);

}  // namespace mixity
