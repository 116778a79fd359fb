"""tools/who_covers --check: what the table rests on, beside independent sources."""

import json

import mixity
import numpy as np
import odrpack
from scipy.optimize import minimize_scalar

from coverage_of_tools import by_odrpack, campaign, curves, objectives, problems


def areas():
    """The generator's brentq beside the engine's areas."""
    worst = 0.0
    for problem in problems.PROBLEMS.values():
        if isinstance(problem, problems.ContactProblem):
            T, A, curve = problem.true_points(20)
            worst = max(worst, np.max(np.abs(mixity.area("c", problem.theta[0], curve.P, T) / A - 1)))
    return "areas beside mixity.area, relative", worst, 1e-12  # brentq stops at 1e-14 of a radius


def closed_form():
    """The closed form that the tools are given beside the equation as printed."""
    T, A, curve = problems.PROBLEMS["fold"].true_points(20)
    return "closed form of the area beside the equation, relative", np.max(np.abs(curve.height([0.15], T) / A - 1)), 1e-12


def slopes():
    """Derivatives along the curve beside differences; 1e-6 is what central differences at 1e-5 leave."""
    T, A, curve = problems.PROBLEMS["fold"].true_points(20)
    u, h = curve.nearby([0.15], T, A), 1e-5
    ahead, behind, here = curve.along([0.15], u + h), curve.along([0.15], u - h), curve.along([0.15], u)
    worst = max(np.max(np.abs((ahead[i] - behind[i]) / (2 * h) - here[i + 2])) for i in (0, 1))
    return "derivatives along the curve", worst, 1e-6


def sums_of_squares():
    """odrpack's own sum of squares beside ours at its answer, forms explicit and implicit. It stops at some 1e-6 of it."""
    worst = 0.0
    for name in ("fold", "far", "line"):
        cell = problems.Cell(name, "known", "constant", 20)
        for number in range(5):
            data = problems.experiment(cell, number)
            weights = 1 / data.sigma_x**2, 1 / data.sigma_y**2
            done = odrpack.odr_fit(lambda x, theta: data.curve.height(theta, x), data.x, data.y, problems.PROBLEMS[name].start,
                                   weight_x=weights[0], weight_y=weights[1], diff_scheme="central")
            if done.success:
                worst = max(worst, abs(objectives.squares("graph", done.beta, data) / done.sum_square - 1))
            implicit = by_odrpack.one_fit(problems.PROBLEMS[name], cell, data, "implicit", "central")
            lowest = objectives.best("distance", problems.PROBLEMS[name], data)[1]
            worst = max(worst, abs(objectives.squares("distance", implicit.theta, data) / lowest - 1))
    return "sums of squares beside odrpack's, relative", worst, 1e-5


def york():
    """The slope of the line beside York's weights, (y - a - b x)^2/(sigma_y^2 + b^2 sigma_x^2), minimised in b alone."""
    cell = problems.Cell("line", "known", "proportional", 20)
    data = problems.experiment(cell, 0)
    data = data._replace(sigma_x=data.true_sigma_x, sigma_y=data.true_sigma_y)

    def profiled(b):
        weights = 1 / (data.sigma_y**2 + b * b * data.sigma_x**2)
        a = np.sum(weights * (data.y + b * data.x)) / np.sum(weights)
        return np.sum(weights * (data.y + b * data.x - a) ** 2)

    slope = minimize_scalar(profiled, bounds=(0.2, 0.9), method="bounded", options={"xatol": 1e-10}).x
    value, _ = objectives.exact_interval(problems.PROBLEMS["line"], data)
    return "slope of the exact likelihood beside York's, relative", abs(value / slope - 1), 1e-6


def parts():
    """A replicate is a function of cell and number: twice the same line, times apart."""
    cell = problems.Cell("far", "unknown", "2 % outliers", 20)
    lines = [json.loads(campaign.batch(cell, [7], {"slow": 0, "judged": 8})[0]) for _ in range(2)]
    for line in lines:
        for one in line["tools"].values():
            del one["seconds"]
    return "replicates that differ when repeated", float(lines[0] != lines[1]), 0.5


def bound():
    """The law at psi_0 = 0 beside model b's formula with 1 - lambda for 1 - lambda/2."""
    psi = np.linspace(0.1, 1.2, 10)
    apart = curves.hutchinson_suo([0.3, 0], psi) - curves.waters_guduru([0.6], psi)
    return "Hutchinson-Suo without a shift beside model b", np.max(np.abs(apart)), 1e-12


def run():
    status = 0
    for check in (areas, closed_form, slopes, sums_of_squares, york, bound, parts):
        what, worst, most = check()
        print(f"{'ok  ' if worst <= most else 'FAIL'} {what}: {worst:.2g} (at most {most:g})")
        status |= worst > most
    return int(status)
