"""Elliptic contacts: fits of axes, whole data, options."""

import pickle

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
