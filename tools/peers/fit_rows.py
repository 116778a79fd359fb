"""SciPy and lmfit in the table of fits: the cases of precision_fit, at its tolerances, taking turns with its rows.

precision_fit --turns says when: so what disturbs the machine disturbs all, and both read the same kind of clock, the
processor time of their thread.
"""

import decimal
import itertools
import json
import math
import time

import numpy as np

from peers import fits
from peers.programs import beside
from peers.solvers import SOLVERS

TOLERANCES = [10.0**-digits for digits in range(2, 16)]  # those of precision_fit; SciPy refuses less than 2.2e-16
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


def error(x, case):
    """Relative to the truth, or where that is the bound 0, to lambda's range."""
    truth = decimal.Decimal(case["truth"])
    if not math.isfinite(x):
        return math.inf
    with decimal.localcontext() as context:
        context.prec = 50
        return float(abs(decimal.Decimal(x) - truth) / (truth or decimal.Decimal(case["upper"])))


class Row:
    """One solver at one tolerance on one case."""

    def __init__(self, case, problem, name, tolerance):
        sweeps = itertools.count()
        problem = counted(problem, sweeps)
        self.case, self.method, self.tolerance = case["case"], name, tolerance
        self.run = lambda: SOLVERS[name](problem, case["start"], tolerance)
        answer = self.run()
        self.evaluations = next(sweeps)
        self.error = error(answer.x, case)
        outside = answer.x < case["lower"] or answer.x > case["upper"]  # lm knows no bounds, its reader does
        self.claim = "out of range" if outside else answer.claim
        self.times = []

    def take_turn(self):
        self.run()  # what other solvers left in the caches would count: a run of precision_fit is one of many
        start = time.thread_time_ns()
        self.run()
        self.times.append(time.thread_time_ns() - start)

    def csv(self):
        low, median, high = np.quantile(self.times, (0.25, 0.5, 0.75), method="lower")
        return (f'fit,"{self.case}",{self.method},{self.tolerance:.3g},{self.error:.3g},{self.evaluations},'
                f"{median:.5g},{(high - low) / 2:.3g},{self.claim}\n")


def rows_of(case):
    psi, f = np.array(case["psi"]), np.array(case["f"])
    problem = fits.problem(case["model"], psi, np.log(f), (case["lower"], case["upper"]))
    return [Row(case, problem, name, tolerance) for name in SOLVERS for tolerance in TOLERANCES]


def run(program):
    """What precision_fit prints, with rows of SciPy and lmfit after its own."""
    rows, text = [], b""
    with beside(program, "--turns") as fit, np.errstate(all="ignore"):  # lm tries lambdas that have no logarithm
        for line in fit.stdout:
            if line.startswith(b"{"):
                rows += rows_of(json.loads(line))
            elif line == b"turn\n":
                for row in rows:
                    row.take_turn()
                fit.stdin.write(b"\n")
                fit.stdin.flush()
            else:
                text += line
    return text.decode() + "".join(row.csv() for row in rows)
