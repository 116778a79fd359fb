#include "fitting/scan.h"

#include <algorithm>
#include <cmath>

#include "fitting/minimise.h"
#include "fitting/single_scan.h"

namespace mixity {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Between more bends than that no basin is looked for by itself: it would take minutes, and one point of so many moves
/// the cost by little.
constexpr std::size_t kMostBends = 400;

/// Values of one parameter to scan: logarithmic, also away from a neutral value, and from a lower bound of zero
/// logarithmic at first, then even.
std::vector<double> scan_values(const FreeParameter& parameter, std::size_t density) {
  std::vector<double> values;
  if (parameter.start) return {*parameter.start};
  const auto logarithmic = [&](double from, double to, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i)
      values.push_back(from * std::pow(to / from, static_cast<double>(i) / static_cast<double>(n - 1)));
  };
  if (parameter.lower > 0) {
    logarithmic(parameter.lower, parameter.upper, 2 * density);
    if (parameter.neutral > 0)
      for (const double distance : {0.1, 0.03, 0.01, 0.003})
        for (const double side : {-1, 1}) values.push_back(parameter.neutral * (1 + side * distance));
    std::sort(values.begin(), values.end());
    return values;
  }
  const double width = parameter.upper - parameter.lower;
  values.push_back(parameter.lower);
  logarithmic(1e-12 * width, 0.02 * width, density);
  for (std::size_t i = 2; i <= density; ++i)
    values.push_back(parameter.lower + width * static_cast<double>(i) / static_cast<double>(density));
  return values;
}

using Axes = std::vector<std::vector<double>>;

/// Places of a grid, numbered along the first axis, then the second, ...
class Grid {
 public:
  explicit Grid(const Axes& axes) : axes_(axes) {}

  std::size_t size() const {
    std::size_t total = 1;
    for (const auto& axis : axes_) total *= axis.size();
    return total;
  }
  std::vector<double> place(std::size_t i) const {
    std::vector<double> x;
    for (const auto& axis : axes_) {
      x.push_back(axis[i % axis.size()]);
      i /= axis.size();
    }
    return x;
  }
  /// Calls use(below, above) for each axis: the neighbours of place i, null beyond an end of the axis.
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

/// How far below a place its basin may reach: the second difference to its neighbours. A parabola through the three
/// reaches an eighth of that at most.
double depth_below(double place, double one, double other) { return one + other - 2 * place; }

/// The basins that costs over the grid of the axes' values show; a local minimum is no higher than its neighbours.
Scan basins_of(const Axes& axes, const std::vector<double>& costs, bool about_bends) {
  Scan result;
  const Grid grid(axes);
  const bool single = axes.size() == 1;
  for (const double cost : costs) {
    if (!std::isfinite(cost)) continue;
    result.lowest = std::min(result.lowest, cost);
    result.highest = std::max(result.highest, cost);
  }
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    bool lowest_here = std::isfinite(costs[i]);
    grid.neighbours(i, [&](auto below, auto above) {
      // <= on one side only, so that a plateau counts once
      lowest_here &= (!below || costs[i] <= costs[*below]) && (!above || costs[i] < costs[*above]);
    });
    if (lowest_here) found.push_back(i);
  }
  std::sort(found.begin(), found.end(), [&](std::size_t i, std::size_t j) { return costs[i] < costs[j]; });
  for (const std::size_t i : found) {
    double reachable = costs[i];
    grid.neighbours(i, [&](auto below, auto above) {
      if (below || above)
        reachable -= depth_below(costs[i], costs[below ? *below : *above], costs[above ? *above : *below]);
    });
    result.minima.push_back({grid.place(i), reachable, costs[i]});
    const bool at_end = i == 0 || i + 1 == costs.size();
    if (!single || !(at_end || about_bends)) continue;
    // Beside it, too: at a bound the slope may vanish by symmetry, at a bend there is none.
    grid.neighbours(i, [&](auto below, auto above) {
      for (const auto& beside : {below, above})
        if (beside) result.minima.push_back({{0.5 * (axes[0][i] + axes[0][*beside])}, reachable});
    });
  }
  return result;
}

Scan scan_grid(const LeastSquares& problem, const Axes& axes) {
  const Grid grid(axes);
  const auto single = axes.size() == 1 ? problem.single_cost() : nullptr;
  std::vector<double> costs(grid.size(), kInfinity), residuals(problem.residual_count());
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const std::vector<double> x = grid.place(i);
    costs[i] = (single ? single->value(x[0]) : sum_of_squares(problem, x, residuals)).value_or(kInfinity);
  }
  return basins_of(axes, costs, false);
}

/// A bound of the cost between two places, from the residuals there (none: not finite): an area only falls or only
/// rises with the parameter, so that its residual is 0 in between, or least at one of the two; those `free` may be
/// anything.
double least_between(const std::vector<double>& one, const std::vector<double>& other,
                     const std::vector<std::size_t>& free) {
  if (one.empty() || other.empty()) return 0;
  double least = 0;
  for (std::size_t i = 0; i < one.size(); ++i)
    if (one[i] * other[i] > 0 && std::find(free.begin(), free.end(), i) == free.end())
      least += std::min(one[i] * one[i], other[i] * other[i]);
  return least;
}

/// Over an axis, the bends, and between these wherever a basin may come near the lowest cost. Null if there are no
/// bends, or too many.
std::optional<Scan> scan_bends(const LeastSquares& problem, const std::vector<double>& axis) {
  const std::vector<LoadEnds> loads = problem.load_ends();
  const std::vector<double> coarse = scan_values(problem.parameters()[0], 16);
  if (loads.empty() || coarse.size() < 2) return std::nullopt;
  const auto cost_at = problem.single_cost();
  std::vector<std::pair<double, double>> line;
  const auto look = [&](double x) { line.emplace_back(x, cost_at->value(x).value_or(kInfinity)); };
  for (const double x : axis) look(x);
  const auto limit = [&] {
    double least = kInfinity;
    for (const auto& [x, cost] : line) least = std::min(least, cost);
    return least + fit_tolerance(problem, least);
  };
  double matters = limit();
  const auto residuals_at = [&](double x) {
    std::vector<double> residuals(problem.residual_count());
    if (!problem.evaluate({&x, 1}, residuals, {})) residuals.clear();
    return residuals;
  };
  const std::vector<Bend> bends =
      find_bends(loads, coarse, kMostBends, [&](std::size_t k, const std::vector<std::size_t>& passing) {
        return least_between(residuals_at(coarse[k]), residuals_at(coarse[k + 1]), passing) <= matters;
      });
  const bool about_bends = bends.size() <= kMostBends;
  if (about_bends) {
    for (const Bend& bend : bends) look(bend.x);
    matters = limit();
    double left = axis.front();
    std::vector<double> at_left = residuals_at(left);
    for (std::size_t i = 0; i <= bends.size(); ++i) {  // from each bend to the next, and from and to the ends
      const double right = i < bends.size() ? bends[i].x : axis.back();
      std::vector<double> at_right = residuals_at(right);
      const bool from_left = i > 0 && !bends[i - 1].root_below, from_right = i < bends.size() && bends[i].root_below;
      if ((from_left || from_right) && least_between(at_left, at_right, {}) <= matters) {
        for (const double x : dip_places(left, right))
          if (from_left) look(x);
        for (const double x : dip_places(right, left))
          if (from_right) look(x);
      }
      left = right;
      at_left = std::move(at_right);
    }
  }
  std::sort(line.begin(), line.end());
  line.erase(
      std::unique(line.begin(), line.end(), [](const auto& one, const auto& two) { return one.first == two.first; }),
      line.end());
  Axes axes(1);
  std::vector<double> costs;
  for (const auto& [x, cost] : line) {
    axes[0].push_back(x);
    costs.push_back(cost);
  }
  Scan result = basins_of(axes, costs, about_bends);
  if (about_bends) result.line = std::move(line);
  return result;
}

}  // namespace

Scan scan(const LeastSquares& problem, const std::vector<std::vector<double>>& guesses) {
  const auto single = problem.parameters().size() == 1 ? problem.single_cost() : nullptr;
  Scan result;
  if (single && single->exact_curvature() && !problem.parameters()[0].start) {
    const SingleScan found = scan_basins(*single, problem.parameters()[0]);
    result.lowest = found.lowest;
    result.highest = found.highest;
    for (const Basin& basin : found.basins) result.minima.push_back({{basin.start}});
  } else {
    const auto scanned = std::count_if(problem.parameters().begin(), problem.parameters().end(),
                                       [](const FreeParameter& parameter) { return !parameter.start; });
    Axes axes;
    for (const FreeParameter& parameter : problem.parameters())
      axes.push_back(scan_values(parameter, scanned == 1 ? problem.scan_density() : 16));
    if (!single) {
      result = scan_grid(problem, axes);
    } else {  // a guess divides the basins around it
      for (const auto& guess : guesses) axes[0].push_back(guess[0]);
      std::sort(axes[0].begin(), axes[0].end());
      axes[0].erase(std::unique(axes[0].begin(), axes[0].end()), axes[0].end());
      if (auto about_bends = scan_bends(problem, axes[0])) return *about_bends;
      return scan_grid(problem, axes);
    }
  }
  for (const auto& guess : guesses) result.minima.push_back({guess});
  return result;
}

/// The number of bends passed grows or falls with each parameter, so that it is least at one corner of the box and
/// largest at another.
bool bends_between(const LeastSquares& problem, const std::vector<double>& one, const std::vector<double>& other) {
  const std::size_t first = problem.bends_passed(one);
  for (std::size_t corner = 1; corner < std::size_t{1} << one.size(); ++corner) {
    std::vector<double> x = one;
    for (std::size_t k = 0; k < x.size(); ++k)
      if (corner >> k & 1) x[k] = other[k];
    if (x != one && problem.bends_passed(x) != first) return true;
  }
  return false;
}

double barrier(const Scan& scan, double one, double other) {
  if (scan.line.empty()) return kInfinity;
  double highest = 0;
  for (const auto& [x, cost] : scan.line)
    if (x > std::min(one, other) && x < std::max(one, other)) highest = std::max(highest, cost);
  return highest;
}

Scan scan_around(const LeastSquares& problem, const std::vector<double>& x, double reach) {
  // A single parameter can afford more; of several, the grid has some hundred places.
  const double places = std::pow(350, 1 / static_cast<double>(x.size()));
  const int half = x.size() > 1 ? std::max(static_cast<int>(0.5 * (places - 1)), 1) : 64;
  Axes axes;
  std::vector<double> lowest, highest;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const FreeParameter& parameter = problem.parameters()[k];
    std::vector<double> axis;
    const double size = std::max(std::abs(x[k]), 1e-3 * (parameter.upper - parameter.lower));
    for (int i = -half; i <= half; ++i) {
      const double value = std::clamp(x[k] + reach * size * i / half, parameter.lower, parameter.upper);
      if (axis.empty() || value > axis.back()) axis.push_back(value);
    }
    lowest.push_back(axis.front());
    highest.push_back(axis.back());
    axes.push_back(std::move(axis));
  }
  if (!bends_between(problem, lowest, highest)) return {};
  return scan_grid(problem, axes);
}

std::vector<Start> scan_between(const LeastSquares& problem, const std::vector<double>& one,
                                const std::vector<double>& other) {
  if (!bends_between(problem, one, other)) return {};
  constexpr int kSteps = 32;
  std::vector<Start> places;
  std::vector<double> costs, residuals(problem.residual_count());
  for (int i = 0; i <= kSteps; ++i) {
    const double part = static_cast<double>(i) / kSteps;
    std::vector<double> x;
    for (std::size_t k = 0; k < one.size(); ++k)
      x.push_back(one[k] > 0 && other[k] > 0 ? std::pow(one[k], 1 - part) * std::pow(other[k], part)
                                             : (1 - part) * one[k] + part * other[k]);
    costs.push_back(sum_of_squares(problem, x, residuals).value_or(kInfinity));
    places.push_back({x});
  }
  std::vector<Start> minima;
  for (std::size_t i = 1; i < kSteps; ++i) {
    if (!(costs[i] <= costs[i - 1] && costs[i] < costs[i + 1])) continue;
    places[i].reachable = costs[i] - depth_below(costs[i], costs[i - 1], costs[i + 1]);
    minima.push_back(places[i]);
  }
  return minima;
}

}  // namespace mixity
