"""Rows of this process in the table of a program precision_TASK: at each of its turns, which `--turns` makes it tell.

So what disturbs the machine disturbs all, and all read the same kind of clock, the processor time of their thread.
"""

import collections
import decimal
import json
import math
import time

import numpy as np

from peers.programs import beside

Answer = collections.namedtuple("Answer", "x claim")
TOLERANCES = [10.0**-digits for digits in range(2, 16)]  # those of the programs; SciPy refuses less than 2.2e-16


def error(x, case):
    """Relative to the truth, or where that is the bound 0, to lambda's range."""
    truth = decimal.Decimal(case["truth"])
    if not math.isfinite(x):
        return math.inf
    with decimal.localcontext() as context:
        context.prec = 50
        return float(abs(decimal.Decimal(x) - truth) / (truth or decimal.Decimal(case["upper"])))


class Row:
    """One solver at one tolerance on one case. `solve` returns what has Answer's members."""

    def __init__(self, case, method, tolerance, solve):
        self.case, self.method, self.tolerance, self.solve = case, method, tolerance, solve
        self.evaluations = 0
        answer = solve()
        self.error = error(answer.x, case)
        outside = answer.x < case["lower"] or answer.x > case["upper"]  # some know no bounds, their reader does
        self.claim = "out of range" if outside else answer.claim
        self.times = []

    def take_turn(self):
        self.solve()  # what other solvers left in the caches would count: a run of the program's is one of many
        start = time.thread_time_ns()
        self.solve()
        self.times.append(time.thread_time_ns() - start)

    def csv(self, task):
        low, median, high = np.quantile(self.times, (0.25, 0.5, 0.75), method="lower")
        return (f'{task},"{self.case["case"]}",{self.method},{self.tolerance:.3g},{self.error:.3g},{self.evaluations},'
                f"{median:.5g},{(high - low) / 2:.3g},{self.claim}\n")


def run(program, task, rows_of):
    """What the program prints, with the rows of each of its cases after its own."""
    rows, text = [], b""
    with beside(program, "--turns") as process, np.errstate(all="ignore"):  # some try lambdas that have no logarithm
        for line in process.stdout:
            if line.startswith(b"{"):
                rows += rows_of(json.loads(line))
            elif line == b"turn\n":
                for row in rows:
                    row.take_turn()
                process.stdin.write(b"\n")
                process.stdin.flush()
            else:
                text += line
    return text.decode() + "".join(row.csv(task) for row in rows)
