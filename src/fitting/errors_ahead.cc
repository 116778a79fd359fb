#include "fitting/errors_ahead.h"

#include <cmath>
#include <utility>
#include <vector>

namespace mixity {
namespace {

/// Calls use(number) for all numbers of a model, in a fixed order.
template <class Models, class Use>
void each_size(Models& models, const Use& use) {
  for (const auto axis : {&ErrorModels::T, &ErrorModels::A})
    if (models.*axis) {
      use((models.*axis)->constant);
      use((models.*axis)->share);
    }
  for (auto& factor : models.run_factors) use(factor);
}
template <class Models, class Use>
void each_correlation(Models& models, const Use& use) {
  use(models.correlations.first);
  use(models.correlations.second);
}

/// Logarithms of sizes and inverse hyperbolic tangents of correlations; those that are 0 are left out.
Eigen::VectorXd numbers_of(const ErrorModels& models) {
  std::vector<double> list;
  each_size(models, [&](double size) {
    if (size > 0) list.push_back(std::log(size));
  });
  each_correlation(models, [&](double correlation) {
    if (correlation > 0) list.push_back(std::atanh(correlation));
  });
  return Eigen::Map<const Eigen::VectorXd>(list.data(), static_cast<Eigen::Index>(list.size()));
}

ErrorModels with_numbers(ErrorModels models, const Eigen::VectorXd& numbers) {
  Eigen::Index k = 0;
  each_size(models, [&](double& size) {
    if (size > 0) size = std::exp(numbers[k++]);
  });
  each_correlation(models, [&](double& correlation) {
    if (correlation > 0) correlation = std::tanh(numbers[k++]);
  });
  return models;
}

/// Whether the same numbers are 0.
bool have_same_parts(const ErrorModels& one, const ErrorModels& other) {
  const auto zeros = [](const ErrorModels& models) {
    std::vector<bool> list;
    const auto add = [&](double x) { list.push_back(x > 0); };
    each_size(models, add);
    each_correlation(models, add);
    return list;
  };
  return one.run_factors.size() == other.run_factors.size() && zeros(one) == zeros(other);
}

}  // namespace

ErrorModels ErrorsAhead::next(const ErrorModels& from, const ErrorModels& to) {
  constexpr double kFar = 10;  // times the last change: a longer step is not believed
  if (!have_same_parts(from, to)) {
    last_.reset();
    return to;
  }
  const Eigen::VectorXd found = numbers_of(to), change = found - numbers_of(from);
  const std::optional<Round> before = std::exchange(last_, Round{found, change});
  if (!before || before->found.size() != found.size()) return to;
  const Eigen::VectorXd less = before->change - change;
  const Eigen::VectorXd step = (found - before->found) * (less.dot(change) / less.squaredNorm());
  const bool back = -step.dot(change) > change.squaredNorm();  // beyond where the round began: rounds that lead away
  if (!step.allFinite() || back || step.lpNorm<Eigen::Infinity>() > kFar * change.lpNorm<Eigen::Infinity>()) return to;
  return with_numbers(to, found + step);
}

}  // namespace mixity
