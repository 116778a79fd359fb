// Random fits over the whole domain and its edges: what the program says of the parameters against the printed law's
// own cost, scanned by brute force.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/input_error.h"
#include "fitting/fit.h"
#include "stress/golden.h"
#include "stress/random_data.h"

namespace mixity::stress {

/// 3 n places between 0 and `upper`, dense towards both.
inline std::vector<double> places_to(double upper, int n) {
  std::vector<double> places{0, upper};
  for (int i = 1; i < n; ++i) {
    places.push_back(upper * i / n);
    places.push_back(upper * std::pow(10.0, -10.0 * i / n));
    places.push_back(upper * (1 - std::pow(10.0, -10.0 * i / n)));
  }
  std::sort(places.begin(), places.end());
  return places;
}

/// The printed cost of a fit's points, and its lowest place by brute force.
class PrintedCost {
 public:
  PrintedCost(const Dataset& data, const FitResult& fit) : data_(data), fit_(fit) {}
  double operator()(const std::vector<double>& p) const {
    double sum = 0;
    for (const std::size_t i : fit_.used) {
      const ToughnessPoint& point = data_.converted[i];
      const double r = printed_log_toughness(fit_.model, p, point.psi()) - std::log(point.ratio);
      sum += r * r;
    }
    return sum;
  }
  /// Also the highest finite cost met.
  Place lowest(double& highest) const { return fit_.parameters.size() == 1 ? of_one(highest) : of_two(highest); }

 private:
  Place of_one(double& highest) const {
    const std::vector<double> places = places_to(fit_.parameters[0].upper, fit_.used.size() > 10000 ? 12 : 150);
    std::size_t best = 0;
    std::vector<double> costs;
    for (const double place : places) {
      costs.push_back((*this)({place}));
      if (std::isfinite(costs.back())) highest = std::max(highest, costs.back());
    }
    for (std::size_t i = 0; i < places.size(); ++i)
      if (costs[i] < costs[best]) best = i;
    const Place inside = golden([&](double x) { return (*this)({x}); }, places[best ? best - 1 : 0],
                                places[std::min(best + 1, places.size() - 1)], 55);
    return inside.cost < costs[best] ? inside : Place{{places[best]}, costs[best]};
  }
  /// A grid in ln r and ln eta, and from its best places compass search down to a millionth.
  Place of_two(double& highest) const {
    const std::vector<FittedParameter>& range = fit_.parameters;
    constexpr int kGrid = 25;
    const auto at = [&](const std::array<double, 2>& s) {
      std::vector<double> x;
      for (std::size_t k = 0; k < 2; ++k)
        x.push_back(std::clamp(range[k].lower * std::pow(range[k].upper / range[k].lower, s[k]), range[k].lower,
                               range[k].upper));
      return Place{x, (*this)(x)};
    };
    std::vector<std::pair<double, std::array<double, 2>>> grid;
    for (int i = 0; i <= kGrid; ++i)
      for (int j = 0; j <= kGrid; ++j) {
        const std::array<double, 2> s{1.0 * i / kGrid, 1.0 * j / kGrid};
        grid.emplace_back(at(s).cost, s);
        if (std::isfinite(grid.back().first)) highest = std::max(highest, grid.back().first);
      }
    std::sort(grid.begin(), grid.end());
    Place best = at(grid[0].second);
    for (int start = 0; start < 3; ++start) {
      auto s = grid[static_cast<std::size_t>(start)].second;
      double here = grid[static_cast<std::size_t>(start)].first;
      for (double step = 0.5 / kGrid; step > 1e-6;) {
        bool better = false;
        for (int direction = 0; direction < 8 && !better; ++direction) {
          static constexpr int kX[] = {1, -1, 0, 0, 1, 1, -1, -1}, kY[] = {0, 0, 1, -1, 1, -1, 1, -1};
          const std::array<double, 2> next{std::clamp(s[0] + step * kX[direction], 0.0, 1.0),
                                           std::clamp(s[1] + step * kY[direction], 0.0, 1.0)};
          const double cost = at(next).cost;
          if ((better = cost < here)) s = next, here = cost;
        }
        step *= better ? 1.5 : 0.5;
      }
      if (here < best.cost) best = at(s);
    }
    return best;
  }

  const Dataset& data_;
  const FitResult& fit_;
};

/// What is wrong with the numbers of a fit, whatever they were fitted to; empty if nothing.
inline std::string wrong_with_numbers(const FitResult& fit) {
  for (const auto& value : {fit.r2, fit.rmse, fit.max_abs_residual})
    if (value && !std::isfinite(*value)) return "a goodness of fit is not finite";
  if (fit.status != FitStatus::ok && fit.message.empty()) return "no word on why it is not ok";
  for (const FittedParameter& parameter : fit.parameters) {
    for (const auto& value : {parameter.value, parameter.stderr_})
      if (value && !std::isfinite(*value)) return "value or standard error is not finite";
    if (!parameter.value) {
      if (fit.status != FitStatus::not_identifiable) return "no value";
      continue;
    }
    if (!(*parameter.value >= parameter.lower && *parameter.value <= parameter.upper)) return "value out of range";
    if (!parameter.interval) continue;
    const auto &low = parameter.interval->low, &high = parameter.interval->high;
    if (low && !(*low <= *parameter.value)) return "the interval begins above the value";
    if (high && !(*high >= *parameter.value)) return "the interval ends below the value";
  }
  return "";
}

/// What is wrong with a fit; empty if nothing. `error`: how far the value found lies from the scanned minimum, in
/// standard errors, where rounding does not cover that.
inline std::string wrong_with_fit(const Dataset& data, const FitResult& fit, double& error) {
  error = 0;
  if (const std::string wrong = wrong_with_numbers(fit); !wrong.empty()) return wrong;
  const std::size_t n = fit.used.size(), p = fit.parameters.size();
  if (fit.status == FitStatus::not_converged || n <= p) return "";
  const PrintedCost cost(data, fit);
  double highest = 0;
  const Place lowest = cost.lowest(highest);
  // Roundings of the printed law: tan psi towards pi/2 magnifies that of psi.
  double steepest = 0, size = 0;
  for (const std::size_t i : fit.used) {
    steepest = std::max(steepest, std::tan(data.converted[i].psi()));
    size = std::max(size, std::abs(std::log(data.converted[i].ratio)));
  }
  const double count = static_cast<double>(n), of_one = 1e-15 * (1 + steepest + size),
               rounding = count * of_one * (2 * std::sqrt(lowest.cost / count) + of_one);
  const double variance = lowest.cost / (count - static_cast<double>(p));
  if (fit.status == FitStatus::not_identifiable) {
    // Of one parameter the whole range must fit: within 95 % of the scatter, or of 16 eps of each f. Twice that, as the
    // places of two scans differ. Of two a line of places is enough, which this scan does not see.
    const double allowed = 3.84 * variance + count * std::pow(16 * 2.3e-16 * (1 + size), 2) + rounding;
    return p > 1 || highest <= lowest.cost + 2 * allowed ? ""
                                                         : "not identifiable, but the printed cost goes from " +
                                                               shortest(lowest.cost) + " to " + shortest(highest);
  }
  std::vector<double> found;
  std::string text;
  for (const FittedParameter& parameter : fit.parameters) {
    found.push_back(*parameter.value);
    text += " " + shortest(found.back());
  }
  const double excess = cost(found) - lowest.cost;
  if (variance > 0 && rounding < 1e-6 * variance && excess > 0) error = std::sqrt(excess / variance);
  // A thousandth of a standard error, and the rounding of a sum of n terms.
  if (!(excess <= lowest.cost * (1e-6 / count + 1e-16 * count) + rounding)) {
    std::string place;
    for (const double x : lowest.x) place += " " + shortest(x);
    return "the printed cost is " + shortest(lowest.cost) + " at" + place + ", " + shortest(cost(found)) +
           " at the values found," + text;
  }
  return "";
}

/// Times a fit, counts it and what `wrong_with(fit, error)` says of it; no fit may be refused.
template <class Fit, class WrongWith>
void judge_fit(Tally& tally, const std::string& where, const Fit& fit_it, const WrongWith& wrong_with) {
  ++tally.cases;
  try {
    const FitResult fit = tally.timed(where, fit_it);
    tally.answered += fit.status == FitStatus::ok;
    if (fit.status == FitStatus::not_converged) tally.give_up(where + ": " + fit.message.text());
    double error = 0;
    const std::string wrong = wrong_with(fit, error);
    if (!wrong.empty())
      tally.fail(where + " (" + std::string(to_string(fit.status)) + ", " + fit.message.text() + "): " + wrong);
    tally.see_error(error, where);
  } catch (const InputError& refused) {
    tally.fail(where + ": refused: " + refused.what());
  }
}

inline void one_fit(const RandomData& drawn, const char* model, Tally& tally) {
  judge_fit(
      tally, drawn.what + "; fitted " + model, [&] { return fit_model(drawn.data, model); },
      [&](const FitResult& fit, double& error) { return wrong_with_fit(drawn.data, fit, error); });
}

/// Fits of all models to random data, from a random stream of their own; bk, with its scans over a plane, to fewer.
inline Tally random_fits(std::uint64_t seed, std::size_t cases) {
  return random_cases("fits", seed, cases, [](Random& random, Tally& tally) {
    const auto kind = static_cast<Kind>(random() % 8);
    const RandomData drawn = random_data(random, kind, random_size(random));
    for (const char* model : {"a", "b", "c"}) one_fit(drawn, model, tally);
    if (drawn.data.points.size() <= 100 && chance(random, 0.1)) one_fit(drawn, "bk", tally);
  });
}

/// One data set of a million points, fitted with a, b and c.
inline Tally large_fits(std::uint64_t seed, std::size_t) {
  Tally tally;
  tally.what = "fits of 10^6 points";
  Random random(seed);
  static constexpr Kind kKinds[] = {Kind::usual, Kind::outlier, Kind::mixture, Kind::small};
  const RandomData drawn = random_data(random, kKinds[seed % 4], 1000000);
  for (const char* model : {"a", "b", "c"}) one_fit(drawn, model, tally);
  return tally;
}

}  // namespace mixity::stress
