// The verdict on what the solver found from the places of the scan.
#include "fitting/minimise.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "dataset/number_text.h"
#include "fitting/edge_minimum.h"
#include "fitting/interval.h"
#include "fitting/scan.h"
#include "fitting/single_scan.h"

namespace mixity {
namespace {

constexpr double kChiSquare95 = 3.841458820694124;  // of one degree of freedom

bool same_place(const LeastSquares& problem, const Minimum& one, const Minimum& other) {
  for (std::size_t k = 0; k < one.x.size(); ++k) {
    const FreeParameter& parameter = problem.parameters()[k];
    const double scale = std::max(std::abs(one.x[k]), 1e-9 * (parameter.upper - parameter.lower));
    if (std::abs(one.x[k] - other.x[k]) > 1e-5 * scale) return false;
  }
  return true;
}

bool lower(const Minimum& one, const Minimum& other) { return one.sum_of_squares < other.sum_of_squares; }

const Minimum& lowest(const std::vector<Minimum>& minima) {
  return *std::min_element(minima.begin(), minima.end(), lower);
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

/// True if the cost falls inwards from a bound that the minimum lies at.
bool is_peak_at_bound(const LeastSquares& problem, const Minimum& minimum) {
  for (std::size_t k = 0; k < minimum.x.size(); ++k) {
    const FreeParameter& parameter = problem.parameters()[k];
    const double x = minimum.x[k], inwards = x <= parameter.lower ? 1 : x >= parameter.upper ? -1 : 0;
    if (inwards == 0) continue;
    if (minimum.x.size() == 1) return !lowest_at_bound(*problem.single_cost(), parameter, x);
    Profile profile(problem, minimum, k);
    for (const double share : {1e-3, 1e-2})
      if (const auto cost = profile(x + share * inwards * (parameter.upper - parameter.lower));
          cost && *cost < minimum.sum_of_squares * (1 - 1e-9))  // what descents leave
        return true;
  }
  return false;
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
  const double variance = problem.known_errors() ? 1 : verdict.best.sum_of_squares / static_cast<double>(n - p);
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

std::string too_few_points(std::size_t distinct, std::size_t points, std::size_t parameters) {
  return std::to_string(distinct) + " usable point" + (distinct == 1 ? "" : "s") +
         (distinct < points ? ", repeated in " + std::to_string(points) + " rows," : "") + " cannot determine " +
         std::to_string(parameters) + " parameter" + (parameters == 1 ? "" : "s") + " and their errors";
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
  if (n <= p) return end(FitStatus::not_identifiable, too_few_points(n, n, p));

  Scan scanned;
  if (near.empty()) {
    scanned = scan(problem, guesses);
  } else {
    scanned.minima = {{near}};
    for (const auto& guess : guesses) scanned.minima.push_back({guess});
  }
  if (scanned.minima.empty())
    return end(FitStatus::not_converged, "the model is not finite at these points for any parameter value");
  // Within rounding, or within what the scatter allows, every value fits as well as the best.
  const double rounding = residual_rounding(problem);
  const auto fits_as_well = [&](double sum_of_squares, double least) {
    return sum_of_squares <= least + fit_tolerance(problem, least);
  };
  std::vector<Minimum> minima;
  const auto keep = [&](const Minimum& minimum) {
    const auto same = std::find_if(minima.begin(), minima.end(),
                                   [&](const Minimum& known) { return same_place(problem, known, minimum); });
    if (same == minima.end())
      minima.push_back(minimum);
    else if (minimum.stationary ? !same->stationary || lower(minimum, *same)
                                : std::sqrt(minimum.sum_of_squares) + rounding < std::sqrt(same->sum_of_squares))
      *same = minimum;
  };
  const auto descend_from = [&](const Start& start) {
    const auto minimum = descend(problem, start.x);
    if (minimum) keep(*minimum);
    // A bend has no slope to descend by: the place itself may be the minimum.
    if (!minimum || std::sqrt(minimum->sum_of_squares) > std::sqrt(start.cost) + rounding)
      if (std::isfinite(start.cost)) keep({start.x, start.cost, 1, false});
  };
  // Not from basins that cannot come near the lowest known
  const auto may_matter = [&](const Start& start) {
    if (minima.empty() || scanned.line.empty()) return true;
    const double least = lowest(minima).sum_of_squares;
    return start.reachable < least + fit_tolerance(problem, least);
  };
  for (const Start& start : scanned.minima)
    if (may_matter(start)) descend_from(start);
  if (near.empty() && p > 1) {
    // from one side of a fold's bend to the other
    std::sort(minima.begin(), minima.end(), lower);
    constexpr std::size_t kEnds = 5;
    std::vector<Minimum> ends = minima;
    if (ends.size() > kEnds) ends.resize(kEnds);
    for (std::size_t i = 1; i < ends.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        for (const Start& start : scan_between(problem, ends[i].x, ends[j].x))
          if (start.reachable < lowest(minima).sum_of_squares) descend_from(start);
  }
  if (near.empty() && scanned.line.empty())
    for (double reach = 0.3; !minima.empty() && reach > (p > 1 ? 0.005 : 3e-4); reach *= 0.3) {
      Scan closer = scan_around(problem, lowest(minima).x, reach);
      if (closer.minima.empty()) break;
      constexpr std::size_t kStarts = 4;
      if (closer.minima.size() > kStarts) closer.minima.resize(kStarts);
      for (const Start& start : closer.minima)
        if (start.reachable < lowest(minima).sum_of_squares) descend_from(start);
    }
  // a scan that was nowhere finite knows of no value that would fit
  const bool any_scanned =
      std::isfinite(scanned.lowest) && std::any_of(problem.parameters().begin(), problem.parameters().end(),
                                                   [](const FreeParameter& parameter) { return !parameter.start; });
  // Of the minima, not of the scan's places: a narrow basin between two of them goes far below both.
  double least = scanned.lowest;
  for (const Minimum& minimum : minima) least = std::min(least, minimum.sum_of_squares);
  if (any_scanned && (std::sqrt(scanned.highest) <= rounding || fits_as_well(scanned.highest, least))) {
    std::string names;
    for (const FreeParameter& parameter : problem.parameters()) names += (names.empty() ? "" : ", ") + parameter.name;
    return end(FitStatus::not_identifiable, "the data do not constrain " + names + ": every value in the range fits");
  }
  // At a bound the slope may vanish by symmetry where the cost is highest.
  if (minima.size() > 1)
    std::erase_if(minima, [&](const Minimum& minimum) { return is_peak_at_bound(problem, minimum); });
  if (minima.empty()) return end(FitStatus::not_converged, "no start led to a minimum");
  std::sort(minima.begin(), minima.end(), lower);
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
    return end(FitStatus::at_bound,
               "beyond " + place(problem, verdict.best.x) + " the model is not defined at these loads");
  // Without a barrier that does not fit, the interval reaches from one to the other and tells of both.
  const auto other = std::find_if(verdict.others.begin(), verdict.others.end(), [&](const Minimum& minimum) {
    const double best = verdict.best.sum_of_squares;
    return fits_as_well(minimum.sum_of_squares, best) &&
           (p > 1 || !fits_as_well(barrier(scanned, minimum.x[0], verdict.best.x[0]), best));
  });
  if (other != verdict.others.end())
    return end(FitStatus::multimodal, std::string("another minimum fits as well within the ") +
                                          (problem.known_errors() ? "standard errors: " : "scatter: ") +
                                          place(problem, other->x));
  if (edge)
    verdict.message =
        "the least squares lie on a bend of the cost, such as where a measured load is that of the fold: no standard "
        "error";
  return verdict;
}

}  // namespace mixity
