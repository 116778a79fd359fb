"""Areas predicted by root searches on the printed equation, beside mixity's."""

import csv
import json
import math

import numpy as np
from scipy import optimize

from peers.timing import OwnTime, alternate, benchmark, run, time_cells

LAMBDA, LOAD = 0.15, 3.0  # those of mechanics_benchmark


def stable_branch(program, model):
    """Loads spread over the stable branch and the radii that bracket the answer."""
    P, m = LOAD, 1 - LAMBDA
    top = (3 / 4 * (P + 3 * math.pi + math.sqrt(9 * math.pi**2 + 6 * math.pi * P))) ** (1 / 3)
    if model == "a":  # no fold: the asymptote
        T_end, y = 100.0, m * (3 * math.pi + math.sqrt(9 * math.pi**2 + 6 * math.pi * P / m))
        bottom = (3 / 4 * (y + P)) ** (1 / 3)
    else:
        folds = json.loads(run([program, "instability", f"--model={model}", f"--lambda={LAMBDA}", f"--load={P}",
                                "--format=json"]))["folds"]
        fold = next(fold for fold in folds if fold["control"] == "load")
        T_end, bottom = min(fold["T"], 100.0), math.sqrt(fold["A"] / math.pi)
    return P, np.sort(np.random.default_rng(7).uniform(0, 0.99 * T_end, 1000)), bottom, top * (1 + 1e-9)


def table(options, model):
    """Time per predicted area, and how far the areas are from those of `mixity predict`."""
    P, loads, bottom, top = stable_branch(options.program, model)
    slope, k = (1 - LAMBDA, 1) if model == "a" else (1, 1 - LAMBDA / 2)  # f = 1 + slope tan^2(k psi)

    def excess(a, T):
        y = 4 / 3 * a**3 - P
        return y * y + T * T - 8 * math.pi * a**3 * (1 + slope * math.tan(k * math.atan2(T, y)) ** 2)

    def bisection():
        low, high = np.full_like(loads, bottom), np.full_like(loads, top)
        for _ in range(52):
            a = (low + high) / 2
            y = 4 / 3 * a**3 - P
            below = y * y + loads**2 < 8 * np.pi * a**3 * (1 + slope * np.tan(k * np.arctan2(loads, y)) ** 2)
            low, high = np.where(below, a, low), np.where(below, high, a)
        return np.pi * low**2

    law = {"a": "Johnson", "b": "WatersGuduru"}[model]
    timed = {f"mixity, arrays, {model}": "PredictBatch", f"mixity, point by point, {model}": "Predict"}
    tasks = {name: lambda kind=kind: OwnTime(
        benchmark(options.benchmarks / "mechanics_benchmark", f"{kind}<{law}>", "time/point").seconds * len(loads))
        for name, kind in timed.items()} if options.benchmarks else {}
    tasks[f"scipy brentq on the printed equation, {model}"] = lambda: np.array(
        [math.pi * optimize.brentq(excess, bottom, top, args=(T,)) ** 2 for T in loads.tolist()])
    tasks[f"numpy bisection of 1000 at once, {model}"] = bisection
    times, answers = alternate(tasks, options.repetitions, options.clock)
    shear = "--shear=" + ",".join(map(repr, loads.tolist()))
    ours = run([options.program, "predict", f"--model={model}", f"--lambda={LAMBDA}", f"--load={P}", shear])
    areas = np.array([float(row["A"]) for row in csv.DictReader(ours.splitlines())])
    for name, row in zip(tasks, time_cells({name: taken / len(loads) for name, taken in times.items()})):
        own = isinstance(answers[name], OwnTime)
        yield [*row, "" if own else f"{np.max(np.abs(answers[name] / areas - 1)):.1e}"]
