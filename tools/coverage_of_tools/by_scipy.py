"""curve_fit (errors of y alone), the effective variance by least_squares as laboratories write it, and scipy.odr."""

import warnings

import numpy as np
from scipy import optimize

with warnings.catch_warnings():
    warnings.simplefilter("ignore", DeprecationWarning)
    from scipy import odr

from coverage_of_tools import objectives
from coverage_of_tools.answers import by_error, failed


def curve_fit(problem, cell, data):
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        try:
            theta, covariance = optimize.curve_fit(lambda x, *theta: data.curve.height(theta, x), data.x, data.y, problem.start,
                                                   data.sigma_y, absolute_sigma=cell.errors == "known", bounds=problem.bounds)
        except RuntimeError as error:
            return {"curve_fit": failed(str(error))}
    warned = [str(one.message) for one in said if issubclass(one.category, optimize.OptimizeWarning)]
    stderr = np.sqrt(covariance[problem.judged, problem.judged])
    return {"curve_fit": by_error(problem, theta, stderr, "".join(warned[:1]), "vertical")}


def effective_variance(problem, cell, data):
    if problem.exact_x:
        return {}
    done = optimize.least_squares(lambda theta: objectives.residuals("effective", theta, data), problem.start,
                                  bounds=problem.bounds)
    variance = 1 if cell.errors == "known" else 2 * done.cost / (len(data.x) - len(done.x))
    try:
        covariance = np.linalg.inv(done.jac.T @ done.jac) * variance
    except np.linalg.LinAlgError as error:
        return {"least_squares, effective variance": failed(str(error))}
    said = "" if done.success else done.message
    return {"least_squares, effective variance":
            by_error(problem, done.x, np.sqrt(covariance[problem.judged, problem.judged]), said, "effective")}


def orthogonal(problem, cell, data):
    """Explicit, forward differences: its defaults. It knows no bounds."""
    if problem.exact_x:
        return {}
    task = odr.ODR(odr.RealData(data.x, data.y, data.sigma_x, data.sigma_y), odr.Model(data.curve.height), problem.start)
    done = task.run()
    stderr = np.sqrt(done.cov_beta[problem.judged, problem.judged] * (1 if cell.errors == "known" else done.res_var))
    said = "" if 0 < done.info < 4 else "; ".join(done.stopreason)
    return {"scipy.odr, explicit": by_error(problem, done.beta, stderr, said, "graph")}
