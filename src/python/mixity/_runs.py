"""Loading runs of logs."""

from __future__ import annotations

import csv
import io
import os
from typing import Any, Sequence

from . import _core
from ._binary import tables
from ._data import Dataset, files_and_constants
from ._reports import warn

_NAME = "runs.csv"


class Runs:
    """The loading runs of a log, as ``mixity runs`` finds them.

    Attributes
    ----------
    data : Dataset
        The points of all runs, ready to fit, with the same numbers as in the program's file.
    """

    def __init__(self, log: Any, paths: Sequence[str]) -> None:
        self._log = log
        self._paths = list(paths)
        texts = [(_NAME, log.csv().encode()), ("runs.toml", log.toml().encode())]
        self.data = Dataset._of(_core.read([_NAME], [], texts), ("file", ([_NAME], [])))
        self.data._tell_notes()

    @property
    def runs(self) -> list[dict[str, Any]]:
        """The runs, one dict each.

        ``name``; ``P`` [N], the mean of its readings, and ``P_scatter``; ``T_zero`` [N], which was
        subtracted from T, and ``T_noise`` of a frame; the kept ``frames``; ``shear`` and ``sliding`` (None where it is
        not seen): dicts of ``time`` [s], its 95 % interval ``low`` .. ``high``, and whether it was ``stated``.
        """
        return self._log.runs()

    @property
    def peaks(self) -> list[dict[str, Any]]:
        """Stick-slip cycles of the runs: one dict per row of peaks.csv, in the units of its header."""
        return _rows(self._log.peaks())

    @property
    def phases(self) -> list[dict[str, Any]]:
        """The use of the log's frames: one dict per row of phases.csv."""
        return _rows(self._log.phases())

    def save(self, folder: str | os.PathLike[str], *, formats: str | Sequence[str] = "", force: bool = False) -> None:
        """Writes points, peaks, phases, cuts, figures and the definition of a fit, as ``mixity runs --out``.

        Parameters
        ----------
        folder : path
            Is made if it is missing.
        formats, force
            As for :func:`report`.
        """
        asked = formats if isinstance(formats, str) else ",".join(formats)
        warn(self._log.save(os.fspath(folder), asked, force, self._paths))

    def save_definition(self, path: str | os.PathLike[str], *, force: bool = False) -> None:
        """Writes a TOML for other logs of this kind: ``runs(..., definition=path)``.

        Parameters
        ----------
        path : path
            The file for the columns, rate and constants as they were understood.
        force : bool
            As for :func:`report`.
        """
        self._log.save_definition(os.fspath(path), force, self._paths)

    def __len__(self) -> int:
        return len(self._log.runs())

    def __str__(self) -> str:
        return self._log.text()

    def __repr__(self) -> str:
        return f"<mixity.Runs: {len(self)} {'run' if len(self) == 1 else 'runs'}, {len(self.data)} points>"


def _number(text):
    try:
        return float(text)
    except ValueError:
        return text


def _rows(text):
    lines = [line for line in text.splitlines() if line and not line.startswith("#")]
    return [{key: _number(value) for key, value in row.items()} for row in csv.DictReader(io.StringIO("\n".join(lines)))]


def runs(
    *logs: str | os.PathLike[str],
    areas: str | os.PathLike[str] | None = None,
    lag: float | None = None,
    zero_drift: bool | None = None,
    cuts: str | os.PathLike[str] | None = None,
    **constants: Any,
) -> Runs:
    """Finds the loading runs of logs of forces and areas over time.

    Parameters
    ----------
    *logs : path
        Tables with a column of times, P, T and A, each a log with a clock and zeros of its own, such as one for each
        load; or in pairs, one of forces and one of areas, recorded with two clocks. A file whose clock starts anew has
        several logs.
    areas : path, optional
        The table of times and areas that belongs to a single log of forces.
    lag : float, optional
        Lead of the areas' clock over that of the forces [s]; by default estimated from events that both show.
    zero_drift : bool, optional
        Whether to subtract a line through the zeros of all runs from T; by default if the drift is significant.
    cuts : path, optional
        A TOML of cuts, such as the cuts.toml of :meth:`Runs.save`.
    **constants
        As for :func:`read`.

    Returns
    -------
    Runs
        What was found, and the data set of it.

    Raises
    ------
    InputError
        With the program's message; also if there is no loading run.
    """
    paths = [os.fspath(one) for one in (*logs, areas) if one is not None]
    _, stated = files_and_constants([], constants)
    where = "" if cuts is None else os.fspath(cuts)
    others = [text for key, text in stated if key in ("definition", "headings")] + ([where] if where else [])
    return Runs(_core.runs(paths, stated, lag, zero_drift, where, tables(paths, stated)), [*paths, *others])
