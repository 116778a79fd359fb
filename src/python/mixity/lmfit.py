"""A model for lmfit, for those who keep their own scripts."""

from __future__ import annotations

import inspect
from typing import Any

import lmfit
import numpy as np

from . import _core
from ._arrays import Units
from ._law import Law, define, definitions, key_of
from .scipy import areas_to_the_fold, slopes


class _Area(lmfit.Model):
    """Gives leastsq, lmfit's default, the engine's derivatives."""

    # made from a local function, which cannot be pickled
    def __reduce__(self):
        return _again, (definitions([self.key]), self.key, self.contact, self.prefix, self.param_hints)

    def fit(self, data, params=None, weights=None, method="leastsq", fit_kws=None, **given):
        params = self.make_params() if params is None else params.copy()
        for name in [name for name in given if name in params]:
            value = given.pop(name)
            if isinstance(value, lmfit.Parameter):
                params[name] = lmfit.Parameter(name, value.value, value.vary, value.min, value.max, value.expr)
            else:
                params[name].set(value=value)
        vary = [one for one in params.values() if one.vary]
        for one in vary:  # at a bound the derivative in lmfit's own variable is zero, and nothing moves
            inside = 1e-3 * (one.max - one.min)
            if np.isfinite(inside):
                one.set(value=min(max(one.value, one.min + inside), one.max - inside))
        ours = vary and all(one.name in self.param_names for one in vary) and not any(one.expr for one in params.values())
        if method == "leastsq" and ours:
            fit_kws = {"Dfun": self._slopes_of_residual, "col_deriv": False, **(fit_kws or {})}
        return super().fit(data, params, weights, method, fit_kws=fit_kws, **given)

    def _slopes_of_residual(self, params, data, weights, *, P, T, **_):
        """Derivatives of what lmfit minimises, data minus model."""
        x = [params[name].value for name in self.param_names]
        by_name = dict(zip(self.param_names, slopes(self.key, x, *self.loads(P, T))))
        columns = [np.broadcast_to(by_name[name], np.shape(data)) for name in params if params[name].vary]
        return np.column_stack([
            np.ravel(-self.area_unit * one * (1.0 if weights is None else weights)) for one in columns
        ])


_NOT_SAID = object()


def model(key: str | Law, *, contact: Any = _NOT_SAID) -> lmfit.Model:
    """An ``lmfit.Model`` of the area: independent variables P and T, the model's parameters within their bounds.

    Parameters
    ----------
    key : str or Law
        A model with a law: "a", "b", "c", "bk", ...
    contact : (radius [m], modulus [Pa], toughness [J/m^2]) or None
        P, T in N and A in m^2; None: dimensionless, as the models are. It must be given: data in N that are taken for
        dimensionless loads fit without a complaint.

    Returns
    -------
    lmfit.Model
        Named "mixity c", with hints for start and bounds; lambda is called ``lambda_``.

    Raises
    ------
    InputError
        Without ``contact``, for an unknown model, and for constants that are not above 0.

    Notes
    -----
    lmfit's default method, leastsq, uses the engine's derivatives. Beyond the last equilibrium the area at it is returned, so
    that a minimiser sees no NaN. For intervals that include the uncertainty of the constants, and for a status, use
    :func:`mixity.fit`: lmfit's ``conf_interval`` needs at least two parameters that vary.

    Examples
    --------
    >>> import numpy as np, mixity
    >>> T = np.linspace(0, 20, 30)
    >>> law = mixity.lmfit.model("c", contact=None)
    >>> result = law.fit(mixity.area("c", 0.15, 2.0, T), P=np.full(30, 2.0), T=T, **{"lambda_": 0.3})
    >>> round(result.params["lambda_"].value, 8)
    0.15
    """
    if contact is _NOT_SAID:
        raise _core.InputError("state contact=(radius [m], modulus [Pa], toughness [J/m^2]), or contact=None if P, T and A are dimensionless")
    units = Units(contact)
    key = key_of(key)
    if key not in _core.model_keys():
        raise _core.InputError(f"there is no model '{key}'; there are {', '.join(_core.known_models())}")
    names = [_python_name(name) for name in _core.parameter_names(key)]

    def loads(P, T):
        return np.broadcast_arrays(units.without("P", P), np.abs(units.without("T", T)))

    def area(P, T, **parameters):
        x = [parameters[name] for name in names]
        return units.area * areas_to_the_fold(key, x, *loads(P, T))

    # lmfit takes the names of parameters from the signature
    typed: Any = area
    typed.__signature__ = inspect.Signature(
        [inspect.Parameter(name, inspect.Parameter.POSITIONAL_OR_KEYWORD) for name in ("P", "T", *names)]
    )
    made = _Area(area, independent_vars=["P", "T"], name=f"mixity {key}")
    made.key, made.contact, made.loads, made.area_unit = key, contact, loads, units.area
    for name, (low, high) in zip(names, _core.parameter_bounds(key)):
        made.set_param_hint(name, value=low + 0.1 * (min(high, 10.0) - low), min=low, max=high)
    return made


def _again(laws, key, contact, prefix, hints):
    define(laws)
    made = model(key, contact=contact)
    made.prefix = prefix
    for name, hint in hints.items():
        made.set_param_hint(name, **hint)
    return made


def _python_name(name):
    return "lambda_" if name == "lambda" else name
