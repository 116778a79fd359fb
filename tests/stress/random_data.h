// Random (psi, f) data in the shapes that break fits.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "base/number_text.h"
#include "dataset/dataset.h"
#include "stress/contacts.h"

namespace mixity::stress {

/// ln f as printed, psi in [0, pi/2]; c's 1 + (lambda - 1) sin^2 as cos^2 + lambda sin^2, and bk's B near 1 from cos,
/// which keep digits near pi/2. parameters: {lambda}, or {r, eta} of bk.
inline double printed_log_toughness(const std::string& model, const std::vector<double>& p, double psi) {
  if (model == "a") return std::log1p((1 - p[0]) * std::pow(std::tan(psi), 2));
  if (model == "b") return std::log1p(std::pow(std::tan((1 - 0.5 * p[0]) * psi), 2));
  const double C = std::pow(std::cos(psi), 2), B = std::pow(std::sin(psi), 2);
  if (model == "c") return p[0] < 0.5 ? -std::log(C + p[0] * B) : -std::log1p((p[0] - 1) * B);
  const double power = std::exp(p.back() * (B < 0.5 ? std::log(B) : std::log1p(-C)));
  return std::log1p((p[0] - 1) * power);
}

inline double upper_bound(const std::string& model) { return model == "b" ? 2 : 1; }

struct RandomData {
  Dataset data;
  std::string what;
};

/// small: psi down to 1e-8. d(ln f)/d(lambda) is of the size of psi^2 there, so that the condition number of a fit, the
/// standard error of lambda in units of the noise, goes up to 1e15. narrow: the same psi for all, to 1e-15, so that the
/// normal matrix of bk's two parameters has a condition number from 1 to infinity.
enum class Kind { usual, unsheared, right_angle, outlier, narrow, mixture, exact, small };

inline std::vector<double> random_law(Random& random, const std::string& model) {
  if (model == "bk") return {log_uniform(random, 1e-2, 1e2), log_uniform(random, 0.1, 10)};
  const double choice = uniform(random), upper = upper_bound(model);
  return {choice < 0.1   ? 0
          : choice < 0.2 ? upper
          : choice < 0.6 ? log_uniform(random, 1e-8, 1) * upper
                         : uniform(random) * upper};
}

inline std::size_t random_size(Random& random) {
  return static_cast<std::size_t>(log_uniform(random, 1, chance(random, 0.02) ? 1e5 : 300));
}

/// n points of a model with scatter.
inline RandomData random_data(Random& random, Kind kind, std::size_t n) {
  static const char* kNames[] = {"usual",  "all T = 0",   "all psi = pi/2", "outlier",
                                 "narrow", "two lambdas", "exact",          "small angles"};
  RandomData result;
  const std::string model = std::vector<std::string>{"a", "b", "c", "bk"}[random() % 4];
  const std::vector<double> law = random_law(random, model), other = random_law(random, model);
  // an outlier of 1e6 standard errors is still the logarithm of a double
  const double noise = kind == Kind::exact ? 0 : log_uniform(random, 1e-8, kind == Kind::outlier ? 3e-4 : 0.3);
  const double last =
      0.5 * pi<double>() * (kind == Kind::small ? log_uniform(random, 1e-8, 1) : 1 - log_uniform(random, 1e-8, 0.5));
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
    const auto& here = kind == Kind::mixture && i % 2 ? other : law;
    const double log_f = kind == Kind::right_angle ? uniform(random, 0, 5) : printed_log_toughness(model, here, psi);
    // in units of what there is to see, at small angles
    const double scatter = noise * (kind == Kind::small ? std::max(last * last, 1e-16) : 1);
    data.points.push_back({i + 2, 0, 0, 0, 0});
    data.converted.push_back(
        {mixity_from_angle(psi), std::exp(std::clamp(log_f + scatter * normal(random), -300.0, 300.0))});
  }
  if (kind == Kind::outlier) data.converted[random() % n].ratio = std::exp(1e6 * noise);
  data.rows = n;
  result.what = std::string(kNames[static_cast<int>(kind)]) + ", model " + model;
  for (const double value : law) result.what += " " + shortest(value);
  result.what += ", noise " + rounded(noise, 3) + ", psi < " + rounded(last, 3) + ", " + std::to_string(n) + " points";
  return result;
}

}  // namespace mixity::stress
