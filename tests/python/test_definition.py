"""Definitions of data: what is understood of one file reads others of its kind."""

import pickle

import numpy as np
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
    assert "the constants radius, modulus, toughness are missing" in mixity.check(first, columns=COLUMNS, save=lab, force=True)
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


def test_mode_III_is_a_keyword_of_data_sets_files_and_plans(tmp_path):
    constants = dict(radius="9.42 mm", modulus="2.133 MPa", toughness="27 mJ/m^2")
    exact = dict(sigma_T="1e-9%", sigma_A="1e-9%")
    data = mixity.Plan("c", 0.2, loads="1,4 mN", mode_III="averaged", **exact, **constants).simulate(1)
    assert mixity.fit(data, "c")["c"].params["lambda"].value == pytest.approx(0.2, rel=1e-9)  # the noise is 1e-11
    arrays = {"P": data.P * 1e-3, "T": data.T * 1e-3, "A": data.A * 1e-6, "runs": data.run_of_point}
    averaged, half = (mixity.Dataset(**arrays, mode_III=one, **constants) for one in ("averaged", "half"))
    fits = [mixity.fit(one, "c") for one in (averaged, half)]
    assert [one.to_dict()["datasets"][0]["mode_III"] for one in fits] == ["averaged", "half"]
    assert fits[1]["c"].params["lambda"].value == pytest.approx(0.3, rel=1e-9)
    assert (averaged.T == half.T).all()
    # the phase angle of a state is another, its tangent sqrt(1.5) times as large
    assert np.tan(averaged.psi[1:20]) == pytest.approx(np.sqrt(1.5) * np.tan(half.psi[1:20]), rel=1e-12)
    for one, other in zip(fits[0]["c"].folds(4e-3), fits[1]["c"].folds(4e-3)):
        for name in "T", "u", "A":
            assert one[name] == pytest.approx(other[name], rel=1e-8)  # lambda within 1e-9, in the root of a fold
    # the equations have sqrt(1.5) times the shear
    weighted = mixity.area("c", 0.2, 4e-3, np.sqrt(1.5) * 5e-3, contact=(9.42e-3, 2.133e6, 27e-3))
    assert fits[0]["c"].area(4e-3, 5e-3)[0] == pytest.approx(weighted, rel=1e-9)
    with pytest.raises(mixity.InputError, match="must be half or averaged"):
        mixity.Dataset(**arrays, mode_III="round", **constants)


def test_poisson_ratio_stays_beside_another_modulus_where_mode_III_is_averaged(tmp_path):
    lab = tmp_path / "lab.toml"
    lab.write_text('radius = "9.42 mm"\nyoungs_modulus = "1.6 MPa"\npoisson_ratio = 0.3\ntoughness = "27 mJ/m^2"\nmode_III = "averaged"\n')
    arrays = {"P": [4e-3] * 3, "T": [0, 2e-3, 4e-3], "A": [3.53e-7, 3.5e-7, 3.4e-7]}
    given = mixity.Dataset(**arrays, definition=lab, modulus="2.133 MPa")
    same = mixity.Dataset(**arrays, radius="9.42 mm", modulus="2.133 MPa", toughness="27 mJ/m^2", poisson_ratio=0.3, mode_III="averaged")
    other = mixity.Dataset(**arrays, definition=lab, modulus="2.133 MPa", mode_III="half")
    assert (given.psi == same.psi).all()
    assert given.psi[2] > other.psi[2]


def test_a_definition_of_a_log_reads_another_one(root, tmp_path):
    lines = (root / "data/shear_log.csv").read_text().splitlines()
    log = tmp_path / "log.csv"
    log.write_text("\n".join(["Signal 1,Signal 2,Signal 3"] + [line.split(",", 1)[1] for line in lines[1:]]))
    named = {"columns": {"P": "Signal 1 (mN)", "T": "Signal 2 (mN)", "A": "Signal 3 (mm^2)"}, "rate": "400 Hz", **CONSTANTS}
    runs = mixity.runs(log, **named)
    runs.save_definition(tmp_path / "lab.toml")
    again = mixity.runs(log, definition=tmp_path / "lab.toml")
    assert again.runs == runs.runs and str(again) == str(runs)
