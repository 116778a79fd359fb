"""Least-squares solvers of SciPy and lmfit on a problem of one parameter, each called as its documentation shows."""

import collections
import functools
import math

import lmfit
import numpy as np
from scipy import optimize

# residuals(x) and slopes(x) take a number and return arrays; slopes are those of the residuals
Problem = collections.namedtuple("Problem", "residuals slopes lower upper")
Answer = collections.namedtuple("Answer", "x converged claim")

MOST_EVALUATIONS = 400  # enough for every case here that converges at all
TOLERANCES = ("ftol", "xtol", "gtol")
REFUSED = (ValueError, np.linalg.LinAlgError)  # what both raise at numbers that are not finite


def limits(tolerance):
    """Arguments of both: all tolerances alike, or those that the library comes with."""
    return {"max_nfev": MOST_EVALUATIONS} | ({} if tolerance is None else dict.fromkeys(TOLERANCES, tolerance))


def failed():
    return Answer(math.nan, False, "failed")


def with_scipy(problem, start, tolerance=None, *, method, analytic):
    """Bounds are unknown to lm."""
    more = limits(tolerance) | ({} if method == "lm" else {"bounds": (problem.lower, problem.upper)})
    if analytic:
        more["jac"] = lambda x: problem.slopes(x[0])[:, None]
    try:
        fit = optimize.least_squares(lambda x: problem.residuals(x[0]), [start], method=method, **more)
    except REFUSED:
        return failed()
    return Answer(float(fit.x[0]), fit.success, "converged" if fit.success else "no convergence")


def with_lmfit(problem, start, tolerance=None, *, analytic):
    """MINPACK again, on a variable of which the parameter is a sine, so that it keeps its bounds."""
    parameters = lmfit.Parameters()
    parameters.add("x", start, min=problem.lower, max=problem.upper)
    more = limits(tolerance)
    if analytic:
        more["Dfun"] = lambda p: problem.slopes(p["x"].value)[:, None]
    try:
        fit = lmfit.minimize(lambda p: problem.residuals(p["x"].value), parameters, **more)
    except REFUSED:
        return failed()
    too_small = getattr(fit, "ier", 0) >= 6  # 6 to 8: a tolerance was too small for doubles
    claim = "converged" if fit.success else "tolerance too small" if too_small else "no convergence"
    return Answer(float(fit.params["x"].value), fit.success, claim)


# Name and function of (problem, start, tolerance)
SOLVERS = {
    "SciPy lm analytic": functools.partial(with_scipy, method="lm", analytic=True),
    "SciPy lm numeric": functools.partial(with_scipy, method="lm", analytic=False),
    "SciPy trf analytic": functools.partial(with_scipy, method="trf", analytic=True),
    "SciPy trf numeric": functools.partial(with_scipy, method="trf", analytic=False),
    "lmfit analytic": functools.partial(with_lmfit, analytic=True),
    "lmfit numeric": functools.partial(with_lmfit, analytic=False),
}
