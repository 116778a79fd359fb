"""How fast the Python package is beside SciPy and lmfit, in one run: tools/python speed. Medians; ratios are what counts."""

import functools
import statistics
import subprocess
import sys
import time
from concurrent.futures import ProcessPoolExecutor

import lmfit
import numpy as np
import scipy
from scipy.optimize import brentq

import mixity
from mixity import _core

CONTACT = (9.42e-3, 2.133e6, 27e-3)


def seconds(call, repeat=21):
    call()
    times = []
    for _ in range(repeat):
        begin = time.perf_counter()
        call()
        times.append(time.perf_counter() - begin)
    return statistics.median(times)


def row(what, ours, theirs=None, peer="", wanted=""):
    ratio = f"{theirs / ours:.3g}" if theirs else ""
    print(f"| {what} | {ours * 1e3:.3g} ms | {peer} | {ratio} | {wanted} |")


def main():
    random = np.random.default_rng(1)
    P = np.repeat(np.geomspace(0.5e-3, 8e-3, 8), 25)
    T = np.tile(np.linspace(0, 0.8, 25), 8) * np.array(
        [mixity.folds("c", 0.01, p, contact=CONTACT)[0]["T"] for p in P]
    )
    A = mixity.area("c", 0.01, P, T, contact=CONTACT) * (1 + 0.003 * random.standard_normal(200))
    data = mixity.Dataset(P=P, T=T, A=A, radius=CONTACT[0], modulus="2.133 MPa +/- 3%", toughness=CONTACT[2])
    print(f"NumPy {np.__version__}, SciPy {scipy.__version__}, lmfit {lmfit.__version__}, mixity {mixity.__version__}\n")
    print("| what | mixity | beside | ratio | wanted |\n|---|---|---|---|---|")

    law = mixity.lmfit.model("c", contact=CONTACT)
    scale = 1e6  # areas in mm^2, as lmfit's users have them

    def residual(params):
        return (law.func(P=P, T=T, lambda_=params["lambda_"].value) - A) * scale

    def area_by_brentq(x):  # the equation as it is printed, point by point, as scripts have it
        force, area = CONTACT[0] * CONTACT[2], (CONTACT[0] / np.cbrt(CONTACT[1] * CONTACT[0] / CONTACT[2])) ** 2
        found = []
        for p, t in zip(P / force, T / force):
            def balance(a):
                y = 4 / 3 * a**3 - p
                psi = np.arctan2(t, y)
                return y * y + t * t - 8 * np.pi * a**3 / (1 + (x - 1) * np.sin(psi) ** 2)

            centre = np.cbrt(0.75 * (3 * np.pi + p))  # the fold: beyond it the area there
            beyond = balance(centre) > 0
            found.append(np.pi * (centre if beyond else brentq(balance, centre, 3 * centre)) ** 2 * area)
        return np.array(found)

    start = lmfit.create_params(lambda_=dict(value=0.02, min=1e-6, max=1))

    def residual_by_brentq(params):
        return (area_by_brentq(params["lambda_"].value) - A) * scale

    all_models = seconds(lambda: mixity.fit(data)["c"].params["lambda"].interval)
    alone = seconds(lambda: mixity.fit(data, compare=False)["c"].params["lambda"].interval)
    row("three models, 200 points, budget, intervals, tests, comparison", all_models,
        seconds(lambda: lmfit.minimize(residual_by_brentq, start), 3), "lmfit, one model by brentq, value and error", "20")
    row("the same without comparing them", alone, seconds(lambda: lmfit.minimize(residual, start)),
        "lmfit, one model on mixity's arrays, value and error", "")
    bare = seconds(lambda: mixity.fit(data, compare=False, checks=False)["c"].params["lambda"].budget)
    row("values, errors, intervals and budgets of the three, nothing tested", bare,
        seconds(lambda: lmfit.minimize(residual_by_brentq, start), 3), "lmfit, one model by brentq, value and error", "20")
    stated = [("models", "c"), ("checks", "false"), ("compare", "false")]
    more, engine_times = [], []  # in turn, as the machine's pace changes
    for _ in range(401):
        direct = seconds(lambda: _core.fit(data._core, stated, None), 1)
        more.append(seconds(lambda: mixity.fit(data, "c", checks=False, compare=False), 1) - direct)
        engine_times.append(direct)
    print(f"| the call itself, above the engine's time | {statistics.median(more) * 1e6:.1f} us "
          f"| engine {statistics.median(engine_times) * 1e6:.0f} us | | 30 us |")

    many = np.linspace(0, 20, 100_000)
    out, status = np.empty_like(many), np.empty(many.size, np.uint8)
    lam, load = np.array([0.3]), np.array([2.0])
    engine = seconds(lambda: _core.areas("b", [lam], load, many, out, status))
    ours = seconds(lambda: mixity.area("b", 0.3, 2.0, many, out=out))
    print(f"| areas at 10^5 loads, out given | {ours * 1e3:.3g} ms | engine {engine * 1e3:.3g} ms | {ours / engine:.3g} times | 1.2 |")
    few = np.linspace(0, 20, 300)

    def by_brentq():
        found = []
        for t in few:
            def balance(a):
                y = 4 / 3 * a**3 - 2.0
                psi = np.arctan2(t, y)
                return y * y + t * t - 8 * np.pi * a**3 * (1 + np.tan((1 - 0.3 / 2) * psi) ** 2)

            found.append(brentq(balance, 1.9, 4.0))
        return found

    row("areas at 300 loads", seconds(lambda: mixity.area("b", 0.3, 2.0, few)), seconds(by_brentq, 5), "brentq", "100")
    begin = "import time; import numpy; t = time.perf_counter(); import mixity; print(time.perf_counter() - t)"
    loads = [float(subprocess.run([sys.executable, "-c", begin], capture_output=True, text=True, check=True).stdout) for _ in range(9)]
    print(f"| import beside NumPy | {statistics.median(loads) * 1e3:.3g} ms | | | 100 ms |")


    campaign()


def one(plan, index):
    return mixity.fit(plan.simulate(1, index), "c", checks=False, compare=False)["c"].params["lambda"].value


def campaign():
    """Simulated experiments and a fit of each, which is one thread: the cost of a task, and what a second processor brings."""
    plan = mixity.Plan("c", 0.01, [1e-3, 4e-3], radius="9.42 mm", modulus="2.133 MPa +/- 3%", toughness="27 mJ/m^2")
    work = functools.partial(one, plan)
    count = 3000
    begin = time.perf_counter()
    plain = [work(i) for i in range(count)]
    alone = time.perf_counter() - begin
    begin = time.perf_counter()
    assert mixity.campaign(work, count) == plain
    here = time.perf_counter() - begin
    with ProcessPoolExecutor(2) as pool:
        mixity.campaign(work, 4, pool, chunk=1)  # the workers have started
        begin = time.perf_counter()
        assert mixity.campaign(work, count, pool) == plain
        two = time.perf_counter() - begin
    print(f"| campaign of {count} experiments, simulated and fitted, one process | {count / here:.0f} a second | a loop {count / alone:.0f} | "
          f"{100 * (here / alone - 1):.1f} % more time | 5 % |")
    print(f"| the same on two processes | {count / two:.0f} a second | {count / two / 2:.0f} a core | {100 * (2 * two / here - 1):.1f} % more processor time | 5 % |")


if __name__ == "__main__":
    main()
