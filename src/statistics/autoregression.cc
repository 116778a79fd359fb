#include "statistics/autoregression.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace mixity {
namespace {

constexpr double kClosest = 0.98;  // a larger correlation would be a drift

/// The first runs with about `enough` deviations together, and these.
struct Beginning {
  TwoProcesses processes;
  std::vector<double> deviations{};
};

Beginning beginning(const TwoProcesses& all, std::span<const double> deviations, std::size_t enough) {
  Beginning some{{{}, {}, {}, {}, std::vector<std::vector<double>>(all.own.size())}};
  TwoProcesses& to = some.processes;
  for (const auto& run : all.runs) {
    auto& copy = to.runs.emplace_back();
    for (const std::size_t i : run) {
      if (some.deviations.size() >= enough) break;
      copy.push_back(some.deviations.size());
      some.deviations.push_back(deviations[i]);
      to.places.push_back(all.places[i]);
      to.first.push_back(all.first[i]);
      to.second.push_back(all.second[i]);
      for (std::size_t q = 0; q < to.own.size(); ++q) to.own[q].push_back(all.own[q][i]);
    }
  }
  return some;
}

// Constants, since of indices that a loop makes doubles Emscripten 3.1.6 forms wrong vectors.
constexpr Trials kShares{0, 1 / 7.0, 2 / 7.0, 3 / 7.0, 4 / 7.0, 5 / 7.0, 6 / 7.0, 1};
Trials evenly(double low, double high) {
  Trials x;
  for (std::size_t t = 0; t < kTrials; ++t) x[t] = low + (high - low) * kShares[t];
  x.back() = high;
  return x;
}

/// Where the polynomial through these nodes is the highest, near the best of them, which has neighbours.
double peak_of(const Trials& x, const Trials& values, std::size_t best) {
  const double step = x[best + 1] - x[best], rise = values[best] - values[best - 1],
               fall = values[best] - values[best + 1];
  if (!(rise + fall > 0)) return x[best];
  const double of_parabola = x[best] + step * (rise - fall) / (2 * (rise + fall));
  Trials divided = values;  // differences (Newton)
  for (std::size_t order = 1; order < kTrials; ++order)
    for (std::size_t t = kTrials - 1; t >= order; --t)
      divided[t] = (divided[t] - divided[t - 1]) / (x[t] - x[t - order]);
  double peak = of_parabola;
  for (int i = 0; i < 3; ++i) {
    double value = divided[kTrials - 1], slope = 0, curvature = 0;
    for (std::size_t t = kTrials - 1; t-- > 0;) {
      curvature = curvature * (peak - x[t]) + 2 * slope;
      slope = slope * (peak - x[t]) + value;
      value = value * (peak - x[t]) + divided[t];
    }
    peak -= slope / curvature;
  }
  return std::abs(peak - of_parabola) < 0.5 * step ? peak : of_parabola;  // not where values have a kink
}

/// The x in [low, high] with the largest of the values(x), to about 1e-6 of their distance: by grids, each between the
/// neighbours of the last one's best node, and the polynomial through the last. `tried`: the first grid.
template <class Values>
double highest_of(const Values& values, Trials tried) {
  constexpr int kGrids = 3;
  for (int grid = 1;; ++grid) {
    const Trials found = values(tried);
    const auto best = static_cast<std::size_t>(std::max_element(found.begin(), found.end()) - found.begin());
    const bool inside = best > 0 && best + 1 < kTrials;
    if (grid == kGrids) return inside ? peak_of(tried, found, best) : tried[best];
    tried = evenly(tried[best > 0 ? best - 1 : 0], tried[std::min(best + 1, kTrials - 1)]);
  }
}

/// Kalman's filter of a run: the covariance of u and v predicted from the deviations before, and what a deviation says.
struct Filter {
  const TwoProcesses& processes;
  const ScaledCorrelations& at;
  double p11 = 1, p12 = 0, p22 = 1;
  double d1 = 1, d2 = 1;  // decays since the last deviation
  double l1 = 0, l2 = 0;  // weights of u and v
  double u = 0, v = 0;    // their covariances with the deviation
  double variance = 0;    // of the deviation

  /// Predicts deviation k of the run.
  void predict(const std::vector<std::size_t>& run, std::size_t k) {
    const std::size_t i = run[k];
    if (k == 0) {
      p11 = p22 = 1;
      p12 = 0;
    } else {
      const double apart = processes.places[i] - processes.places[run[k - 1]];
      const auto decay = [apart](double correlation) {
        return apart == 1 ? correlation : std::pow(correlation, apart);
      };
      d1 = decay(at.correlations.first);
      d2 = decay(at.correlations.second);
      p11 = d1 * d1 * p11 + 1 - d1 * d1;
      p22 = d2 * d2 * p22 + 1 - d2 * d2;
      p12 *= d1 * d2;
    }
    l1 = at.first * processes.first[i];
    l2 = at.second * processes.second[i];
    u = p11 * l1 + p12 * l2;
    v = p12 * l1 + p22 * l2;
    variance = l1 * u + l2 * v;
  }
  void learn() {
    const double gain_1 = u / variance, gain_2 = v / variance;
    p11 -= u * gain_1;
    p12 -= u * gain_2;
    p22 -= v * gain_2;
  }
};

}  // namespace

Decorrelation::Decorrelation(const TwoProcesses& processes, const ScaledCorrelations& at)
    : predicted_across_(processes.places.size()) {
  steps_.reserve(processes.places.size());
  Filter filter{processes, at};
  for (const auto& run : processes.runs)
    for (std::size_t k = 0; k < run.size(); ++k) {
      filter.predict(run, k);
      const auto& [l1, l2, variance] = std::tie(filter.l1, filter.l2, filter.variance);
      predicted_across_[run[k]] =
          1 - (l2 * l2 * filter.p11 - 2 * l1 * l2 * filter.p12 + l1 * l1 * filter.p22) / (l1 * l1 + l2 * l2);
      steps_.push_back({run[k], k == 0, filter.d1, filter.d2, l1, l2, filter.u / variance, filter.v / variance,
                        1 / std::sqrt(variance)});
      log_determinant_ += std::log(variance);
      filter.learn();
    }
}

void Decorrelation::apply(std::span<double> values, std::size_t stride) const {
  double u = 0, v = 0;
  for (const Step& step : steps_) {
    u = step.begins ? 0 : u * step.decay_1;
    v = step.begins ? 0 : v * step.decay_2;
    double& value = values[step.row * stride];
    const double innovation = value - step.first * u - step.second * v;
    u += step.gain_1 * innovation;
    v += step.gain_2 * innovation;
    value = innovation * step.per_sd;
  }
}

namespace {

constexpr Trials kTried{0, 0.2, 0.4, 0.6, 0.75, 0.87, 0.95, kClosest};

/// ln L with the most likely unit of the deviations, at several correlations.
class OfAnyUnit {
 public:
  OfAnyUnit(const TwoProcesses& processes, std::span<const double> deviations,
            const std::function<double(double)>& second_factor)
      : processes_(processes), deviations_(deviations), second_factor_(second_factor) {}

  using Many = std::array<NeighbourCorrelations, kTrials>;
  Trials operator()(const Many& many) const {
    std::array<ScaledCorrelations, kTrials> trials;
    for (std::size_t t = 0; t < kTrials; ++t) trials[t] = {many[t], 1, second_factor_(many[t].second)};
    const auto [squares, n, log_determinant] = independent(processes_, deviations_, trials);
    Trials values;
    for (std::size_t t = 0; t < kTrials; ++t)
      values[t] = squares[t] > 0 ? -(n[t] * std::log(squares[t] / n[t]) + log_determinant[t]) / 2 : 0;
    return values;
  }
  double operator()(const NeighbourCorrelations& one) const {
    Many all;
    all.fill(one);
    return (*this)(all)[0];
  }

 private:
  const TwoProcesses& processes_;
  std::span<const double> deviations_;
  const std::function<double(double)>& second_factor_;
};

/// The x in the range of `tried` at which the correlations at(x) are the most likely; there may be several maxima.
template <class At>
double highest(const OfAnyUnit& value, const At& at, const Trials& tried = kTried) {
  return highest_of(
      [&](const Trials& x) {
        OfAnyUnit::Many many;
        std::transform(x.begin(), x.end(), many.begin(), at);
        return value(many);
      },
      tried);
}

/// The same between those of kTried on either side of `from`.
template <class At>
double highest_near(const OfAnyUnit& value, const At& at, double from) {
  const auto above = std::upper_bound(kTried.begin() + 1, kTried.end() - 1, from);
  const auto below = std::lower_bound(kTried.begin() + 1, kTried.end() - 1, from) - 1;
  return highest(value, at, evenly(*below, *above));
}

}  // namespace

ChosenCorrelations choose_correlations(const TwoProcesses& processes, std::span<const double> deviations,
                                       const std::function<double(double)>& second_factor) {
  constexpr int kRounds = 3;        // over the two correlations in turn
  constexpr double kHardly = 1e-3;  // change of a correlation that needs no further round
  constexpr double kNear = 2;       // tolerated shortfall of ln L at a few trial values from its maximum
  constexpr double kUndecided = 2;  // of ln L
  const Beginning some = beginning(processes, deviations, kDeciding);
  const std::size_t n = some.deviations.size();
  const OfAnyUnit value(some.processes, some.deviations, second_factor);
  const double price = 0.5 * std::log(static_cast<double>(std::max<std::size_t>(n, 2)));
  // ln L rises by n r^2/2 at a small correlation r of the residuals: the first value is the smallest worth its price.
  const double least = std::sqrt(2 * price / static_cast<double>(n));
  const Trials of_few =
      value({{{0, 0}, {least, 0}, {0, least}, {0.3, 0}, {0, 0.3}, {0.7, 0}, {0, 0.7}, {0, 0.92}}});
  const double without = of_few[0];
  ChosenCorrelations best{{}, without};
  double most = without;
  if (!(*std::max_element(of_few.begin(), of_few.end()) > without + price - kNear)) return best;
  const auto consider = [&](NeighbourCorrelations one, double here) {
    const double gain = here - price * ((one.first > 0) + (one.second > 0));
    if (!(gain > most)) return;
    most = gain;
    best = {one, here};
  };
  const double first = highest(value,
                               [](double x) {
                                 return NeighbourCorrelations{x, 0};
                               }),
               second = highest(value, [](double x) {
                 return NeighbourCorrelations{0, x};
               });
  const Trials of_one = value({{{first, 0}, {0, second}}});
  consider({first, 0}, of_one[0]);
  consider({0, second}, of_one[1]);
  if (!best.correlations.any()) return best;
  // One that both share is as simple as one of either. Where the data do not tell, it is what widens most.
  const double shared = highest(value,
                                [](double x) {
                                  return NeighbourCorrelations{x, x};
                                }),
               of_shared = value(NeighbourCorrelations{shared, shared});
  if (of_shared > best.log_likelihood - kUndecided && of_shared - price > without) {
    best = {{shared, shared}, of_shared};
    most = std::max(most, of_shared - price);
  }
  NeighbourCorrelations both{first, second};
  for (int round = 0; round < kRounds; ++round) {
    const NeighbourCorrelations last = both;
    const auto with_second = [&](double x) { return NeighbourCorrelations{both.first, x}; };
    both.second = round == 0 ? highest(value, with_second) : highest_near(value, with_second, both.second);
    const auto with_first = [&](double x) { return NeighbourCorrelations{x, both.second}; };
    both.first = round == 0 ? highest(value, with_first) : highest_near(value, with_first, both.first);
    if (std::abs(both.first - last.first) + std::abs(both.second - last.second) < kHardly) break;
  }
  // One of either has been considered: rounding would decide whether it is better than itself.
  if (both.first > 0 && both.second > 0) consider(both, value(both));
  return best;
}

ScaledCorrelations improve(const TwoProcesses& processes, std::span<const double> deviations,
                           const NeighbourCorrelations& from,
                           const std::function<double(const ScaledCorrelations&)>& more) {
  constexpr double kReach = 0.25;  // of ln(factor) and atanh(correlation)
  const Beginning some = beginning(processes, deviations, kDeciding);
  ScaledCorrelations best{from};
  const auto change = [&](auto&& set) {
    const double step = highest_of(
        [&](const Trials& x) {
          std::array<ScaledCorrelations, kTrials> trials;
          trials.fill(best);
          for (std::size_t t = 0; t < kTrials; ++t) set(trials[t], x[t]);
          const auto [squares, n, log_determinant] = independent(some.processes, some.deviations, trials);
          Trials values;
          for (std::size_t t = 0; t < kTrials; ++t)
            values[t] = -(squares[t] + log_determinant[t]) / 2 + more(trials[t]);
          return values;
        },
        evenly(-kReach, kReach));
    set(best, step);
  };
  for (const auto& [factor, correlation] : {std::pair(&ScaledCorrelations::first, &NeighbourCorrelations::first),
                                            std::pair(&ScaledCorrelations::second, &NeighbourCorrelations::second)}) {
    change([&, factor = factor](ScaledCorrelations& at, double x) { at.*factor *= std::exp(x); });
    if (!(best.correlations.*correlation > 0)) continue;
    change([&, factor = factor, correlation = correlation](ScaledCorrelations& at, double x) {
      double& rho = at.correlations.*correlation;
      const double innovation = 1 - rho * rho;
      rho = std::clamp(std::tanh(std::atanh(rho) + x), 0.0, kClosest);
      at.*factor *= std::sqrt(innovation / (1 - rho * rho));
    });
  }
  return best;
}

}  // namespace mixity
