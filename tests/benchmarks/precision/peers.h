// The solvers of other libraries by name, for programs that compare all of them.
#pragma once

#include <functional>

#include "benchmarks/precision/optional_solvers.h"

namespace mixity::precision {

template <class Problem>
struct Peer {
  std::string name;
  Tolerances usual;  // its defaults, or what its manual uses where it has none
  std::function<Answer(const Problem&, double start, const Tolerances&)> solve;
};

template <class Problem>
std::vector<Peer<Problem>> peers() {
  std::vector<Peer<Problem>> list;
  const Tolerances ceres{1e-6, 1e-10, 1e-8, std::numeric_limits<double>::epsilon()};
  const auto add = [&](const char* name, const Tolerances& usual, auto solve, auto... derivatives) {
    list.push_back({name, usual, [=](const Problem& problem, double start, const Tolerances& tolerances) {
                      return solve(problem, derivatives..., start, tolerances);
                    }});
  };
  add("Ceres analytic", ceres, with_ceres<Problem>, Derivatives::analytic);
  add("Ceres automatic", ceres, with_ceres<Problem>, Derivatives::automatic);
  add("Ceres numeric", ceres, with_ceres<Problem>, Derivatives::numeric);
  add("TinySolver automatic", ceres, with_tiny_solver<Problem>);
#ifdef MIXITY_HAS_CMINPACK
  const Tolerances minpack{1.5e-8, 0, 1.5e-8, 0};  // sqrt(eps), as the manual advises for lmdif1
  add("MINPACK lmder", minpack, with_minpack<Problem>, Derivatives::analytic);
  add("MINPACK lmdif", minpack, with_minpack<Problem>, Derivatives::numeric);
#endif
#ifdef MIXITY_HAS_GSL
  const Tolerances gsl{0, 1e-8, 1e-8, 0};  // the manual's examples
  add("GSL analytic", gsl, with_gsl<Problem>, Derivatives::analytic);
  add("GSL numeric", gsl, with_gsl<Problem>, Derivatives::numeric);
#endif
  return list;
}

}  // namespace mixity::precision
