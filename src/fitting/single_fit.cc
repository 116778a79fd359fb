#include "fitting/single_fit.h"

#include <algorithm>
#include <cmath>

#include "fitting/single_scan.h"

namespace mixity {
namespace {

struct Refined {
  double x;
  CostValue cost;
  bool converged;
};

/// Newton on the slope inside [low, high]. An end whose slope is not `known` to point inwards is tried where Newton's
/// step leads there, and is the minimum if the cost falls towards it.
Refined refine(SingleCost& cost, std::span<const double> weights, double low, double high, bool known, double start) {
  bool low_known = known, high_known = known;
  double x = start, last_x = x, last_slope = 0;
  CostValue here = cost.at(x, weights);
  for (int i = 0; i < 80 && here.finite; ++i) {
    if (std::abs(here.slope) <= 1e-14 * here.slope_size * std::sqrt(here.value)) return {x, here, true};
    if ((here.slope > 0 && x <= low) || (here.slope < 0 && x >= high)) return {x, here, true};
    (here.slope > 0 ? high : low) = x;
    (here.slope > 0 ? high_known : low_known) = true;
    double next = here.curvature > 0 ? x - here.slope / here.curvature : here.slope > 0 ? low : high;
    const double move = next - x;
    if (cost.exact_curvature() && here.curvature > 0 && next > low && next < high &&
        std::abs(move) <= 1e-9 * std::abs(x)) {
      // Newton with the exact curvature squares the error: this step is the last, and the parabola gives the cost
      // there.
      here.value = std::max(here.value + move * (here.slope + 0.5 * here.curvature * move), 0.0);
      here.slope = 0;
      return {next, here, true};
    }
    // The secant of the slopes has the curvature that Gauss-Newton leaves out.
    if (!cost.exact_curvature() && i > 0 && here.slope != last_slope) {
      const double secant = x - here.slope * (x - last_x) / (here.slope - last_slope);
      if (std::abs(secant - x) < 0.1 * std::abs(x - last_x)) next = secant;
    }
    if (next <= low)
      next = !low_known ? low : low > 0 && high > 16 * low ? std::sqrt(low * high) : 0.5 * (low + high);
    else if (next >= high)
      next = !high_known ? high : 0.5 * (low + high);
    if (std::abs(next - x) <= 2e-16 * std::abs(x) || high - low <= 2e-16 * high) return {x, here, true};
    last_x = x;
    last_slope = here.slope;
    x = next;
    here = cost.at(x, weights);
  }
  return {x, here, false};
}

/// What minimise() says of a minimum, as far as one parameter and one start can.
void judge(SingleFit& fit, const Refined& refined, const FreeParameter& parameter, std::size_t points) {
  fit.x = refined.x;
  fit.sum_of_squares = refined.cost.value;
  if (!refined.cost.finite) return;
  const double scale = refined.cost.slope_size * std::sqrt(refined.cost.value);
  const bool at_low = refined.x <= parameter.lower && refined.cost.slope >= 0;
  const bool at_high = refined.x >= parameter.upper && refined.cost.slope <= 0;
  if (at_low || at_high) {
    fit.status = FitStatus::at_bound;
    return;
  }
  if (!(refined.cost.slope_size > 0)) {
    fit.status = FitStatus::not_identifiable;
    return;
  }
  if (points > 1)
    fit.standard_error = std::sqrt(refined.cost.value / static_cast<double>(points - 1)) / refined.cost.slope_size;
  // |J'r| <= 1e-8 |J||r|, or as close as doubles come
  const bool stationary = refined.converged || 0.5 * std::abs(refined.cost.slope) <= 1e-8 * scale;
  fit.status = stationary ? FitStatus::ok : FitStatus::not_converged;
}

}  // namespace

std::unique_ptr<SingleCost> LeastSquares::single_cost() const { return std::make_unique<GeneralCost>(*this); }

SingleFit solve_single_near(SingleCost& cost, const FreeParameter& parameter, std::size_t points, double start,
                            std::span<const double> weights) {
  SingleFit fit;
  const double x = std::clamp(start, parameter.lower, parameter.upper);
  judge(fit, refine(cost, weights, parameter.lower, parameter.upper, false, x), parameter, points);
  return fit;
}

SingleFit solve_single(SingleCost& cost, const LeastSquares& problem) {
  const FreeParameter& parameter = problem.parameters()[0];
  const std::size_t points = problem.residual_count();
  SingleFit best;
  if (points < 2) {
    best.status = FitStatus::not_identifiable;
    return best;
  }
  const SingleScan scan = scan_basins(cost, parameter);
  if (!std::isfinite(scan.lowest)) return best;
  std::vector<SingleFit> found;
  for (const Basin& basin : scan.basins) {
    SingleFit fit;
    judge(fit, refine(cost, {}, basin.low, basin.high, true, basin.start), parameter, points);
    if (fit.sum_of_squares >= 0 && std::isfinite(fit.sum_of_squares)) found.push_back(fit);
  }
  std::sort(found.begin(), found.end(),
            [](const SingleFit& one, const SingleFit& other) { return one.sum_of_squares < other.sum_of_squares; });
  // Of the minima, not of the scan's places: a narrow basin between two of them goes far below both.
  const double least = found.empty() ? scan.lowest : std::min(scan.lowest, found.front().sum_of_squares);
  if (scan.highest <= least + fit_tolerance(problem, least)) {
    best.status = FitStatus::not_identifiable;
    return best;
  }
  if (found.empty()) return best;
  best = found.front();
  for (std::size_t i = 1; i < found.size(); ++i)
    if (std::abs(found[i].x - best.x) > 1e-5 * std::max(std::abs(best.x), 1e-9)) best.others.push_back(found[i].x);
  if (best.status == FitStatus::ok && !best.others.empty() &&
      found[1].sum_of_squares <= best.sum_of_squares + fit_tolerance(problem, best.sum_of_squares) &&
      found[1].x == best.others.front())
    best.status = FitStatus::multimodal;
  return best;
}

}  // namespace mixity
