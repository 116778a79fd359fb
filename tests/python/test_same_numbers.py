"""Both doors lead to the same numbers, to the last digit."""

import json
import subprocess

import numpy as np
import pytest

import mixity

SETS = ["mergel2018", "mergel2018_fig7", "waters_guduru2010", "as4_peek"]


def shipped(root):
    found = []
    for path in sorted((root / "data").glob("*.csv")):
        try:
            mixity.read(path)
        except mixity.InputError:  # logs, peaks
            continue
        found.append(path)
    return found


def without_words(value):
    """A result without its sentences, in which each door names options in its own way."""
    if isinstance(value, dict):
        return {key: without_words(one) for key, one in value.items() if key not in ("message", "remedy", "notes")}
    return [without_words(one) for one in value] if isinstance(value, list) else value


def test_of_every_shipped_set(root, program):
    sets = shipped(root)
    assert len(sets) >= 4
    for path in sets:
        data = mixity.read(path)
        free = ["toughness"] if any("toughness is not stated" in note for note in data.notes) else []
        command = [program, "fit", path, "--format=json", *(f"--free={name}" for name in free)]
        done = subprocess.run(command, capture_output=True, text=True, cwd=root)
        assert done.returncode in (0, 1), done.stderr
        ours = mixity.fit(data, free=free or None).to_dict()
        assert without_words(ours) == without_words(json.loads(done.stdout)), path


def test_of_arrays(root, program, data, tmp_path):
    columns = {"P [mN]": data.P, "T [mN]": data.T, "A [mm^2]": data.A}
    path = tmp_path / "data.csv"
    path.write_text(
        ",".join(columns) + "\n" + "\n".join(",".join(map(repr, row)) for row in zip(*map(lambda c: c.tolist(), columns.values())))
    )
    (tmp_path / "data.toml").write_text('radius = "9.42 mm"\nmodulus = "2.133 MPa +/- 3%"\ntoughness = "27 mJ/m^2"\n')
    done = subprocess.run(
        [program, "fit", path, "--format=json", "--models=c,bk", "--loss=cauchy", "--free=toughness"],
        capture_output=True,
        text=True,
    )
    ours = mixity.fit(mixity.read(path), models=["c", "bk"], loss="cauchy", free=["toughness"]).to_dict()
    assert ours == json.loads(done.stdout)


def test_of_predictions(root, program):
    T = np.linspace(0, 18, 7)
    done = subprocess.run(
        [program, "predict", "--model=b", "--lambda=0.3", "--load=2", "--shear=" + ",".join(map(repr, T.tolist()))],
        capture_output=True,
        text=True,
    )
    header, *rows = done.stdout.splitlines()
    column = header.split(",").index("A")
    theirs = [float(row.split(",")[column]) if row.split(",")[column] else np.nan for row in rows]
    # the program asks point by point, arrays are vectorised: 4e-15 each
    np.testing.assert_allclose(mixity.area("b", 0.3, 2.0, T), theirs, rtol=1e-14)


def test_folds_are_where_predictions_end():
    for model, lam in (("a", 0.95), ("b", 0.3), ("c", 0.15)):
        fold = [one for one in mixity.folds(model, lam, 2.0) if one["met_on"] == "loading"][-1]
        inside, outside = mixity.area(model, lam, 2.0, fold["T"] * np.array([1 - 1e-9, 1 + 1e-9]))
        assert np.isfinite(inside)
        if fold["jumps_to"] == "hertz":
            assert np.isnan(outside)
        else:
            assert outside == pytest.approx(fold["area_after"], rel=1e-6)
        assert fold["A"] == pytest.approx(inside, rel=1e-3)  # steep there: the square root of 1e-9
