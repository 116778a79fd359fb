"""Fitting: the options of the program, and the log of a fit."""

from __future__ import annotations

import time
from typing import Any, Callable, Sequence

import numpy as np

from . import _core
from ._data import Dataset
from ._fits import Fits
from ._law import Law, model_keys
from ._log import DEBUG, INFO, listening
from ._quantities import si_names
from ._units import error_text

_OPTIONS = {name: (help, initial) for name, help, initial in _core.options()}


def _option_text(value: Any) -> str:
    if isinstance(value, (np.generic, np.ndarray)):
        value = value.tolist()
    if isinstance(value, str):
        return value
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float) and value.is_integer() and abs(value) < 1e15:
        return str(int(value))
    if isinstance(value, dict):
        return ",".join(key if one is None else f"{key}={_option_text(one)}" for key, one in value.items())
    if isinstance(value, (list, tuple, set, range)):
        return ",".join(map(_option_text, value))
    return repr(value)


def fit(
    data: Dataset,
    models: str | Law | Sequence[str | Law] = "abc",
    *,
    objective: str | None = None,
    free: str | Sequence[str] | None = None,
    shape: str | None = None,
    progress: Callable[[float], Any] | bool | None = None,
    **options: Any,
) -> Fits:
    """Fits models to a data set.

    Parameters
    ----------
    data : Dataset
        The points, and the constants of the experiment.
    models : str, Law, or list of them
        "c", "abc", ["a", "bk"], ["c", "power", mixity.Law(...)].
    objective : {"curve", "toughness"}, optional
        Distance from the equilibrium curve in the plane of T and A (the default where there are loads), or
        ln(G_c/G_Ic) against psi.
    free : list of str, optional
        Constants of the experiment that are fitted without a prior.
    shape : {"circle", "ellipse"}, optional
        Of the contacts. "ellipse" fits the laws of the models at the ends of both axes ("c-ellipse" in place of "c"), to the
        axes where these were measured; ``tie="equal"`` or ``tie="lambda_III=0"`` ties the two couplings.
    progress : callable or bool, optional
        Called with the fraction done, 0..1, on the calling thread; True: a tqdm bar if that is installed.
    **options
        The options of ``mixity fit``: sigma_T="2%", loss="cauchy", hold={"lambda": 0.3}, bootstrap=1000, per="curve",
        exclude=[17], checks=False. ``sigma_T`` and ``sigma_A`` may be floats in SI (dimensionless as the data are) or
        quantities.

    Returns
    -------
    Fits
        By model. The numbers equal the program's to the last digit.

    Raises
    ------
    InputError
        With the program's message. Ctrl-C raises KeyboardInterrupt: in a bootstrap at once, otherwise between parts of a fit.

    Notes
    -----
    ``logging.getLogger("mixity")`` receives data, statuses and seconds at INFO, options and messages at DEBUG.
    """
    if not isinstance(data, Dataset):
        raise TypeError("data must be a mixity.Dataset: Dataset(P=..., T=..., A=...), from_frame(...) or read(...)")
    keys = model_keys(models)
    if shape not in (None, "circle", "ellipse"):
        raise ValueError(f'shape must be "circle" or "ellipse", not {shape!r}')
    if shape == "ellipse":
        listed = keys.split(",") if isinstance(keys, str) else keys
        keys = [key if "-ellipse" in key else f"{key}-ellipse" for key in listed]
    stated = [("models", _option_text(keys))]
    for name, value in {"objective": objective, "free": free, **options}.items():
        if name in si_names() and name not in _OPTIONS:
            raise _core.InputError(f"{name}: is no option of a fit: state it in mixity.Dataset({name}=...), or in mixity.read")
        if name in ("sigma_T", "sigma_A") and value is not None:
            value = error_text(name, value, bool(data._core.force_unit_text))
        text = None if value is None else _option_text(value)
        if text is not None and not (text == "" and not isinstance(value, str)):  # an empty list states nothing
            stated.append((name, text))
    bar = None
    if progress is True:
        try:
            from tqdm.auto import tqdm

            bar = tqdm(total=1.0, bar_format="{l_bar}{bar}| {elapsed}<{remaining}")
            progress = lambda share: bar.update(share - bar.n)  # noqa: E731
        except ImportError:
            progress = None
    begin = time.perf_counter()
    try:
        fits = Fits(data, _core.fit(data._core, stated, progress or None))
    finally:
        if bar is not None:
            bar.close()
    if logger := listening(INFO):
        seconds = time.perf_counter() - begin
        statuses = ", ".join(f"{key} {one.status}" for key, one in fits.items())
        logger.info("fit of %s: %s; %.3g s", data.name, statuses, seconds)
        if logger.isEnabledFor(DEBUG):
            logger.debug("options: %s", ", ".join(f"{name}={text}" for name, text in stated))
            for key, one in fits.items():
                if one.message:
                    logger.debug("%s: %s", key, one.message)
    return fits


def _described() -> str:
    """The options that are not parameters of :func:`fit` itself."""
    lines = []
    for name, (help, initial) in _OPTIONS.items():
        if name not in ("models", "objective", "free"):
            lines.append(f"``{name}``: {help}" + (f" (default {initial})" if initial else ""))
    return "".join(f"\n        {line}\n" for line in lines)


if fit.__doc__:  # absent with python -OO
    fit.__doc__ = fit.__doc__.replace("        quantities.\n", "        quantities.\n" + _described(), 1)
