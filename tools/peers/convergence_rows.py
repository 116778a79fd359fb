"""SciPy and lmfit in the table of false convergence: precision_convergence --serve evaluates the costs and judges."""

import json

import numpy as np

from peers.programs import beside
from peers.solvers import SOLVERS, Problem

TIGHT = 1e-15


class Served:
    """precision_convergence as convergence_server.h describes it."""

    def __init__(self, process):
        self.process, self.sets = process, []
        for line in process.stdout:
            if line == b"serving\n":
                return
            self.sets.append(json.loads(line))

    def ask(self, request):
        self.process.stdin.write(f"{request}\n".encode())

    def sweep(self, what, data, unit, x):
        self.ask(f"{what} {data} {unit} {float(x)!r}")
        self.process.stdin.flush()
        size = 8 * self.sets[data]["points"]
        answer = self.process.stdout.read(size)
        if len(answer) != size:
            raise EOFError
        return np.frombuffer(answer).copy()  # lmfit scales slopes in place

    def problem(self, data, unit):
        return Problem(lambda x: self.sweep("residuals", data, unit, x), lambda x: self.sweep("slopes", data, unit, x),
                       self.sets[data]["lower"], self.sets[data]["upper"])


def fit_all(served, name, tolerance):
    row = name if tolerance is None else f"{name}, {tolerance:.0e}"
    for data, at in enumerate(served.sets):
        for unit in range(at["units"]):
            problem = served.problem(data, unit)
            for start in at["starts"]:
                answer = SOLVERS[name](problem, start, tolerance)
                served.ask(f"count {data} {unit} {answer.x!r} {int(answer.converged)} {row}")


def run(program):
    """What precision_convergence prints, SciPy and lmfit in its tables."""
    with beside(program, "--serve") as process, np.errstate(all="ignore"):
        served = Served(process)
        for name in SOLVERS:
            for tolerance in (None, TIGHT):  # usual tolerances first
                fit_all(served, name, tolerance)
        process.stdin.close()
        return process.stdout.read().decode()
