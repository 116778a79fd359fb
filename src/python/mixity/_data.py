"""Data sets from arrays and files."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Iterable, Mapping

import numpy as np

from . import _core
from ._binary import tables
from ._log import WARNING, listening
from ._quantities import carries_units, si_unit
from ._units import constant_text, plain_array

if TYPE_CHECKING:
    from numpy.typing import NDArray

    FloatArray = NDArray[np.float64]

COLUMNS = [name for name in _core.column_names() if name not in ("curve", "include", "time")]


def _column(name, values, units):
    if isinstance(values, str):
        raise _core.InputError(f"arrays: column '{name}' is the text '{values}'; a percentage is an option of fit({name}=...)")
    # a copy, so that later changes of the array do not affect the data set
    array = np.array(plain_array(name, values), order="C")
    if array.ndim == 2 and 1 in array.shape:  # a column or a row of a matrix
        array = array.reshape(-1)
    if array.ndim != 1:
        raise _core.InputError(f"arrays: column '{name}' must have one dimension, not {array.ndim}")
    if carries_units(values) and isinstance(units, dict) and name in units:
        raise _core.InputError(f"arrays: column '{name}' has a unit of its own, and its heading or units says {units[name]}: state it once")
    unit = si_unit(name) if carries_units(values) or units == "SI" else "" if units is None else units.get(name, si_unit(name))
    return (f"{name} [{unit}]" if unit else name), array


def _require_all_units(there, units):
    """Raises InputError where some columns have units and others have none, which are hardly in SI."""
    named = units if isinstance(units, dict) else {}
    of_units = [name for name in there if si_unit(name) not in ("", "rad")]
    bare = [name for name in of_units if name not in named and not carries_units(there[name])]
    if bare and len(bare) < len(of_units):
        other = next(name for name in of_units if name not in bare)
        raise _core.InputError(
            f"arrays: column '{bare[0]}' has no unit, '{other}' has one: state it in units={{\"{bare[0]}\": \"{si_unit(bare[0])}\"}} or another"
        )


class Dataset:
    """Measured points of one experiment, ready to fit.

    Parameters
    ----------
    runs : array_like of str or int, shape (n,), optional
        The loading run of each point; without a name (None, NaN), points of one load form a run.
    units : dict, "SI" or None
        Units of the columns, as in ``{"P": "mN", "T": "mN", "A": "mm^2"}``: of all that have no unit of their own, or of none,
        which then are in SI. None: dimensionless as in the paper (loads in R G_Ic, areas in (R/xi)^2).
    name : str
        Shown in texts and messages.
    **given
        Columns, each array_like of shape (n,): ``P``, ``T`` and ``A`` (normal load, tangential load, contact area); or others
        of the program by their names: ``a`` (radius), ``a_par`` and ``a_perp``, ``psi`` with ``Gc`` or ``Gc_over_GIc``,
        ``G_I`` with ``G_II``, and standard errors ``sigma_T``, ``sigma_A``, ... With ``control="approach"``, ``delta`` in
        place of P or beside it. Values that are not finite, and areas <= 0, are left out and listed in ``excluded``.

        Constants: ``radius``, ``modulus`` (plane strain) or ``youngs_modulus`` and ``poisson_ratio``, ``toughness``, and the
        others of the program's TOML: texts with units and errors, floats in SI, pairs (value, standard error), or quantities
        of pint, astropy, unyt or quantities, as may the columns be; they are converted to SI. ``mode_III="averaged"`` is the convention of Johnson and of Waters & Guduru. ``definition``, a TOML as :func:`check` saves it, has those that are not given.

    Raises
    ------
    InputError
        As for a file with these columns. Row i is called line i + 2.
    """

    def __init__(
        self,
        *,
        runs: Iterable[Any] | None = None,
        units: Mapping[str, str] | str | None = "SI",
        name: str = "data",
        **given: Any,
    ) -> None:
        there = {column: given.pop(column) for column in COLUMNS if column in given}
        there = {column: values for column, values in there.items() if values is not None}
        if isinstance(units, dict):
            unknown = [key for key in units if key not in there]
            if unknown:
                raise _core.InputError(f"units: '{unknown[0]}' is no column; there are {', '.join(there)}{_core.did_you_mean(str(unknown[0]), list(there))}")
        elif units not in (None, "SI"):
            raise _core.InputError("units must be a dict such as {'P': 'mN', 'A': 'mm^2'}, \"SI\", or None: dimensionless")
        name = str(name)
        columns = [_column(column, values, units) for column, values in there.items()]
        if units is not None:
            _require_all_units(there, units)
        if runs is not None:
            runs = runs.to_pylist() if hasattr(runs, "to_pylist") else runs  # pyarrow
            columns.append(("curve", ["" if run is None or run != run else str(run) for run in runs]))
        stated = stated_constants(given)
        self._core = _core.from_arrays(name, columns, stated)
        self._source = ("arrays", (name, columns, stated))
        self._tell_notes()

    def _tell_notes(self) -> None:
        if logger := listening(WARNING):
            for note in self.notes:
                logger.warning("%s: %s", self.name, note)

    @classmethod
    def _of(cls, core, source):
        made = cls.__new__(cls)
        made._core = core
        made._source = source
        return made

    # A pickled data set contains its inputs, with the contents of files, which may change or vanish later.
    def __reduce__(self) -> tuple[Any, ...]:
        kind, arguments = self._source
        return _again, (kind, (*arguments, self._core.contents()) if kind == "file" else arguments)

    # Immutable, so a copy is the object itself.
    def __copy__(self) -> Dataset:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Dataset:
        return self

    def __len__(self) -> int:
        return len(self._core)

    def __repr__(self) -> str:
        runs = len(self._core.curves)
        return f"<mixity.Dataset '{self.name}': {len(self)} points in {runs} {'run' if runs == 1 else 'runs'}>"

    @property
    def name(self) -> str:
        """Shown in texts and messages."""
        return self._core.name

    @property
    def notes(self) -> list[str]:
        """Sentences on what was ignored or reinterpreted in the data."""
        return self._core.notes

    @property
    def inputs(self) -> list[tuple[str, int, str]]:
        """The files that were read, as [(path, bytes, xxh128)].

        Hashed as by ``xxh128sum``; of .mat, HDF5 and .tdms the table that was made of it. Empty for arrays.
        """
        return self._core.inputs

    @property
    def runs(self) -> list[str]:
        """Names of the loading runs."""
        return self._core.curves

    @property
    def excluded(self) -> list[tuple[int, str]]:
        """Rows that were left out, as [(line, reason)]."""
        return self._core.excluded

    @property
    def units(self) -> dict[str, str]:
        """Units of loads and areas as shown and returned: {"force": "mN", "area": "mm^2"}; empty texts if dimensionless.

        With control="approach" also that of the approach: {"approach": "um"}.
        """
        units = {"force": self._core.force_unit_text, "area": self._core.area_unit_text}
        return units | {"approach": self._core.approach_unit_text} if self._core.holds_approach else units

    @property
    def P(self) -> FloatArray:
        """Normal loads of the points, shape (n,), in units["force"].

        Of a held approach those that were measured beside it, or NaN.
        """
        return self._core.column("P") * self._core.force_scale

    @property
    def delta(self) -> FloatArray:
        """The approach that is held (control="approach"), shape (n,), in the unit of the file; NaN where a load is held."""
        return self._core.column("delta") * self._core.approach_scale

    @property
    def T(self) -> FloatArray:
        """Tangential loads, shape (n,), in units["force"]."""
        return self._core.column("T") * self._core.force_scale

    @property
    def A(self) -> FloatArray:
        """Areas, shape (n,), in units["area"]."""
        return self._core.column("A") * self._core.area_scale

    @property
    def psi(self) -> FloatArray:
        """Phase angles [rad] of readings corrected by stated offsets and area_scale, shape (n,).

        NaN where the area does not exceed that of Hertz.
        """
        return self._core.column("psi")

    @property
    def toughness_ratio(self) -> FloatArray:
        """G_c/G_Ic, shape (n,); NaN where there is no phase angle."""
        return self._core.column("f")

    @property
    def run_of_point(self) -> NDArray[np.int_]:
        """Indices into ``runs``, shape (n,)."""
        return self._core.column("curve").astype(int)


def _again(kind, arguments):
    if kind == "simulated":
        plan, seed, index = arguments
        return plan.simulate(seed, index)
    core = (_core.from_arrays if kind == "arrays" else _core.read)(*arguments)
    return Dataset._of(core, (kind, arguments[:2] if kind == "file" else arguments))


def files_and_constants(path, constants):
    """The files of a path, a pattern or a list of them, and the constants as texts."""
    paths = [path] if isinstance(path, (str, os.PathLike)) else list(path)
    files = [file for one in paths for file in _core.files_of(os.fspath(one))]
    stated = []
    for key, value in constants.items():
        if value is None:
            continue
        if key == "columns" and isinstance(value, dict):
            value = ",".join(f"{column}={heading}" for column, heading in value.items())
        stated.append((key, constant_text(key, os.fspath(value) if isinstance(value, os.PathLike) else value)))
    return files, stated


def stated_constants(given):
    """Constants of arrays as texts, with those of a definition, which are read at once."""
    definition = given.pop("definition", None)
    stated = [(key, constant_text(key, value)) for key, value in given.items() if value is not None]
    if definition is None:
        return stated
    common = _core.constants_of_definition(os.fspath(definition))
    given = dict(stated)
    names = set(given)
    averaged = {**dict(common), **given}.get("mode_III") == "averaged"  # poisson_ratio then is not of the modulus alone
    replaced = {"modulus": {"youngs_modulus"}, "youngs_modulus": {"modulus"}}
    if not averaged:
        replaced = {"modulus": {"youngs_modulus", "poisson_ratio"}, "youngs_modulus": {"modulus"}, "poisson_ratio": {"modulus"}}
    for one, instead in replaced.items():
        if one in given:
            names |= instead
    return [one for one in common if one[0] not in names] + stated


def read(path: str | os.PathLike[str] | Iterable[str | os.PathLike[str]], **constants: Any) -> Dataset:
    """Reads a data file as the program does, with the TOML beside it.

    Parameters
    ----------
    path : str, path, or list of them
        A CSV, an Excel workbook (.xlsx) or another export of a table; a pattern such as ``"run_*.csv"``, or several files, are one data set.
        Also arrays of .mat (needs SciPy, of version 7.3 h5py), HDF5 (h5py) and .tdms (npTDMS): of names that are known,
        such as P, T, A, or ``columns={"P": "group/channel (mN)", ...}``. Their units are the attributes ``units`` or
        ``unit``, in .tdms ``unit_string`` or ``NI_UnitDescription``.
    **constants
        Replace those in the TOML: the constants of :class:`Dataset`, and how to read the file (``columns``, ``decimal``, ``sheet``, ``table``,
        ``rate``, ``fps``, ``pixel``, ``load``, ``load_from``, ``headings``). ``definition`` is a TOML of such
        constants, as :func:`check` saves it, for all that is stated nowhere else.

    Returns
    -------
    Dataset
        With the units of the file.

    Raises
    ------
    InputError
        With the program's message: file, line, column and remedy.
    """
    files, stated = files_and_constants(path, constants)
    data = Dataset._of(_core.read(files, stated, None, tables(files, stated)), ("file", (files, stated)))
    data._tell_notes()
    return data
