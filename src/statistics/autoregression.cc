#include "statistics/autoregression.h"

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
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

/// The x in [low, high] with the largest f(x), to this many bits (Brent 1973).
template <class Function>
double highest_between(const Function& f, double low, double high, int bits) {
  return boost::math::tools::brent_find_minima([&](double x) { return -f(x); }, low, high, bits).first;
}

constexpr std::array kTried{0.0, 0.15, 0.3, 0.45, 0.6, 0.75, 0.85, 0.93, 0.97, kClosest};
constexpr int kBits = 14;

/// The x with the largest f(x) between those of kTried on either side of `from`.
template <class Function>
double highest_near(const Function& f, double from) {
  const auto above = std::upper_bound(kTried.begin() + 1, kTried.end() - 1, from);
  const auto below = std::lower_bound(kTried.begin() + 1, kTried.end() - 1, from) - 1;
  return highest_between(f, *below, *above, kBits);
}

/// The x in [0, kClosest] with the largest f(x), which may have several maxima.
template <class Function>
double highest(const Function& f) {
  std::size_t best = 0;
  double most = f(kTried[0]);
  for (std::size_t i = 1; i < kTried.size(); ++i)
    if (const double value = f(kTried[i]); value > most) {
      most = value;
      best = i;
    }
  return highest_between(f, kTried[best > 0 ? best - 1 : 0], kTried[std::min(best + 1, kTried.size() - 1)], kBits);
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

/// The sum of squares of the decorrelated deviations, their number, and ln of the determinant.
struct Independent {
  double squares = 0, n = 0, log_determinant = 0;
};

/// Subtracts what multiples of decorrelated columns explain in one run, one column after the other.
void take_off(const std::vector<std::size_t>& run, std::vector<std::vector<double>> columns,
              const std::vector<double>& values, Independent& result) {
  constexpr double kNone = 1e-12;  // relative to a column's square: it depends on those before
  const auto product = [&](const std::vector<double>& x, const std::vector<double>& y) {
    double sum = 0;
    for (const std::size_t i : run) sum += x[i] * y[i];
    return sum;
  };
  for (std::size_t q = 0; q < columns.size(); ++q) {
    const double whole = product(columns[q], columns[q]);
    for (std::size_t before = 0; before < q; ++before) {
      const double square = product(columns[before], columns[before]);
      if (!(square > 0)) continue;
      const double part = product(columns[before], columns[q]) / square;
      for (const std::size_t i : run) columns[q][i] -= part * columns[before][i];
    }
    const double square = product(columns[q], columns[q]);
    if (!(square > kNone * whole)) {
      for (const std::size_t i : run) columns[q][i] = 0;
      continue;
    }
    const double along = product(columns[q], values);
    result.squares -= along * along / square;
    result.log_determinant += std::log(square);
    --result.n;
  }
}

/// The sum of logarithms of positive numbers: those of products, which seldom near the limits of a double.
class SumOfLogarithms {
 public:
  void add(double x) {
    if (x < kSmall || x > 1 / kSmall) {
      sum_ += std::log(x);
      return;
    }
    product_ *= x;
    if (product_ > kSmall && product_ < 1 / kSmall) return;
    sum_ += std::log(product_);
    product_ = 1;
  }
  double sum() const { return sum_ + std::log(product_); }

 private:
  static constexpr double kSmall = 1e-100;
  double sum_ = 0, product_ = 1;
};

Independent independent(const TwoProcesses& processes, std::span<const double> deviations,
                        const ScaledCorrelations& at) {
  Independent result;
  if (processes.own.empty()) {
    Filter filter{processes, at};
    SumOfLogarithms logarithms;
    for (const auto& run : processes.runs) {
      double u = 0, v = 0;
      for (std::size_t k = 0; k < run.size(); ++k) {
        filter.predict(run, k);
        u *= filter.d1;
        v *= filter.d2;
        const double innovation = deviations[run[k]] - filter.l1 * u - filter.l2 * v,
                     share = innovation / filter.variance;
        u += filter.u * share;
        v += filter.v * share;
        filter.learn();
        result.squares += innovation * share;
        logarithms.add(filter.variance);
      }
      result.n += static_cast<double>(run.size());
    }
    result.log_determinant = logarithms.sum();
    return result;
  }
  const Decorrelation decorrelation(processes, at);
  std::vector<double> values(deviations.begin(), deviations.end());
  decorrelation.apply(values);
  result.log_determinant = decorrelation.log_determinant();
  for (const auto& run : processes.runs)
    for (const std::size_t i : run) {
      result.squares += values[i] * values[i];
      ++result.n;
    }
  std::vector<std::vector<double>> own = processes.own;
  for (auto& column : own) decorrelation.apply(column);
  for (const auto& run : processes.runs) take_off(run, own, values, result);
  return result;
}

/// ln L with the most likely unit of the deviations.
double log_likelihood_of_any_unit(const TwoProcesses& processes, std::span<const double> deviations,
                                  const ScaledCorrelations& at) {
  const auto [squares, n, log_determinant] = independent(processes, deviations, at);
  return squares > 0 ? -(n * std::log(squares / n) + log_determinant) / 2 : 0;
}

}  // namespace

double log_likelihood(const TwoProcesses& processes, std::span<const double> deviations, const ScaledCorrelations& at) {
  const auto [squares, n, log_determinant] = independent(processes, deviations, at);
  return -(squares + log_determinant) / 2;
}

ChosenCorrelations choose_correlations(const TwoProcesses& processes, std::span<const double> deviations,
                                       const std::function<double(double)>& second_factor) {
  constexpr int kRounds = 3;        // over the two correlations in turn
  constexpr double kHardly = 1e-3;  // change of a correlation that needs no further round
  constexpr double kNear = 2;       // tolerated shortfall of ln L at a few trial values from its maximum
  constexpr double kUndecided = 2;  // of ln L
  const Beginning some = beginning(processes, deviations, kDeciding);
  const std::size_t n = some.deviations.size();
  const auto value = [&](double first, double second) {
    return log_likelihood_of_any_unit(some.processes, some.deviations, {{first, second}, 1, second_factor(second)});
  };
  const double price = 0.5 * std::log(static_cast<double>(std::max<std::size_t>(n, 2)));
  const double without = value(0, 0);
  ChosenCorrelations best{{}, without};
  double most = without;
  bool promising = false;
  // ln L rises by n r^2/2 at a small correlation r of the residuals: the first value is the smallest worth its price.
  for (const double tried : {std::sqrt(2 * price / static_cast<double>(n)), 0.3, 0.7, 0.92})
    promising |= std::max(value(tried, 0), value(0, tried)) > most + price - kNear;
  if (!promising) return best;
  const auto consider = [&](NeighbourCorrelations one) {
    const double here = value(one.first, one.second), gain = here - price * ((one.first > 0) + (one.second > 0));
    if (!(gain > most)) return;
    most = gain;
    best = {one, here};
  };
  const double first = highest([&](double x) { return value(x, 0); }),
               second = highest([&](double x) { return value(0, x); });
  consider({first, 0});
  consider({0, second});
  if (!best.correlations.any()) return best;
  // One that both share is as simple as one of either. Where the data do not tell, it is what widens most.
  const double shared = highest([&](double x) { return value(x, x); }), of_shared = value(shared, shared);
  if (of_shared > best.log_likelihood - kUndecided && of_shared - price > without) {
    best = {{shared, shared}, of_shared};
    most = std::max(most, of_shared - price);
  }
  NeighbourCorrelations both{first, second};
  for (int round = 0; round < kRounds; ++round) {
    const NeighbourCorrelations last = both;
    const auto of_second = [&](double x) { return value(both.first, x); };
    both.second = round == 0 ? highest(of_second) : highest_near(of_second, both.second);
    const auto of_first = [&](double x) { return value(x, both.second); };
    both.first = round == 0 ? highest(of_first) : highest_near(of_first, both.first);
    if (std::abs(both.first - last.first) + std::abs(both.second - last.second) < kHardly) break;
  }
  consider(both);
  return best;
}

ScaledCorrelations improve(const TwoProcesses& processes, std::span<const double> deviations,
                           const NeighbourCorrelations& from,
                           const std::function<double(const ScaledCorrelations&)>& more) {
  constexpr double kReach = 0.25;  // of ln(factor) and atanh(correlation)
  constexpr int kBits = 16;
  const Beginning some = beginning(processes, deviations, kDeciding);
  ScaledCorrelations best{from};
  const auto value = [&](const ScaledCorrelations& at) {
    return log_likelihood(some.processes, some.deviations, at) + more(at);
  };
  const auto change = [&](auto&& set) {
    const ScaledCorrelations before = best;
    const double step = highest_between(
        [&](double x) {
          ScaledCorrelations at = before;
          set(at, x);
          return value(at);
        },
        -kReach, kReach, kBits);
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
