"""Fits mode-mixity models to soft adhesive contacts that lose area under shear.

>>> import mixity
>>> data = mixity.Dataset(P=[4.68] * 6, T=[0, 10, 20, 30, 40, 50], A=[0.395, 0.393, 0.386, 0.375, 0.357, 0.331],
...                       units={"P": "mN", "T": "mN", "A": "mm^2"},
...                       radius="9.42 mm", modulus="2.133 MPa +/- 3%", toughness="27 mJ/m^2")
>>> fits = mixity.fit(data, models="c")
>>> fits["c"].status
'ok'
>>> round(fits["c"].params["lambda"].value, 4)
0.0089

Quantities are floats in SI, strings with units as in the program ("2.133 +/- 0.1 MPa"), or quantities of pint, astropy, unyt or quantities.
Invalid input raises :class:`InputError` with the program's message. ``logging.getLogger("mixity")`` gets the
progress of fits (see :func:`fit`), and the notes of a data set as warnings.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from ._core import InputError, version
from ._data import Dataset, read
from ._frame import from_frame
from ._law import Law
from ._fits import Fit, Fits, Parameter
from ._fitting import fit
from ._mechanics import (
    STATUS,
    area,
    axes,
    curve,
    displacement,
    folds,
    models,
    phase_angle,
    regime,
    tangential_load,
    toughness,
)
from ._reports import check, report
from ._runs import Runs, runs
from ._studies import Plan, campaign, design, simulate

__all__ = [
    "STATUS",
    "Dataset",
    "Fit",
    "Fits",
    "InputError",
    "Law",
    "Parameter",
    "Plan",
    "Runs",
    "__version__",
    "area",
    "axes",
    "campaign",
    "check",
    "curve",
    "design",
    "displacement",
    "fit",
    "folds",
    "from_frame",
    "models",
    "phase_angle",
    "read",
    "regime",
    "report",
    "runs",
    "simulate",
    "tangential_load",
    "toughness",
]


__version__: str = version()


if TYPE_CHECKING:
    from . import lmfit, plots, scipy
else:

    def __getattr__(name):
        # modules that need more than NumPy are imported on first use
        if name in ("lmfit", "scipy", "plots"):
            import importlib

            return importlib.import_module(f".{name}", __name__)
        raise AttributeError(f"module 'mixity' has no attribute '{name}'")
