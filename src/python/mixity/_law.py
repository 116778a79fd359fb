"""Laws of one's own."""

import warnings

from . import _core


class Law:
    """A mode-mixity law that is typed, which is then a model like a, b, c.

    Parameters
    ----------
    f : str
        f = G_c/G_Ic, of psi, B = sin^2 psi, t = tan psi and the parameters: "1 + p*tan(psi)^n". Or a criterion of
        fracture, an equation in K_I and K_II in units of the toughness: "(K_I^2)^m + (K_II^2/r)^n = 1".
    key : str, optional
        What models=... calls it; else law_ and digits that follow from the definition, in every process the same.
    name : str, optional
        Shown beside the key.
    normalised : bool
        f over its value at psi = 0, which must be 1.
    **parameters
        For each parameter (least, greatest) or (least, greatest, start).

    Raises
    ------
    InputError
        With the column, for what cannot be read; where f is no positive number. Where one area stands for several
        T, and where the form loses digits, a UserWarning says so.

    Examples
    --------
    >>> import mixity
    >>> law = mixity.Law("1 + (1 - l)*tan(psi)^2", l=(0, 1), key="mine")
    >>> round(float(mixity.toughness(law, 0.3, 0.5)), 6)
    1.208912
    """

    def __init__(self, f, *, key="", name="", normalised=False, **parameters):
        for what, text in (("key", key), ("name", name)):
            if not isinstance(text, str):
                raise _core.InputError(f"{what} is {text!r}; it must be a text, and no parameter can be called {what}")
        ranges = []
        for parameter, given in parameters.items():
            try:
                numbers = [float(one) for one in given]
            except (TypeError, ValueError):
                numbers = []
            if len(numbers) not in (2, 3):
                raise _core.InputError(f"parameter '{parameter}' is {given!r}; it must be (least, greatest) or (least, greatest, start)")
            ranges.append((parameter, *numbers))
        self.key, self.formula, told = _core.define_law(str(f), ranges, key, name, bool(normalised))
        for warning in told:
            warnings.warn(f"law {self.key}: {warning}", stacklevel=2)

    def __repr__(self):
        return f"Law({self.key}: {self.formula})"

    def __reduce__(self):
        return _again, (_core.law_definition(self.key),)


def _again(definition):
    f, ranges, key, name, normalised = definition
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return Law(f, key=key, name=name, normalised=normalised, **{one[0]: one[1:] for one in ranges})


def definitions(keys):
    """Of the laws among these models, so that another process has them."""
    return [found for found in map(_core.law_definition, keys) if found]


def define(laws):
    for definition in laws:
        _again(definition)


def key_of(model):
    """The key of a model, which may be a Law; one of data/laws.toml is made ready."""
    if isinstance(model, Law):
        return model.key
    if isinstance(model, str):
        _core.provide_law(model)
    return model
