// Random fits over the whole domain and its edges: what the program says of lambda against the printed law's own cost,
// scanned by brute force.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "dataset/input_error.h"
#include "dataset/number_text.h"
#include "fitting/fit.h"
#include "stress/contacts.h"

namespace mixity::stress {

/// ln f as printed, psi in [0, pi/2); c's 1 + (lambda - 1) sin^2 as cos^2 + lambda sin^2, which keeps digits near pi/2.
inline double printed_log_toughness(const std::string& model, double lambda, double psi) {
  if (model == "a") return std::log1p((1 - lambda) * std::pow(std::tan(psi), 2));
  if (model == "b") return std::log1p(std::pow(std::tan((1 - 0.5 * lambda) * psi), 2));
  return -std::log(std::pow(std::cos(psi), 2) + lambda * std::pow(std::sin(psi), 2));
}

struct RandomData {
  Dataset data;
  std::string what;
};

enum class Kind { usual, unsheared, right_angle, outlier, narrow, mixture, exact };

/// Points of a model with scatter, in one of the shapes that break fits.
inline RandomData random_data(Random& random) {
  static const char* kNames[] = {"usual", "all T = 0", "all psi = pi/2", "outlier", "narrow", "two lambdas", "exact"};
  RandomData result;
  const auto kind = static_cast<Kind>(random() % 7);
  const std::string model = std::vector<std::string>{"a", "b", "c"}[random() % 3];
  const double upper = model == "b" ? 2 : 1;
  const auto any_lambda = [&] {
    const double choice = uniform(random);
    return choice < 0.1   ? 0
           : choice < 0.2 ? upper
           : choice < 0.6 ? log_uniform(random, 1e-8, 1) * upper
                          : uniform(random) * upper;
  };
  const double lambda = any_lambda(), other = any_lambda(),
               noise = kind == Kind::exact ? 0 : log_uniform(random, 1e-8, 0.3);
  auto n = static_cast<std::size_t>(log_uniform(random, 1, chance(random, 0.02) ? 1e5 : 300));
  if (chance(random, 1e-5)) n = 1000000;
  const double last = 0.5 * pi<double>() * (1 - log_uniform(random, 1e-8, 0.5));
  const double centre = uniform(random) * last, width = log_uniform(random, 1e-15, 0.1);
  std::normal_distribution<double> normal;
  Dataset& data = result.data;
  data.path = data.name = "random";
  data.curves = {""};
  for (std::size_t i = 0; i < n; ++i) {
    double psi = uniform(random) * last;
    if (kind == Kind::unsheared) psi = 0;
    if (kind == Kind::right_angle) psi = 0.5 * pi<double>();
    if (kind == Kind::narrow) psi = std::clamp(centre + width * uniform(random, -1, 1), 0.0, last);
    const double here = kind == Kind::mixture && i % 2 ? other : lambda;
    const double log_f = kind == Kind::right_angle ? uniform(random, 0, 5) : printed_log_toughness(model, here, psi);
    Point point{};
    point.line = i + 2;
    point.mixity = mixity_from_angle(psi);
    point.ratio = std::exp(std::clamp(log_f + noise * normal(random), -300.0, 300.0));
    data.points.push_back(point);
  }
  if (kind == Kind::outlier) data.points[random() % n].ratio = std::exp(std::clamp(1e6 * noise, -300.0, 300.0));
  data.rows = n;
  result.what = std::string(kNames[static_cast<int>(kind)]) + ", model " + model + ", lambda " + shortest(lambda) +
                ", noise " + rounded(noise, 3) + ", " + std::to_string(n) + " points";
  return result;
}

/// The printed cost of a fit's points, and the lowest place of it on a scan that is dense towards both bounds.
class PrintedCost {
 public:
  PrintedCost(const Dataset& data, const FitResult& fit) : data_(data), fit_(fit) {}
  double operator()(double lambda) const {
    double sum = 0;
    for (const std::size_t i : fit_.used) {
      const Point& point = data_.points[i];
      const double r = printed_log_toughness(fit_.model, lambda, point.psi()) - std::log(point.ratio);
      sum += r * r;
    }
    return sum;
  }
  std::pair<double, double> lowest(double upper) const {
    std::vector<double> places{0, upper};
    const int n = fit_.used.size() > 10000 ? 20 : 150;
    for (int i = 1; i < n; ++i) {
      places.push_back(upper * i / n);
      places.push_back(upper * std::pow(10.0, -10.0 * i / n));
      places.push_back(upper * (1 - std::pow(10.0, -10.0 * i / n)));
    }
    std::sort(places.begin(), places.end());
    std::size_t best = 0;
    std::vector<double> costs;
    for (const double place : places) costs.push_back((*this)(place));
    for (std::size_t i = 0; i < places.size(); ++i)
      if (costs[i] < costs[best]) best = i;
    // golden section between the neighbours of the lowest
    double low = places[best ? best - 1 : 0], high = places[std::min(best + 1, places.size() - 1)];
    constexpr double kGolden = 0.6180339887498949;
    for (int i = 0; i < 60; ++i) {
      const double one = high - kGolden * (high - low), two = low + kGolden * (high - low);
      (*this)(one) < (*this)(two) ? high = two : low = one;
    }
    const double middle = 0.5 * (low + high), cost = (*this)(middle);
    return cost < costs[best] ? std::pair(middle, cost) : std::pair(places[best], costs[best]);
  }

 private:
  const Dataset& data_;
  const FitResult& fit_;
};

/// What is wrong with a fit; empty if nothing.
inline std::string wrong_with_fit(const Dataset& data, const FitResult& fit) {
  for (const auto& value : {fit.r2, fit.rmse, fit.max_abs_residual})
    if (value && !std::isfinite(*value)) return "a goodness of fit is not finite";
  const FittedParameter& lambda = fit.parameters[0];
  for (const auto& value : {lambda.value, lambda.stderr_})
    if (value && !std::isfinite(*value)) return "value or standard error is not finite";
  if (fit.status != FitStatus::ok && fit.message.empty()) return "no word on why it is not ok";
  if (!lambda.value) return fit.status == FitStatus::not_identifiable ? "" : "no value";
  if (!(*lambda.value >= lambda.lower && *lambda.value <= lambda.upper)) return "value out of range";
  if (lambda.interval) {
    const auto &low = lambda.interval->low, &high = lambda.interval->high;
    if (low && !(*low <= *lambda.value)) return "the interval begins above the value";
    if (high && !(*high >= *lambda.value)) return "the interval ends below the value";
  }
  if (fit.status == FitStatus::not_converged) return "";
  const PrintedCost cost(data, fit);
  const auto [place, lowest] = cost.lowest(lambda.upper);
  // Roundings of the printed law: tan psi towards pi/2 magnifies that of psi.
  double steepest = 0, size = 0;
  for (const std::size_t i : fit.used) {
    steepest = std::max(steepest, std::tan(data.points[i].psi()));
    size = std::max(size, std::abs(std::log(data.points[i].ratio)));
  }
  const double n = static_cast<double>(fit.used.size());
  const double rounding =
      n * 2 * std::sqrt(lowest / n) * 1e-15 * (1 + steepest + size) + n * std::pow(1e-15 * (1 + steepest + size), 2);
  if (cost(*lambda.value) > lowest * (1 + 1e-7) + rounding)
    return "the printed cost is " + shortest(lowest) + " at " + shortest(place) + ", " + shortest(cost(*lambda.value)) +
           " at the value found, " + shortest(*lambda.value);
  return "";
}

/// Fits of a, b and c to random data, from a random stream of their own.
inline Tally random_fits(std::uint64_t seed, std::size_t cases) {
  Tally tally;
  tally.what = "fits";
  Random random(seed);
  while (tally.cases < cases) {
    const RandomData drawn = random_data(random);
    for (const char* model : {"a", "b", "c"}) {
      const std::string where = drawn.what + "; fitted " + model;
      ++tally.cases;
      try {
        const FitResult fit = tally.timed(where, [&] { return fit_model(drawn.data, model); });
        tally.answered += fit.status == FitStatus::ok;
        const std::string wrong = wrong_with_fit(drawn.data, fit);
        if (!wrong.empty()) tally.fail(where + " (" + std::string(to_string(fit.status)) + "): " + wrong);
      } catch (const InputError& error) {
        tally.fail(where + ": refused: " + error.what());
      }
    }
  }
  return tally;
}

}  // namespace mixity::stress
