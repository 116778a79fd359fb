"""Data sets from frames."""

from __future__ import annotations

from typing import Any, Iterable, Mapping

from . import _core
from ._data import COLUMNS, Dataset


def _one_unit(name, heading, own, stated):
    """The unit of a column with ``own`` in its heading and ``stated`` in ``units``; None if neither has one."""
    if own is None or stated is None:
        return own if stated is None else stated
    if not _core.same_unit(own, own):  # brackets without a unit
        return stated
    if not _core.same_unit(own, stated):
        raise _core.InputError(f"{name}: column '{heading}' is in {own}, units says {stated or 'that it has none'}")
    return own


def _headings(frame):
    """The names of the columns; raises InputError where there are none."""
    for attribute in ("colnames", "column_names"):  # astropy, pyarrow
        if hasattr(frame, attribute):
            return list(getattr(frame, attribute))
    names = getattr(getattr(frame, "dtype", None), "names", None)  # a structured array
    if names:
        return list(names)
    if hasattr(frame, "collect") and not hasattr(frame, "__len__"):  # polars' LazyFrame and others
        raise _core.InputError(f"a {type(frame).__name__} has no values yet: give its collect()")
    columns = getattr(frame, "columns", None)  # pandas, polars, and others
    try:
        return list(frame if columns is None else columns)  # a dict, xarray
    except TypeError:
        raise _core.InputError(f"a {type(frame).__name__} is no frame: it has no named columns") from None


def from_frame(
    frame: Any,
    columns: Mapping[str, Any] | None = None,
    *,
    runs: str | Iterable[Any] | None = None,
    units: Mapping[str, str] | str | None = "SI",
    name: str = "frame",
    **constants: Any,
) -> Dataset:
    """A data set from a frame: of pandas, polars, pyarrow or xarray, an astropy table, a structured array, a dict of columns.

    Units of the columns' quantities (pint-pandas, astropy, xarray's attribute ``units``) are kept.

    Parameters
    ----------
    frame : DataFrame or another object with named columns
        Of numbers or quantities.
    columns : dict, optional
        Columns of the quantities: ``{"P": "Normal force [mN]", "T": "Friction", "A": "Area"}``. By default the columns whose headings the
        program knows in a file, such as "T [mN]" or "Normal force (mN)".
    runs : str or array_like, optional
        The column that names runs, or the names. By default a column ``curve``, if there is one.
    units : dict, "SI" or None
        As for :class:`Dataset`, for columns without a unit in the heading; a different unit there is an error.
    name : str
        Shown in texts and messages.
    **constants
        Those of :class:`Dataset`.

    Returns
    -------
    Dataset
        With copies of the columns.

    Raises
    ------
    InputError
        As for :class:`Dataset`, and for columns that are missing or unknown.
    """
    headings = _headings(frame)
    texts = list(map(str, headings))

    def named(heading):
        if heading not in headings:
            raise _core.InputError(f"{name}: has no column '{heading}'; there are {', '.join(texts)}{_core.did_you_mean(str(heading), texts)}")
        return heading

    if columns:
        found = {column: (named(heading), _core.unit_in_heading(str(heading))) for column, heading in columns.items()}
    else:
        known = _core.named_columns(name, texts, bool(constants.get("load") or constants.get("load_from")))
        found = {column: (headings[index], unit) for column, index, unit in known}
        if not any(column in found for column in COLUMNS):
            raise _core.InputError(
                f"{name}: none of its columns is known; there are {', '.join(texts)}. Say which is which: "
                'columns={"P": ..., "T": ..., "A": ...}'
            )
    if isinstance(runs, str):
        runs = frame[named(runs)]
    elif runs is None and ("curve" in found or "curve" in headings):
        runs = frame[found["curve"][0] if "curve" in found else "curve"]
    taken = {column: one for column, one in found.items() if column in COLUMNS}
    stated = units if isinstance(units, dict) else dict.fromkeys(taken, "") if units is None else {}
    of_columns = {
        column: _one_unit(name, heading, own, stated.get(column)) for column, (heading, own) in taken.items()
    }
    if units is None or isinstance(units, dict) or units == "SI":
        units = {**stated, **{column: unit for column, unit in of_columns.items() if unit is not None}}
    given = {column: frame[heading] for column, (heading, _) in taken.items()}
    try:
        return Dataset(**given, runs=runs, units=units, name=name, **constants)
    except _core.MissingColumn as error:
        others = [f"'{heading}'" for heading in texts if heading not in [str(one) for one, _ in found.values()]]
        if not others:
            raise
        which = 'columns={"A": ..., ...}'
        raise _core.InputError(f"{error}; not understood: {', '.join(others)}. Say which is which: {which}") from None
