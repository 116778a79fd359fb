"""Problems, cells and the experiments that are made of them. An experiment is a function of cell and number alone."""

import collections
import math
import zlib

import numpy as np
from scipy.optimize import brentq

from coverage_of_tools import curves

# x, y: readings; sigma_x, sigma_y: errors as a laboratory states or guesses them; truth: those it has; `memory`: of neighbours
Experiment = collections.namedtuple("Experiment", "x y sigma_x sigma_y true_sigma_x true_sigma_y memory curve")
Cell = collections.namedtuple("Cell", "problem errors noise points")

BASE = {"errors": "unknown", "noise": "constant", "points": 20}
VARIED = {"errors": ("known", "to a factor"), "noise": ("proportional", "floor and proportional", "memory 0.6", "2 % outliers"),
          "points": (6, 100, 1000)}
FACTOR = 0.5  # an error known to a factor is stated as half of what it is
GUESS = 0.01  # an error that is not known: this share of the largest reading, in each axis


class Problem:
    """theta: the true parameters, the first of which is judged. noise: of x, of y, as shares of their scales."""

    def __init__(self, title, names, theta, bounds, start, noise, exact_x=False, judged=0):
        self.title, self.names, self.theta = title, names, np.array(theta, float)
        self.bounds, self.start, self.noise, self.exact_x = np.array(bounds, float).T, np.array(start, float), noise, exact_x
        self.judged = judged

    truth = property(lambda self: self.theta[self.judged])


class LineProblem(Problem):
    def true_points(self, count):
        x = np.linspace(0.02, 0.55, count)
        curve = curves.Line()
        return x, curve.height(self.theta, x), curve


class LawProblem(Problem):
    def __init__(self, *given, formula, **more):
        super().__init__(*given, exact_x=True, **more)
        self.formula = formula

    def true_points(self, count):
        psi = np.linspace(0.05, 1.2, count)
        return psi, self.formula(self.theta, psi), curves.Law(self.formula)


class ContactProblem(Problem):
    """reach: the last T over that of the fold, or T itself."""

    def __init__(self, *given, loads=(3.0,), reach=None, last=None, **more):
        super().__init__(*given, **more)
        self.loads, self.reach, self.last = loads, reach, last

    def true_points(self, count):
        lam, T, A, P = self.theta[0], [], [], []
        for number, load in enumerate(self.loads):
            n = count // len(self.loads) + (number < count % len(self.loads))
            end = self.last or self.reach * math.sqrt(3 * math.pi * (3 * math.pi + 2 * load) / lam)
            shear = np.linspace(0.05, 1, n) * end
            T.append(shear)
            A.append([area(lam, load, one) for one in shear])
            P.append(np.full(n, load))
        return np.concatenate(T), np.concatenate(A), curves.Contact(np.concatenate(P))


def area(lam, P, T):
    """Of model c, from the equation as printed, y^2 + T^2 = 8 pi a^3 f(psi), between JKR and the fold."""
    def excess(a):
        y = 4 / 3 * a**3 - P
        psi = math.atan2(T, y)
        return y * y + T * T - 8 * math.pi * a**3 / (1 + (lam - 1) * math.sin(psi) ** 2)

    largest = np.cbrt(0.75 * (3 * math.pi + math.sqrt(9 * math.pi**2 + 6 * math.pi * P) + P))
    smallest = np.cbrt(0.75 * (3 * math.pi + P))
    a = brentq(excess, smallest, largest * (1 + 1e-12), xtol=1e-15, rtol=1e-14)
    return math.pi * a * a


CONTACT = (["lambda"], [0.15], [(0, 1)], [0.1], (0.01, 0.005))
PROBLEMS = {
    "fold": ContactProblem("model c, A(T) up to 0.98 of the fold", *CONTACT, reach=0.98),
    "far": ContactProblem("model c, A(T) up to half of the fold", *CONTACT, reach=0.5),
    "zero": ContactProblem("model c, lambda about one standard error above 0", ["lambda"], [0.002], [(0, 1)], [0.02],
                           (0.01, 0.005), last=30.0),
    "constants": ContactProblem("model c with toughness and modulus free", ["lambda", "ln toughness", "ln modulus"],
                                [0.15, 0, 0], [(0, 1), (-2, 2), (-2, 2)], [0.1, 0, 0], (0.005, 0.0025),
                                loads=(3.0, 15.0), reach=0.95),
    "line": LineProblem("a straight line of two energies", ["G_Ic", "slope"], [0.3, 0.5], [(1e-3, 10), (1e-3, 20)], [0.5, 1],
                        (0.04, 0.02), judged=1),
    "b": LawProblem("model b, toughness against psi", ["lambda"], [0.3], [(0, 2)], [0.15], (0, 0.03),
                    formula=curves.waters_guduru),
    "bk": LawProblem("Benzeggagh-Kenane, toughness against psi", ["r", "eta"], [3, 2], [(1e-3, 1000), (0.01, 100)], [2, 1.5],
                     (0, 0.03), formula=curves.benzeggagh_kenane),
    "bound": LawProblem("two parameters, the second at its bound: Hutchinson-Suo", ["lambda", "psi_0"], [0.3, 0],
                        [(0, 1), (0, 0.3)], [0.15, 0.05], (0, 0.03), formula=curves.hutchinson_suo),
}


def cells(main_only=False):
    """The base of each problem, and what differs from it in one thing; bases first. The main ones: also errors known."""
    for name in PROBLEMS:
        yield Cell(name, **BASE)
    if main_only:
        for name in PROBLEMS:
            yield Cell(name, **BASE | {"errors": "known"})
        return
    for key, values in VARIED.items():
        for value in values:
            for name in PROBLEMS:
                yield Cell(name, **BASE | {key: value})


def words(cell):
    return f"{cell.problem}, errors {cell.errors}, {cell.noise}, {cell.points} points"


def shares(noise, value, scale, share):
    """Standard errors at a value: constant, proportional, or half of the variance each."""
    constant, proportional = np.full_like(value, share * scale), share * np.abs(value)
    if noise == "proportional":
        return np.maximum(proportional, 1e-3 * share * scale)
    if noise == "floor and proportional":
        return np.hypot(0.5 * constant, proportional)
    return constant


def draw(random, count, memory):
    values = random.standard_normal(count)
    for i in range(1, count):
        values[i] = memory * values[i - 1] + math.sqrt(1 - memory**2) * values[i]
    return values


CACHE = {}


def experiment(cell, number):
    problem = PROBLEMS[cell.problem]
    key = cell.problem, cell.points
    if key not in CACHE:
        CACHE[key] = problem.true_points(cell.points)
    x, y, curve = CACHE[key]
    random = np.random.default_rng([zlib.crc32(words(cell).encode()), number])
    memory = 0.6 if cell.noise == "memory 0.6" else 0.0
    scales = np.max(x), 1.0 if problem.exact_x else np.max(y)
    true_x, true_y = (shares(cell.noise, value, scale, share) for value, scale, share in zip((x, y), scales, problem.noise))
    read_x = x + true_x * draw(random, x.size, memory)
    read_y = y + true_y * draw(random, y.size, memory)
    if cell.noise == "2 % outliers":
        off = random.choice([-1, 1], y.size) * true_y * random.uniform(8, 20, y.size)
        read_y = np.where(random.random(y.size) < 0.02, read_y + off, read_y)
    if cell.errors == "unknown":
        told_x, told_y = (np.full_like(x, GUESS * np.max(np.abs(one))) for one in (read_x, read_y))
    else:  # an error is taken at the reading, as a laboratory takes it
        factor = 1.0 if cell.errors == "known" else FACTOR
        told_x, told_y = (factor * shares(cell.noise, value, scale, share)
                          for value, scale, share in zip((read_x, read_y), scales, problem.noise))
    if problem.exact_x:
        read_x = x
    return Experiment(read_x, read_y, told_x, told_y, true_x, true_y, memory, curve)
