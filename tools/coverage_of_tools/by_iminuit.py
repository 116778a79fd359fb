"""iminuit on the effective variance (on the errors of y where x is exact): HESSE's errors and MINOS' intervals. Where errors are
known to a factor or not at all, `errordef` is chi^2 per degree of freedom, as its users rescale."""

import iminuit
import numpy as np

from coverage_of_tools import objectives
from coverage_of_tools.answers import Answer, by_error
from coverage_of_tools.by_lmfit import kind_of


def fit(problem, cell, data, minos):
    kind = kind_of(problem)
    task = iminuit.Minuit(lambda *theta: objectives.squares(kind, theta, data), *problem.start,
                          name=[f"p{i}" for i in range(len(problem.start))])
    task.errordef = 1
    task.limits = list(zip(*problem.bounds))
    task.migrad()
    if cell.errors != "known":
        task.errordef = max(task.fval / (len(data.x) - len(problem.start)), 1e-30)
    task.hesse()
    said = "" if task.valid else "not valid"
    theta, stderr = list(task.values), task.errors[problem.judged]
    if not minos:
        return {"iminuit, HESSE": by_error(problem, theta, stderr, said, kind)}
    ends, value = {}, theta[problem.judged]
    for level, share in objectives.COVERAGES.items():
        if said:
            break
        try:
            task.minos(problem.judged, cl=share)
        except RuntimeError as error:
            said = str(error)
            break
        found = task.merrors[f"p{problem.judged}"]
        ends[level] = value + found.lower, value + found.upper
        said = said or ("" if found.is_valid else "MINOS is not valid")
    return {"iminuit, MINOS": Answer(value, float(stderr), ends if np.all(np.isfinite(list(ends.values()))) else {}, said, theta,
                                     kind)}


def hesse(problem, cell, data):
    return fit(problem, cell, data, False)


def minos(problem, cell, data):
    return fit(problem, cell, data, True)
