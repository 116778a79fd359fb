"""odrpack: explicit and implicit, forward differences (its default) and central ones; ordinary least squares where x is exact."""

import numpy as np
import odrpack

from coverage_of_tools.answers import by_error, failed


def form(name, scheme):
    """A tool for each, so that each has a time."""
    def tool(problem, cell, data):
        if problem.exact_x and name == "implicit":
            return {}
        with np.errstate(divide="ignore"):
            return {f"odrpack, {name}, {scheme}": one_fit(problem, cell, data, name, scheme)}
    return tool


def one_fit(problem, cell, data, name, scheme):
    weight_x, weight_y = 1 / data.sigma_x**2, 1 / data.sigma_y**2
    common = {"beta0": problem.start, "bounds": tuple(problem.bounds), "diff_scheme": scheme}
    try:
        if problem.exact_x:
            done = odrpack.odr_fit(lambda x, theta: data.curve.height(theta, x), data.x, data.y, task="OLS", weight_y=weight_y,
                                   **common)
        elif name == "explicit":
            done = odrpack.odr_fit(lambda x, theta: data.curve.height(theta, x), data.x, data.y, weight_x=weight_x,
                                   weight_y=weight_y, **common)
        else:
            done = odrpack.odr_fit(lambda x, theta: data.curve.equation(theta, x[0], x[1]), np.array([data.x, data.y]),
                                   np.zeros_like(data.x), task="implicit-ODR", weight_x=np.array([weight_x, weight_y]), **common)
    except ValueError as error:
        return failed(str(error))
    # sd_beta holds the residual variance
    scale = np.sqrt(done.res_var) if cell.errors == "known" and done.res_var > 0 else 1.0
    kind = "vertical" if problem.exact_x else "graph" if name == "explicit" else "distance"
    return by_error(problem, done.beta, done.sd_beta[problem.judged] / scale, "" if done.success else done.stopreason, kind)
