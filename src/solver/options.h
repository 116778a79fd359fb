// Options and tolerances of the solver.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>

namespace mixity {

/// The engine of the last descent: Ceres for a reported fit, the kernel for fits by the hundred. Both reach the same
/// minimum, to the last digits.
enum class Engine { ceres, kernel };

struct SolverOptions {
  Engine engine = Engine::ceres;
  /// Whether the kernel refines minima of several parameters to their last digits; comparisons do not need this.
  bool last_digits = true;

  // ---- Descent ----
  int most_iterations = 200;
  /// For one start of many, with several parameters. A descent that is then above a known minimum is abandoned.
  int most_iterations_of_a_start = 30;
  /// For the last descent: curved valleys (NIST's Bennett5, MGH17) take more than a thousand iterations.
  int most_iterations_shown = 5000;
  /// Relative changes at which Ceres stops, close enough for the Newton steps that follow.
  double ceres_cost_change = 1e-10, ceres_step = 1e-14;
  /// The most Newton steps on the gradient, and the gradient at which they stop (measured as `stationary`).
  int newton_steps = 12;
  double newton_stationary = 1e-13;
  /// Relative step of the finite differences of the gradient.
  double difference_step = 1e-5;
  /// At a minimum, at most this fraction of |r| lies along the columns of J for parameters that no bound holds.
  double stationary = 1e-8;
  /// If Newton's method with one parameter takes more steps than this, the residuals are so large that the curvature
  /// that Gauss-Newton neglects is a good part of the whole. Minima may then lie closer together than a search looks.
  int many_steps = 15;
  /// Where the kernel stops, with one parameter and with several: largest |J_k' r|/(|J_k| |r|).
  double kernel_stationary = 1e-14, kernel_stationary_of_several = 3e-13;

  // ---- Verdict ----
  /// Minima whose parameters agree to this relative difference count as one.
  double same_minimum = 1e-5;
  /// The smallest singular value of J, with columns scaled to 1, at which parameters count as independent.
  double independent = 1e-6;
  /// The largest standard error of a parameter with a start, as a fraction of its wide range.
  double known_part = 0.25;
  /// The relative difference by which a cost is lower beyond rounding.
  double lower_cost = 1e-9;

  // ---- Profile intervals ----
  /// Tolerated height of a profile above the minimum over the other parameters, as a fraction of the allowance
  /// (corrected to first order).
  double profile_decrease = 1e-8;
  /// Factor on profile_decrease at the first step to an end, which is never the last.
  double profile_first = 1e5;
  /// Relative size of Newton's last step to an interval's end; the error is its square.
  double interval_step = 1e-5;
  /// A cost lower than the minimum by this fraction of the allowance revokes the minimum.
  double deeper = 1e-6;
};

/// Robust losses, see robust.h.
enum class Loss { none, huber, cauchy, t };
constexpr std::string_view to_string(Loss loss) {
  constexpr std::string_view kNames[] = {"none", "huber", "cauchy", "t"};
  return kNames[static_cast<int>(loss)];
}

/// Scales, in standard errors, at which a loss has 95 % efficiency for Gaussian errors (Huber 1964; Holland & Welsch
/// 1977).
constexpr double usual_scale(Loss loss) { return loss == Loss::cauchy ? 2.3849 : 1.345; }

/// Called with the fraction done, 0..1, from any thread.
using Progress = std::function<void(double)>;

/// The progress of a step that covers the fractions `from` to `to` of the whole. Null if `whole` is.
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

/// uniform: over the parameter's range. log_uniform: uniform in its logarithm from what is stated, else kLeastOfUpper
/// times the upper bound, to that bound, for a parameter whose range starts at 0.
enum class RangePrior { uniform, log_uniform };
constexpr std::string_view to_string(RangePrior prior) {
  return prior == RangePrior::uniform ? "uniform" : "log_uniform";
}
inline constexpr double kLeastOfUpper = 1e-6;

}  // namespace mixity
