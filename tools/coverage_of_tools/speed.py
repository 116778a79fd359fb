"""Times of a replicate, tools in turn in one run: 20 points, errors known and unknown."""

import warnings

import numpy as np
from scipy.optimize import brentq

from coverage_of_tools import by_iminuit, by_lmfit, by_mixity, by_odrpack, by_scipy, problems
from peers.markdown import markdown, show_time
from peers.timing import alternate

REPETITIONS, IN_A_ROW = 11, 5  # replicates of a campaign follow one another
NAMES = ("fold", "constants", "line", "b", "bk")


class SearchedContact:
    """The area as laboratories write it: the printed equation, solved point by point."""

    def __init__(self, curve):
        self.curve, self.P = curve, curve.P

    def height(self, theta, T):
        return np.array([self.one(theta[0], P, t) for P, t in zip(self.P, np.broadcast_to(T, self.P.shape))])

    @staticmethod
    def one(lam, P, t):
        t = min(abs(t), np.sqrt(3 * np.pi * (3 * np.pi + 2 * P) / max(lam, 1e-12)))
        low, high = np.cbrt(0.75 * (3 * np.pi + P)), np.cbrt(0.75 * (3 * np.pi + np.sqrt(9 * np.pi**2 + 6 * np.pi * P) + P))

        def excess(a):
            y = 4 / 3 * a**3 - P
            return y * y + lam * t * t - 8 * np.pi * a**3
        return np.pi * (low if excess(low) > 0 else brentq(excess, low, high * (1 + 1e-12))) ** 2

    def slope(self, theta, T):
        return (self.height(theta, T + 1e-4) - self.height(theta, T - 1e-4)) / 2e-4


def tasks_of(name, errors):
    cell = problems.Cell(name, errors, "constant", 20)
    problem, data = problems.PROBLEMS[name], problems.experiment(cell, 0)
    tools = {"mixity, interval and status": lambda: by_mixity.fit(problem, cell, data, checks=False),
             "mixity, all tests": lambda: by_mixity.fit(problem, cell, data),
             "lmfit": lambda: by_lmfit.wald(problem, cell, data),
             "lmfit, conf_interval": lambda: by_lmfit.conf_interval(problem, cell, data) if len(problem.start) > 1 else None,
             "odrpack, explicit": lambda: by_odrpack.one_fit(problem, cell, data, "explicit", "forward"),
             "odrpack, implicit, central": lambda: by_odrpack.one_fit(problem, cell, data, "implicit", "central")
             if not problem.exact_x else None,
             "iminuit, MINOS": lambda: by_iminuit.minos(problem, cell, data),
             "curve_fit": lambda: by_scipy.curve_fit(problem, cell, data)}
    if name == "fold":
        searched = data._replace(curve=SearchedContact(data.curve))
        tools["lmfit, areas by brentq"] = lambda: by_lmfit.wald(problem, cell, searched)
        tools["odrpack, explicit, areas by brentq"] = lambda: by_odrpack.one_fit(problem, cell, searched, "explicit", "forward")
    return tools


def in_a_row(task):
    def tasks():
        for _ in range(IN_A_ROW):
            answer = task()
        return answer
    return tasks


def table():
    rows = []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for name in NAMES:
            for errors in ("known", "unknown"):
                with np.errstate(all="ignore"):
                    tasks = {tool: in_a_row(task) for tool, task in tasks_of(name, errors).items()}
                    times, answers = alternate(tasks, REPETITIONS, "cpu")
                median = {tool: float(np.median(taken)) / IN_A_ROW for tool, taken in times.items() if answers[tool]}
                bare, whole = median["mixity, interval and status"], median["mixity, all tests"]
                rows += [[f"{name}, {errors}", tool, show_time(seconds), f"{seconds / bare:.2g}", f"{seconds / whole:.2g}"]
                         for tool, seconds in median.items()]
    header = ["problem, errors", "tool", "time", "over mixity, interval and status", "over mixity, all tests"]
    return markdown(header, rows)
