#include "fitting/prediction.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "fitting/predicted_area.h"

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

template <class Model>
std::vector<AreaPrediction> predict(const Dataset& data, const FitResult& fit, const FitOptions& options,
                                    std::span<const double> P, std::span<const double> T) {
  const auto at_all = [&](const FitResult& with) {
    PredictedAreas<Model> predicted(fitted_candidate<Model>(data, with, options));
    std::vector<PredictedArea> areas;
    for (std::size_t i = 0; i < P.size(); ++i) areas.push_back(predicted.at(P[i], T[i]));
    return areas;
  };
  std::vector<AreaPrediction> predictions;
  for (const PredictedArea& area : at_all(fit)) {
    const bool ok = area.state == PredictedArea::State::equilibrium;
    predictions.push_back({ok                                              ? EquilibriumStatus::ok
                           : area.state == PredictedArea::State::undefined ? EquilibriumStatus::invalid
                                                                           : EquilibriumStatus::no_equilibrium,
                           ok ? area.value : 0});
  }
  const std::vector<std::size_t> free = uncertain_parameters(fit);
  if (free.empty()) return predictions;
  constexpr double kStep = 1e-3;  // standard errors
  // derivatives times standard errors, [parameter][point]; beyond the fold on one side, the other one tells
  std::vector<std::vector<double>> slopes;
  for (const std::size_t k : free) {
    const FittedParameter& parameter = fit.parameters[k];
    const auto moved = [&](double steps) {
      FitResult one = fit;
      one.parameters[k].value =
          std::clamp(*parameter.value + steps * kStep * *parameter.stderr_, parameter.lower, parameter.upper);
      return std::pair(at_all(one), (*one.parameters[k].value - *parameter.value) / *parameter.stderr_);
    };
    const auto [below, down] = moved(-1);
    const auto [above, up] = moved(1);
    std::vector<double>& slope = slopes.emplace_back();
    for (std::size_t i = 0; i < P.size(); ++i) {
      const bool low = below[i].state == PredictedArea::State::equilibrium,
                 high = above[i].state == PredictedArea::State::equilibrium;
      const double A = predictions[i].A, from = low ? below[i].value : A, to = high ? above[i].value : A,
                   width = (high ? up : 0) - (low ? down : 0);
      slope.push_back(width > 0 ? (to - from) / width : 0);
    }
  }
  const std::size_t p = free.size();
  for (std::size_t i = 0; i < P.size(); ++i) {
    if (predictions[i].status != EquilibriumStatus::ok) continue;
    double variance = 0;
    for (std::size_t k = 0; k < p; ++k)
      for (std::size_t l = 0; l < p; ++l)
        variance += slopes[k][i] * slopes[l][i] *
                    (k == l                             ? 1
                     : fit.correlations.size() == p * p ? fit.correlations[k * p + l]
                                                        : 0);
    predictions[i].standard_error = std::sqrt(std::max(variance, 0.0));
  }
  return predictions;
}

}  // namespace

std::vector<AreaPrediction> predict_areas_of(const Dataset& data, const FitResult& fit, const FitOptions& options,
                                             std::span<const double> P, std::span<const double> T) {
  if (!has_all_values(fit)) return {};
  std::vector<AreaPrediction> predictions;
  if (!with_model(fit.model, [&](auto model) { predictions = predict<decltype(model)>(data, fit, options, P, T); }))
    throw std::invalid_argument("no model is called '" + fit.model + "'");
  return predictions;
}

}  // namespace mixity
