"""mixity's package: what `mixity fit` does by default, told the errors where they are known, or known to a factor."""

import math

import mixity
import numpy as np

from coverage_of_tools.answers import Answer, failed
from coverage_of_tools.objectives import COVERAGES, LEVELS

RADIUS, MODULUS, TOUGHNESS = 9.42e-3, 2.133e6, 27e-3
FORCE, AREA = RADIUS * TOUGHNESS, RADIUS**2 / (MODULUS * RADIUS / TOUGHNESS) ** (2 / 3)
MODELS = {"line": "linear", "b": "b", "bk": "bk", "bound": "hutchinson_suo"}


def task(problem_name, cell, data):
    """Data set, model, options and name of the judged parameter."""
    known = cell.errors != "unknown"
    to_a_factor = {"sigma_factor": "free"} if cell.errors == "to a factor" else {}
    if hasattr(data.curve, "P"):
        errors = {"sigma_T": data.sigma_x * FORCE, "sigma_A": data.sigma_y * AREA} if known else {}
        one = mixity.Dataset(P=data.curve.P * FORCE, T=data.x * FORCE, A=data.y * AREA, radius=RADIUS, modulus=MODULUS,
                             toughness=TOUGHNESS, **errors)
        free = {"free": ["toughness", "modulus"]} if problem_name == "constants" else {}
        return one, "c", free | to_a_factor, "lambda"
    if problem_name == "line":
        errors = {"sigma_GI": data.sigma_y, "sigma_GII": data.sigma_x} if known else {}
        options = {"objective": "curve", "free": "toughness"} | to_a_factor
        return mixity.Dataset(G_I=data.y, G_II=data.x, **errors), "linear", options, "r"
    errors = {"sigma_Gc": data.sigma_y} if known else {}
    one = mixity.Dataset(psi=data.x, Gc_over_GIc=data.y, units=None, **errors)
    options = {"weighted": True} | to_a_factor if known else {}
    return one, MODELS[problem_name], options, "r" if problem_name == "bk" else "lambda"


def turned(problem_name, value):
    """r = G_IIc/G_Ic is judged as the slope 1/r."""
    return 1 / value if problem_name == "line" else value


def ends_of(problem, name, low, high):
    """An end that mixity does not give lies at the bound."""
    low, high = (None if one is None else turned(name, one) for one in (low, high))
    if name == "line":
        low, high = high, low
    bounds = problem.bounds[:, problem.judged]
    return bounds[0] if low is None else low, bounds[1] if high is None else high


def fit(problem, cell, data, **more):
    name = cell.problem
    one, model, options, parameter = task(name, cell, data)
    fits = mixity.fit(one, model, compare=False, **options | more)
    found = list(fits.values())[0]
    return found, found.params[parameter]


def said_of(found):
    return "" if found.status in ("ok", "at_bound") else f"{found.status}: {found.message}"


def default(problem, cell, data):
    """Profile, Wald and credible intervals of one fit at 95 %, and of a second at 68 %, whose time does not count."""
    found, one = fit(problem, cell, data)
    return answers(problem, cell, found, one, lambda: fit(problem, cell, data, confidence=COVERAGES["68"]))


def answers(problem, cell, found, one, narrower):
    name, said = cell.problem, said_of(found)
    if one.interval is None or one.stderr is None and found.status != "at_bound":
        return {row: failed(said or "no interval") for row in ("mixity, profile", "mixity, Wald", "mixity, credible")}
    value = turned(name, one.value)
    stderr = one.stderr if one.stderr is not None else math.nan
    stderr = stderr / one.value**2 if name == "line" else stderr

    def second():
        narrow, its = narrower()
        return {"68": (its.interval, narrow.evidence), "95": (one.interval, found.evidence)}

    def rows():
        intervals = second()
        ends = {level: ends_of(problem, name, *interval) for level, (interval, _) in intervals.items() if interval}
        both = {"mixity, profile": Answer(value, stderr, ends, said, None, "")}
        if np.isfinite(stderr):
            wald = {level: (value - z * stderr, value + z * stderr) for level, z in LEVELS.items()}
            both["mixity, Wald"] = Answer(value, stderr, wald, said, None, "")
        if all(evidence and evidence["parameter"] in ("lambda", "r") for _, evidence in intervals.values()):
            credible = {level: ends_of(problem, name, evidence["low"], evidence["high"])
                        for level, (_, evidence) in intervals.items()}
            both["mixity, credible"] = Answer(value, stderr, credible, said, None, "")
        return both
    return rows


def bare(problem, cell, data):
    """Distances alone with the errors as stated or guessed, without tests: what ODRPACK minimises."""
    if problem.exact_x or cell.errors != "known":
        return {}
    found, one = fit(problem, cell, data, fitted_errors=False, checks=False)
    name = cell.problem
    theta = None
    if len(problem.start) == 1:
        theta = [one.value]
    elif name == "line":
        toughness = found.params["toughness"].value
        theta = [toughness, 1 / one.value]
    _, narrow = fit(problem, cell, data, fitted_errors=False, checks=False, confidence=COVERAGES["68"])
    if one.interval is None or narrow.interval is None:
        return {"mixity, distances alone": failed(said_of(found) or "no interval")}
    ends = {"95": ends_of(problem, name, *one.interval), "68": ends_of(problem, name, *narrow.interval)}
    stderr = math.nan if one.stderr is None else one.stderr / one.value**2 if name == "line" else one.stderr
    return {"mixity, distances alone": Answer(turned(name, one.value), stderr, ends, said_of(found), theta, "distance")}


def linear_scale(problem, cell, data):
    """Toughness itself instead of its logarithm: for noise of constant size, a choice that the user makes."""
    if not problem.exact_x or cell.errors == "known":
        return {}
    found, one = fit(problem, cell, data, scale="linear")
    _, narrow = fit(problem, cell, data, scale="linear", confidence=COVERAGES["68"], checks=False)
    if one.interval is None or narrow.interval is None:
        return {"mixity, profile, linear scale": failed(said_of(found) or "no interval")}
    ends = {"95": ends_of(problem, cell.problem, *one.interval), "68": ends_of(problem, cell.problem, *narrow.interval)}
    stderr = math.nan if one.stderr is None else one.stderr
    return {"mixity, profile, linear scale": Answer(one.value, stderr, ends, said_of(found), None, "")}


def bootstrap(problem, cell, data):
    ends, value = {}, None
    for level, share in COVERAGES.items():
        found, one = fit(problem, cell, data, bootstrap=200, interval="none", checks=False, confidence=share, threads=1)
        of = one.bootstrap
        if not of:
            return {"mixity, bootstrap": failed(said_of(found) or "none")}
        interval = of.get("interval", of)
        ends[level], value = ends_of(problem, cell.problem, interval["low"], interval["high"]), turned(cell.problem, one.value)
    stderr = of.get("stderr") or math.nan
    return {"mixity, bootstrap": Answer(value, stderr / one.value**2 if cell.problem == "line" else stderr, ends, said_of(found),
                                        None, "")}
