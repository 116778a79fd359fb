"""lmfit on the effective variance (on the errors of y where x is exact): Wald's error; from two variables on conf_interval."""

import warnings

import lmfit

from coverage_of_tools import objectives
from coverage_of_tools.answers import Answer, by_error, failed


def kind_of(problem):
    return "vertical" if problem.exact_x else "effective"


def minimised(problem, cell, data):
    parameters = lmfit.Parameters()
    names = [f"p{i}" for i in range(len(problem.start))]
    for name, start, low, high in zip(names, problem.start, *problem.bounds):
        parameters.add(name, start, min=low, max=high)
    kind = kind_of(problem)

    def residual(values):
        return objectives.residuals(kind, [values[name].value for name in names], data)

    minimizer = lmfit.Minimizer(residual, parameters, scale_covar=cell.errors != "known")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return minimizer, minimizer.leastsq(), names


def wald(problem, cell, data):
    _, done, names = minimised(problem, cell, data)
    one = done.params[names[problem.judged]]
    if not done.success or one.stderr is None:
        return {"lmfit": failed(f"{done.message}")}
    return {"lmfit": by_error(problem, [done.params[name].value for name in names], one.stderr, "", kind_of(problem))}


def conf_interval(problem, cell, data):
    if len(problem.start) < 2:
        return {}  # it raises MinimizerException for one variable
    minimizer, done, names = minimised(problem, cell, data)
    name, label = names[problem.judged], "lmfit, conf_interval"
    if not done.success or not done.errorbars:
        return {label: failed(done.message)}
    try:
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            found = lmfit.conf_interval(minimizer, done, p_names=[name], sigmas=list(objectives.COVERAGES.values()))[name]
    except Exception as error:  # pylint: disable=broad-except # whatever it says is a failure that is said
        return {label: failed(f"{type(error).__name__}: {error}")}
    values = [value for _, value in found]
    ends = {"95": (values[0], values[-1]), "68": (values[1], values[-2])}
    theta = [done.params[name].value for name in names]
    warned = [str(one.message) for one in said if "conf_interval" in str(one.message) or "Bound" in str(one.message)]
    return {label: Answer(theta[problem.judged], float(done.params[name].stderr), ends, "".join(warned[:1]), theta,
                          kind_of(problem))}


