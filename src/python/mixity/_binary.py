"""Arrays in files of MATLAB, HDF5 and LabVIEW (TDMS) as tables of text, which the engine reads like any other."""

from __future__ import annotations

import csv
import io
from typing import Any, Iterator, NamedTuple

import numpy as np

from . import _core
from ._log import WARNING, listening

_MOST_COLUMNS = 64  # of a matrix whose columns are read as arrays


class _Array(NamedTuple):
    path: str  # "group/channel"
    values: Any  # of one dimension: numbers, texts or times
    unit: str = ""
    clock: tuple[float, float] | None = None  # time of the first value and step [s]

    @property
    def leaf(self):
        return self.path.rsplit("/", 1)[-1]


def tables(files, stated):
    """[(path, bytes)]: the tables of those of the files that hold arrays. ``stated``: constants as texts."""
    made = []
    for path in files:
        reader = _reader(path)
        if reader:
            made.append((path, _text(path, list(reader(path)), _core.columns_stated(path, stated))))
    return made


def _reader(path):
    try:
        with open(path, "rb") as file:
            start = file.read(32)
    except OSError:
        return None  # the engine says what is wrong
    if start.startswith(b"MATLAB 7.3 MAT-file") or start.startswith(b"\x89HDF\r\n\x1a\n"):
        return _hdf5
    if start.startswith(b"TDSm"):
        return _tdms
    return _mat if start.startswith(b"MATLAB 5.0 MAT-file") or path.endswith(".mat") else None


def _with_package(path, what, package, extra, read):
    """What ``read`` makes of the file. Every failure is an InputError."""
    try:
        return read()
    except ImportError:
        raise _core.InputError(f'{path}: is {what}, which {package} reads: pip install "mixity[{extra}]"') from None
    except Exception as error:
        raise _core.InputError(f"{path}: is {what} that {package} cannot read: {error}") from None


def _mat(path) -> Iterator[_Array]:
    def read():
        from scipy.io import loadmat

        return loadmat(path, squeeze_me=True, struct_as_record=False)

    def walk(name, value):
        if hasattr(value, "_fieldnames"):
            for field in value._fieldnames:
                yield from walk(f"{name}/{field}", getattr(value, field))
        elif isinstance(value, np.ndarray) and value.dtype == object and not all(isinstance(one, str) for one in value.flat):
            for number, one in enumerate(value.flat, 1):
                yield from walk(f"{name}/{number}", one)
        else:
            yield from _arrays(name, np.asarray(value))

    for name, value in _with_package(path, "a .mat file of MATLAB", "SciPy", "mat", read).items():
        if not name.startswith("__"):
            yield from walk(name, value)


def _hdf5(path) -> Iterator[_Array]:
    def read():
        import h5py

        found = []

        def visit(name, node):
            if isinstance(node, h5py.Dataset) and not name.startswith("#") and _text_of(node.attrs.get("MATLAB_class")) != "char":
                found.extend(_of_hdf5(h5py, name, node))

        with h5py.File(path, "r") as file:
            file.visititems(visit)
        return found

    yield from _with_package(path, "an HDF5 file", "h5py", "hdf5", read)


def _of_hdf5(h5py, name, node):
    if node.dtype.names:
        values = node[()]
        for field in node.dtype.names:
            yield from _arrays(f"{name}/{field}", values[field])
        return
    if h5py.check_string_dtype(node.dtype):
        yield from _arrays(name, np.squeeze(np.asarray(node.asstr()[()])))
        return
    if node.dtype.kind not in "biuf":
        return
    values, attributes = node[()], node.attrs
    if "_FillValue" in attributes or "scale_factor" in attributes or "add_offset" in attributes:  # packed, as in NetCDF
        missing = np.isin(values, attributes.get("_FillValue", []))
        values = values * attributes.get("scale_factor", 1.0) + attributes.get("add_offset", 0.0)
        values = np.where(missing, np.nan, values)
    unit = next((_text_of(attributes[key]) for key in ("units", "unit", "Units", "Unit") if key in attributes), "")
    yield from _arrays(name, values, unit)


def _tdms(path) -> Iterator[_Array]:
    def read():
        from nptdms import TdmsFile

        return TdmsFile.read(path)

    def clock_of(properties):
        step = float(properties.get("wf_increment", 0) or 0)
        return (float(properties.get("wf_start_offset", 0) or 0), step) if step > 0 else None

    for group in _with_package(path, "a TDMS file of LabVIEW", "npTDMS", "tdms", read).groups():
        for channel in group.channels():
            properties = channel.properties
            unit = next((_text_of(properties[key]) for key in ("unit_string", "NI_UnitDescription") if properties.get(key)), "")
            yield from _arrays(f"{group.name}/{channel.name}", np.asarray(channel[:]), unit, clock_of(properties))


def _text_of(value):
    """An attribute as a text: HDF5 has bytes and arrays of one text, too."""
    if isinstance(value, np.ndarray) and value.size == 1:
        value = value.reshape(-1)[0]
    if isinstance(value, bytes):
        value = value.decode("utf-8", "replace")
    return value.strip() if isinstance(value, str) else ""


def _arrays(path, values, unit="", clock=None):
    """An array of one dimension, or the columns of a matrix, which count from 1. Nothing for other values."""
    values = np.squeeze(values)
    if values.dtype.kind not in "biufUOM" or values.ndim not in (1, 2) or values.size < 2:
        return
    if values.dtype.kind == "O" and not all(isinstance(one, str) for one in values.flat):
        return
    if values.ndim == 1:
        yield _Array(path, values, unit, clock)
    elif values.shape[1] <= _MOST_COLUMNS:
        for k in range(values.shape[1]):
            yield _Array(f"{path}/{k + 1}", values[:, k], unit, clock)


def _text(path, arrays, mapping):
    """The table of the arrays that belong together, as CSV."""
    if not arrays:
        raise _core.InputError(f"{path}: holds no arrays of numbers")
    leaves = [one.leaf for one in arrays]
    asked = {}  # index of an array to the name that the mapping has for it
    for heading in mapping.values():
        unit = _core.unit_in_heading(heading)
        for name in (heading, heading[: heading.rfind(unit)].rstrip("([ ").rstrip() if unit else heading):
            by_path = [i for i, one in enumerate(arrays) if one.path == name.strip("/")]
            found = by_path or [i for i, leaf in enumerate(leaves) if leaf == name]
            if len(found) == 1:
                asked[found[0]] = name
                break
    names = [asked.get(i, one.leaf if leaves.count(one.leaf) == 1 else one.path) for i, one in enumerate(arrays)]
    headings = [_heading(name, one.unit) for name, one in zip(names, arrays)]
    rows = _rows_of_table(path, arrays, headings, asked)
    kept = [i for i, one in enumerate(arrays) if len(one.values) == rows]
    left = [f"{headings[i]} ({len(one.values)})" for i, one in enumerate(arrays) if len(one.values) != rows]
    if left and (logger := listening(WARNING)):
        logger.warning("%s: arrays of %d values are read, and not those of other lengths: %s", path, rows, ", ".join(left))
    columns = [_fields(arrays[i].values) for i in kept]
    shown = [headings[i] for i in kept]
    clocks = {one.clock for one in (arrays[i] for i in kept) if one.clock}
    if clocks and not any(_is_time(arrays[i]) for i in kept) and "time" not in mapping:
        if len(clocks) > 1:
            raise _core.InputError(f"{path}: its channels of {rows} values have different clocks (wf_increment); say which are read: columns=...")
        start, step = clocks.pop()
        shown.insert(0, "time [s]")
        columns.insert(0, [f"{start + step * i:.15g}" for i in range(rows)])  # as a file of text has them
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(shown)
    writer.writerows(zip(*columns))
    return text.getvalue().encode()


def _heading(name, unit):
    own = _core.unit_in_heading(name)
    return name if not unit or (own and _core.same_unit(own, unit)) else f"{name} [{unit}]"


def _rows_of_table(path, arrays, headings, asked):
    """How many values the arrays of the table have: those that the mapping asks for, else those of known names."""
    lengths = {len(one.values) for one in arrays}
    if len(lengths) == 1:
        return lengths.pop()
    wanted = list(asked)
    if not wanted:
        try:
            wanted = [index for _, index, _ in _core.named_columns(path, headings, True)]
        except _core.InputError:  # two arrays of one quantity
            wanted = []
    chosen = {len(arrays[i].values) for i in wanted}
    if len(chosen) == 1:
        return chosen.pop()
    listed = ", ".join(f"{headings[i]} ({len(arrays[i].values)})" for i in wanted or range(len(arrays)))
    raise _core.InputError(
        f"{path}: its arrays have different lengths: {listed}. Say which make one table: "
        'columns={"P": "GROUP/NAME (mN)", ...}, or hand them over as arrays'
    )


def _is_time(one):
    names = ("time", "zeit", "temps", "tempo", "tiempo")
    return one.values.dtype.kind == "M" or one.leaf.lower() in names or one.leaf == "t" or one.unit in ("s", "ms", "sec")


def _fields(values):
    kind = values.dtype.kind
    if kind == "M":
        return [str(one) for one in np.datetime_as_string(values)]
    if kind in "UO":
        return [str(one) for one in values]
    if kind == "f":
        return ["" if one != one else repr(one) for one in values.astype(np.float64).tolist()]
    return [str(int(one)) for one in values.tolist()]
