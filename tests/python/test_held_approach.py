"""Data whose approach is held in place of the load."""

import numpy as np
import pytest

import mixity

CONSTANTS = dict(radius="9.42 mm", modulus="2.133 MPa", toughness="27 mJ/m^2", control="approach")


@pytest.fixture(scope="module")
def data():
    plan = mixity.Plan(
        "c", (0.05,), [3e-6, 8e-6, 15e-6], points=25, sigma_T="1%", sigma_A="0.5%", normal_stiffness="1.2 kN/m", **CONSTANTS
    )
    return plan.simulate(1, 0)


def test_fit_finds_lambda(data):
    parameter = mixity.fit(data, "c")["c"].params["lambda"]
    assert abs(parameter.value - 0.05) < 4 * parameter.stderr


def test_approaches_are_not_called_loads(data):
    assert data.units["approach"] == "um"
    assert np.unique(np.round(data.delta, 9)).tolist() == [3, 8, 15]
    assert np.isnan(data.P).all()


def test_arrays_of_approaches_are_fitted_and_predicted(data):
    again = mixity.Dataset(
        delta=data.delta,
        T=data.T,
        A=data.A,
        units={"delta": "um", "T": "mN", "A": "mm^2"},
        normal_stiffness="1.2 kN/m",
        approach_offset="0 +/- 0.2 um",
        **CONSTANTS,
    )
    fit = mixity.fit(again, "c")["c"]
    assert fit.params["approach_offset"].stderr > 0
    A, low, high = fit.area(8.0, [1.0, 5.0])
    assert (low < A).all() and (A < high).all() and A[1] < A[0]
    assert fit.folds(8.0)[0]["T"] > 5


def test_approaches_are_planned():
    plan = mixity.Plan("c", (0.05,), "3,8 um", points=9, **CONSTANTS)
    assert plan.loads == [3e-6, 8e-6]
    best = plan.best("2 um", "20 um", 1)
    assert len(best.loads) == 3 and best.expect("")["standard_error"] < plan.expect("")["standard_error"]
    with pytest.raises(mixity.InputError, match="approaches with a unit"):
        mixity.Plan("c", (0.05,), "3,8 mN", **CONSTANTS)


def test_areas_are_drawn_at_approaches(data):
    pytest.importorskip("matplotlib").use("Agg")
    lines = mixity.fit(data, "c")["c"].plot_area().lines
    assert all(np.isfinite(line.get_ydata()).all() for line in lines) and len(lines) >= 4
