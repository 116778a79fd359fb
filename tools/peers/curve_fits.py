"""Fits under the objective curve: mixity's library beside ODRPACK on the same points, in turn, and whole programs.

ODRPACK gives value and Wald error, from one start; a bare fit of mixity (--checks=false) searches the whole range and
has a status and the ends of 95 % profile intervals, too; the whole one also budget, score tests, tests of the residuals
and evidence. A sweep: the distances of all points from given curves, with derivatives, on one
processor, each found anew; a fit can do with none fewer than it has steps.
"""

import contextlib
import json
import math
import pathlib
import subprocess
import tempfile

import numpy as np

from peers import odrpack
from peers.markdown import show_time
from peers.timing import OwnTime, alternate, run

# model, points, constants free, each point with a load of its own, rounds
CASES = [("c", 100, False, True, 15), ("c", 100, False, False, 15), ("c", 100, True, True, 15),
         ("c", 100, True, False, 15), ("c", 2500, False, True, 9), ("c", 2500, False, False, 9),
         ("c", 2500, True, True, 9), ("c", 2500, True, False, 9), ("b", 100, False, True, 9), ("b", 100, True, True, 9),
         ("b", 2500, False, True, 7), ("b", 2500, True, True, 7), ("c", 200, False, True, 9),
         ("bk", 200, False, True, 7)]
LARGE = [("c", 10**4, False, True, 5), ("c", 10**5, False, True, 3), ("c", 10**6, False, True, 1)]
MOST_NUMERIC = 10**5  # points up to which ODRPACK is tried without derivatives, too
HEADER = ["model", "points", "free", "loads", "mixity, bare", "ODRPACK", "ODRPACK, derivatives", "bare to the faster",
          "mixity, whole", "whole to bare", "lambda", "ODRPACK's, relative", "status", "a sweep", "bare, in sweeps"]
FREE = "--free=toughness,modulus"


@contextlib.contextmanager
def served(program, model, points, constants, own_loads, *more):
    """A process that fits when asked, what its fit says, and the points."""
    with tempfile.TemporaryDirectory(prefix="curve-") as folder:
        path, pipe = pathlib.Path(folder, "points"), subprocess.PIPE
        words = ["constants"] * constants + ["own_loads"] * own_loads + list(more)
        with subprocess.Popen([program, model, str(points), path, *words], stdin=pipe, stdout=pipe, text=True) as process:
            yield process, json.loads(process.stdout.readline()), np.fromfile(path).reshape(-1, 5)


def own_time(process, clock, which):
    print(which, file=process.stdin, flush=True)
    return OwnTime(float(process.stdout.readline().split()[("cpu", "wall").index(clock)]))


def fit_row(program, clock, case):
    """Seconds of mixity's fit, and the row."""
    model, points, constants, own_loads, rounds = case
    with served(program, model, points, constants, own_loads) as (process, fit, data):
        tasks = {which: lambda which=which: own_time(process, clock, which) for which in ("bare", "whole")}
        if points <= MOST_NUMERIC:
            tasks["numeric"] = lambda: odrpack.fit(model, data, fit["starts"])
        if model == "c":
            tasks["analytic"] = lambda: odrpack.fit(model, data, fit["starts"], analytic=True)
        times, answers = alternate(tasks, rounds, clock)
    seconds = {name: float(np.median(taken)) for name, taken in times.items()}
    value = fit["values"][0]
    theirs = {name: float(answers[name].beta[0]) / value - 1 for name in seconds
              if name not in ("bare", "whole")}
    furthest = max(theirs.values(), key=abs)
    note = "" if abs(furthest) <= 1e-6 else " DIFFERENT"  # ODRPACK stops at some 1e-7
    time = {name: show_time(taken) for name, taken in seconds.items()}
    return seconds["bare"], [
        model, str(points), ", ".join(fit["names"]), "own" if own_loads else "shared", time["bare"],
        time.get("numeric", ""), time.get("analytic", ""),
        f"{min(seconds[name] for name in theirs) / seconds['bare']:.3g}", time["whole"],
        f"{seconds['whole'] / seconds['bare']:.3g}", f"{value:.10g}", f"{furthest:+.1e}{note}", fit["status"],
        show_time(fit["sweep"]), f"{seconds['bare'] / fit['sweep']:.3g}"]


def ratio_line(seconds):
    """What is wanted of models among themselves."""
    def of(model, points, constants):
        return seconds[model, points, constants, True]
    ratios = {f"b over c, {points} points{', constants free' * constants}":
              of("b", points, constants) / of("c", points, constants)
              for points in (100, 2500) for constants in (False, True)}
    ratios["bk over c, 200 points"] = of("bk", 200, False) / of("c", 200, False)
    return "; ".join(f"{name}: {ratio:.3g}" for name, ratio in ratios.items())


def growth_exponent(seconds):
    """By least squares of the logarithms, and the sizes."""
    sizes = sorted(points for _, points, _, _ in seconds)
    times = [seconds["c", n, False, True] for n in sizes]
    return np.polyfit([math.log(n) for n in sizes], [math.log(t) for t in times], 1)[0], sizes


def process_rows(options, points):
    """Whole programs on a file of (P, T, A) with errors of 1 %: seconds on the wall, and of all processors."""
    with served(options.benchmarks / "curve_fits", "c", points, True, False) as (_, _, data), \
            tempfile.TemporaryDirectory(prefix="curve-") as folder:
        path = pathlib.Path(folder, "runs.csv")
        np.savetxt(path, data, fmt="%.10g", delimiter=",", header="P,T,A,sigma_T,sigma_A", comments="")
        fit = [options.program, "fit", path, "--objective=curve", "--format=json"]
        tasks = {f"models a, b, c, {FREE}, comparison, loads left out": [*fit, FREE, "--models=a,b,c"],
                 f"models a, b, c, {FREE}, no comparison": [*fit, FREE, "--models=a,b,c", "--compare=false"],
                 "models a, b, c, comparison, loads left out": [*fit, "--models=a,b,c"],
                 "model c, no comparison": [*fit, "--models=c", "--compare=false"]}
        tasks = {name: lambda command=command: run(command) for name, command in tasks.items()}
        wall, cpu = (alternate(tasks, 3, clock)[0] for clock in ("wall", "cpu"))
        for name, taken in wall.items():
            yield [name, show_time(float(np.median(taken))), show_time(float(np.median(cpu[name])))]
