// A straight line through seven points, of which everything is known in closed form.
#pragma once

#include "solver/jet_problem.h"

namespace mixity {

/// Residuals level + slope t - y of errors 1, at t = 0..6: sum t = 21, sum t^2 = 91.
struct Line {
  static constexpr double kY[] = {1.1, 1.4, 2.2, 2.4, 3.1, 3.4, 4.2};
  static constexpr double kSumT = 21, kSumTT = 91, kSumY = 17.8, kSumTY = 67.6, kN = 7;

  template <class T>
  T operator()(const T* b, std::size_t i) const {
    return b[0] + b[1] * static_cast<double>(i) - kY[i];
  }
  static JetProblem<2, Line> problem(FreeParameter level, FreeParameter slope, bool known_errors = true) {
    return {7, {std::move(level), std::move(slope)}, 7, known_errors, Line{}};
  }
};

}  // namespace mixity
