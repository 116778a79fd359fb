"""Results of fits."""

from __future__ import annotations

import copy
from typing import TYPE_CHECKING, Any, Iterator, Sequence

import numpy as np

from . import _core, plots
from ._data import Dataset
from ._law import Law, define, definitions
from ._quantities import carries_units
from ._units import plain_array

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    FloatArray = NDArray[np.float64]


class _Described:
    """Gives the fields of a part of the program's JSON as attributes."""

    _fields: dict[str, Any]

    if not TYPE_CHECKING:

        def __getattr__(self, name):
            try:
                return self.__dict__["_fields"][name]
            except KeyError:
                raise AttributeError(f"a {type(self).__name__.lower()} has no '{name}'") from None

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._fields]


class Parameter(_Described):
    """A parameter of a fit; None where a number is not known.

    Attributes
    ----------
    name : str
        As in ``fit.params``.
    value : float
        The estimate, in ``unit``.
    stderr : float or None
        Its standard error.
    interval : (low, high) or None
        The 95 % interval of the profile likelihood; an end that is not found is None.
    unit : str
        Empty if dimensionless.
    lower, upper : float
        The bounds of the fit.
    at_bound, held : bool
        Whether the estimate lies at one of them, and whether it was held.
    bootstrap, prior : dict or None
        As in the program's JSON.
    budget : dict or None
        Shares of the variance, for the parameter that has them.
    """

    name: str
    value: float
    stderr: float | None
    interval: tuple[float | None, float | None] | None
    budget: dict[str, Any] | None
    unit: str
    lower: float
    upper: float
    at_bound: bool
    held: bool
    bootstrap: dict[str, Any] | None
    prior: dict[str, Any] | None

    def __init__(self, name: str, fields: dict[str, Any], budget: dict[str, Any] | None) -> None:
        self.name = name
        self._fields = fields
        interval = fields["interval"]
        self.interval = (interval["low"], interval["high"]) if interval else None
        self.budget = budget

    def __repr__(self) -> str:
        error = "" if self.stderr is None else f" +/- {_core.rounded(self.stderr, 2)}"
        return f"<{self.name} = {self.value}{error} {self.unit}>".replace(" >", ">")


class Fit(_Described):
    """One model's fit: an item of :class:`Fits`. Every field of the program's JSON is an attribute, these among them.

    Attributes
    ----------
    model : str
        The model's key.
    status, message : str
        "ok", "suspect", "at_bound", ..., and the sentence that says why.
    params : dict of Parameter
        By name.
    used : int
        Number of points used; ``excluded`` lists the others with their reasons.
    r2, rmse : float or None
        Coefficient of determination, and root mean square of the residuals.
    budget : dict or None
        Shares of the variance of a parameter: scatter, and each constant.
    """

    params: dict[str, Parameter]
    model: str
    status: str
    message: str
    objective: str
    scale: str
    used: int
    excluded: list[dict[str, Any]]
    r2: float | None
    rmse: float | None
    max_abs_residual: float | None
    outliers: list[dict[str, Any]]
    errors: dict[str, Any] | None
    sigma_factor: float | None
    loss_scale: float | None
    loss_freedom: float | None
    correlations: list[dict[str, Any]]
    influence: dict[str, Any] | None
    paper: dict[str, Any] | None
    evidence: dict[str, Any] | None
    budget: dict[str, Any] | None
    consistency: dict[str, Any] | None
    outdone_by: str | None
    published: dict[str, Any]

    def __init__(self, fits: Fits, index: int) -> None:
        self._fits = fits
        self._index = index
        self._fields = fits._document["datasets"][0]["fits"][index]
        budget = self._fields["budget"]
        self.params = {
            name: Parameter(name, fields, budget if budget and budget["parameter"] == name else None)
            for name, fields in self._fields["parameters"].items()
        }

    @property
    def suspect(self) -> str | None:
        """The sentence that states what is wrong and its remedy; None if the status is not suspect."""
        return self.message if self.status == "suspect" else None

    @property
    def data(self) -> Dataset:
        """The data set that was fitted."""
        return self._fits.data

    @property
    def residuals(self) -> FloatArray:
        """Model minus data of the points in ``used_points``, shape (m,), in standard errors where these are known."""
        return self._fits._results.residuals(self._index)

    @property
    def used_points(self) -> NDArray[np.int_]:
        """Indices of the points that the fit used, shape (m,)."""
        return self._fits._results.used(self._index).astype(int)

    def area(self, P: ArrayLike, T: ArrayLike, confidence: float = 0.95) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Predicted area, as it would be measured, with its band.

        Parameters
        ----------
        P, T : array_like
            In ``data.units["force"]``; broadcast. Where the approach is held, P is that, in ``data.units["approach"]``.
        confidence : float
            Between 0 and 1.

        Returns
        -------
        A : ndarray
            In ``data.units["area"]``. NaN beyond the last equilibrium.
        low, high : ndarray
            The band, likewise; NaN where a parameter has no standard error. It is that of the curve (delta method on the
            fit's covariance, constants of the experiment among them), without the scatter of a new measurement.
        """
        (band,) = self._predicted(lambda *at: [self._fits._results.areas(*at)], P, T, confidence)
        return band

    def axes(
        self, P: ArrayLike, T: ArrayLike, confidence: float = 0.95
    ) -> tuple[tuple[FloatArray, FloatArray, FloatArray], tuple[FloatArray, FloatArray, FloatArray]]:
        """Predicted semi-axes of an elliptic contact, as they would be measured, with their bands.

        Parameters
        ----------
        P, T, confidence
            As for :meth:`area`.

        Returns
        -------
        along : tuple of ndarray
            (a, low, high): along the shear, in the length whose square is ``data.units["area"]``. NaN as in :meth:`area`.
        across : tuple of ndarray
            (b, low, high): across the shear, likewise.

        Raises
        ------
        InputError
            The model is that of a circle: fit with ``shape="ellipse"``.
        """
        if "-ellipse" not in self.model:
            raise _core.InputError(f'model {self.model} is that of a circle; fit with shape="ellipse" for its axes')
        along, across = self._predicted(self._fits._results.axes, P, T, confidence)
        return along, across

    def _predicted(self, bands: Any, P: ArrayLike, T: ArrayLike, confidence: float) -> list[tuple[FloatArray, FloatArray, FloatArray]]:
        """What ``bands`` of the engine gives at these loads, in their broadcast shape."""
        if not 0 < confidence < 1:
            raise _core.InputError(f"confidence is {confidence}; it must lie between 0 and 1")
        P, T = np.broadcast_arrays(self._load("P", P), self._load("T", T))
        flat = (np.ascontiguousarray(one).reshape(-1) for one in (P, T))
        return [tuple(one.reshape(P.shape) for one in band) for band in bands(self._index, *flat, confidence)]

    def _load(self, name: str, loads: Any) -> FloatArray:
        """Dimensionless loads, from loads in the data's unit or quantities."""
        core = self.data._core
        array = plain_array(name, loads)
        held = name == "P" and core.holds_approach  # P is then the approach, in data.units["approach"]
        if not carries_units(loads):
            return array / (core.approach_scale if held else core.force_scale)
        if not core.force_unit_text:
            raise _core.InputError(f"'{name}' has a unit, but the data are dimensionless")
        return array / (core.held_unit if held else core.force_unit)

    def folds(self, P: ArrayLike, control: str = "load", stiffness: float = 0.0) -> list[dict[str, Any]]:
        """The folds of the fitted contact at one load, as they would be measured.

        Parameters
        ----------
        P : float
            In ``data.units["force"]``.
        control : {"load", "displacement", "stiffness"}
            The controlled quantity, as for :func:`mixity.folds`.
        stiffness : float
            Of the spring of control "stiffness": in N/m, of dimensionless data k/(xi^2 G_Ic).

        Returns
        -------
        list of dict
            As from :func:`mixity.folds`, in the units of the data, u in m; with T_stderr, u_stderr and A_stderr from the
            covariance of the fit, constants of the experiment among them (None where they are not known).
        """
        core = self.data._core
        found = self._fits._results.folds(self._index, float(self._load("P", P)), control, stiffness / core.stiffness_unit)
        units = {"T": core.force_scale, "u": core.displacement_unit, "A": core.area_scale, "a": core.area_scale}
        scaled = ("T", "T_stderr", "A", "A_stderr", "area_after", "area_lost", "u", "u_stderr")
        return [
            {key: value * units[key[0]] if key in scaled and value is not None else value for key, value in fold.items()}
            for fold in found
        ]

    def to_dict(self) -> dict[str, Any]:
        """This fit's part of the program's JSON.

        Returns
        -------
        dict
            A copy.
        """
        return copy.deepcopy(self._fields)

    def __repr__(self) -> str:
        values = ", ".join(repr(one)[1:-1] for one in self.params.values())
        return f"<mixity.Fit {self.model}: {self.status}, {values}>"

    plot_area = plots.area
    plot_toughness = plots.toughness
    plot_residuals = plots.residuals
    plot_profile = plots.profile
    plot_budget = plots.budget


class Fits:
    """Fits of several models to one data set: maps keys to :class:`Fit`, and prints as the program does."""

    def __init__(self, data: Dataset, results: Any) -> None:
        self.data = data
        self._results = results
        self._read: dict[str, Any] | None = None
        self._made: dict[str, Fit] = {}

    @property
    def _document(self) -> dict[str, Any]:
        if self._read is None:
            self._read = self._results.document()
        return self._read

    def to_dict(self) -> dict[str, Any]:
        """The program's JSON (schema mixity-fit-1) of this data set and its fits.

        Returns
        -------
        dict
            A copy.
        """
        return copy.deepcopy(self._document)

    def keys(self) -> list[str]:
        """Keys of the models, in the order of the request.

        Returns
        -------
        list of str
            Such as ["a", "b", "c"].
        """
        return self._results.models()

    def __len__(self) -> int:
        return len(self.keys())

    def __iter__(self) -> Iterator[str]:
        return iter(self.keys())

    def __getitem__(self, model: str | Law) -> Fit:
        key: str = model.key if isinstance(model, Law) else model
        if key not in self._made:
            try:
                index = self.keys().index(key)
            except ValueError:
                raise KeyError(key) from None
            self._made[key] = Fit(self, index)
        return self._made[key]

    def values(self) -> list[Fit]:
        """The fits, in the same order.

        Returns
        -------
        list of Fit
            One per model.
        """
        return [self[key] for key in self]

    def items(self) -> list[tuple[str, Fit]]:
        """Pairs of key and fit, in the same order.

        Returns
        -------
        list of (str, Fit)
            One per model.
        """
        return [(key, self[key]) for key in self]

    @property
    def comparison(self) -> list[dict[str, Any]]:
        """AICc, evidence and error on left-out loads for each model, as in the program's JSON."""
        return self._document["datasets"][0]["comparison"]

    def __str__(self) -> str:
        return self._results.text()

    def __repr__(self) -> str:
        return f"<mixity.Fits of '{self.data.name}': " + ", ".join(f"{k} {f.status}" for k, f in self.items()) + ">"

    def _repr_html_(self) -> str:
        import html

        def cell(value):
            text = "" if value is None else _core.rounded(value, 5) if isinstance(value, float) else str(value)
            return f"<td>{html.escape(text)}</td>"

        rows = []
        for key, one in self.items():
            for p in one.params.values():
                cells = (key, p.name, p.value, p.stderr, *(p.interval or (None, None)), p.unit, one.status)
                rows.append(f"<tr>{''.join(map(cell, cells))}</tr>")
        head = "".join(f"<th>{h}</th>" for h in ("model", "parameter", "value", "stderr", "low", "high", "unit", "status"))
        messages = "".join(f"<p>{html.escape(k)}: {html.escape(f.message)}</p>" for k, f in self.items() if f.message)
        return f"<table><thead><tr>{head}</tr></thead><tbody>{''.join(rows)}</tbody></table>{messages}"

    # Results are a pure function of data and options, so unpickling repeats the fit and reproduces them to the last bit.
    def __reduce__(self) -> tuple[Any, ...]:
        return _refit, (self.data, self._results.options(), definitions(self.keys()))


def _refit(data: Dataset, options: list[tuple[str, str]], laws: Sequence[Any] = ()) -> Fits:
    define(laws)
    return Fits(data, _core.fit(data._core, options, None))
