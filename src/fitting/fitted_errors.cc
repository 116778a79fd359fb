#include "fitting/fitted_errors.h"

#include <algorithm>
#include <cmath>

#include "base/threads.h"
#include "fitting/run_differences.h"
#include "fitting/whitening.h"

namespace mixity {

std::vector<double> of_points(const std::vector<double>& all, const PointIndices& used) {
  std::vector<double> some;
  if (all.empty()) return some;
  some.reserve(used.size());
  for (const std::size_t i : used) some.push_back(all[i]);
  return some;
}

namespace {

/// Sets the elements of `all` at these points. Takes the array itself if these are all: each counts with millions.
void put(const PointIndices& used, std::vector<double>&& some, std::size_t n, double otherwise,
         std::vector<double>& all) {
  if (used.are_all(n)) {
    all = std::move(some);
    return;
  }
  all.resize(n, otherwise);
  for (std::size_t i = 0; i < used.size(); ++i) all[used[i]] = some[i];
}

}  // namespace

void keep_places(const Dataset& data, const PointIndices& used, NearestPlaces&& nearest, StandardErrors& errors) {
  put(used, std::move(nearest.T), data.points.size(), 0, errors.place_T);
  put(used, std::move(nearest.A), data.points.size(), 0, errors.place_A);
}

double evaluate_errors(const Dataset& data, const PointIndices& used, NearestPlaces&& nearest, StandardErrors& errors) {
  double change = 0;
  const bool all = used.are_all(data.points.size());
  const auto evaluate = [&](const std::optional<ErrorModel>& model, bool estimated, double step, double Point::*reading,
                            const std::vector<double>& at, double least, std::vector<double>& sigma) {
    if (!model) return;
    const double rounding = estimated ? step / std::sqrt(12.0) : 0;
    const auto error = [&](std::size_t point, double value) {
      const bool scaled = estimated && !errors.run_factors.empty();
      const double factor = scaled ? errors.run_factors[data.points[point].curve] : 1;
      const double found = factor * model->at(value);
      return std::max(rounding > 0 ? std::hypot(found, rounding) : found, least);
    };
    std::vector<double> before;
    if (!all) {
      before = sigma;
      for (std::size_t point = 0; point < sigma.size(); ++point)
        sigma[point] = error(point, std::abs(data.points[point].*reading));
    }
    constexpr std::size_t kPart = 1 << 15;
    std::vector<double> changes((used.size() + kPart - 1) / kPart);
    parallel_for(changes.size(), [&](std::size_t part) {
      for (std::size_t i = part * kPart; i < std::min(used.size(), (part + 1) * kPart); ++i) {
        double& one = sigma[used[i]];
        const double last = all ? one : before[used[i]];
        one = error(used[i], at[i]);
        changes[part] = std::max(changes[part], std::abs(one / last - 1));
      }
    });
    for (const double one : changes) change = std::max(change, one);
  };
  evaluate(errors.model_T, !StandardErrors::is_known(errors.source_T), errors.step_T, &Point::T, nearest.T,
           kLeastError * largest_value(data, &Point::T), errors.T);
  evaluate(errors.model_A, !StandardErrors::is_known(errors.source_A), errors.step_A, &Point::A, nearest.A,
           kLeastError * largest_value(data, &Point::A), errors.A);
  put(used, std::move(nearest.load_T), data.points.size(), 0, errors.load_T);
  put(used, std::move(nearest.load_A), data.points.size(), 1, errors.load_A);
  keep_places(data, used, std::move(nearest), errors);
  return change;
}

double variance_ratio(const Dataset& data, const StandardErrors& errors, std::size_t point) {
  if (!errors.scatter || errors.load_A.empty()) return errors.factor * errors.factor;
  const auto by_reading = [&](ErrorSource source, double sigma, double value) {
    return StandardErrors::is_known(source) ? 1 : std::pow(*errors.scatter * value / sigma, 2);
  };
  const double T = by_reading(errors.source_T, errors.T[point], data.points[point].shear()),
               A = by_reading(errors.source_A, errors.A[point], data.points[point].A);
  return 1 / (errors.square_of_load_T(point) * T + std::pow(errors.load_A[point], 2) * A);
}

double log_variances_of_axes(const Dataset& data, const PointIndices& used, const StandardErrors& errors) {
  double sum = 0;
  for (const std::size_t i : used) {
    if (!std::isfinite(beside(data)[i].q) || beside(data)[i].sigma_q > 0) continue;
    const bool known = StandardErrors::is_known(errors.source_A) || !errors.scatter;
    sum += 2 * std::log(errors.factor * errors.axes_factor *
                        (known ? 1 : errors.A[i] / (data.points[i].A * *errors.scatter)));
  }
  return sum;
}

std::vector<double> taken_off(const Dataset& data, const PointIndices& used, const StandardErrors& errors) {
  std::vector<double> list = of_points(errors.expected, used);
  const RunDifferences& runs = errors.runs;
  for (std::size_t q = 0; q < runs.spreads.size(); ++q) {
    list.resize(used.size(), 0.0);
    for (std::size_t i = 0; i < used.size(); ++i)
      list[i] += runs.columns[q][used[i]] * runs.deviations[q][data.points[used[i]].curve];
  }
  return list;
}

std::optional<Decorrelation> neighbours_of(const Dataset& data, const PointIndices& used,
                                           const StandardErrors& errors) {
  if (!errors.correlations.any()) return std::nullopt;
  return Decorrelation(processes_of(data, used, of_points(errors.load_T, used), of_points(errors.load_A, used)),
                       {errors.correlations});
}

std::optional<GroupWhitening> whitening_of_runs(const Dataset& data, const PointIndices& used,
                                                const StandardErrors& errors,
                                                const std::optional<Decorrelation>& neighbours) {
  if (errors.runs.spreads.empty()) return std::nullopt;
  Eigen::MatrixXd Z(static_cast<Eigen::Index>(used.size()), static_cast<Eigen::Index>(errors.runs.columns.size()));
  for (std::size_t q = 0; q < errors.runs.columns.size(); ++q) {
    std::vector<double> column = of_points(errors.runs.columns[q], used);
    if (neighbours) neighbours->apply(column);
    Z.col(static_cast<Eigen::Index>(q)) = as_vector(column);
  }
  return GroupWhitening(std::move(Z), as_vector(errors.runs.spreads), used_runs(data, used).groups);
}

std::shared_ptr<const Whitening> whitening_of(const Dataset& data, const PointIndices& used,
                                              const StandardErrors& errors) {
  auto neighbours = neighbours_of(data, used, errors);
  auto runs = whitening_of_runs(data, used, errors, neighbours);
  if (!neighbours && !runs) return nullptr;
  return std::make_shared<Whitening>(std::move(neighbours), std::move(runs));
}

double log_variances(const Dataset& data, const PointIndices& used, const StandardErrors& errors) {
  double sum = 0;
  for (const std::size_t point : used) sum += std::log(variance_ratio(data, errors, point));
  const auto whitening = whitening_of(data, used, errors);
  return whitening ? sum + whitening->log_determinant() : sum;
}

double mean_error_of_loads(const Dataset& data, const FitResult& fit) {
  double sum = 0, count = 0, largest = 0;
  for (const std::size_t i : fit.used)
    if (std::isfinite(data.loads_beside[i].q)) largest = std::max(largest, std::abs(data.loads_beside[i].q));
  for (const std::size_t i : fit.used) {
    const PointAxes& load = data.loads_beside[i];
    if (!std::isfinite(load.q)) continue;
    sum += load.sigma_q > 0 ? load.sigma_q : fit.errors->axes_factor * fit.errors->A[i] / data.points[i].A * largest;
    ++count;
  }
  return sum / count * data.display.force_scale;
}

}  // namespace mixity
