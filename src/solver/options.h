// What the solver can be asked for, and its tolerances by name.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>

namespace mixity {

/// What makes the descent that a result is shown of: Ceres for the fit itself, the kernel for fits by the hundred. Both
/// end at the same minimum, to the last digits.
enum class Engine { ceres, kernel };

struct SolverOptions {
  Engine engine = Engine::ceres;
  /// Whether the kernel's minima of several parameters are taken to their last digits; what is only compared needs
  /// none.
  bool last_digits = true;

  // ---- Descent ----
  int most_iterations = 200;
  /// Of several parameters from one start of many: what has not arrived by then, above a minimum that is known, is let
  /// go.
  int most_iterations_of_a_start = 30;
  /// Of the descent that a result is shown of: curved valleys (NIST's Bennett5, MGH17) take more than a thousand.
  int most_iterations_shown = 5000;
  /// Where Ceres stops, relative. Close enough for the Newton steps on the gradient that follow.
  double ceres_cost_change = 1e-10, ceres_step = 1e-14;
  /// Newton steps on the gradient, at most, until it is this small on the scale of `stationary`.
  int newton_steps = 12;
  double newton_stationary = 1e-13;
  /// Relative step of the differences that give the gradient's derivative.
  double difference_step = 1e-5;
  /// A minimum: at most this part of |r| lies along the columns of J of the parameters that no bound holds.
  double stationary = 1e-8;
  /// Where the kernel stops with one parameter, and with several: |J_k' r|/(|J_k| |r|) of each.
  double kernel_stationary = 1e-14, kernel_stationary_of_several = 3e-13;

  // ---- Verdict ----
  /// Minima whose parameters agree to this part are one.
  double same_minimum = 1e-5;
  /// Smallest singular value of J, its columns scaled to 1, at which the parameters count as independent.
  double independent = 1e-6;
  /// The part of its wide range to which a parameter with a start must be known to be known at all.
  double known_part = 0.25;
  /// A cost this part below that of a minimum is lower, whatever rounding did.
  double lower_cost = 1e-9;

  // ---- Profile intervals ----
  /// What the others' minimum may lie below, as a part of the allowance: to first order that is taken off.
  double profile_decrease = 1e-8;
  /// So many times that at the first step to an end, which is never the last.
  double profile_first = 1e5;
  /// Relative size of Newton's last step to an interval's end: what is left is its square.
  double interval_step = 1e-5;
  /// A cost below the minimum by this part of the allowance proves that it was none.
  double deeper = 1e-6;
};

/// Large residuals count less. Scales in units of the residuals, see robust.h.
enum class Loss { none, huber, cauchy };
constexpr std::string_view to_string(Loss loss) {
  return loss == Loss::none ? "none" : loss == Loss::huber ? "huber" : "cauchy";
}

/// Scales, in standard errors, at which the loss keeps 95 % efficiency for Gaussian errors (Huber 1964; Holland &
/// Welsch 1977).
constexpr double usual_scale(Loss loss) { return loss == Loss::cauchy ? 2.3849 : 1.345; }

/// Told how much is done, 0..1, from any thread.
using Progress = std::function<void(double)>;

/// For a step that is this stretch of the whole. Null if the whole is not told.
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

/// uniform: over the parameter's range. log_uniform: in its logarithm, from kLeastOfUpper of the upper bound to it; for
/// a parameter whose range begins at 0.
enum class RangePrior { uniform, log_uniform };
constexpr std::string_view to_string(RangePrior prior) {
  return prior == RangePrior::uniform ? "uniform" : "log_uniform";
}
inline constexpr double kLeastOfUpper = 1e-6;

}  // namespace mixity
