// Solvers of other libraries on a problem of several parameters without bounds, each called as its documentation shows.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "benchmarks/precision/peers.h"
#include "solver/problem.h"

namespace mixity::precision {

struct Fitted {
  std::vector<double> x;
  std::string claim{};
};

/// Of all solvers: what converges does so in fewer; NIST's Bennett5 takes more than a thousand.
inline constexpr int kIterationsOfSeveral = 5000;

/// Counted by who asks; where the model is not finite no solver accepts a step.
class Asked {
 public:
  explicit Asked(const Problem& problem)
      : n(problem.residual_count()), p(problem.parameters().size()), problem_(problem) {}
  std::size_t n, p;
  long sweeps = 0;

  bool residuals(const double* x, double* r) {
    ++sweeps;
    const bool finite = problem_.evaluate({x, p}, {r, n}, {});
    if (!finite) std::fill(r, r + n, kOutOfReach);
    return finite;
  }
  /// Row by row; not numbers where the model is not finite.
  bool both(const double* x, double* r, double* J) {
    ++sweeps;
    const bool finite = problem_.evaluate({x, p}, {r, n}, {J, n * p});
    if (!finite) std::fill(J, J + n * p, std::nan(""));
    return finite;
  }

 private:
  const Problem& problem_;
};

class AskedByCeres final : public ceres::CostFunction {
 public:
  explicit AskedByCeres(Asked& asked) : asked_(asked) {
    set_num_residuals(static_cast<int>(asked.n));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(asked.p));
  }
  bool Evaluate(const double* const* x, double* r, double** jacobians) const override {
    return jacobians && jacobians[0] ? asked_.both(x[0], r, jacobians[0]) : asked_.residuals(x[0], r);
  }

 private:
  Asked& asked_;
};

inline Fitted ceres_of_several(Asked& asked, std::vector<double> x, const Tolerances& tolerances) {
  ceres::Problem fit;
  fit.AddResidualBlock(new AskedByCeres(asked), nullptr, x.data());
  ceres::Solver::Summary summary;
  ceres::Solve(ceres_options(tolerances, kIterationsOfSeveral), &fit, &summary);
  return {x, claim_of(summary)};
}

#ifdef MIXITY_HAS_CMINPACK
/// lmder with derivatives, lmdif with forward differences; scaled by MINPACK itself, its usual step bound.
inline Fitted minpack_of_several(Asked& asked, Derivatives derivatives, std::vector<double> x,
                                 const Tolerances& tolerances) {
  const auto n = static_cast<int>(asked.n), p = static_cast<int>(asked.p);
  std::vector<double> residuals(asked.n), jacobian(asked.n * asked.p), work(asked.n), of_parameters(5 * asked.p);
  std::vector<int> pivots(asked.p);
  const auto array = [&](std::size_t which) { return of_parameters.data() + which * asked.p; };
  constexpr double kStepBound = 100;
  int evaluations, slopes, info;
  if (derivatives == Derivatives::numeric) {
    const auto function = [](void* data, int, int, const double* at, double* r, int) {
      static_cast<Asked*>(data)->residuals(at, r);
      return 0;
    };
    info = lmdif(function, &asked, n, p, x.data(), residuals.data(), tolerances.function, tolerances.parameter,
                 tolerances.gradient, kIterationsOfSeveral * (p + 1), 0, array(0), 1, kStepBound, 0, &evaluations,
                 jacobian.data(), n, pivots.data(), array(1), array(2), array(3), array(4), work.data());
  } else {
    const auto function = [](void* data, int, int, const double* at, double* r, double* J, int stride, int what) {
      Asked& it = *static_cast<Asked*>(data);
      if (what == 1) {
        it.residuals(at, r);
        return 0;
      }
      std::vector<double> unused(it.n), rows(it.n * it.p);
      it.both(at, unused.data(), rows.data());
      for (std::size_t i = 0; i < it.n; ++i)
        for (std::size_t k = 0; k < it.p; ++k) J[k * static_cast<std::size_t>(stride) + i] = rows[i * it.p + k];
      return 0;
    };
    info = lmder(function, &asked, n, p, x.data(), residuals.data(), jacobian.data(), n, tolerances.function,
                 tolerances.parameter, tolerances.gradient, kIterationsOfSeveral, array(0), 1, kStepBound, 0,
                 &evaluations, &slopes, pivots.data(), array(1), array(2), array(3), array(4), work.data());
  }
  // 6 to 8: a tolerance was too small for doubles; the rest: not legal, or too many evaluations
  return {x, info >= 1 && info <= 4 ? "converged" : info >= 6 ? "tolerance too small" : "no convergence"};
}
#endif

#ifdef MIXITY_HAS_GSL
/// gsl_multifit_nlinear with its default parameters.
inline Fitted gsl_of_several(Asked& asked, std::vector<double> x, const Tolerances& tolerances) {
  gsl_set_error_handler_off();  // the default one ends the program
  gsl_multifit_nlinear_fdf functions{};
  functions.f = [](const gsl_vector* at, void* data, gsl_vector* r) -> int {
    static_cast<Asked*>(data)->residuals(at->data, r->data);
    return GSL_SUCCESS;
  };
  functions.df = [](const gsl_vector* at, void* data, gsl_matrix* J) -> int {
    Asked& it = *static_cast<Asked*>(data);
    std::vector<double> unused(it.n);
    it.both(at->data, unused.data(), J->data);
    return GSL_SUCCESS;
  };
  functions.n = asked.n;
  functions.p = asked.p;
  functions.params = &asked;
  const gsl_multifit_nlinear_parameters parameters = gsl_multifit_nlinear_default_parameters();
  gsl_multifit_nlinear_workspace* work =
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &parameters, asked.n, asked.p);
  const gsl_vector_view start = gsl_vector_view_array(x.data(), asked.p);
  gsl_multifit_nlinear_init(&start.vector, &functions, work);
  int info = 0;
  const int status = gsl_multifit_nlinear_driver(kIterationsOfSeveral, tolerances.parameter, tolerances.gradient,
                                                 tolerances.function, nullptr, nullptr, &info, work);
  const gsl_vector* end = gsl_multifit_nlinear_position(work);
  Fitted fitted{std::vector<double>(end->data, end->data + asked.p),
                status == GSL_SUCCESS ? "converged" : gsl_strerror(status)};
  gsl_multifit_nlinear_free(work);
  return fitted;
}
#endif

struct PeerOfSeveral {
  std::string name;
  Tolerances usual;
  std::function<Fitted(Asked&, const std::vector<double>& start, const Tolerances&)> solve;
};

inline std::vector<PeerOfSeveral> peers_of_several() {
  std::vector<PeerOfSeveral> list{{"Ceres", kUsualOfCeres, ceres_of_several}};
#ifdef MIXITY_HAS_CMINPACK
  const auto minpack = [](Derivatives derivatives) {
    return [derivatives](Asked& asked, const std::vector<double>& start, const Tolerances& tolerances) {
      return minpack_of_several(asked, derivatives, start, tolerances);
    };
  };
  list.push_back({"MINPACK lmder", kUsualOfMinpack, minpack(Derivatives::analytic)});
  list.push_back({"MINPACK lmdif", kUsualOfMinpack, minpack(Derivatives::numeric)});
#endif
#ifdef MIXITY_HAS_GSL
  list.push_back({"GSL", kUsualOfGsl, gsl_of_several});
#endif
  return list;
}

}  // namespace mixity::precision
