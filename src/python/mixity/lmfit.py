"""A model for lmfit, for those who keep their own scripts."""

import inspect

import lmfit
import numpy as np

from . import _core
from .scipy import areas_to_the_fold


def model(key, *, contact=None):
    """An ``lmfit.Model`` of the area, independent variables P and T, parameters those of the model in their bounds.

    Parameters
    ----------
    key : {"a", "b", "c", "bk"}
    contact : (radius [m], modulus [Pa], toughness [J/m^2]), optional
        P, T in N and A in m^2; else dimensionless.

    Notes
    -----
    Beyond the last equilibrium the area there counts, so that a minimiser sees no NaN. For intervals that hold what is
    not known of the constants, and for a verdict, use :func:`mixity.fit`.

    Examples
    --------
    >>> import numpy as np, mixity
    >>> T = np.linspace(0, 20, 30)
    >>> law = mixity.lmfit.model("c")
    >>> result = law.fit(mixity.area("c", 0.15, 2.0, T), P=np.full(30, 2.0), T=T, **{"lambda_": 0.3})
    >>> round(result.params["lambda_"].value, 8)
    0.15
    """
    from . import _mechanics

    units = _mechanics._Units(contact)
    names = [_python_name(name) for name in _core.parameter_names(key)]

    def area(P, T, **parameters):
        x = [parameters[name] for name in names]
        loads, shears = np.broadcast_arrays(np.asarray(P, float) / units.force, np.abs(np.asarray(T, float)) / units.force)
        return units.area * areas_to_the_fold(key, x, loads, shears)

    # lmfit takes the names of parameters from the signature
    area.__signature__ = inspect.Signature(
        [inspect.Parameter(name, inspect.Parameter.POSITIONAL_OR_KEYWORD) for name in ("P", "T", *names)]
    )
    made = lmfit.Model(area, independent_vars=["P", "T"], name=f"mixity {key}")
    for name, (low, high) in zip(names, _core.parameter_bounds(key)):
        made.set_param_hint(name, min=low, max=high)
    return made


def _python_name(name):
    return "lambda_" if name == "lambda" else name
