"""Files of MATLAB, HDF5 and LabVIEW give the same points as a table of their numbers."""

import logging
import pickle
import sys

import numpy as np
import pytest

import mixity

CONSTANTS = {"radius": "9.42 mm", "modulus": "2.1 MPa", "toughness": "27 mJ/m^2"}
UNITS = {"P": "mN", "T": "mN", "A": "mm^2"}
ARRAYS = {
    "P": np.repeat([1.0, 4.1], 5),
    "T": np.tile(np.arange(5) * 0.1, 2),
    "A": np.linspace(0.3, 0.28, 10) / 3,  # no short decimals
}
MAPPED = {"columns": {name: f"{name} ({unit})" for name, unit in UNITS.items()}}


@pytest.fixture
def expected():
    return mixity.Dataset(**ARRAYS, units=UNITS, **CONSTANTS)


def same(data, other):
    equal = [np.array_equal(getattr(data, name), getattr(other, name), equal_nan=True) for name in ("P", "T", "A", "psi")]
    return all(equal) and data.runs == other.runs


def mat(path, arrays, **more):
    scipy_io = pytest.importorskip("scipy.io", reason="SciPy is not installed")
    scipy_io.savemat(path, {**arrays, **more})
    return path


def hdf5(path, arrays, units=UNITS, key="units"):
    h5py = pytest.importorskip("h5py", reason="h5py is not installed")
    with h5py.File(path, "w") as file:
        for name, values in arrays.items():
            one = file.create_dataset(name, data=values)
            if units and name.rsplit("/")[-1] in units:
                one.attrs[key] = units[name.rsplit("/")[-1]]
    return path


def matlab_73(path, arrays):
    """As MATLAB writes it: a block of 512 bytes before the HDF5, vectors as matrices, and texts as numbers."""
    h5py = pytest.importorskip("h5py", reason="h5py is not installed")
    with h5py.File(path, "w", userblock_size=512) as file:
        for name, values in arrays.items():
            file.create_dataset(name, data=values.reshape(1, -1)).attrs["MATLAB_class"] = np.bytes_("double")
        file.create_dataset("note", data=np.frombuffer("0123456789".encode("utf-16-le"), np.uint16)).attrs["MATLAB_class"] = np.bytes_("char")
        file.create_dataset("#refs#/a", data=np.arange(10.0))
    with open(path, "r+b") as file:
        file.write(b"MATLAB 7.3 MAT-file, Platform: GLNXA64, Created on: Mon May  4 2026 HDF5 schema 1.00 .".ljust(124) + b"\x00\x02IM")
    return path


def tdms(path, arrays, properties, group="forces"):
    nptdms = pytest.importorskip("nptdms", reason="npTDMS is not installed")
    with nptdms.TdmsWriter(str(path)) as writer:
        writer.write_segment([nptdms.ChannelObject(group, name, values, properties.get(name, {})) for name, values in arrays.items()])
    return path


def test_matlab_files_are_read_by_the_names_of_their_variables(tmp_path, expected):
    assert same(mixity.read(mat(tmp_path / "a.mat", ARRAYS, gain=2.0, note="0123456789"), **MAPPED, **CONSTANTS), expected)
    rows = {name: values.reshape(-1, 1) for name, values in ARRAYS.items()}
    assert same(mixity.read(mat(tmp_path / "b.mat", rows), **MAPPED, **CONSTANTS), expected)
    struct = mixity.read(
        mat(tmp_path / "c.mat", {"run": ARRAYS, "P": ARRAYS["T"]}),
        columns={"P": "run/P (mN)", "T": "run/T (mN)", "A": "A (mm^2)"},
        **CONSTANTS,
    )
    assert same(struct, expected)
    matrix = mixity.read(
        mat(tmp_path / "d.mat", {"data": np.column_stack(list(ARRAYS.values()))}),
        columns={"P": "data/1 (mN)", "T": "data/2 (mN)", "A": "data/3 (mm^2)"},
        **CONSTANTS,
    )
    assert same(matrix, expected)


def test_matlab_7_3_files_are_read(tmp_path, expected):
    assert same(mixity.read(matlab_73(tmp_path / "a.mat", ARRAYS), **MAPPED, **CONSTANTS), expected)


def test_hdf5_files_have_units_and_paths(tmp_path, expected):
    for key in ("units", "unit"):
        assert same(mixity.read(hdf5(tmp_path / f"{key}.h5", ARRAYS, key=key), **CONSTANTS), expected)
    grouped = {f"run 1/{name}": values for name, values in ARRAYS.items()}
    both = {**grouped, **{f"run 2/{name}": 2 * values for name, values in ARRAYS.items()}}
    assert same(mixity.read(hdf5(tmp_path / "grouped.h5", grouped), **CONSTANTS), expected)
    path = hdf5(tmp_path / "both.h5", both)
    paths = {name: f"run 1/{name}" for name in UNITS}
    assert same(mixity.read(path, columns=paths, **CONSTANTS), expected)
    with pytest.raises(mixity.InputError, match="run 1/P"):
        mixity.read(path, **CONSTANTS)
    # the mapping may stand beside the file
    (tmp_path / "both.toml").write_text("[columns]\n" + "\n".join(f'{name} = "{one}"' for name, one in paths.items()))
    assert same(mixity.read(path, **CONSTANTS), expected)


def test_packed_numbers_of_hdf5_are_unpacked(tmp_path):
    h5py = pytest.importorskip("h5py", reason="h5py is not installed")
    path = hdf5(tmp_path / "a.h5", {"P": ARRAYS["P"], "A": ARRAYS["A"]})
    with h5py.File(path, "a") as file:
        packed = file.create_dataset("T", data=np.array([-99, 1, 2, 3, 4, 0, 1, 2, 3, 4], np.int16))
        packed.attrs.update({"scale_factor": 0.5, "add_offset": 1.0, "_FillValue": np.int16(-99), "units": "mN"})
    data = mixity.read(path, **CONSTANTS)
    assert data.T == pytest.approx([1.5, 2, 2.5, 3, 1, 1.5, 2, 2.5, 3])  # mN in and out of SI
    assert data.excluded == [(2, "T is empty")]


def test_tdms_files_have_units_and_a_clock(root, tmp_path, expected):
    for key in ("unit_string", "NI_UnitDescription"):
        properties = {name: {key: unit} for name, unit in UNITS.items()}
        assert same(mixity.read(tdms(tmp_path / f"{key}.tdms", ARRAYS, properties), **CONSTANTS), expected)
    table = np.genfromtxt(root / "data/shear_log.csv", delimiter=",", skip_header=1)
    step = {"wf_increment": 0.0025, "wf_start_offset": 0.0}
    channels = {"Kanal 1": table[:, 1], "Kanal 2": table[:, 2], "Kanal 3": table[:, 3]}
    properties = {name: {**step, "unit_string": unit} for name, unit in zip(channels, UNITS.values())}
    path = tdms(tmp_path / "log.tdms", channels, properties)
    named = {"P": "forces/Kanal 1", "T": "Kanal 2", "A": "forces/Kanal 3"}
    runs, text = mixity.runs(path, columns=named, **CONSTANTS), mixity.runs(root / "data/shear_log.csv", **CONSTANTS)
    assert runs.runs == text.runs and (runs.data.T == text.data.T).all()
    other = {**properties, "Kanal 2": {**properties["Kanal 2"], "wf_increment": 0.005}}
    with pytest.raises(mixity.InputError, match="different clocks"):
        mixity.runs(tdms(tmp_path / "clocks.tdms", channels, other), columns=named, **CONSTANTS)


def test_arrays_of_other_lengths_are_named(tmp_path, caplog):
    path = hdf5(tmp_path / "a.h5", {**ARRAYS, "calibration": np.arange(3.0)})
    with caplog.at_level(logging.WARNING, "mixity"):
        assert len(mixity.read(path, **CONSTANTS)) == 10
    assert "not those of other lengths: calibration (3)" in caplog.text
    uneven = hdf5(tmp_path / "b.h5", {**ARRAYS, "A": ARRAYS["A"][:7]})
    with pytest.raises(mixity.InputError, match=r"different lengths: A \[mm\^2\] \(7\), P \[mN\] \(10\), T \[mN\] \(10\)"):
        mixity.read(uneven, **CONSTANTS)
    with pytest.raises(mixity.InputError, match="holds no arrays of numbers"):
        mixity.read(hdf5(tmp_path / "c.h5", {"x": np.float64(3)}), **CONSTANTS)


def test_binary_files_are_checked_pooled_and_pickled_like_others(tmp_path, expected):
    one, two = (hdf5(tmp_path / f"run_{i}.h5", {**ARRAYS, "T": i * ARRAYS["T"]}) for i in (1, 2))
    assert "10 rows, 10 usable" in mixity.check(one, save=tmp_path / "lab.toml", **CONSTANTS)
    assert same(mixity.read(one, definition=tmp_path / "lab.toml"), expected)
    assert len(mixity.read([one, two], **CONSTANTS)) == 20
    data = mixity.read(one, **CONSTANTS)
    pickled = pickle.dumps(data)
    one.unlink()
    assert same(pickle.loads(pickled), expected)


@pytest.mark.parametrize(
    "start, package, extra",
    [(b"MATLAB 5.0 MAT-file", "SciPy", "mat"), (b"\x89HDF\r\n\x1a\n", "h5py", "hdf5"), (b"TDSm", "npTDMS", "tdms")],
)
def test_a_missing_package_and_a_damaged_file_are_one_sentence(tmp_path, monkeypatch, start, package, extra):
    path = tmp_path / "a.dat"
    path.write_bytes(start + bytes(200))
    for module in ("scipy.io", "h5py", "nptdms"):
        monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(mixity.InputError) as error:
        mixity.read(path)
    assert f'which {package} reads: pip install "mixity[{extra}]"' in str(error.value) and "\n" not in str(error.value)
    monkeypatch.undo()
    pytest.importorskip({"SciPy": "scipy", "npTDMS": "nptdms"}.get(package, package), reason=f"{package} is not installed")
    with pytest.raises(mixity.InputError) as error:
        mixity.read(path)
    assert f"that {package} cannot read" in str(error.value) or "holds no arrays" in str(error.value)


def test_the_program_names_pythons_way(tmp_path, program):
    import subprocess

    for start, name in ((b"MATLAB 5.0 MAT-file", "mat"), (b"\x89HDF\r\n\x1a\n", "h5"), (b"TDSm", "tdms")):
        path = tmp_path / f"a.{name}"
        path.write_bytes(start + bytes(200))
        done = subprocess.run([program, "check", path], capture_output=True, text=True)
        assert f'in Python mixity.read("FILE.{name}") reads it' in done.stderr
