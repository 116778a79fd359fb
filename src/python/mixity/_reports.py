"""Checks of data, and reports."""

from __future__ import annotations

import os
from typing import Any, Callable, Iterable, Sequence

from . import _core
from ._binary import tables
from ._data import Dataset, files_and_constants
from ._fits import Fits
from ._log import WARNING, listening


def check(
    data: Dataset | str | os.PathLike[str] | Iterable[str | os.PathLike[str]],
    *,
    save: str | os.PathLike[str] | None = None,
    force: bool = False,
    **constants: Any,
) -> str:
    """How data are read, and their oddities: the text of ``mixity check``.

    Parameters
    ----------
    data : Dataset, path, or list of paths
        As for :func:`read`.
    save : path, optional
        A TOML to be written: columns, rate, table and constants as they were understood, for other files of this kind
        (``read(..., definition=save)``). Constants that are missing do not matter.
    force : bool
        Also replace a file that mixity did not write, or that was edited since.
    **constants
        As for :func:`read`. Missing constants are named at the end of the text.

    Returns
    -------
    str
        Lines to print.

    Raises
    ------
    InputError
        If the data cannot be read.
    OSError
        If ``save`` names a file that mixity did not write, or that was edited since, without ``force``.
    """
    where = None if save is None else os.fspath(save)
    if isinstance(data, Dataset):
        if constants:
            raise _core.InputError(f"{next(iter(constants))}: the constants of a Dataset are stated where it is made")
        return _core.checked_data(data._core, where, force)
    files, stated = files_and_constants(data, constants)
    return _core.checked_files(files, stated, where, force, tables(files, stated))


def report(
    fits: Fits | Sequence[Fits],
    folder: str | os.PathLike[str] | None = None,
    *,
    formats: str | Sequence[str] = "",
    force: bool = False,
    progress: Callable[[float], Any] | None = None,
) -> str:
    """Makes a report with figures and tables, as ``mixity report`` does. Repeats the fits with what the figures need.

    Parameters
    ----------
    fits : Fits, or list of them
        One per data set.
    folder : path, optional
        The folder for report.html, results.json, tables and figures; all of them are written or none.
    formats : {"pdf", "png", "gnuplot"}, or list of them
        Additional files of each figure; needs gnuplot.
    force : bool
        Also replace files that mixity did not write, or that were edited since.
    progress : callable, optional
        Called with the fraction done, 0..1.

    Returns
    -------
    str
        The page as HTML, which needs no other file; with ``folder`` the path of the page.
    """
    given: list[Any] = list(fits) if isinstance(fits, (list, tuple)) else [fits]
    several = [one for one in given if isinstance(one, Fits)]
    if not several or len(several) < len(given):
        raise TypeError("fits must be what mixity.fit returns, or a list of such")
    asked = formats if isinstance(formats, str) else ",".join(formats)
    where = None if folder is None else os.fspath(folder)
    made = _core.report([(one.data._core, one._results.options()) for one in several], where, asked, force, progress)
    if where is None:
        return made
    warn(made)
    return os.path.join(where, "report.html")


def warn(missing):
    """Logs what could not be drawn."""
    if missing and (logger := listening(WARNING)):
        logger.warning("%s", missing)
