"""SciPy and lmfit in the table of fits: the cases of precision_fit, at its tolerances, taking turns with its rows."""

import itertools
import math

import numpy as np

from peers import fits, turns
from peers.solvers import SOLVERS

OUT_OF_REACH = 1e100  # what stands for residuals where the model is not finite, as in solvers.h


def counted(problem, sweeps):
    """The problem with a count of its evaluations, and with the cost that the others see where it is not finite."""
    def residuals(x):
        next(sweeps)
        values = problem.residuals(x)
        return values if math.isfinite(values @ values) else np.full_like(values, OUT_OF_REACH)

    def slopes(x):
        next(sweeps)
        return problem.slopes(x)

    return problem._replace(residuals=residuals, slopes=slopes)


def row(case, problem, name, tolerance):
    sweeps = itertools.count()
    seen = counted(problem, sweeps)
    made = turns.Row(case, name, tolerance, lambda: SOLVERS[name](seen, case["start"], tolerance))
    made.evaluations = next(sweeps)
    return made


def rows_of(case):
    psi, f = np.array(case["psi"]), np.array(case["f"])
    problem = fits.problem(case["model"], psi, np.log(f), (case["lower"], case["upper"]))
    return [row(case, problem, name, tolerance) for name in SOLVERS for tolerance in turns.TOLERANCES]


def run(program):
    """What precision_fit prints, with rows of SciPy and lmfit after its own."""
    return turns.run(program, "fit", rows_of)
