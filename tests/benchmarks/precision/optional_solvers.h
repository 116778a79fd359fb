// Solvers of libraries that need not be installed: MINPACK (cminpack) and the GNU Scientific Library.
#pragma once

#include "benchmarks/precision/solvers.h"

#ifdef MIXITY_HAS_CMINPACK
#include <cminpack.h>
#endif
#ifdef MIXITY_HAS_GSL
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>
#endif

namespace mixity::precision {

#ifdef MIXITY_HAS_CMINPACK

/// lmder with analytic derivatives, lmdif with forward differences. Bounds are unknown to both.
template <class Problem>
Answer with_minpack(const Problem& problem, Derivatives derivatives, double start, const Tolerances& tolerances) {
  const auto before = problem.sweeps;
  const auto n = static_cast<int>(problem.size());
  std::vector<double> residuals(problem.size()), jacobian(problem.size()), work(problem.size());
  double x = start, diagonal = 1, qtf, wa1, wa2, wa3;
  int pivot, evaluations, slopes, info;
  constexpr double kStepBound = 100;  // lmdif1's, as the other numbers
  if (derivatives == Derivatives::numeric) {
    const auto function = [](void* p, int, int, const double* at, double* r, int) {
      fill(*static_cast<const Problem*>(p), *at, r);
      return 0;
    };
    info = lmdif(function, const_cast<Problem*>(&problem), n, 1, &x, residuals.data(), tolerances.function,
                 tolerances.parameter, tolerances.gradient, 2 * kIterations, 0, &diagonal, 1, kStepBound, 0,
                 &evaluations, jacobian.data(), n, &pivot, &qtf, &wa1, &wa2, &wa3, work.data());
  } else {
    const auto function = [](void* p, int, int, const double* at, double* r, double* J, int, int what) {
      const auto& it = *static_cast<const Problem*>(p);
      what == 1 ? fill(it, *at, r) : fill_slopes(it, *at, J);
      return 0;
    };
    info = lmder(function, const_cast<Problem*>(&problem), n, 1, &x, residuals.data(), jacobian.data(), n,
                 tolerances.function, tolerances.parameter, tolerances.gradient, 2 * kIterations, &diagonal, 1,
                 kStepBound, 0, &evaluations, &slopes, &pivot, &qtf, &wa1, &wa2, &wa3, work.data());
  }
  // 6 to 8: a tolerance was too small for doubles; the rest: not legal, or too many evaluations
  const bool converged = info >= 1 && info <= 4;
  const char* claim = converged ? "converged" : info >= 6 ? "tolerance too small" : "no convergence";
  return {x, converged, claim, static_cast<double>(problem.sweeps - before)};
}

#endif
#ifdef MIXITY_HAS_GSL

/// gsl_multifit_nlinear with its default parameters; forward differences unless derivatives are analytic.
template <class Problem>
Answer with_gsl(const Problem& problem, Derivatives derivatives, double start, const Tolerances& tolerances) {
  gsl_set_error_handler_off();  // the default one ends the program
  const auto before = problem.sweeps;
  gsl_multifit_nlinear_fdf functions{};
  functions.f = [](const gsl_vector* x, void* p, gsl_vector* r) -> int {
    fill(*static_cast<const Problem*>(p), gsl_vector_get(x, 0), r->data);
    return GSL_SUCCESS;
  };
  if (derivatives == Derivatives::analytic)
    functions.df = [](const gsl_vector* x, void* p, gsl_matrix* J) -> int {
      fill_slopes(*static_cast<const Problem*>(p), gsl_vector_get(x, 0), J->data);
      return GSL_SUCCESS;
    };
  functions.n = problem.size();
  functions.p = 1;
  functions.params = const_cast<Problem*>(&problem);
  const gsl_multifit_nlinear_parameters parameters = gsl_multifit_nlinear_default_parameters();
  gsl_multifit_nlinear_workspace* work =
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &parameters, problem.size(), 1);
  const gsl_vector_view x = gsl_vector_view_array(&start, 1);
  gsl_multifit_nlinear_init(&x.vector, &functions, work);
  int info = 0;
  const int status = gsl_multifit_nlinear_driver(kIterations, tolerances.parameter, tolerances.gradient,
                                                 tolerances.function, nullptr, nullptr, &info, work);
  Answer answer{gsl_vector_get(gsl_multifit_nlinear_position(work), 0), status == GSL_SUCCESS,
                status == GSL_SUCCESS ? "converged" : gsl_strerror(status),
                static_cast<double>(problem.sweeps - before)};
  gsl_multifit_nlinear_free(work);
  return answer;
}

#endif

}  // namespace mixity::precision
