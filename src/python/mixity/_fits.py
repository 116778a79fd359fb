"""Fits and what they say."""

import copy
import html
import json

import numpy as np

from . import _core
from ._data import Dataset
from ._law import Law, define, definitions, key_of
from ._units import carries_units, plain_array, si_names


_KEYS = frozenset(_core.model_keys())


def _option_text(value):
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


def _model_keys(models):
    if isinstance(models, Law):
        return models.key
    if isinstance(models, (list, tuple)):
        return [key_of(model) for model in models]
    if not isinstance(models, str) or "," in models:
        return models
    # "abc" are three
    return models if models in _KEYS or not all(key in _KEYS for key in models) else ",".join(models)


def fit(data, models="abc", *, objective=None, free=None, progress=None, **options):
    """Fits models to a data set.

    Parameters
    ----------
    data : Dataset
    models : str, Law, or list of them
        "c", "abc", ["a", "bk"], ["c", "power", mixity.Law(...)].
    objective : {"curve", "toughness"}, optional
        Distance from the equilibrium curve in the plane of T and A (the default where there are loads), or
        ln(G_c/G_Ic) against psi.
    free : list of str, optional
        Constants of the experiment that are fitted as if nothing were known of them.
    progress : callable or bool, optional
        Called with the share that is done, 0..1, on the calling thread; True: a bar of tqdm, where that is installed.
    **options
        Every option of ``mixity fit`` by its name: sigma_T="2%", loss="cauchy", hold={"lambda": 0.3}, bootstrap=1000,
        per="curve", exclude=[17], checks=False, ... (``mixity help fit``).

    Returns
    -------
    Fits
        By model. The same numbers as the program's, to the last digit.

    Raises
    ------
    InputError
        With the program's sentence. Ctrl-C ends a fit at once (KeyboardInterrupt).
    """
    if not isinstance(data, Dataset):
        raise TypeError("data must be a mixity.Dataset: Dataset(P=..., T=..., A=...), from_frame(...) or read(...)")
    stated = [("models", _option_text(_model_keys(models)))]
    for name, value in {"objective": objective, "free": free, **options}.items():
        if name in si_names() and name not in _core.option_names():
            raise _core.InputError(f"{name}: is no option of a fit: state it in mixity.Dataset({name}=...), or in mixity.read")
        text = None if value is None else _option_text(value)
        if text is not None and not (text == "" and not isinstance(value, str)):  # an empty list is none
            stated.append((name, text))
    bar = None
    if progress is True:
        try:
            from tqdm.auto import tqdm

            bar = tqdm(total=1.0, bar_format="{l_bar}{bar}| {elapsed}<{remaining}")
            progress = lambda share: bar.update(share - bar.n)  # noqa: E731
        except ImportError:
            progress = None
    try:
        return Fits(data, _core.fit(data._core, stated, progress or None))
    finally:
        if bar is not None:
            bar.close()


class Parameter:
    """A parameter of a fit: ``value``, ``stderr``, ``interval`` (low, high), ``unit``, ``lower``, ``upper``, ``at_bound``, ``held``,
    ``bootstrap``, ``prior``, and ``budget`` of the one that has it. None where a number is not known."""

    def __init__(self, name, fields, budget):
        self.name = name
        self._fields = fields
        interval = fields["interval"]
        self.interval = (interval["low"], interval["high"]) if interval else None
        self.budget = budget
        self.value = fields["value"]
        self.stderr = fields["stderr"]

    def __getattr__(self, name):
        try:
            return self.__dict__["_fields"][name]
        except KeyError:
            raise AttributeError(f"a parameter has no '{name}'") from None

    def __repr__(self):
        error = "" if self.stderr is None else f" +/- {self.stderr:.2g}"
        return f"<{self.name} = {self.value}{error} {self.unit}>".replace(" >", ">")


class Fit:
    """One model's fit: ``status`` ("ok", "suspect", "at_bound", ...), ``message``, ``params``, and every field of the program's JSON."""

    def __init__(self, fits, index):
        self._fits = fits
        self._index = index
        self._fields = fits._document["datasets"][0]["fits"][index]
        budget = self._fields["budget"]
        self.params = {
            name: Parameter(name, fields, budget if budget and budget["parameter"] == name else None)
            for name, fields in self._fields["parameters"].items()
        }
        self.model = self._fields["model"]
        self.status = self._fields["status"]
        self.message = self._fields["message"]

    def __getattr__(self, name):
        try:
            return self.__dict__["_fields"][name]
        except KeyError:
            raise AttributeError(f"a fit has no '{name}'") from None

    @property
    def suspect(self):
        """The sentence that says what is wrong and what helps; None if the data do not contradict the fit."""
        return self.message if self.status == "suspect" else None

    @property
    def data(self):
        return self._fits.data

    @property
    def residuals(self):
        """Of the points in ``used_points``, shape (m,): model minus data, in standard errors where these are known."""
        return self._fits._results.residuals(self._index)

    @property
    def used_points(self):
        """Indices of the points that the fit used, shape (m,)."""
        return self._fits._results.used(self._index).astype(int)

    def area(self, P, T, confidence=0.95):
        """Predicted area at loads as they would be read, with its band.

        Parameters
        ----------
        P, T : array_like
            In ``data.units["force"]``; broadcast.
        confidence : float

        Returns
        -------
        A, low, high : ndarray
            In ``data.units["area"]``. NaN beyond the last equilibrium; low and high NaN where a parameter has no
            standard error. The band is that of the curve (delta method on the fit's covariance, constants of the
            experiment among them), without the scatter of a new measurement.
        """
        core = self.data._core
        if not 0 < confidence < 1:
            raise _core.InputError(f"confidence is {confidence}; it must lie between 0 and 1")
        P, T = np.broadcast_arrays(self._load("P", P), self._load("T", T))
        A, error, _ = self._fits._results.areas(
            self._index, np.ascontiguousarray(P).reshape(-1), np.ascontiguousarray(T).reshape(-1)
        )
        A, error = A.reshape(P.shape) * core.area_scale, error.reshape(P.shape) * core.area_scale
        half = _normal_quantile(0.5 + confidence / 2) * error
        return A, A - half, A + half

    def _load(self, name, loads):
        """Dimensionless, of loads in the data's unit or of pint quantities."""
        core = self.data._core
        array = plain_array(name, loads)
        if not carries_units(loads):
            return array / core.force_scale
        if not core.force_unit_text:
            raise _core.InputError(f"'{name}' has a unit, but the data are dimensionless")
        return array / core.force_unit

    def folds(self, P, control="load", stiffness=0.0):
        """Where the fitted contact loses stability at load P (in ``data.units["force"]``), as it would be read.

        Returns
        -------
        list of dict
            As of :func:`mixity.folds`, in the units of the data, u in m; with T_stderr, u_stderr and A_stderr from the
            covariance of the fit, constants of the experiment among them (None where they are not known). ``stiffness`` of
            control "stiffness" is in N/m, of dimensionless data k/(xi^2 G_Ic).
        """
        core = self.data._core
        found = self._fits._results.folds(self._index, float(self._load("P", P)), control, stiffness / core.stiffness_unit)
        for fold in found:
            for key in ("T", "T_stderr", "A", "A_stderr", "area_after", "area_lost", "u", "u_stderr"):
                if fold[key] is not None:
                    scale = core.force_scale if key[0] == "T" else core.displacement_unit if key[0] == "u" else core.area_scale
                    fold[key] *= scale
        return found

    def to_dict(self):
        """This fit's part of the program's JSON."""
        return copy.deepcopy(self._fields)

    def __repr__(self):
        values = ", ".join(repr(one)[1:-1] for one in self.params.values())
        return f"<mixity.Fit {self.model}: {self.status}, {values}>"

    def __dir__(self):
        return [*super().__dir__(), *self._fields]

    def plot_area(self, ax=None):
        from . import plots

        return plots.area(self, ax)

    def plot_toughness(self, ax=None):
        from . import plots

        return plots.toughness(self, ax)

    def plot_residuals(self, ax=None):
        from . import plots

        return plots.residuals(self, ax)

    def plot_profile(self, parameter="lambda", ax=None):
        from . import plots

        return plots.profile(self, parameter, ax)

    def plot_budget(self, ax=None):
        from . import plots

        return plots.budget(self, ax)


class Fits:
    """Fits of several models to one data set: a mapping from keys to :class:`Fit`, printed as the program's report."""

    def __init__(self, data, results):
        self.data = data
        self._results = results
        self._read = None
        self._made = {}

    @property
    def _document(self):
        if self._read is None:
            self._read = json.loads(self._results.json())
        return self._read

    def to_dict(self):
        """The program's JSON (schema mixity-fit-1) of this data set and its fits."""
        return copy.deepcopy(self._document)

    def keys(self):
        return self._results.models()

    def __len__(self):
        return len(self.keys())

    def __iter__(self):
        return iter(self.keys())

    def __getitem__(self, model):
        if model not in self._made:
            try:
                index = self.keys().index(model)
            except ValueError:
                raise KeyError(model) from None
            self._made[model] = Fit(self, index)
        return self._made[model]

    def values(self):
        return [self[key] for key in self]

    def items(self):
        return [(key, self[key]) for key in self]

    @property
    def comparison(self):
        """Per model AICc, evidence and error on loads left out, as in the program's JSON."""
        return self._document["datasets"][0]["comparison"]

    def __str__(self):
        return self._results.text()

    def __repr__(self):
        return f"<mixity.Fits of '{self.data.name}': " + ", ".join(f"{k} {f.status}" for k, f in self.items()) + ">"

    def _repr_html_(self):
        rows = []
        for key, one in self.items():
            for parameter in one.params.values():
                low, high = parameter.interval or (None, None)
                cells = [key, parameter.name, parameter.value, parameter.stderr, low, high, parameter.unit, one.status]
                rows.append(
                    "<tr>"
                    + "".join(f"<td>{html.escape('' if c is None else f'{c:.5g}' if isinstance(c, float) else str(c))}</td>" for c in cells)
                    + "</tr>"
                )
        head = "".join(f"<th>{h}</th>" for h in ("model", "parameter", "value", "stderr", "low", "high", "unit", "status"))
        messages = "".join(f"<p>{html.escape(k)}: {html.escape(f.message)}</p>" for k, f in self.items() if f.message)
        return f"<table><thead><tr>{head}</tr></thead><tbody>{''.join(rows)}</tbody></table>{messages}"

    # Results are a pure function of data and options: the same numbers to the last bit are found again.
    def __reduce__(self):
        return _refit, (self.data, self._results.options(), definitions(self.keys()))


def _refit(data, options, laws=()):
    define(laws)
    return Fits(data, _core.fit(data._core, options, None))


def _normal_quantile(p):
    from statistics import NormalDist

    return NormalDist().inv_cdf(p)
