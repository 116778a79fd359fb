// Measured areas in seven units, and the true best lambda: for tests and tables of whether a fit that calls itself
// converged is.
#pragma once

#include <algorithm>
#include <array>
#include <cstdio>
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
  double sigma_A;                           // [m^2]: 1 % of the mean area

  static constexpr const char* kConstants = "radius = '9.42 mm'\nmodulus = '2.133 MPa'\ntoughness = '27 mJ/m^2'\n";

  UnitCase(std::string title, std::string key, const Dataset& data) : name(std::move(title)), model(std::move(key)) {
    const Contact contact{9.42e-3, 2.133e6, 27e-3};
    double sum = 0;
    for (const Point& point : data.points) {
      rows.push_back({point.P * contact.force_unit(), point.T * contact.force_unit(), point.A * contact.area_unit()});
      sum += rows.back()[2];
    }
    sigma_A = 0.01 * sum / static_cast<double>(rows.size());
  }

  /// As a user's file would hold them, all digits given.
  Dataset in(const AreaUnit& unit) const {
    std::string text = std::string("P [N],T [N],A [") + unit.name + "]\n";
    for (const auto& [P, T, A] : rows) {
      char line[100];
      std::snprintf(line, sizeof line, "%.17g,%.17g,%.17g\n", P, T, A / unit.square_metres);
      text += line;
    }
    return load_text(text, kConstants, {}, PointUse::areas);
  }

  /// "2.5e-09 m^2", in the unit.
  std::string sigma_in(const AreaUnit& unit) const {
    char text[60];
    std::snprintf(text, sizeof text, "%.17g %s", sigma_A / unit.square_metres, unit.name);
    return text;
  }
};

namespace unit_cases_detail {

template <class Model>
Dataset noisy(double lambda, double upto, unsigned seed, double size = 0.01) {
  SeededNoise noise(seed, size);
  return synthetic_runs<Model>({lambda}, {0.5, 2, 5, 10, 20}, 20, upto, noise);
}

}  // namespace unit_cases_detail

/// The shipped data, one set for each model, one with two populations (half of the runs at another lambda, and points
/// that stand out), and one whose area grows with shear, which no lambda describes: it lies at its bound.
inline std::vector<UnitCase> unit_cases(const std::string& mergel) {
  using namespace unit_cases_detail;
  std::vector<UnitCase> cases;
  cases.emplace_back("mergel2018", "c", load_dataset(mergel));
  cases.emplace_back("c, 0.15", "c", noisy<PapangeloCiavarella>(0.15, 0.95, 1));
  cases.emplace_back("b, 0.3", "b", noisy<WatersGuduru>(0.3, 0.95, 2));
  cases.emplace_back("a, 0.6", "a", noisy<Johnson>(0.6, 0.95, 3));
  Dataset two = noisy<PapangeloCiavarella>(0.04, 0.9, 4);
  for (const double P : {0.5, 2.0, 5.0, 10.0, 20.0}) {
    SeededNoise noise(5, 0.01);
    add_run<PapangeloCiavarella>(two, {0.6}, P, 20, 0.97, noise);
  }
  for (std::size_t i = 7; i < two.points.size(); i += 23) two.points[i].A *= 0.7;
  cases.emplace_back("c, two populations and outliers", "c", two);
  Dataset growing = noisy<PapangeloCiavarella>(0.15, 1e-6, 6);
  for (std::size_t i = 0; i < growing.points.size(); ++i) {
    Point& point = growing.points[i];
    point.T = 0.5 * static_cast<double>(i % 20);
    point.A *= 1 + 0.002 * static_cast<double>(i % 20);
  }
  cases.emplace_back("c, growing area", "c", growing);
  return cases;
}

/// A place at which the derivative of something is taken is a number with derivatives or without.
inline double plain(double x) { return x; }
inline double plain(long double x) { return static_cast<double>(x); }
template <class Jet>
double plain(const Jet& x) {
  return x.a;
}
inline double with_slope(double value, double, double) { return value; }
inline long double with_slope(double value, double, long double) { return value; }
template <class Jet>
Jet with_slope(double value, double slope, const Jet& x) {
  return Jet(value, slope * x.v);
}

/// A of the model at the measured T minus the measured A, in some unit. Beyond the last equilibrium the area at the
/// fold stands for the model's.
template <class Model>
class AreaDifferences {
 public:
  double lower = Model::parameters[0].lower, upper = Model::parameters[0].upper;
  mutable long sweeps = 0;

  /// `unit`: the residual of a dimensionless difference of 1.
  AreaDifferences(const Dataset& data, double unit) : points_(data.points), unit_(unit) {}
  std::size_t size() const { return points_.size(); }

  template <class S>
  bool operator()(const S* x, S* residuals) const {
    ++sweeps;
    const double lambda = plain(*x);
    std::optional<LoadedContact<Model>> contact;
    double P = 0;
    S fold(0);
    bool fold_known = false;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Point& point = points_[i];
      if (!contact || point.P != P) {
        P = point.P;
        contact.emplace(Parameters<Model>{lambda}, P);
        if (!contact->obstacle().empty() || !contact->in_contact()) return false;
        fold_known = false;
      }
      const Equilibrium at = contact->at(point.T);
      if (at.status == EquilibriumStatus::invalid) return false;
      S y;
      if (at.status == EquilibriumStatus::ok) {
        // One step of Newton's method carries the derivative, and what digits S has beyond a double's.
        const auto R = circle_residual<Model, S>({*x}, S(P), S(at.y), S(point.T));
        y = S(at.y) - R.value / R.d1;
      } else {
        if (!fold_known) fold = fold_at(*x, P, contact->branches().back().y_bottom);
        fold_known = true;
        y = fold;
      }
      const S a = S(cube_root(S(0.75) * (y + S(P))));
      residuals[i] = S(unit_) * (S(pi<double>()) * a * a - S(point.A));
    }
    return true;
  }

 private:
  template <class S>
  static S cube_root(const S& x) {
    using std::cbrt;
    return cbrt(x);
  }
  template <class S>
  static S fold_at(const S& x, double P, double y) {
    const double lambda = plain(x), h = 1e-6 * std::max(lambda, 1e-3);
    const double low = std::max(lambda - h, Model::parameters[0].lower),
                 high = std::min(lambda + h, Model::parameters[0].upper);
    const auto edge = [&](double at) { return LoadedContact<Model>({at}, P).branches().back().y_bottom; };
    return with_slope(y, (edge(high) - edge(low)) / (high - low), x);
  }

  std::vector<Point> points_;
  double unit_;
};

/// The least sum of squares in the whole range: a dense scan, and golden sections in long double.
struct BestValue {
  double x, standard_error;
  int minima;  // within 10 %
};

template <class Model>
BestValue best_value(const Dataset& data, int places) {
  const AreaDifferences<Model> problem(data, 1);
  using Long = long double;
  const auto cost = [&]<class S>(const S& x) {
    std::vector<S> r(problem.size());
    if (!problem(&x, r.data())) return std::numeric_limits<S>::infinity();
    S sum = 0;
    for (const S& value : r) sum += value * value;
    return sum;
  };
  std::vector<double> x{problem.lower};
  for (int i = 0; i < places / 2; ++i) x.push_back(0.02 * problem.upper * std::pow(10.0, -8 + 16.0 * i / places));
  for (int i = 1; i <= places / 2; ++i) x.push_back(problem.upper * (0.02 + 1.96 * i / places));
  BestValue best{};
  Long least = std::numeric_limits<Long>::infinity();
  // Each point that passes the fold bends the cost: once more, finer, around the best of the whole range.
  for (int round = 0; round < 2; ++round) {
    std::vector<double> costs;
    for (const double at : x) costs.push_back(cost(at));
    const double lowest = *std::min_element(costs.begin(), costs.end());
    best.minima = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      // < on one side only, so that a plateau counts once
      if ((i > 0 && costs[i] >= costs[i - 1]) || (i + 1 < x.size() && costs[i] > costs[i + 1])) continue;
      ++best.minima;
      if (costs[i] > 1.1 * lowest) continue;
      Long low = x[i > 0 ? i - 1 : 0], high = x[std::min(i + 1, x.size() - 1)];
      const Long ratio = 0.618033988749894848L;
      for (int k = 0; k < 60; ++k) {
        const Long one = high - ratio * (high - low), other = low + ratio * (high - low);
        const bool left = cost(one) < cost(other);
        (left ? high : low) = left ? other : one;
      }
      for (const Long at : {(low + high) / 2, Long(x[i])})
        if (const Long here = cost(at); here < least) {
          least = here;
          best.x = static_cast<double>(at);
        }
    }
    if (!(best.x > 0)) break;
    x.clear();
    for (int i = 0; i <= places; ++i) x.push_back(std::min(best.x * (0.9 + 0.2 * i / places), problem.upper));
  }
  // from the curvature of the sum of squares, half of which is J'J
  const double h = 1e-4 * std::max(best.x, 1e-3 * problem.upper);
  const double middle = std::clamp(best.x, problem.lower + h, problem.upper - h);
  std::vector<double> low(problem.size()), high(problem.size());
  const double below = middle - h, above = middle + h;
  double square = 0;
  if (problem(&below, low.data()) && problem(&above, high.data()))
    for (std::size_t i = 0; i < low.size(); ++i) square += std::pow((high[i] - low[i]) / (2 * h), 2);
  best.standard_error = std::sqrt(static_cast<double>(least) / static_cast<double>(problem.size() - 1) / square);
  return best;
}

/// Within 1e-6 of the best value, or within a thousandth of what the data can tell.
inline bool is_right(double x, const BestValue& best) {
  return std::abs(x - best.x) <= std::max(1e-6 * std::abs(best.x), 1e-3 * best.standard_error);
}

}  // namespace mixity
