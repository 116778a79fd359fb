"""A law of one's own is a model: the same numbers as the published one that it is, in every function, in pickles too."""

import pickle
import subprocess
import sys

import numpy as np
import pytest

import mixity

CONTACT = (9.42e-3, 2.133e6, 27e-3)


@pytest.fixture(scope="module")
def law():
    return mixity.Law("1/(1 + (lam - 1)*sin(psi)^2)", lam=(0, 1), name="c, typed", key="typed_c")


def test_arrays_are_those_of_the_published_law(law):
    T = np.linspace(0, 10, 50)
    np.testing.assert_allclose(mixity.area(law, 0.15, 2.0, T), mixity.area("c", 0.15, 2.0, T), rtol=1e-12)
    psi = np.linspace(0, 1.5, 20)
    np.testing.assert_allclose(mixity.toughness(law, 0.15, psi), mixity.toughness("c", 0.15, psi), rtol=1e-14)
    one, other = (mixity.folds(model, 0.15, 2.0)[0] for model in (law, "c"))
    assert one["T"] == pytest.approx(other["T"], rel=1e-12) and one["jumps_to"] == other["jumps_to"]
    assert mixity.regime(law, 0.15, 2.0)["regime"] == mixity.regime("c", 0.15, 2.0)["regime"]
    assert mixity.displacement(law, 0.15, 2.0, 5.0) == pytest.approx(mixity.displacement("c", 0.15, 2.0, 5.0), rel=1e-12)


def test_fits_are_those_of_the_published_law(law, data):
    fits = mixity.fit(data, [law, "c"])
    one, other = fits[law.key], fits["c"]
    assert one.status == other.status
    mine, published = one.params["lam"], other.params["lambda"]
    assert mine.value == pytest.approx(published.value, rel=1e-8)
    assert mine.stderr == pytest.approx(published.stderr, rel=1e-6)
    np.testing.assert_allclose(mine.interval, published.interval, rtol=1e-8)
    np.testing.assert_allclose(one.area(data.P[:3] * 1e-3, data.T[:3] * 1e-3), other.area(data.P[:3] * 1e-3, data.T[:3] * 1e-3), rtol=1e-8)


def test_laws_of_the_literature_are_there_by_key(data):
    assert mixity.fit(data, ["c", "linear"])["linear"].params["r"].value > 0
    np.testing.assert_allclose(mixity.toughness("power", (2.0, 1.0, 1.0), np.pi / 4), 4 / 3, rtol=1e-12)


def test_what_is_wrong_is_said_with_its_column():
    with pytest.raises(mixity.InputError, match=r"law:1:7: 'q' is not known"):
        mixity.Law("1 + p*q", p=(0, 1))
    with pytest.raises(mixity.InputError, match="f at psi = 0 is 2"):
        mixity.Law("2 + p*t^2", p=(0, 1))
    with pytest.raises(mixity.InputError, match=r"must be \(least, greatest\)"):
        mixity.Law("1 + p*t^2", p=3)
    with pytest.warns(UserWarning, match="one area stands for several T in"):
        mixity.Law("1 + (r - 1)*B^n", r=(0.5, 20, 2), n=(1, 4))


def test_another_process_has_the_law_of_a_pickle(law, data):
    fits = mixity.fit(data, law)
    plan = mixity.Plan(law, 0.01, [1e-3], radius="9.42 mm", modulus="2.133 MPa", toughness="27 mJ/m^2")
    stated = (fits[law.key].params["lam"].value, plan.simulate(1, 0).A.tolist())
    code = (
        "import pickle, sys, mixity\n"
        "law, fits, plan, stated = pickle.load(sys.stdin.buffer)\n"
        "assert (fits[law.key].params['lam'].value, plan.simulate(1, 0).A.tolist()) == stated"
    )
    subprocess.run([sys.executable, "-c", code], input=pickle.dumps((law, fits, plan, stated)), check=True)


def test_the_same_law_is_one_and_others_are_told_apart():
    assert mixity.Law("1 + z*t^2", z=(0, 1)).key == mixity.Law("1 + z*t^2", z=(0, 1)).key
    assert mixity.Law("1 + z*t^2", z=(0, 1)).key != mixity.Law("1 + z*t^2", z=(0, 0.5)).key


def test_a_law_without_a_key_has_the_same_in_every_process(law, data):
    mine = mixity.Law("1 + w*t^2", w=(0, 1))
    fits = pickle.dumps(mixity.fit(data, mine, checks=False))
    code = (
        "import pickle, sys, mixity\n"
        "mixity.Law('1 + q*t^4', q=(0, 1)), mixity.Law('1 + q*t^6', q=(0, 1))\n"
        "print(*pickle.load(sys.stdin.buffer).keys(), mixity.Law('1 + w*t^2', w=(0, 1)).key)"
    )
    told = subprocess.run([sys.executable, "-c", code], input=fits, capture_output=True, check=True).stdout.decode()
    assert told.split() == [mine.key] * 2


def test_another_law_of_one_key_is_told_from_the_first():
    mixity.Law("1 + p*t^2", p=(0, 1), key="edited")
    for edited, differs in [
        (dict(f="1 + p*t^3", p=(0, 1)), r"f = 1 \+ p\*t\^2; choose another key"),
        (dict(f="1 + p*t^2", p=(0, 2)), r"whose p is in 0\.\.1 start 0.5, not in 0\.\.2 start 1; choose another key"),
        (dict(f="1 + p*t^2", p=(0, 1), normalised=True), "not normalised; choose another key"),
    ]:
        with pytest.raises(mixity.InputError, match="there is another law 'edited': .*" + differs):
            mixity.Law(key="edited", **edited)
