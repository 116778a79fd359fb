// The solvers of other libraries by name, for programs that compare all of them.
#pragma once

#include <functional>

#include "benchmarks/precision/optional_solvers.h"

namespace mixity::precision {

inline constexpr Tolerances kUsualOfCeres{1e-6, 1e-10, 1e-8, std::numeric_limits<double>::epsilon()};
inline constexpr Tolerances kUsualOfMinpack{1.5e-8, 0, 1.5e-8, 0};  // sqrt(eps), as the manual advises for lmdif1
inline constexpr Tolerances kUsualOfGsl{0, 1e-8, 1e-8, 0};          // the manual's examples

template <class Problem>
struct Peer {
  std::string name;
  Tolerances usual;  // its defaults, or what its manual uses where it has none
  std::function<Answer(const Problem&, double start, const Tolerances&)> solve;
};

template <class Problem>
std::vector<Peer<Problem>> peers() {
  std::vector<Peer<Problem>> list;
  const auto add = [&](const char* name, const Tolerances& usual, auto solve, auto... derivatives) {
    list.push_back({name, usual, [=](const Problem& problem, double start, const Tolerances& tolerances) {
                      return solve(problem, derivatives..., start, tolerances);
                    }});
  };
  add("Ceres analytic", kUsualOfCeres, with_ceres<Problem>, Derivatives::analytic);
  add("Ceres automatic", kUsualOfCeres, with_ceres<Problem>, Derivatives::automatic);
  add("Ceres numeric", kUsualOfCeres, with_ceres<Problem>, Derivatives::numeric);
  add("TinySolver automatic", kUsualOfCeres, with_tiny_solver<Problem>);
#ifdef MIXITY_HAS_CMINPACK
  add("MINPACK lmder", kUsualOfMinpack, with_minpack<Problem>, Derivatives::analytic);
  add("MINPACK lmdif", kUsualOfMinpack, with_minpack<Problem>, Derivatives::numeric);
#endif
#ifdef MIXITY_HAS_GSL
  add("GSL analytic", kUsualOfGsl, with_gsl<Problem>, Derivatives::analytic);
  add("GSL numeric", kUsualOfGsl, with_gsl<Problem>, Derivatives::numeric);
#endif
  return list;
}

}  // namespace mixity::precision
