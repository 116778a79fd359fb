// What one would write without the circle: the contact radius a from the printed equation
//
//     G(a) = y^2 + T^2 - 8 pi a^3 f(psi) = 0,       y = 4/3 a^3 - P,  tan psi = T/y,
//
// with root finders from textbooks and libraries. The laws stand here in their cheapest form, and searches by bracket
// are given the bracket of the stable branch, which costs them nothing: both flatter the textbook.
#pragma once

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <exception>
#include <limits>
#include <type_traits>
#include <utility>

#include "mechanics/equilibrium.h"

#ifdef MIXITY_HAS_GSL
#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>
#endif

namespace mixity::precision {

struct Answer {
  double A;
  bool ok;          // what the method says
  int evaluations;  // calls of the equation; with a derivative it is one call, too
};

inline constexpr int kMostEvaluations = 200;

template <class Model>
struct PrintedEquation {
  double lambda, P, T;

  struct Value {
    double value, slope;
  };

  double operator()(double a) const {
    const double cube = a * a * a, y = 4.0 / 3 * cube - P;
    return y * y + T * T - 8 * pi<double>() * cube * toughness(y);
  }

  /// G and dG/da.
  Value differentiated(double a) const {
    const double cube = a * a * a, y = 4.0 / 3 * cube - P, dy = 4 * a * a, square = y * y + T * T;
    double f = 0, f_y = 0;
    if constexpr (std::is_same_v<Model, Johnson>) {
      const double tan = T / y, rise = (1 - lambda) * tan * tan;
      f = 1 + rise;
      f_y = -2 * rise / y;
    } else if constexpr (std::is_same_v<Model, WatersGuduru>) {
      const double k = 1 - lambda / 2, tan = std::tan(k * std::atan2(T, y));
      f = 1 + tan * tan;
      f_y = -2 * k * tan * f * T / square;
    } else {
      const double sin2 = T * T / square;
      f = 1 / (1 + (lambda - 1) * sin2);
      f_y = -2 * f * f * (1 - lambda) * y * sin2 / square;
    }
    constexpr double kFactor = 8 * 3.14159265358979323846;
    return {square - kFactor * cube * f, 2 * y * dy - kFactor * a * a * (3 * f + a * f_y * dy)};
  }

 private:
  double toughness(double y) const {
    if constexpr (std::is_same_v<Model, Johnson>) {
      const double tan = T / y;
      return 1 + (1 - lambda) * tan * tan;
    } else if constexpr (std::is_same_v<Model, WatersGuduru>) {
      const double tan = std::tan((1 - lambda / 2) * std::atan2(T, y));
      return 1 + tan * tan;
    } else {
      return 1 / (1 + (lambda - 1) * T * T / (y * y + T * T));
    }
  }
};

/// Radii between which the printed equation has one root: JKR, and the end of its stable branch.
struct Bracket {
  double low, high;
};

/// From JKR, as long as steps exceed the tolerance. Nothing keeps it on the stable branch.
template <class Model>
Answer newton(const PrintedEquation<Model>& G, const Bracket& bracket, double tolerance) {
  double a = bracket.high;
  for (int i = 1; i <= kMostEvaluations; ++i) {
    const auto [value, slope] = G.differentiated(a);
    const double step = value / slope;
    a -= step;
    if (std::abs(step) <= tolerance * std::abs(a)) return {area_from_radius(a), true, i};
  }
  return {area_from_radius(a), false, kMostEvaluations};
}

/// Boost's, which bisects where a step leaves the bracket; its tolerance counts in bits.
template <class Model>
Answer bracketed_newton(const PrintedEquation<Model>& G, const Bracket& bracket, double tolerance) {
  std::uintmax_t evaluations = kMostEvaluations;
  const int bits = std::min(static_cast<int>(std::ceil(-std::log2(tolerance))), 52);
  const auto pair = [&](double a) {
    const auto [value, slope] = G.differentiated(a);
    return std::make_pair(value, slope);
  };
  try {
    const double a =
        boost::math::tools::newton_raphson_iterate(pair, bracket.high, bracket.low, bracket.high, bits, evaluations);
    return {area_from_radius(a), evaluations < kMostEvaluations, static_cast<int>(evaluations)};
  } catch (const std::exception&) {
    return {std::numeric_limits<double>::infinity(), false, kMostEvaluations};
  }
}

/// A search of Boost's that shrinks a bracket: its middle.
template <class Model, class Search>
Answer shrink(const PrintedEquation<Model>& G, const Bracket& bracket, double tolerance, const Search& search) {
  const auto close = [&](double low, double high) { return std::abs(high - low) <= tolerance * std::min(low, high); };
  std::uintmax_t evaluations = kMostEvaluations;
  int calls = 0;
  const auto counted = [&](double a) {
    ++calls;
    return G(a);
  };
  try {
    const auto [low, high] = search(counted, bracket.low, bracket.high, close, evaluations);
    return {area_from_radius(0.5 * (low + high)), close(low, high), calls};
  } catch (const std::exception&) {  // no change of sign
    return {std::numeric_limits<double>::infinity(), false, calls};
  }
}

template <class Model>
Answer toms748(const PrintedEquation<Model>& G, const Bracket& bracket, double tolerance) {
  return shrink(G, bracket, tolerance, [](const auto& f, double low, double high, const auto& close, auto& most) {
    return boost::math::tools::toms748_solve(f, low, high, close, most);
  });
}

template <class Model>
Answer bisection(const PrintedEquation<Model>& G, const Bracket& bracket, double tolerance) {
  return shrink(G, bracket, tolerance, [](const auto& f, double low, double high, const auto& close, auto& most) {
    return boost::math::tools::bisect(f, low, high, close, most);
  });
}

#ifdef MIXITY_HAS_GSL
/// GSL's; the solver is allocated once for all answers.
template <class Model>
Answer brent(const PrintedEquation<Model>& G, const Bracket& bracket, double tolerance) {
  static gsl_root_fsolver* const solver = (gsl_set_error_handler_off(), gsl_root_fsolver_alloc(gsl_root_fsolver_brent));
  struct Counted {
    const PrintedEquation<Model>& equation;
    int calls;
  } counted{G, 0};
  gsl_function function{[](double a, void* data) {
                          auto& c = *static_cast<Counted*>(data);
                          ++c.calls;
                          return c.equation(a);
                        },
                        &counted};
  if (gsl_root_fsolver_set(solver, &function, bracket.low, bracket.high) != GSL_SUCCESS)
    return {std::numeric_limits<double>::infinity(), false, counted.calls};
  bool close = false;
  while (!close && counted.calls < kMostEvaluations && gsl_root_fsolver_iterate(solver) == GSL_SUCCESS)
    close = gsl_root_test_interval(gsl_root_fsolver_x_lower(solver), gsl_root_fsolver_x_upper(solver), 0, tolerance) ==
            GSL_SUCCESS;
  return {area_from_radius(gsl_root_fsolver_root(solver)), close, counted.calls};
}
#endif

}  // namespace mixity::precision
