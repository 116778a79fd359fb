"""User-defined laws."""

from __future__ import annotations

import atexit
import pickle
import reprlib
import types
import warnings
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from . import _core


class Law:
    """A user-defined mode-mixity law, which becomes a model like a, b, c.

    Parameters
    ----------
    f : str or callable
        Formula of f = G_c/G_Ic, of psi, B = sin^2 psi, t = tan psi and the parameters: "1 + p*tan(psi)^n". Or a criterion of
        fracture, an equation in K_I and K_II in units of the toughness: "(K_I^2)^m + (K_II^2/r)^n = 1". Or a function
        f(psi, p=..., n=...) of an array of phase angles [rad], 0 <= psi < pi/2, and of the parameters as floats, by
        their names, that returns f of each angle and depends on nothing else.
    key : str, optional
        The key for models=...; by default ``law_`` and a hash of the definition, the same in every process.
    name : str, optional
        Shown beside the key.
    normalised : bool
        Divide f by its value at psi = 0, which otherwise must be 1.
    **parameters
        For each parameter (least, greatest) or (least, greatest, start).

    Raises
    ------
    InputError
        For a syntax error, with its column; if f is not a positive number; if a function does not return an array of
        the angles' shape. A UserWarning is issued if several T have the same area, or if the form loses digits.

    Notes
    -----
    A function is called with a few hundred angles for each set of parameters. Its values are interpolated to rounding
    accuracy, including any power of psi or cos psi at the ends, and kinks. A larger interpolation error is reported in a
    warning, and refused above 1e-6 of f. Derivatives in the parameters are finite differences, accurate to about 1e-10.

    It may be called on any thread of a fit, by one at a time. An exception in it ends the fit, which raises it again.
    The law, and fits with it, can be pickled if the function can.

    Examples
    --------
    >>> import mixity
    >>> law = mixity.Law("1 + (1 - l)*tan(psi)^2", l=(0, 1), key="mine")
    >>> round(float(mixity.toughness(law, 0.3, 0.5)), 6)
    1.208912

    >>> import numpy as np
    >>> law = mixity.Law(lambda psi, l: 1 + (1 - l) * np.tan(psi) ** 2, l=(0, 1), key="as_a_function")
    >>> round(float(mixity.toughness(law, 0.3, 0.5)), 6)
    1.208912
    """

    key: str
    formula: str

    def __init__(
        self,
        f: str | Callable[..., Any],
        *,
        key: str = "",
        name: str = "",
        normalised: bool = False,
        **parameters: Sequence[float],
    ) -> None:
        for what, text in (("key", key), ("name", name)):
            if not isinstance(text, str):
                raise _core.InputError(f"{what} is {text!r}; it must be a text, and no parameter can be called {what}")
        ranges = []
        for parameter, given in parameters.items():
            try:
                numbers = [] if isinstance(given, (str, set)) else [float(one) for one in given]
            except (TypeError, ValueError):
                numbers = []
            if len(numbers) not in (2, 3):
                raise _core.InputError(f"parameter '{parameter}' is {given!r}; it must be (least, greatest) or (least, greatest, start)")
            ranges.append((parameter, *numbers))
        text, function = str(f), None
        if callable(f):
            names = tuple(parameters)
            shown = getattr(f, "__name__", type(f).__name__).strip("<>")
            text, function = f"{shown}({', '.join(('psi', *names))})", _known(f, names, ranges)
        self.key, self.formula, told = _core.define_law(text, ranges, key, name, bool(normalised), function)
        if function is not None:
            _by_key[self.key] = f
        for warning in told:
            warnings.warn(f"law {self.key}: {warning}", stacklevel=2)

    def __repr__(self) -> str:
        return f"Law({self.key}: {self.formula})"

    def __reduce__(self):
        return _again, (_definition(self.key),)


_functions: list = []  # (function, names of its parameters, sampled values, callable for the engine)
_by_key: dict = {}  # functions of laws


@atexit.register
def _let_go():
    _functions.clear()


def _known(f, names, ranges):
    """The callable that the engine uses for a function: the same object for the same function, so that the laws are equal."""
    says = _sayings(f, names, ranges)
    for other, of_other, said, called in _functions:
        if of_other == names and said == says and _same(f, other):
            return called
    _functions.append((f, names, says, _core.Function(_checked(f, names))))
    return _functions[-1][3]


def _sayings(f, names, ranges):
    """The function's values at a few points, which change if its globals do."""
    call = _checked(f, names)
    psi = np.linspace(0.05, 1.5, 8)
    return b"".join(call(psi, [low + share * (high - low) for _, low, high, *_ in ranges]).tobytes() for share in (0.11, 0.47, 0.83))


def _same(one, other):
    """Whether two functions are equal, as when a notebook cell is run again."""
    if one is other or not (isinstance(one, types.FunctionType) and isinstance(other, types.FunctionType)):
        return one is other
    parts = ("__code__", "__defaults__", "__kwdefaults__", "__closure__")
    try:
        return one.__globals__ is other.__globals__ and all(getattr(one, part) == getattr(other, part) for part in parts)
    except ValueError:  # arrays
        return False


def _checked(f, names):
    def call(psi, values):
        with np.errstate(all="ignore"):  # the engine reports values that are not positive numbers
            found = f(psi, **dict(zip(names, values)))
        try:
            array = np.asarray(np.ma.filled(found, np.nan) if np.ma.isMaskedArray(found) else found)
        except ValueError:  # lists of several lengths
            array = np.empty(0, object)
        if array.dtype.kind not in "bfiu":
            raise _core.InputError(f"law: the function returned {reprlib.repr(found)}; it must return an array of f at each psi")
        if array.dtype in (np.float32, np.float16):
            raise _core.InputError(
                f"law: the function returned {array.dtype}, which has too few digits for a fit; return float64 (with JAX: "
                'jax.config.update("jax_enable_x64", True) before anything else)'
            )
        if array.shape != psi.shape:
            raise _core.InputError(
                f"law: for {psi.size} angles, an array of shape {psi.shape}, the function returned shape {array.shape}; "
                "it must return f at each of them"
            )
        return np.ascontiguousarray(array, np.float64)

    return call


def _definition(key):
    found = _core.law_definition(key)
    f = _by_key.get(key)
    if not found or f is None:
        return found
    try:
        pickle.dumps(f)
    except Exception as error:
        raise pickle.PicklingError(f"law {key} does not pickle, as its function does not: {error}; state it as a text, or by a function of a module") from None
    return (f, *found[1:])


def _again(definition):
    f, ranges, key, name, normalised = definition
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return Law(f, key=key, name=name, normalised=normalised, **{one[0]: one[1:] for one in ranges})


def definitions(keys):
    """Definitions of the laws among these models, for another process."""
    return [found for found in map(_definition, keys) if found]


def define(laws):
    for definition in laws:
        _again(definition)


def key_of(model):
    """The key of a model, which may be a Law; defines it if it is from data/laws.toml."""
    if isinstance(model, Law):
        return model.key
    if isinstance(model, str):
        _core.provide_law(model)
    return model


_BUILT_IN = frozenset(_core.model_keys())


def model_keys(models: Any) -> Any:
    """Keys of models from the argument of :func:`fit`, a text or a list. "abc" are three models."""
    if isinstance(models, Law):
        return models.key
    if isinstance(models, (list, tuple)):
        return [key_of(model) for model in models]
    if not isinstance(models, str) or "," in models:
        return models
    return models if models in _BUILT_IN or not all(key in _BUILT_IN for key in models) else ",".join(models)
