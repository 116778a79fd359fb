"""tools/who_covers --causes: cells that surprise, with one thing changed."""

import warnings

import lmfit
import numpy as np
import odrpack
from scipy import stats
from scipy.optimize import least_squares

from coverage_of_tools import by_odrpack, by_scipy, objectives, problems
from coverage_of_tools.objectives import LEVELS


def cell_of(name, errors="unknown", points=20):
    return problems.Cell(name, errors, "constant", points), problems.PROBLEMS[name]


def slope_at_the_place(theta, data):
    """The effective variance with the slope at the nearest point of the curve in place of that at the reading."""
    _, _, u = objectives.nearest(data.curve, theta, data, data.sigma_x, data.sigma_y)
    X, Y, by_x, by_y = data.curve.along(theta, u)
    slope = by_y / by_x
    return (data.y - Y - slope * (data.x - X)) / np.hypot(data.sigma_y, slope * data.sigma_x)


def effective_variance(count=200):
    cell, problem = cell_of("fold", "known")
    forms = {"the reading": lambda theta, data: objectives.residuals("effective", theta, data),
             "the nearest point": slope_at_the_place}
    for where, residual in forms.items():
        covered = 0
        for number in range(count):
            data = problems.experiment(cell, number)
            done = least_squares(lambda theta: residual(theta, data), [0.14], bounds=([0], [1]))
            stderr = 1 / np.sqrt((done.jac.T @ done.jac)[0, 0])
            covered += abs(done.x[0] - problem.truth) < LEVELS["95"] * stderr
        yield f"fold, errors known, effective variance with the slope at {where}: {100 * covered / count:.1f} % of 95 %"


def lmfit_starts(count=40):
    cell, problem = cell_of("constants")
    for start, bounded in ((0.1, True), (0.13, True), (0.1, False)):
        wrong, worst = 0, 1.0
        for number in range(count):
            data = problems.experiment(cell, number)
            parameters = lmfit.Parameters()
            for i, (low, high) in enumerate(problem.bounds.T):
                limits = {"min": low, "max": high} if bounded else {}
                parameters.add(f"p{i}", start if i == 0 else 0, **limits)
            fit = lmfit.minimize(lambda values: objectives.residuals("effective", [one.value for one in values.values()], data),
                                 parameters)
            ratio = fit.chisqr / objectives.best("effective", problem, data)[1]
            wrong += fit.success and ratio > 1.05
            worst = max(worst, ratio)
        yield (f"constants, lmfit from {start} {'within' if bounded else 'without'} bounds: success at more than 1.05 of the "
               f"least chi^2 in {wrong} of {count}, at most {worst:.3g} of it")


def odrpack_at_bound(count=100):
    cell, problem = cell_of("bound")
    at_bound = fatal = fatal_elsewhere = 0
    for number in range(count):
        data = problems.experiment(cell, number)
        theta, _ = objectives.best("vertical", problem, data)
        said = bool(by_odrpack.one_fit(problem, cell, data, "explicit", "forward").said)
        at_bound += theta[1] < 1e-6
        fatal += said and theta[1] < 1e-6
        fatal_elsewhere += said and theta[1] >= 1e-6
    yield (f"bound, odrpack: a fatal error in {fatal} of {at_bound} at the bound, {fatal_elsewhere} of {count - at_bound} "
           "elsewhere")


def odrpack_steps(count=200):
    """The implicit form's standard error, with lambda as it is and with 1 + lambda as the parameter, or with another step."""
    cell, problem = cell_of("zero", "known")
    for shift, options, words in ((0.0, {}, "lambda"), (1.0, {}, "1 + lambda"), (0.0, {"step_beta": [1e-6]}, "step_beta=1e-6")):
        covered = succeeded = 0
        for number in range(count):
            data = problems.experiment(cell, number)
            done = odrpack.odr_fit(lambda x, beta: data.curve.equation([beta[0] - shift], x[0], x[1]), np.array([data.x, data.y]),
                                   np.zeros_like(data.x), problem.start + shift, bounds=([shift], [1 + shift]),
                                   task="implicit-ODR", weight_x=1 / np.array([data.sigma_x, data.sigma_y]) ** 2, **options)
            if done.success:
                succeeded += 1
                stderr = done.sd_beta[0] / np.sqrt(done.res_var)
                covered += abs(done.beta[0] - shift - problem.truth) < LEVELS["95"] * stderr
        yield f"zero, errors known, odrpack implicit, forward, {words}: {100 * covered / succeeded:.1f} % of 95 %"


def student(count=200):
    for name in ("far", "line", "b", "bk"):
        cell, problem = cell_of(name, points=6)
        tool = by_scipy.curve_fit if problem.exact_x else by_scipy.effective_variance
        covered = {"1.96": 0, "t": 0}
        t = stats.t.ppf(0.975, 6 - len(problem.start))
        for number in range(count):
            (answer,) = tool(problem, cell, problems.experiment(cell, number)).values()
            for key, factor in (("1.96", LEVELS["95"]), ("t", t)):
                covered[key] += abs(answer.value - problem.truth) < factor * answer.stderr
        yield (f"{name}, 6 points, +/- 1.96 standard errors {covered['1.96'] / count:.1%}, +/- t of them "
               f"{covered['t'] / count:.1%}")


def run():
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        for cause in (effective_variance, lmfit_starts, odrpack_at_bound, odrpack_steps, student):
            for line in cause():
                print(line, flush=True)
