// The scan that finds every basin, and the verdict on what the solver found there.
#include "fitting/minimise.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "dataset/number_text.h"
#include "fitting/edge_minimum.h"
#include "fitting/narrow_basins.h"
#include "fitting/single_scan.h"

namespace mixity {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kChiSquare95 = 3.841458820694124;  // of one degree of freedom

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

struct Scan {
  std::vector<std::vector<double>> minima;  // starts, best first
  double lowest = kInfinity, highest = 0;   // over the finite costs
};

std::optional<double> sum_of_squares(const LeastSquares& problem, const std::vector<double>& x) {
  std::vector<double> residuals(problem.residual_count());
  if (!problem.evaluate(x, residuals, {})) return std::nullopt;
  double sum = 0;
  for (const double r : residuals) sum += r * r;
  return sum;
}

/// Cost over the grid of the axes' values; a local minimum is no higher than its neighbours.
Scan scan_grid(const LeastSquares& problem, const std::vector<std::vector<double>>& axes) {
  Scan result;
  const auto single = problem.parameters().size() == 1 ? problem.single_cost() : nullptr;
  std::size_t total = 1;
  for (const auto& axis : axes) total *= axis.size();

  const auto point = [&](std::size_t index) {
    std::vector<double> x;
    for (const auto& axis : axes) {
      x.push_back(axis[index % axis.size()]);
      index /= axis.size();
    }
    return x;
  };
  std::vector<double> costs(total, kInfinity);
  for (std::size_t i = 0; i < total; ++i) {
    const auto cost = single ? single->value(point(i)[0]) : sum_of_squares(problem, point(i));
    if (!cost) continue;
    costs[i] = *cost;
    result.lowest = std::min(result.lowest, costs[i]);
    result.highest = std::max(result.highest, costs[i]);
  }
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < total; ++i) {
    bool lowest_here = std::isfinite(costs[i]);
    std::size_t stride = 1;
    for (const auto& axis : axes) {
      const std::size_t position = i / stride % axis.size();
      // <= on one side only, so that a plateau counts once
      if (position > 0) lowest_here &= costs[i] <= costs[i - stride];
      if (position + 1 < axis.size()) lowest_here &= costs[i] < costs[i + stride];
      stride *= axis.size();
    }
    if (lowest_here) found.push_back(i);
  }
  std::sort(found.begin(), found.end(), [&](std::size_t i, std::size_t j) { return costs[i] < costs[j]; });
  for (const std::size_t i : found) {
    if (single && problem.narrow_basins() && i > 0 && i + 1 < total &&
        result.minima.size() < 3) {  // the lowest ones: each costs another scan
      const double x = zoomed(*single, point(i - 1)[0], point(i)[0], point(i + 1)[0], costs[i]);
      if (const auto least = single->value(x)) result.lowest = std::min(result.lowest, *least);
      result.minima.push_back({x});
      continue;
    }
    result.minima.push_back(point(i));
    if (problem.parameters().size() > 1 || total == 1 || (i > 0 && i + 1 < total)) continue;
    // Beside a bound, too: at it the slope may vanish by symmetry.
    result.minima.push_back({0.5 * (point(i)[0] + point(i == 0 ? 1 : i - 1)[0])});
  }
  return result;
}

/// Over the whole range of all parameters.
Scan scan(const LeastSquares& problem) {
  const auto single = problem.parameters().size() == 1 ? problem.single_cost() : nullptr;
  if (single && single->exact_curvature() && !problem.parameters()[0].start) {
    Scan result;
    const SingleScan found = scan_basins(*single, problem.parameters()[0]);
    result.lowest = found.lowest;
    result.highest = found.highest;
    for (const Basin& basin : found.basins) result.minima.push_back({basin.start});
    return result;
  }
  const auto scanned = std::count_if(problem.parameters().begin(), problem.parameters().end(),
                                     [](const FreeParameter& parameter) { return !parameter.start; });
  std::vector<std::vector<double>> axes;
  for (const FreeParameter& parameter : problem.parameters())
    axes.push_back(scan_values(parameter, scanned == 1 ? problem.scan_density() : 16));
  return scan_grid(problem, axes);
}

bool same_place(const LeastSquares& problem, const Minimum& one, const Minimum& other) {
  for (std::size_t k = 0; k < one.x.size(); ++k) {
    const FreeParameter& parameter = problem.parameters()[k];
    const double scale = std::max(std::abs(one.x[k]), 1e-9 * (parameter.upper - parameter.lower));
    if (std::abs(one.x[k] - other.x[k]) > 1e-5 * scale) return false;
  }
  return true;
}

/// Values of each parameter by up to the part `reach` above and below x.
std::vector<std::vector<double>> axes_around(const LeastSquares& problem, const std::vector<double>& x, double reach) {
  constexpr int kHalf = 8;
  std::vector<std::vector<double>> axes;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const FreeParameter& parameter = problem.parameters()[k];
    std::vector<double> axis;
    const double size = std::max(std::abs(x[k]), 1e-3 * (parameter.upper - parameter.lower));
    for (int i = -kHalf; i <= kHalf; ++i) {
      const double value = std::clamp(x[k] + reach * size * i / kHalf, parameter.lower, parameter.upper);
      if (axis.empty() || value > axis.back()) axis.push_back(value);
    }
    axes.push_back(axis);
  }
  return axes;
}

const Minimum& lowest(const std::vector<Minimum>& minima) {
  return *std::min_element(minima.begin(), minima.end(), [](const Minimum& one, const Minimum& other) {
    return one.sum_of_squares < other.sum_of_squares;
  });
}

std::string value_text(const FreeParameter& parameter, double x) {
  return rounded(parameter.shown(x), 4) + (parameter.unit.empty() ? "" : " " + parameter.unit);
}

std::string place(const LeastSquares& problem, const std::vector<double>& x) {
  std::string text;
  for (std::size_t k = 0; k < x.size(); ++k)
    text += (k ? ", " : "") + problem.parameters()[k].name + " = " + value_text(problem.parameters()[k], x[k]);
  return text;
}

/// Covariance of the parameters that no bound holds, from J'J scaled to unit diagonal. Returns the name of what is
/// degenerate, or an empty string.
std::string standard_errors(const LeastSquares& problem, Verdict& verdict) {
  const std::size_t n = problem.residual_count(), p = problem.parameters().size();
  std::vector<double> residuals(n), jacobian(n * p);
  if (!problem.evaluate(verdict.best.x, residuals, jacobian)) return {};
  const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> J(
      jacobian.data(), static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(p));
  std::vector<Eigen::Index> open;
  for (std::size_t k = 0; k < p; ++k)
    if (!verdict.at_bound[k]) open.push_back(static_cast<Eigen::Index>(k));
  if (open.empty()) return {};
  const auto m = static_cast<Eigen::Index>(open.size());
  Eigen::VectorXd norms(m);
  Eigen::MatrixXd scaled(m, m);
  for (Eigen::Index i = 0; i < m; ++i) norms[i] = J.col(open[i]).norm();
  const auto names = [&](auto&& concerned) {
    std::string list;
    for (Eigen::Index i = 0; i < m; ++i)
      if (concerned(i))
        list += (list.empty() ? "" : " and ") + problem.parameters()[static_cast<std::size_t>(open[i])].name;
    return list;
  };
  if ((norms.array() <= 0).any()) return names([&](Eigen::Index i) { return !(norms[i] > 0); });
  for (Eigen::Index i = 0; i < m; ++i)
    for (Eigen::Index j = 0; j < m; ++j) scaled(i, j) = J.col(open[i]).dot(J.col(open[j])) / (norms[i] * norms[j]);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled);
  if (!(eigen.eigenvalues()[0] > 1e-12)) {
    // the direction that no residual feels
    const auto weak = eigen.eigenvectors().col(0);
    return names([&](Eigen::Index i) { return std::abs(weak[i]) > 0.1; }) + " independently";
  }
  if (n <= p) return {};
  if (const std::vector<double> bend = problem.curvatures(verdict.best.x); !bend.empty()) {
    const Eigen::Map<const Eigen::VectorXd> c(bend.data(), static_cast<Eigen::Index>(n));
    for (Eigen::Index i = 0; i < m; ++i)
      for (Eigen::Index j = 0; j < m; ++j)
        scaled(i, j) = J.col(open[i]).cwiseProduct(c).dot(J.col(open[j])) / (norms[i] * norms[j]);
  }
  const Eigen::LLT<Eigen::MatrixXd> factors(scaled);
  if (factors.info() != Eigen::Success) return {};  // outliers bend the cost more than the rest
  const double variance = verdict.best.sum_of_squares / static_cast<double>(n - p);
  const Eigen::MatrixXd inverse = factors.solve(Eigen::MatrixXd::Identity(m, m));
  for (Eigen::Index i = 0; i < m; ++i)
    verdict.stderrs[static_cast<std::size_t>(open[i])] = std::sqrt(variance * inverse(i, i)) / norms[i];
  // The range of a correction is only wide: what is not known to a fraction of it is not known.
  const auto unknown = [&](Eigen::Index i) {
    const auto k = static_cast<std::size_t>(open[i]);
    const FreeParameter& parameter = problem.parameters()[k];
    return parameter.start && *verdict.stderrs[k] > 0.25 * (parameter.upper - parameter.lower);
  };
  for (Eigen::Index i = 0; i < m; ++i)
    if (unknown(i)) return names(unknown);
  if (m == static_cast<Eigen::Index>(p) && p > 1)
    for (Eigen::Index i = 0; i < m; ++i)
      for (Eigen::Index j = 0; j < m; ++j)
        verdict.correlations.push_back(inverse(i, j) / std::sqrt(inverse(i, i) * inverse(j, j)));
  return {};
}

}  // namespace

std::string_view to_string(FitStatus status) {
  switch (status) {
    case FitStatus::ok:
      return "ok";
    case FitStatus::at_bound:
      return "at_bound";
    case FitStatus::not_identifiable:
      return "not_identifiable";
    case FitStatus::multimodal:
      return "multimodal";
    case FitStatus::not_converged:
      break;
  }
  return "not_converged";
}

double fit_tolerance(const LeastSquares& problem, double least) {
  const auto freedom = static_cast<double>(problem.residual_count() - problem.parameters().size());
  return kChiSquare95 * (problem.known_errors() ? 1 : least / freedom);
}

Verdict minimise(const LeastSquares& problem, const std::vector<double>& near,
                 const std::vector<std::vector<double>>& guesses) {
  const std::size_t n = problem.residual_count(), p = problem.parameters().size();
  Verdict verdict{FitStatus::ok, {}, {}, std::vector<bool>(p), std::vector<std::optional<double>>(p), {}, {}};
  const auto end = [&](FitStatus status, const std::string& message) {
    verdict.status = status;
    verdict.message = message;
    if (status == FitStatus::not_identifiable || status == FitStatus::not_converged)
      verdict.stderrs.assign(p, std::nullopt);
    return verdict;
  };
  if (n <= p)
    return end(FitStatus::not_identifiable, std::to_string(n) + " usable point" + (n == 1 ? "" : "s") +
                                                " cannot determine " + std::to_string(p) + " parameter" +
                                                (p == 1 ? "" : "s") + " and their errors");

  Scan scanned;
  if (near.empty())
    scanned = scan(problem);
  else
    scanned.minima = {near};
  scanned.minima.insert(scanned.minima.end(), guesses.begin(), guesses.end());
  if (scanned.minima.empty())
    return end(FitStatus::not_converged, "the model is not finite at these points for any parameter value");
  // Within rounding, or within what the scatter allows, every value fits as well as the best.
  const double rounding = residual_rounding(problem);
  const auto fits_as_well = [&](double sum_of_squares, double least) {
    return sum_of_squares <= least + fit_tolerance(problem, least);
  };
  std::vector<Minimum> minima;
  const auto descend_from = [&](const std::vector<double>& start) {
    const auto minimum = descend(problem, start);
    if (minimum && std::none_of(minima.begin(), minima.end(),
                                [&](const Minimum& known) { return same_place(problem, known, *minimum); }))
      minima.push_back(*minimum);
  };
  for (const auto& start : scanned.minima) descend_from(start);
  if (near.empty() && p > 1 && problem.narrow_basins())
    for (const double reach : {0.3, 0.1, 0.03, 0.01}) {
      if (minima.empty()) break;
      Scan closer = scan_grid(problem, axes_around(problem, lowest(minima).x, reach));
      constexpr std::size_t kStarts = 4;
      if (closer.minima.size() > kStarts) closer.minima.resize(kStarts);
      for (const auto& start : closer.minima) descend_from(start);
    }
  const bool any_scanned = near.empty() && std::any_of(problem.parameters().begin(), problem.parameters().end(),
                                                       [](const FreeParameter& parameter) { return !parameter.start; });
  // Of the minima, not of the scan's places: a narrow basin between two of them goes far below both.
  double least = scanned.lowest;
  for (const Minimum& minimum : minima) least = std::min(least, minimum.sum_of_squares);
  if (any_scanned && (std::sqrt(scanned.highest) <= rounding || fits_as_well(scanned.highest, least))) {
    std::string names;
    for (const FreeParameter& parameter : problem.parameters()) names += (names.empty() ? "" : ", ") + parameter.name;
    return end(FitStatus::not_identifiable, "the data do not constrain " + names + ": every value in the range fits");
  }
  if (p == 1 && minima.size() > 1) {
    const FreeParameter& parameter = problem.parameters()[0];
    const auto cost = problem.single_cost();
    std::erase_if(minima, [&](const Minimum& minimum) {
      const double x = minimum.x[0];
      return (x <= parameter.lower || x >= parameter.upper) && !lowest_at_bound(*cost, parameter, x);
    });
  }
  if (minima.empty()) return end(FitStatus::not_converged, "no start led to a minimum");
  std::sort(minima.begin(), minima.end(),
            [](const Minimum& one, const Minimum& other) { return one.sum_of_squares < other.sum_of_squares; });
  verdict.best = minima.front();
  verdict.others.assign(minima.begin() + 1, minima.end());
  const std::optional<EdgeMinimum> edge = verdict.best.stationary ? std::nullopt : edge_minimum(problem, verdict.best);
  if (edge) verdict.best = edge->minimum;

  std::string bounds;
  for (std::size_t k = 0; k < p; ++k) {
    const FreeParameter& parameter = problem.parameters()[k];
    const double x = verdict.best.x[k];
    if (x > parameter.lower && x < parameter.upper) continue;
    verdict.at_bound[k] = true;
    bounds += (bounds.empty() ? "" : ", ") + parameter.name + " is at its " +
              (x <= parameter.lower ? "lower bound " : "upper bound ") + value_text(parameter, x);
  }
  const std::string degenerate = standard_errors(problem, verdict);
  if (!degenerate.empty()) return end(FitStatus::not_identifiable, "the data do not constrain " + degenerate);
  if (!verdict.best.stationary && !edge)
    return end(FitStatus::not_converged, "the solver stopped where the gradient is not zero (relative size " +
                                             rounded(verdict.best.stationarity, 2) + ")");
  if (edge) {
    verdict.stderrs.assign(p, std::nullopt);
    verdict.correlations.clear();
  }
  if (verdict.best.sum_of_squares > scanned.lowest * (1 + 1e-9) &&
      std::sqrt(verdict.best.sum_of_squares) > std::sqrt(scanned.lowest) + rounding)
    return end(FitStatus::not_converged, "the solver ended above the lowest cost of the scan");
  if (!bounds.empty()) return end(FitStatus::at_bound, bounds);
  if (edge && edge->at_end)
    return end(FitStatus::at_bound, place(problem, verdict.best.x) + " lies at the end of what the model describes");
  if (!verdict.others.empty() && fits_as_well(verdict.others.front().sum_of_squares, verdict.best.sum_of_squares))
    return end(FitStatus::multimodal, std::string("another minimum fits as well within the ") +
                                          (problem.known_errors() ? "standard errors: " : "scatter: ") +
                                          place(problem, verdict.others.front().x));
  if (edge)
    verdict.message =
        "the least squares lie on a bend of the cost, such as where a measured load is that of the fold: no standard "
        "error";
  return verdict;
}

}  // namespace mixity
