#include "fitting/fitted_errors.h"

#include <algorithm>
#include <cmath>

namespace mixity {
std::vector<double> of_points(const std::vector<double>& all, std::span<const std::size_t> used) {
  std::vector<double> some;
  if (!all.empty())
    for (const std::size_t i : used) some.push_back(all[i]);
  return some;
}

double evaluate_errors(const Dataset& data, std::span<const std::size_t> used, const NearestPlaces& nearest,
                       StandardErrors& errors) {
  double change = 0;
  const auto evaluate = [&](const std::optional<ErrorModel>& model, bool estimated, double step, double Point::*reading,
                            const std::vector<double>& at, double least, std::vector<double>& sigma) {
    if (!model) return;
    const double rounding = estimated ? step / std::sqrt(12.0) : 0;
    const auto error = [&](std::size_t point, double value) {
      const bool scaled = estimated && !errors.run_factors.empty();
      const double factor = scaled ? errors.run_factors[data.points[point].curve] : 1;
      return std::max(std::hypot(factor * model->at(value), rounding), least);
    };
    const std::vector<double> before = sigma;
    for (std::size_t point = 0; point < sigma.size(); ++point)
      sigma[point] = error(point, std::abs(data.points[point].*reading));
    for (std::size_t i = 0; i < used.size(); ++i) {
      sigma[used[i]] = error(used[i], at[i]);
      change = std::max(change, std::abs(sigma[used[i]] / before[used[i]] - 1));
    }
  };
  evaluate(errors.model_T, !StandardErrors::is_known(errors.source_T), errors.step_T, &Point::T, nearest.T,
           kLeastError * largest_value(data, &Point::T), errors.T);
  evaluate(errors.model_A, !StandardErrors::is_known(errors.source_A), errors.step_A, &Point::A, nearest.A,
           kLeastError * largest_value(data, &Point::A), errors.A);
  errors.load_T.resize(data.points.size());
  errors.load_A.resize(data.points.size(), 1.0);
  for (std::size_t i = 0; i < used.size(); ++i) {
    errors.load_T[used[i]] = nearest.load_T[i];
    errors.load_A[used[i]] = nearest.load_A[i];
  }
  return change;
}

std::vector<double> variance_ratios(const Dataset& data, std::span<const std::size_t> used,
                                    const StandardErrors& errors) {
  std::vector<double> ratios(used.size(), 1.0);
  if (!errors.scatter || errors.load_T.empty()) return ratios;
  const auto by_reading = [&](ErrorSource source, double sigma, double value) {
    return StandardErrors::is_known(source) ? 1 : std::pow(*errors.scatter * value / sigma, 2);
  };
  for (std::size_t i = 0; i < used.size(); ++i) {
    const std::size_t k = used[i];
    const double T = by_reading(errors.source_T, errors.T[k], data.points[k].shear()),
                 A = by_reading(errors.source_A, errors.A[k], data.points[k].A);
    ratios[i] = 1 / (std::pow(errors.load_T[k], 2) * T + std::pow(errors.load_A[k], 2) * A);
  }
  return ratios;
}

std::shared_ptr<const Decorrelation> decorrelation_of(const Dataset& data, std::span<const std::size_t> used,
                                                      const StandardErrors& errors) {
  if (!errors.correlations.any()) return nullptr;
  return std::make_shared<Decorrelation>(
      processes_of(data, used, of_points(errors.load_T, used), of_points(errors.load_A, used)), errors.correlations);
}

double log_variances(const Dataset& data, std::span<const std::size_t> used, const StandardErrors& errors) {
  double sum = 0;
  for (const double ratio : variance_ratios(data, used, errors)) sum += std::log(ratio);
  const auto decorrelation = decorrelation_of(data, used, errors);
  return decorrelation ? sum + decorrelation->log_determinant() : sum;
}

}  // namespace mixity
