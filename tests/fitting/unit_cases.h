// Measured areas in seven units, and the true best lambda: for tests and tables of whether a fit that calls itself
// converged is.
#pragma once

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <limits>

#include "dataset/load_text.h"
#include "fitting/synthetic_runs.h"

namespace mixity {

struct AreaUnit {
  const char* name;
  double square_metres;
};
inline constexpr std::array<AreaUnit, 7> kAreaUnits{
    {{"km^2", 1e6}, {"m^2", 1}, {"dm^2", 1e-2}, {"cm^2", 1e-4}, {"mm^2", 1e-6}, {"um^2", 1e-12}, {"nm^2", 1e-18}}};

/// Runs in SI units, from the constants of data/mergel2018.toml.
struct UnitCase {
  std::string name, model;
  std::vector<std::array<double, 3>> rows;  // P [N], T [N], A [m^2]
  double sigma_T, sigma_A;                  // [N], [m^2]: 1 % of the mean

  static constexpr const char* kConstants = "radius = '9.42 mm'\nmodulus = '2.133 MPa'\ntoughness = '27 mJ/m^2'\n";

  UnitCase(std::string title, std::string key, const Dataset& data) : name(std::move(title)), model(std::move(key)) {
    const Contact contact{9.42e-3, 2.133e6, 27e-3};
    double sum_T = 0, sum_A = 0;
    for (const Point& point : data.points) {
      rows.push_back({point.P * contact.force_unit(), point.T * contact.force_unit(), point.A * contact.area_unit()});
      sum_T += rows.back()[1];
      sum_A += rows.back()[2];
    }
    sigma_T = 0.01 * sum_T / static_cast<double>(rows.size());
    sigma_A = 0.01 * sum_A / static_cast<double>(rows.size());
  }

  /// As a user's file would hold them, all digits given.
  Dataset in(const AreaUnit& unit) const {
    std::string text = std::string("P [N],T [N],A [") + unit.name + "]\n";
    for (const auto& [P, T, A] : rows) {
      char line[100];
      std::snprintf(line, sizeof line, "%.17g,%.17g,%.17g\n", P, T, A / unit.square_metres);
      text += line;
    }
    return load_text(text, kConstants);
  }

  /// "2.5e-09 m^2", in the unit.
  std::string sigma_A_in(const AreaUnit& unit) const { return quantity(sigma_A / unit.square_metres, unit.name); }
  std::string sigma_T_text() const { return quantity(sigma_T, "N"); }

 private:
  static std::string quantity(double value, const char* unit) {
    char text[60];
    std::snprintf(text, sizeof text, "%.17g %s", value, unit);
    return text;
  }
};

namespace unit_cases_detail {

inline Dataset noisy(const std::string& model, double lambda, double upto, unsigned seed, double size = 0.01) {
  SeededNoise noise(seed, size);
  return synthetic_runs(model, {lambda}, {0.5, 2, 5, 10, 20}, 20, upto, noise);
}

}  // namespace unit_cases_detail

/// The shipped data, one set for each model, one with two populations (half of the runs at another lambda, and points
/// that stand out), and one whose area grows with shear, which no lambda describes: it lies at its bound.
inline std::vector<UnitCase> unit_cases(const std::string& mergel) {
  using namespace unit_cases_detail;
  std::vector<UnitCase> cases;
  cases.emplace_back("mergel2018", "c", load_dataset(mergel));
  cases.emplace_back("c, 0.15", "c", noisy("c", 0.15, 0.95, 1));
  cases.emplace_back("b, 0.3", "b", noisy("b", 0.3, 0.95, 2));
  cases.emplace_back("a, 0.6", "a", noisy("a", 0.6, 0.95, 3));
  Dataset two = noisy("c", 0.04, 0.9, 4);
  for (const double P : {0.5, 2.0, 5.0, 10.0, 20.0}) {
    SeededNoise noise(5, 0.01);
    add_run(two, "c", {0.6}, P, 20, 0.97, noise);
  }
  for (std::size_t i = 7; i < two.points.size(); i += 23) two.points[i].A *= 0.7;
  cases.emplace_back("c, two populations and outliers", "c", two);
  Dataset growing = noisy("c", 0.15, 1e-6, 6);
  for (std::size_t i = 0; i < growing.points.size(); ++i) {
    Point& point = growing.points[i];
    point.T = 0.5 * static_cast<double>(i % 20);
    point.A *= 1 + 0.002 * static_cast<double>(i % 20);
  }
  cases.emplace_back("c, growing area", "c", growing);
  return cases;
}

/// A cost to be judged: residuals of one parameter, null where they are not defined.
using Residuals = std::function<std::optional<std::vector<double>>(double x)>;

/// Distances from the equilibrium curves, as dimensionless data with these standard errors have them. The nearest place
/// of the whole curve comes from ContactModel, whose distances tests of its own judge in 50 digits.
inline Residuals curve_residuals(const ContactModel& model, const Dataset& data, double sigma_T, double sigma_A) {
  std::vector<double> P, T, A;
  for (const Point& point : data.points) {
    P.push_back(point.P);
    T.push_back(point.T);
    A.push_back(point.A);
  }
  const std::size_t n = P.size();
  const std::vector<double> errors_T(n, sigma_T), errors_A(n, sigma_A);
  return [=](double x) -> std::optional<std::vector<double>> {
    std::vector<double> r(n);
    CurveDistances out{r, {}, {}, {}, {}};
    if (!model.curve_distances(ParameterValues{x}, {P, T, A, errors_T, errors_A}, Search::global, false, out))
      return std::nullopt;
    return r;
  };
}

/// ln f of the model minus that of the points, each with its weight.
inline Residuals toughness_residuals(const ContactModel& model, const Dataset& data,
                                     const std::vector<double>& weights) {
  std::vector<ToughnessPoint> points;
  for (const Point& point : data.points) points.push_back(toughness_of_area(point.P, point.T, point.A).value());
  return [=](double x) -> std::optional<std::vector<double>> {
    std::vector<double> r;
    for (std::size_t i = 0; i < points.size(); ++i)
      r.push_back(weights[i] * (log_f(model, {x}, points[i].mixity) - std::log(points[i].ratio)));
    return r;
  };
}

/// 1/standard error of these residuals at lambda = x, by central differences in what was measured.
inline std::vector<double> toughness_weights(const ContactModel& model, const Dataset& data, double sigma_T,
                                             double sigma_A, double x) {
  const auto residual = [&](double P, double T, double A) {
    const ToughnessPoint point = toughness_of_area(P, std::abs(T), A).value();
    return log_f(model, {x}, point.mixity) - std::log(point.ratio);
  };
  std::vector<double> weights;
  for (const auto& [line, curve, P, T, A] : data.points) {
    const double h = 1e-6 * A, k = 1e-6 * std::max(T, 1.0);
    const double by_A = (residual(P, T, A + h) - residual(P, T, A - h)) / (2 * h),
                 by_T = (residual(P, T + k, A) - residual(P, T - k, A)) / (2 * k);
    weights.push_back(1 / std::hypot(by_A * sigma_A, by_T * sigma_T));
  }
  return weights;
}

/// Where the sum of squares is least in the whole range.
struct BestValue {
  double x, standard_error;
  int minima;
};

/// A dense scan of lower..upper, with golden sections where it is low. `known`: the residuals are in units of known
/// standard errors.
inline BestValue best_value(const Residuals& residuals, double lower, double upper, int values, bool known) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto cost = [&](double x) {
    const auto r = residuals(x);
    if (!r) return kInfinity;
    double sum = 0;
    for (const double value : *r) sum += value * value;
    return sum;
  };
  std::vector<double> x{lower};
  for (int i = 0; i < values / 2; ++i) x.push_back(0.02 * upper * std::pow(10.0, -8 + 16.0 * i / values));
  for (int i = 1; i <= values / 2; ++i) x.push_back(upper * (0.02 + 1.96 * i / values));
  std::vector<double> costs;
  for (const double at : x) costs.push_back(cost(at));
  const double lowest = *std::min_element(costs.begin(), costs.end());
  BestValue best{};
  double least = kInfinity;
  for (std::size_t i = 0; i < x.size(); ++i) {
    // < on one side only, so that a plateau counts once
    if ((i > 0 && costs[i] >= costs[i - 1]) || (i + 1 < x.size() && costs[i] > costs[i + 1])) continue;
    ++best.minima;
    if (costs[i] > 1.1 * lowest) continue;
    double low = x[i > 0 ? i - 1 : 0], high = x[std::min(i + 1, x.size() - 1)];
    for (int k = 0; k < 60; ++k) {
      constexpr double kGolden = 0.6180339887498949;
      const double one = high - kGolden * (high - low), other = low + kGolden * (high - low);
      const bool left = cost(one) < cost(other);
      (left ? high : low) = left ? other : one;
    }
    for (const double at : {0.5 * (low + high), x[i]})
      if (const double here = cost(at); here < least) {
        least = here;
        best.x = at;
      }
  }
  // from J'J, by central differences
  const double h = 1e-4 * std::max(best.x, 1e-3 * upper), middle = std::clamp(best.x, lower + h, upper - h);
  const auto below = residuals(middle - h), above = residuals(middle + h);
  double square = 0;
  if (below && above)
    for (std::size_t i = 0; i < below->size(); ++i) square += std::pow(((*above)[i] - (*below)[i]) / (2 * h), 2);
  const double variance = known || !below ? 1 : least / static_cast<double>(below->size() - 1);
  best.standard_error = std::sqrt(variance / square);
  return best;
}

/// Within 1e-6 of the best value, or within a thousandth of what the data can tell.
inline bool is_right(double x, const BestValue& best) {
  return std::abs(x - best.x) <= std::max(1e-6 * std::abs(best.x), 1e-3 * best.standard_error);
}

}  // namespace mixity
