// Options and tolerances of the solver.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>

namespace mixity {

/// What makes the last descent: Ceres for a reported fit, the kernel for fits by the hundred. Both end at the same
/// minimum, to the last digits.
enum class Engine { ceres, kernel };

struct SolverOptions {
  Engine engine = Engine::ceres;
  /// Whether the kernel's minima of several parameters are taken to their last digits; comparisons need not.
  bool last_digits = true;

  // ---- Descent ----
  int most_iterations = 200;
  /// From one start of many, with several parameters. A descent that is then above a known minimum is abandoned.
  int most_iterations_of_a_start = 30;
  /// In the last descent: curved valleys (NIST's Bennett5, MGH17) take more than a thousand.
  int most_iterations_shown = 5000;
  /// Relative changes at which Ceres stops, close enough for the Newton steps that follow.
  double ceres_cost_change = 1e-10, ceres_step = 1e-14;
  /// At most so many Newton steps on the gradient, until it is this small (measured as `stationary`).
  int newton_steps = 12;
  double newton_stationary = 1e-13;
  /// Relative step of the differences that give the gradient's derivative.
  double difference_step = 1e-5;
  /// At a minimum at most this part of |r| lies along the columns of J of the parameters that no bound holds.
  double stationary = 1e-8;
  /// More steps than these of Newton's method with one parameter: residuals so large that the curvature which
  /// Gauss-Newton neglects is a good part of the whole. Then minima may lie closer to each other than a search looks.
  int many_steps = 15;
  /// Where the kernel stops with one parameter, and with several: |J_k' r|/(|J_k| |r|) of each.
  double kernel_stationary = 1e-14, kernel_stationary_of_several = 3e-13;

  // ---- Verdict ----
  /// Minima whose parameters agree to this part are one.
  double same_minimum = 1e-5;
  /// Smallest singular value of J, its columns scaled to 1, at which the parameters count as independent.
  double independent = 1e-6;
  /// The largest standard error of a parameter with a start, as a part of its wide range.
  double known_part = 0.25;
  /// A cost lower by this part is lower by more than rounding.
  double lower_cost = 1e-9;

  // ---- Profile intervals ----
  /// How far a profile may lie above the minimum over the others, as a part of the allowance (corrected to first
  /// order).
  double profile_decrease = 1e-8;
  /// Factor on that at the first step to an end, which is never the last.
  double profile_first = 1e5;
  /// Relative size of Newton's last step to an interval's end; the error is its square.
  double interval_step = 1e-5;
  /// A cost lower than the minimum by this part of the allowance revokes the minimum.
  double deeper = 1e-6;
};

/// Robust losses, see robust.h.
enum class Loss { none, huber, cauchy, t };
constexpr std::string_view to_string(Loss loss) {
  constexpr std::string_view kNames[] = {"none", "huber", "cauchy", "t"};
  return kNames[static_cast<int>(loss)];
}

/// Scales, in standard errors, at which the loss keeps 95 % efficiency for Gaussian errors (Huber 1964; Holland &
/// Welsch 1977).
constexpr double usual_scale(Loss loss) { return loss == Loss::cauchy ? 2.3849 : 1.345; }

/// Called with the fraction done, 0..1, from any thread.
using Progress = std::function<void(double)>;

/// The progress of a step that takes the whole from one fraction to another. Null if `whole` is.
inline Progress stretch(const Progress& whole, double from, double to) {
  if (!whole) return {};
  return [whole, from, to](double fraction) { whole(fraction < 1 ? std::min(from + (to - from) * fraction, to) : to); };
}

enum class Resample { points, curves };
constexpr std::string_view to_string(Resample resample) { return resample == Resample::points ? "points" : "curves"; }

struct BootstrapOptions {
  std::size_t replicates = 0;
  Resample resample = Resample::points;  // points within their runs, or whole runs
  std::uint64_t seed = 1;
  unsigned threads = 0;  // 0: as many as the machine has
};

/// uniform: over the parameter's range. log_uniform: in its logarithm, from kLeastOfUpper times the upper bound to it,
/// for a parameter with a range from 0.
enum class RangePrior { uniform, log_uniform };
constexpr std::string_view to_string(RangePrior prior) {
  return prior == RangePrior::uniform ? "uniform" : "log_uniform";
}
inline constexpr double kLeastOfUpper = 1e-6;

}  // namespace mixity
