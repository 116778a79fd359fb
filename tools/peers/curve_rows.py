"""SciPy's ODRPACK in the table of fits of curves: the cases of precision_curve, at its tolerances, in turn with it."""

import functools
import warnings

import numpy as np

from peers import odrpack, turns

MOST_ITERATIONS = 200  # as those of the others
CLAIMS = {1: "converged", 2: "converged", 3: "converged", 4: "no convergence"}  # else it says why to doubt it


def solve(case, points, analytic, tolerance):
    fit = odrpack.fit(case["model"], points, [case["start"]], analytic, maxit=MOST_ITERATIONS, sstol=tolerance,
                      partol=tolerance)
    return turns.Answer(float(fit.beta[0]), CLAIMS.get(fit.info, "questionable"))  # pylint: disable=no-member


def rows_of(case):
    points = np.array([case[name] for name in ("P", "T", "A", "sigma_T", "sigma_A")]).T
    return [turns.Row(case, f"ODRPACK {'analytic' if analytic else 'numeric'}", tolerance,
                      functools.partial(solve, case, points, analytic, tolerance))
            for analytic in (True, False) for tolerance in turns.TOLERANCES]


def run(program):
    """What precision_curve prints, with rows of ODRPACK after its own."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # SciPy means to let scipy.odr go
        return turns.run(program, "curve", rows_of)
