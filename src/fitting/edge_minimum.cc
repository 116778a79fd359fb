#include "fitting/edge_minimum.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>

namespace mixity {
namespace {

/// The cost by value; outside the ranges, and where it is not finite, so large that a search turns back.
class Values {
 public:
  Values(const LeastSquares& problem, const Minimum& stopped)
      : problem_(problem), residuals_(problem.residual_count()), outside_(2 * stopped.sum_of_squares + 1) {}

  bool inside(const std::vector<double>& x) const {
    for (std::size_t k = 0; k < x.size(); ++k)
      if (!(x[k] >= problem_.parameters()[k].lower && x[k] <= problem_.parameters()[k].upper)) return false;
    return true;
  }
  std::optional<double> finite(const std::vector<double>& x) {
    return inside(x) ? sum_of_squares(problem_, x, residuals_) : std::nullopt;
  }
  double operator()(const std::vector<double>& x) { return std::min(finite(x).value_or(outside_), outside_); }

  /// Size of a parameter that a reach is a part of.
  double size(const std::vector<double>& x, std::size_t k) const {
    const FreeParameter& parameter = problem_.parameters()[k];
    return std::max(std::abs(x[k]), 1e-6 * (parameter.upper - parameter.lower));
  }

 private:
  const LeastSquares& problem_;
  std::vector<double> residuals_;
  double outside_;
};

/// Brent's method on parameter k within `reach` of x[k], which becomes the lowest place met; on the others nested.
double descend_by_values(Values& cost, std::vector<double>& x, std::size_t k, double reach) {
  const double centre = x[k], width = reach * cost.size(x, k);
  double least = cost(x);
  std::vector<double> lowest = x, inner = x;
  const auto at = [&](double s) {
    inner[k] = centre + s * width;
    const double here = k + 1 < x.size() ? descend_by_values(cost, inner, k + 1, reach) : cost(inner);
    if (here < least) {
      least = here;
      lowest = inner;
    }
    return here;
  };
  boost::math::tools::brent_find_minima(at, -1.0, 1.0, 26);
  x = lowest;
  return least;
}

}  // namespace

std::optional<EdgeMinimum> edge_minimum(const LeastSquares& problem, const Minimum& stopped) {
  const std::size_t p = stopped.x.size();
  if (p > 2) return std::nullopt;
  Values cost(problem, stopped);
  std::vector<double> x = stopped.x;
  double least = cost(x);
  // At each reach until it gains nothing more.
  for (const double reach : {1e-2, 1e-4, 1e-7})
    for (int i = 0; i < 5; ++i) {
      const double before = least;
      least = descend_by_values(cost, x, 0, reach);
      if (!(least < before - 1e-9 * before)) break;
    }
  // Proven by the places around it; lower only by what rounding does to |r|.
  const double lowest = std::pow(std::max(std::sqrt(least) - residual_rounding(problem), 0.0), 2);
  bool at_end = false;
  for (const double distance : {1e-8, 1e-6, 1e-4})
    for (int direction = 0; direction < (p == 2 ? 9 : 3); ++direction) {
      std::vector<double> beside = x;
      for (std::size_t k = 0; k < p; ++k)
        beside[k] += distance * cost.size(x, k) * ((k == 0 ? direction % 3 : direction / 3) - 1);
      if (!cost.inside(beside)) continue;
      const std::optional<double> here = cost.finite(beside);
      if (here && *here < lowest) return std::nullopt;
      at_end |= !here;
    }
  return EdgeMinimum{{x, least, stopped.stationarity, false}, at_end};
}

}  // namespace mixity
