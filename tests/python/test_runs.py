"""Logs, checks and reports: the same as the program's."""

import pickle
import subprocess

import pytest

import mixity


@pytest.fixture
def log(root):
    return root / "data/shear_log.csv"


def written(folder):
    return {path.relative_to(folder): path.read_text() for path in sorted(folder.rglob("*")) if path.is_file()}


def test_runs_are_those_of_the_program(log, program, tmp_path):
    runs = mixity.runs(log)
    runs.save(tmp_path / "python")
    subprocess.run([program, "runs", log, f"--out={tmp_path}/program"], check=True, capture_output=True)
    ours, theirs = written(tmp_path / "python"), written(tmp_path / "program")
    assert ours.keys() == theirs.keys()
    # the cuts name an option in the words of the interface, and the record holds their hash
    differ = {str(path) for path in ours if ours[path] != theirs[path]}
    assert differ == {"cuts.toml", ".mixity-files"}
    again = mixity.runs(log, cuts=tmp_path / "python/cuts.toml")
    assert all(run["shear"]["stated"] for run in again.runs)


def test_points_of_runs_fit_as_the_file_does(log, program, tmp_path):
    runs = mixity.runs(log)
    runs.save(tmp_path)
    assert len(runs) == 3 and [run["name"] for run in runs.runs] == runs.data.runs
    of_file, of_runs = (mixity.fit(data, "c")["c"] for data in (mixity.read(tmp_path / "runs.csv"), runs.data))
    assert of_runs.params["lambda"].value == of_file.params["lambda"].value
    assert of_runs.params["lambda"].stderr == of_file.params["lambda"].stderr
    copied = pickle.loads(pickle.dumps(runs.data))
    assert (copied.A == runs.data.A).all()
    assert runs.peaks[0]["run"] == runs.data.runs[0] and runs.phases[0]["kept"] == 0


def test_options_of_runs_are_checked(log, tmp_path):
    shifted = mixity.runs(log, zero_drift=False, force_gain=1.01)
    assert shifted.runs[0]["P"] == pytest.approx(mixity.runs(log).runs[0]["P"])  # a correction of the fit, not of the log
    with pytest.raises(mixity.InputError, match="holds no loading run"):
        empty = tmp_path / "flat.csv"
        empty.write_text("time [s],P [mN],T [mN],A [mm^2]\n" + "".join(f"{k / 10},0,0,0\n" for k in range(200)))
        mixity.runs(empty)


def test_check_says_what_the_program_says(root, program, data):
    path = root / "data/mergel2018.csv"
    told = subprocess.run([program, "check", path], check=True, capture_output=True, text=True).stdout
    assert mixity.check(path) == told
    assert "10 rows, 10 usable" in mixity.check(data)
    with pytest.raises(mixity.InputError, match="stated where it is made"):
        mixity.check(data, radius=1)


def test_check_names_missing_constants_in_keywords(tmp_path):
    path = tmp_path / "bare.csv"
    path.write_text("P [mN],T [mN],A [mm^2]\n4,0,0.4\n4,10,0.39\n")
    told = mixity.check(path)
    assert "radius=" in told and "--radius" not in told and "2 rows, 2 usable" in told


def test_report_is_that_of_the_program(data, tmp_path):
    fits = mixity.fit(data, "ac")
    page = mixity.report(fits)
    assert page.startswith("<!DOCTYPE html>") and "<svg" in page
    path = mixity.report([fits, mixity.fit(data, "b")], tmp_path / "out")
    assert sorted(one.name for one in (tmp_path / "out").iterdir() if one.suffix) == [
        "curves.csv", "fits.csv", "report.html", "residuals.csv", "results.json", "summary.md",
    ]
    with open(path) as file:
        assert file.read().startswith("<!DOCTYPE html>")
    with pytest.raises(TypeError, match="what mixity.fit returns"):
        mixity.report(data)


def test_a_file_of_somebody_else_is_kept(data, tmp_path):
    (tmp_path / "report.html").write_text("mine")
    fits = mixity.fit(data, "c")
    with pytest.raises(OSError, match="force=True"):
        mixity.report(fits, tmp_path)
    assert (tmp_path / "report.html").read_text() == "mine"
    mixity.report(fits, tmp_path, force=True)
    assert (tmp_path / "report.html").read_text() != "mine"


def test_excluded_rows_stay_excluded_in_a_report(data, tmp_path):
    fits = mixity.fit(data, "c", exclude=[3])
    mixity.report(fits, tmp_path)
    assert mixity.fit(data, "c", exclude=[3])["c"].params["lambda"].value != mixity.fit(data, "c")["c"].params["lambda"].value
    assert repr(fits["c"].params["lambda"].value)[:12] in (tmp_path / "results.json").read_text()


def test_several_logs_are_one_set_of_runs(log, program, tmp_path):
    other = tmp_path / "other.csv"
    other.write_text(log.read_text())
    other.with_suffix(".toml").write_text(log.with_suffix(".toml").read_text())
    runs = mixity.runs(log, other)
    assert len(runs) == 6 and len(set(run["name"] for run in runs.runs)) == 6
    assert runs.runs[0]["shear"] == runs.runs[3]["shear"]
    assert {row["log"] for row in runs.phases} == {str(log), str(other)}
    runs.save(tmp_path / "python")
    subprocess.run([program, "runs", log, other, f"--out={tmp_path}/program"], check=True, capture_output=True)
    assert (tmp_path / "python/runs.csv").read_text() == (tmp_path / "program/runs.csv").read_text()
    with pytest.raises(TypeError):
        mixity.runs(log, 3)
