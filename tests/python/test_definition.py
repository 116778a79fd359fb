"""Definitions of data: what is understood of one file reads others of its kind."""

import pickle

import pytest

import mixity

CONSTANTS = {"radius": "9.42 mm +/- 1%", "modulus": "2.1 MPa", "toughness": "27 mJ/m^2"}
COLUMNS = {"P": "Kanal 3", "T": "Kanal 4 (N)", "A": "4 (mm^2)"}


def table(path, scale):
    rows = [f"{i};{load * scale};{1e-3 * i * scale};{0.3 * scale - 0.001 * i}" for load in (1, 4) for i in range(5)]
    path.write_text("\n".join(["Weg (mm);Kanal 3;Kanal 4 (N);7", ";mN;;mm^2", *rows]) + "\n")
    return path


def test_a_definition_of_check_reads_another_file_as_the_keywords_do(tmp_path):
    lab, second = tmp_path / "lab.toml", table(tmp_path / "second.csv", 1.25)
    assert "10 rows, 10 usable" in mixity.check(table(tmp_path / "first.csv", 1), columns=COLUMNS, save=lab, **CONSTANTS)
    explicitly, by_definition = mixity.read(second, columns=COLUMNS, **CONSTANTS), mixity.read(second, definition=lab)
    for column in ("P", "T", "A", "psi"):
        assert (getattr(explicitly, column) == getattr(by_definition, column)).all()
    assert mixity.check(second, definition=lab) == mixity.check(second, columns=COLUMNS, **CONSTANTS)
    copied = pickle.loads(pickle.dumps(by_definition))
    lab.unlink()
    assert (copied.P == explicitly.P).all()


def test_a_definition_is_saved_without_its_constants_and_over_no_file_of_a_user(tmp_path):
    first, lab = table(tmp_path / "first.csv", 1), tmp_path / "lab.toml"
    lab.write_text('radius = "1 mm"\n')
    with pytest.raises(OSError, match="not written by mixity"):
        mixity.check(first, columns=COLUMNS, save=lab)
    assert lab.read_text() == 'radius = "1 mm"\n'
    assert "needs radius, modulus, toughness" in mixity.check(first, columns=COLUMNS, save=lab, force=True)
    assert "# modulus" in lab.read_text()
    with pytest.raises(mixity.InputError, match="must end in .toml"):
        mixity.check(first, columns=COLUMNS, save=tmp_path / "lab.csv")


def test_a_definition_gives_arrays_its_constants(tmp_path):
    lab = tmp_path / "lab.toml"
    lab.write_text('radius = "9.42 mm +/- 1%"\nmodulus = "1 MPa"\ntoughness = "27 mJ/m^2"\nsheet = "2"\n')
    arrays = {"P": [1e-3] * 3, "T": [0, 1e-3, 2e-3], "A": [3e-7, 2.9e-7, 2.8e-7]}
    given = mixity.Dataset(**arrays, definition=lab, youngs_modulus="1.575 MPa", poisson_ratio=0.5)
    same = mixity.Dataset(**arrays, radius="9.42 mm +/- 1%", modulus="2.1 MPa", toughness="27 mJ/m^2")
    # E/(1 - nu^2) in doubles
    assert given.psi == pytest.approx(same.psi, rel=1e-12)
    assert (pickle.loads(pickle.dumps(given)).psi == given.psi).all()
    plans = [mixity.Plan("c", 0.1, loads="1,4 mN", **one) for one in ({"definition": lab}, {**CONSTANTS, "modulus": "1 MPa"})]
    assert (plans[0].simulate(1).A == plans[1].simulate(1).A).all()


def test_a_definition_of_a_log_reads_another_one(root, tmp_path):
    lines = (root / "data/shear_log.csv").read_text().splitlines()
    log = tmp_path / "log.csv"
    log.write_text("\n".join(["Signal 1,Signal 2,Signal 3"] + [line.split(",", 1)[1] for line in lines[1:]]))
    named = {"columns": {"P": "Signal 1 (mN)", "T": "Signal 2 (mN)", "A": "Signal 3 (mm^2)"}, "rate": "400 Hz", **CONSTANTS}
    runs = mixity.runs(log, **named)
    runs.save_definition(tmp_path / "lab.toml")
    again = mixity.runs(log, definition=tmp_path / "lab.toml")
    assert again.runs == runs.runs and str(again) == str(runs)
