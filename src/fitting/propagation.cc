#include "fitting/propagation.h"

#include <algorithm>
#include <cmath>

namespace mixity {
namespace {

/// Free parameters with standard errors, in the order of FitResult::correlations; empty if one has none.
std::vector<std::size_t> uncertain_parameters(const FitResult& fit) {
  std::vector<std::size_t> free;
  for (std::size_t k = 0; k < fit.parameters.size(); ++k) {
    if (fit.parameters[k].held) continue;
    if (!fit.parameters[k].stderr_) return {};
    free.push_back(k);
  }
  return free;
}

}  // namespace

std::vector<Derived> propagate(const FitResult& fit, const Follows& follows) {
  std::vector<Derived> numbers;
  for (const std::optional<double>& value : follows(fit)) numbers.push_back({value, {}});
  const std::vector<std::size_t> free = uncertain_parameters(fit);
  if (free.empty()) return numbers;
  constexpr double kStep = 1e-3;            // standard errors
  std::vector<std::vector<double>> slopes;  // derivatives times standard errors, [parameter][number]
  std::vector<bool> linear(numbers.size(), true);
  for (const std::size_t k : free) {
    const FittedParameter& parameter = fit.parameters[k];
    const auto moved = [&](double steps) {
      FitResult one = fit;
      one.parameters[k].value =
          std::clamp(*parameter.value + steps * kStep * *parameter.stderr_, parameter.lower, parameter.upper);
      return std::pair(follows(one), (*one.parameters[k].value - *parameter.value) / *parameter.stderr_);
    };
    for (const double whole : {-1 / kStep, 1 / kStep}) {
      const auto there = moved(whole).first;
      for (std::size_t i = 0; i < numbers.size(); ++i) linear[i] = linear[i] && there[i];
    }
    const auto [below, down] = moved(-1);
    const auto [above, up] = moved(1);
    std::vector<double>& slope = slopes.emplace_back();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const double at = numbers[i].value.value_or(0), from = below[i].value_or(at), to = above[i].value_or(at);
      const double width = (above[i] ? up : 0) - (below[i] ? down : 0);
      slope.push_back(width > 0 ? (to - from) / width : 0);
    }
  }
  const std::size_t p = free.size();
  const auto correlation = [&](std::size_t k, std::size_t l) {
    return k == l ? 1 : fit.correlations.size() == p * p ? fit.correlations[k * p + l] : 0;
  };
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!numbers[i].value || !linear[i]) continue;
    double variance = 0;
    for (std::size_t k = 0; k < p; ++k)
      for (std::size_t l = 0; l < p; ++l) variance += slopes[k][i] * slopes[l][i] * correlation(k, l);
    numbers[i].standard_error = std::sqrt(std::max(variance, 0.0));
  }
  return numbers;
}

}  // namespace mixity
