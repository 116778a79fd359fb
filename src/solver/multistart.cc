#include "solver/multistart.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "solver/basins.h"

namespace mixity {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Grid of one parameter: logarithmic above a positive lower bound, with values about `neutral`; else first logarithmic
/// in the distance from the lower bound, then uniform.
std::vector<double> grid_values(const FreeParameter& parameter, std::size_t density) {
  if (parameter.start) return {*parameter.start};
  std::vector<double> values;
  const auto logarithmic = [&](double from, double to, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i)
      values.push_back(from * std::pow(to / from, static_cast<double>(i) / static_cast<double>(n - 1)));
  };
  if (parameter.lower > 0) {
    logarithmic(parameter.lower, parameter.upper, 2 * density);
    if (parameter.neutral > 0 && density >= 16)  // on a coarse grid a guess serves instead
      for (const double distance : {0.1, 0.03, 0.01, 0.003})
        for (const double side : {-1, 1}) values.push_back(parameter.neutral * (1 + side * distance));
    std::sort(values.begin(), values.end());
    return values;
  }
  logarithmic(1e-12 * parameter.width(), 0.02 * parameter.width(), density);
  for (double& value : values) value += parameter.lower;
  values.insert(values.begin(), parameter.lower);
  for (std::size_t i = 2; i <= density; ++i)
    values.push_back(parameter.lower + parameter.width() * static_cast<double>(i) / static_cast<double>(density));
  return values;
}

using Axes = std::vector<std::vector<double>>;

/// Nodes of a grid, numbered along the first axis, then the second, ...
class Grid {
 public:
  explicit Grid(const Axes& axes) : axes_(axes) {}

  std::size_t size() const {
    std::size_t total = 1;
    for (const auto& axis : axes_) total *= axis.size();
    return total;
  }
  std::vector<double> node(std::size_t i) const {
    std::vector<double> x(axes_.size());
    set_node(i, x);
    return x;
  }
  void set_node(std::size_t i, std::vector<double>& x) const {
    for (std::size_t k = 0; k < axes_.size(); ++k) {
      x[k] = axes_[k][i % axes_[k].size()];
      i /= axes_[k].size();
    }
  }
  /// Calls use(below, above) for each axis: the neighbours of node i, null beyond an end of the axis.
  template <class Use>
  void neighbours(std::size_t i, Use&& use) const {
    std::size_t stride = 1;
    for (const auto& axis : axes_) {
      const std::size_t position = i / stride % axis.size();
      use(position > 0 ? std::optional(i - stride) : std::nullopt,
          position + 1 < axis.size() ? std::optional(i + stride) : std::nullopt);
      stride *= axis.size();
    }
  }

 private:
  const Axes& axes_;
};

Starts starts_of_grid(const Problem& problem, const Axes& axes) {
  const Grid grid(axes);
  std::vector<double> costs(grid.size(), kInfinity), residuals(problem.residual_count()), x(axes.size());
  for (std::size_t i = 0; i < costs.size(); ++i) {
    grid.set_node(i, x);
    if (!problem.evaluate_roughly(x, residuals)) continue;
    const double sum = std::inner_product(residuals.begin(), residuals.end(), residuals.begin(), 0.0);
    if (std::isfinite(sum)) costs[i] = sum;
  }
  std::vector<std::size_t> finite, minima;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    if (!std::isfinite(costs[i])) continue;
    finite.push_back(i);
    bool lowest_here = true;
    grid.neighbours(i, [&](auto below, auto above) {
      // <= on one side only, so that a plateau counts once
      lowest_here &= (!below || costs[i] <= costs[*below]) && (!above || costs[i] < costs[*above]);
    });
    if (lowest_here) minima.push_back(i);
  }
  std::sort(minima.begin(), minima.end(), [&](std::size_t i, std::size_t j) { return costs[i] < costs[j]; });
  Starts starts;
  for (const std::size_t i : minima) {
    Start start{grid.node(i), grid.node(i), grid.node(i)};
    std::size_t axis = 0;
    grid.neighbours(i, [&](auto below, auto above) {
      const double least = problem.parameters()[axis].lower, most = problem.parameters()[axis].upper;
      const bool searched = axes[axis].size() > 1;
      start.low[axis] = below ? grid.node(*below)[axis] : searched ? start.low[axis] : least;
      start.high[axis] = above ? grid.node(*above)[axis] : searched ? start.high[axis] : most;
      ++axis;
    });
    starts.list.push_back(start);
    // At a bound of a single parameter the slope may vanish by symmetry: start beside it, too.
    if (axes.size() == 1 && axes[0].size() > 1 && (i == 0 || i + 1 == costs.size()))
      starts.list.push_back({{0.5 * (axes[0][i] + axes[0][i == 0 ? 1 : i - 1])}});
  }
  if (finite.size() > 1) {
    std::sort(finite.begin(), finite.end(), [&](std::size_t i, std::size_t j) { return costs[i] > costs[j]; });
    for (const std::size_t i : finite) starts.dearest.push_back(grid.node(i));
  }
  return starts;
}

Starts starts_of_basins(Kernel& kernel, const FreeParameter& parameter) {
  const auto look = [&](double x) {
    const CostValue& cost = kernel.at({&x, 1});
    if (!cost.finite) return CostSample{x, false, 0, 0, 0, 0};
    return CostSample{x, true, 0.5 * cost.value, cost.gradient[0], cost.hessian(0, 0), cost.slope_size[0]};
  };
  const Basins basins = find_basins(look, parameter.lower, parameter.upper);
  Starts starts;
  for (const Basin& basin : basins.list) {
    if (basin.low < basin.high)
      starts.list.push_back({{basin.x}, {basin.low}, {basin.high}, true});
    else
      starts.list.push_back({{basin.x}});
  }
  for (const double x : basins.dearest) starts.dearest.push_back({x});
  return starts;
}

}  // namespace

Starts find_starts(const Problem& problem, const SolverOptions& options) {
  const std::vector<FreeParameter>& parameters = problem.parameters();
  if (parameters.size() == 1 && !parameters[0].start) {
    Kernel kernel(problem, options);
    if (kernel.exact_curvature()) return starts_of_basins(kernel, parameters[0]);
  }
  const auto searched = std::count_if(parameters.begin(), parameters.end(),
                                      [](const FreeParameter& parameter) { return !parameter.start; });
  Axes axes;
  for (const FreeParameter& parameter : parameters)
    axes.push_back(grid_values(parameter, problem.scan_density(static_cast<std::size_t>(searched))));
  return starts_of_grid(problem, axes);
}

bool lowest_at_bound(const Problem& problem, double bound) {
  const FreeParameter& parameter = problem.parameters()[0];
  std::vector<double> residuals(problem.residual_count());
  const auto at_bound = sum_of_squares(problem, {&bound, 1}, residuals);
  if (!at_bound) return false;
  const double inwards = (bound == parameter.lower ? 1 : -1) * parameter.width();
  for (const double share : {1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
    const double x = bound + share * inwards;
    const auto inside = sum_of_squares(problem, {&x, 1}, residuals);
    if (inside && *inside < *at_bound * (1 - 1e-13)) return false;  // by more than rounding
  }
  return true;
}

}  // namespace mixity
