#include "fitting/standard_errors.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/input_error.h"
#include "base/number_text.h"
#include "base/threads.h"
#include "fitting/pull_off_rows.h"
#include "statistics/readings.h"
#include "statistics/steps.h"

namespace mixity {
namespace {

/// The slope of A against T at a point of a run sorted by T: that of the line through the points within a twentieth of
/// the run to either side, by number and by T, and one more. Where points are dense, nearer neighbours would give only
/// noise.
class Slopes {
 public:
  /// Both arguments must outlive this object.
  Slopes(const Dataset& data, const std::vector<std::size_t>& run) : data_(data), run_(run) {}

  /// Each k must be at least as large as the one before.
  double at(std::size_t k) {
    const std::size_t n = run_.size(), beside = n / 20;
    const double reach = (T(n - 1) - T(0)) / 20;
    while (T(begin_) < T(k) - reach) ++begin_;
    while (end_ < n && T(end_) <= T(k) + reach) ++end_;
    const std::size_t first = std::min(begin_, k - std::min(k, beside)), last = std::max(end_, k + beside + 1);
    extend(first - std::min<std::size_t>(first, 1), low_);
    extend(std::min(last + 1, n), high_);
    const auto points = static_cast<double>(high_.points - low_.points);
    const double sum_T = high_.T - low_.T, sum_A = high_.A - low_.A,
                 spread = high_.TT - low_.TT - sum_T * sum_T / points;
    return spread > 0 ? (high_.TA - low_.TA - sum_T * sum_A / points) / spread : 0;
  }

 private:
  struct Sums {
    std::size_t points = 0;  // the first of the run
    double T = 0, A = 0, TT = 0, TA = 0;
  };
  double T(std::size_t k) const { return data_.points[run_[k]].shear(); }
  void extend(std::size_t points, Sums& sums) const {
    const Point& middle = data_.points[run_[run_.size() / 2]];  // differences from it keep digits
    for (; sums.points < points; ++sums.points) {
      const double t = T(sums.points) - middle.shear(), a = data_.points[run_[sums.points]].A - middle.A;
      sums.T += t;
      sums.A += a;
      sums.TT += t * t;
      sums.TA += t * a;
    }
  }

  const Dataset& data_;
  const std::vector<std::size_t>& run_;
  Sums low_, high_;
  std::size_t begin_ = 0, end_ = 0;
};

/// Relative error s common to T and A. The middle of three neighbours in T deviates from their chord by e = A - w
/// A_before - (1-w) A_after, whose variance is s^2 times the sum below. The median over all triples is robust against
/// those near an instability, where the curve bends. Null with fewer than three.
std::optional<double> relative_scatter(const Dataset& data) {
  constexpr double kMedianOfChiSquare = 0.454936423119573;  // of one degree of freedom
  constexpr double kLeast = 1e-9;
  std::vector<std::vector<std::size_t>> runs = points_by_curve(data);
  std::vector<std::vector<double>> of_runs(runs.size());
  const auto find_ratios = [&](std::size_t which) {
    std::vector<std::size_t> run = std::move(runs[which]);
    std::vector<double>& ratios = of_runs[which];
    // repeated rows carry no information about errors
    const auto key = [&](std::size_t i) {
      return std::tuple(data.points[i].shear(), data.points[i].A, data.points[i].P);
    };
    std::sort(run.begin(), run.end(),
              [&](std::size_t i, std::size_t j) { return std::tuple(key(i), i) < std::tuple(key(j), j); });
    run.erase(std::unique(run.begin(), run.end(), [&](std::size_t i, std::size_t j) { return key(i) == key(j); }),
              run.end());
    for (auto begin = run.begin(), end = begin; begin != run.end();
         begin = end) {  // of the same T by place in the file
      while (end != run.end() && data.points[*end].shear() == data.points[*begin].shear()) ++end;
      std::sort(begin, end);
    }
    if (run.size() < 3) return;
    Slopes slopes(data, run);
    ratios.reserve(run.size() - 2);
    for (std::size_t i = 1; i + 1 < run.size(); ++i) {
      const Point &low = data.points[run[i - 1]], &mid = data.points[run[i]], &high = data.points[run[i + 1]];
      const double width = high.shear() - low.shear();
      if (!(width > 0)) continue;
      const double w = (high.shear() - mid.shear()) / width, slope = slopes.at(i);
      const double e = mid.A - w * low.A - (1 - w) * high.A;
      const auto variance = [&](const Point& q) { return q.A * q.A + slope * slope * q.T * q.T; };
      ratios.push_back(e * e / (variance(mid) + w * w * variance(low) + (1 - w) * (1 - w) * variance(high)));
    }
  };
  if (data.points.size() < kManyPoints)
    for (std::size_t run = 0; run < runs.size(); ++run) find_ratios(run);
  else
    parallel_for(runs.size(), find_ratios);
  std::vector<double> ratios;
  ratios.reserve(data.points.size());
  for (std::vector<double>& one : of_runs) {
    ratios.insert(ratios.end(), one.begin(), one.end());
    one = std::vector<double>();
  }
  if (ratios.size() < 3) return std::nullopt;
  return std::max(std::sqrt(median(std::move(ratios)) / kMedianOfChiSquare), kLeast);
}

ErrorModel understand(const Dataset& data, const std::string& name, const std::optional<StatedError>& stated,
                      const Dimension& dimension, double unit) {
  if (!stated) return {};
  const bool relative = stated->unit.text == "%";
  const bool fits = data.contact ? stated->unit.dimension == dimension : stated->unit.dimension == dimension::none;
  if (!relative && !fits)
    throw InputError(data.path, name + " is '" + shortest(stated->value) + (stated->unit.text.empty() ? "" : " ") +
                                    stated->unit.text + "'; it must be " +
                                    (data.contact ? describe(dimension) : "a number without a unit") +
                                    ", or a percentage such as 1%");
  if (!(stated->value >= 0)) throw InputError(data.path, name + " must not be below 0");
  return relative ? ErrorModel{0, stated->si()} : ErrorModel{stated->si() / unit, 0};
}

/// Raises errors of 0 to kLeastError of the largest value; returns their number.
std::size_t raise_zeros(std::vector<double>& errors, const Dataset& data, double Point::*quantity) {
  const auto is_zero = [](double error) { return !(error > 0); };
  const auto zeros = std::count_if(errors.begin(), errors.end(), is_zero);
  if (zeros > 0) std::replace_if(errors.begin(), errors.end(), is_zero, kLeastError * largest_value(data, quantity));
  return static_cast<std::size_t>(zeros);
}

/// The common ratio of errors to readings, to the digits of a file; null if there is none.
std::optional<ErrorModel> proportional(const Dataset& data, const std::vector<double>& sigma, double Point::*value) {
  constexpr double kDigits = 5e-3;
  std::vector<double> shares;
  for (std::size_t i = 0; i < sigma.size(); ++i)
    if (const double reading = std::abs(data.points[i].*value); reading > 0) shares.push_back(sigma[i] / reading);
  if (shares.empty()) return std::nullopt;
  const double share = median(shares);
  const bool all =
      std::all_of(shares.begin(), shares.end(), [&](double one) { return std::abs(one - share) <= kDigits * share; });
  return all && share > 0 ? std::optional(ErrorModel{0, share}) : std::nullopt;
}

/// The resolution of T and of A; 0: none found.
std::pair<double, double> steps(const Dataset& data) {
  std::vector<std::vector<double>> T, A;
  for (const auto& run : points_by_curve(data)) {
    T.emplace_back().reserve(run.size());
    A.emplace_back().reserve(run.size());
    for (const std::size_t i : run) {
      T.back().push_back(data.points[i].shear());
      A.back().push_back(data.points[i].A);
    }
  }
  return {common_step(T), common_step(A)};
}

}  // namespace

double largest_value(const Dataset& data, double Point::*quantity) {
  double most = 0;
  for (const Point& point : data.points) most = std::max(most, std::abs(point.*quantity));
  return most > 0 ? most : 1;
}

StandardErrors standard_errors(const Dataset& data, const std::optional<StatedError>& sigma_T,
                               const std::optional<StatedError>& sigma_A, bool both_axes, const StandardErrors* whole) {
  const auto any = [&](auto says) { return std::any_of(data.errors.begin(), data.errors.end(), says); };
  const ErrorModel stated_T =
      understand(data, "sigma_T", sigma_T, dimension::force, data.contact ? data.contact->force_unit() : 1);
  const ErrorModel stated_A =
      understand(data, "sigma_A", sigma_A, dimension::area, data.contact ? data.contact->area_unit() : 1);
  if (sigma_A && !both_axes && stated_A.constant + stated_A.share == 0)
    throw InputError(data.path, "sigma_A must be greater than 0: objective toughness weighs its points by it");
  const bool has_A = sigma_A || any([](const PointErrors& e) { return e.A >= 0; });
  const bool has_T = sigma_T || any([](const PointErrors& e) { return e.T >= 0; });
  StandardErrors errors;
  if (!data.pull_off.empty()) errors.pull_off = assumed_pull_off_error(data);
  errors.source_A = sigma_A ? ErrorSource::stated : has_A ? ErrorSource::columns : ErrorSource::scatter;
  errors.source_T = sigma_T               ? ErrorSource::stated
                    : has_T               ? ErrorSource::columns
                    : has_A && !both_axes ? ErrorSource::exact
                                          : ErrorSource::scatter;
  if (!has_A || errors.source_T == ErrorSource::scatter) {
    constexpr double kAssumed = 0.01;
    const bool assumed = whole && (whole->source_A == ErrorSource::assumed || whole->source_T == ErrorSource::assumed);
    if (!assumed) errors.scatter = whole && whole->scatter ? whole->scatter : relative_scatter(data);
    for (ErrorSource* source : {&errors.source_A, &errors.source_T})
      if (!errors.scatter && *source == ErrorSource::scatter) *source = ErrorSource::assumed;
    if (!errors.scatter) errors.scatter = kAssumed;
  }
  const auto error = [&](ErrorSource source, const ErrorModel& stated, double value, double column) {
    switch (source) {
      case ErrorSource::stated:
        return stated.at(value);
      case ErrorSource::columns:
        return column;
      case ErrorSource::scatter:
      case ErrorSource::assumed:
        return *errors.scatter * std::abs(value);
      case ErrorSource::exact:
        break;
    }
    return 0.0;
  };
  errors.T.reserve(data.points.size());
  errors.A.reserve(data.points.size());
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const Point& point = data.points[i];
    const PointErrors columns = data.errors_of(i);
    errors.T.push_back(error(errors.source_T, stated_T, point.shear(), columns.T));
    errors.A.push_back(error(errors.source_A, stated_A, point.A, columns.A));
    if (errors.A.back() < 0 || (!both_axes && errors.A.back() == 0))
      refuse_value(data, point, "sigma_A",
                   std::string("this point has no standard error of its area (sigma_A is ") +
                       (both_axes ? "empty)" : "0 or empty)"));
    if (errors.T.back() < 0)
      refuse_value(data, point, "sigma_T",
                   "this point has no standard error of its shear load (sigma_T is empty; 0 says that T is exact)");
  }
  std::tie(errors.step_T, errors.step_A) = whole ? std::pair(whole->step_T, whole->step_A) : steps(data);
  const auto model = [&](ErrorSource source, const ErrorModel& stated, const std::vector<double>& sigma,
                         double Point::*value) -> std::optional<ErrorModel> {
    if (source == ErrorSource::columns) return proportional(data, sigma, value);
    return source == ErrorSource::stated  ? stated
           : source == ErrorSource::exact ? ErrorModel{}
                                          : ErrorModel{0, *errors.scatter};
  };
  errors.model_T = model(errors.source_T, stated_T, errors.T, &Point::T);
  errors.model_A = model(errors.source_A, stated_A, errors.A, &Point::A);
  if (both_axes) {
    const std::size_t zeros_T = raise_zeros(errors.T, data, &Point::T),
                      zeros_A = raise_zeros(errors.A, data, &Point::A);
    // an error of 0 that is a percentage of T = 0 was not stated as 0
    if (errors.source_T == ErrorSource::columns || (sigma_T && stated_T.constant + stated_T.share == 0))
      errors.raised_T = zeros_T;
    if (errors.source_A == ErrorSource::columns || (sigma_A && stated_A.constant + stated_A.share == 0))
      errors.raised_A = zeros_A;
  }
  return errors;
}

}  // namespace mixity
