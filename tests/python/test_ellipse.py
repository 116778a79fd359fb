"""Elliptic contacts: fits of axes, whole data, options."""

import pickle

import numpy as np
import pytest

import mixity

CONSTANTS = dict(radius="9.42 mm", modulus="2.133 MPa", toughness="27 mJ/m^2")


@pytest.fixture(scope="module")
def data():
    plan = mixity.Plan("c-ellipse", (0.02, 0.005, 0.5), [0.5e-3, 1.5e-3, 4e-3], points=25, **CONSTANTS)
    return plan.simulate(1, 0)


def test_fit_finds_both_couplings(data):
    fit = mixity.fit(data, "c", shape="ellipse")["c-ellipse"]
    for name, truth in (("lambda_II", 0.02), ("lambda_III", 0.005)):
        parameter = fit.params[name]
        assert abs(parameter.value - truth) < 4 * parameter.stderr
    assert mixity.fit(data, ["c-ellipse"])["c-ellipse"].params["lambda_II"].value == fit.params["lambda_II"].value


def test_data_with_axes_travel_whole(data):
    again = pickle.loads(pickle.dumps(data))
    first, second = (mixity.fit(one, "c-ellipse")["c-ellipse"].params["lambda_III"].value for one in (data, again))
    assert first == second


def test_axes_are_those_of_a_reference_solution():
    # 45 digits, as in tests/mechanics/contact_model_ellipses_test.cc
    a, b = mixity.axes("c-ellipse", (0.008, 0.0, 0.5), 3.0, [0.0, 95.3202193183654, 180.0])
    assert a[0] == b[0] and abs(a[1] / 2.54799398314334041 - 1) < 1e-13 and abs(b[1] / 2.60750787687640354 - 1) < 1e-13
    assert np.isnan(a[2]) and np.isnan(b[2])
    area = mixity.area("c-ellipse", (0.008, 0.0, 0.5), 3.0, 95.3202193183654)
    assert abs(np.pi * a[1] * b[1] / area - 1) < 1e-15 * 4  # a few roundings
    one, other = mixity.axes("c", 0.008, 3.0, 50.0)
    assert one == other
    contact, loads = (9.42e-3, 2.133e6, 27e-3), (7.6e-4, 2.4e-2)
    a, b = mixity.axes("c-ellipse", (0.008, 0.0, 0.5), *loads, contact=contact)
    area = mixity.area("c-ellipse", (0.008, 0.0, 0.5), *loads, contact=contact)
    assert b > a > 1e-4 and abs(np.pi * a * b / area - 1) < 1e-15 * 8  # a few roundings


def test_folds_through_a_spring_are_those_of_a_reference_solution():
    # 34 digits, as in tests/mechanics/contact_model_ellipses_test.cc
    fold = mixity.folds("c-ellipse", (0.3, 0.1, 0.5), 3.0, control="stiffness", stiffness=1.0)[0]
    assert abs(fold["T"] / 23.9062611977273543 - 1) < 1e-12 and abs(fold["u"] / 8.69857996077526116 - 1) < 1e-12


def test_a_fit_predicts_axes_with_bands(data):
    fit = mixity.fit(data, "c", shape="ellipse")["c-ellipse"]
    T = np.array([[0.0, 10.0], [20.0, 1e4]])  # mN
    (a, a_low, a_high), (b, b_low, b_high) = fit.axes(1.5, T)
    A = fit.area(1.5, T)[0]
    assert a.shape == T.shape and np.isnan(a[1, 1])
    assert np.nanmax(abs(np.pi * a * b / A - 1)) < 1e-12
    assert b[1, 0] > a[1, 0] and a_low[1, 0] < a[1, 0] < a_high[1, 0] and b_low[1, 0] < b[1, 0] < b_high[1, 0]
    with pytest.raises(mixity.InputError, match="shape"):
        mixity.fit(data, "c", checks=False)["c"].axes(1.5, T)


def test_couplings_are_tied(data):
    assert "lambda" in mixity.fit(data, "c", shape="ellipse", tie="equal")["c-ellipse-equal"].params
    held = mixity.fit(data, "c", shape="ellipse", tie="lambda_III=0.005")["c-ellipse"].params["lambda_III"]
    assert held.value == 0.005
    with pytest.raises(mixity.InputError, match="elliptic"):
        mixity.fit(data, "c", tie="equal")
    with pytest.raises(ValueError, match="circle"):
        mixity.fit(data, "c", shape="square")


def test_a_circle_is_suspect(data):
    fit = mixity.fit(data, "c")["c"]
    assert fit.status == "suspect" and 'shape="ellipse"' in fit.message
