"""A law of one's own is a model: the same numbers as the published one that it is, in every function, in pickles too."""

import pickle
import subprocess
import sys
import threading
import warnings

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
    assert mixity.regime("c", 0.15, 2.0)["regime_name"] == "jumps"
    assert mixity.displacement(law, 0.15, 2.0, 5.0) == pytest.approx(mixity.displacement("c", 0.15, 2.0, 5.0), rel=1e-12)


def assert_same_fit(one, other, stderr):
    assert one.status == other.status
    mine, published = one.params["lam"], other.params["lambda"]
    assert mine.value == pytest.approx(published.value, rel=1e-8)
    assert mine.stderr == pytest.approx(published.stderr, rel=stderr)
    np.testing.assert_allclose(mine.interval, published.interval, rtol=1e-8)


def test_fits_are_those_of_the_published_law(law, data):
    fits = mixity.fit(data, [law, "c"])
    one, other = fits[law.key], fits["c"]
    assert_same_fit(one, other, stderr=1e-6)
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
    with pytest.warns(UserWarning, match="several T have the same area in"):
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


def c_as_function(psi, lam):
    return 1 / (1 + (lam - 1) * np.sin(psi) ** 2)


@pytest.fixture(scope="module")
def function():
    with warnings.catch_warnings():  # its form cancels all digits at 90 degrees with lam = 0, which moves no contact
        warnings.simplefilter("error")
        return mixity.Law(c_as_function, lam=(0, 1), name="c, a function", key="function_c")


def test_a_function_gives_the_arrays_of_the_published_law(function):
    assert function.formula == "f = c_as_function(psi, lam)"
    for lam in (0.0023, 0.15, 0.9):
        T = np.linspace(0, mixity.folds("c", lam, 2.0)[0]["T"] * 0.996, 50)
        np.testing.assert_allclose(mixity.area(function, lam, 2.0, T), mixity.area("c", lam, 2.0, T), rtol=1e-12)
        psi = np.linspace(0, 1.5, 20)
        np.testing.assert_allclose(mixity.toughness(function, lam, psi), mixity.toughness("c", lam, psi), rtol=1e-13)
    one, other = (mixity.folds(model, 0.15, 2.0)[0] for model in (function, "c"))
    assert one["T"] == pytest.approx(other["T"], rel=1e-10) and one["jumps_to"] == other["jumps_to"]
    assert mixity.regime(function, 0.15, 2.0)["regime"] == mixity.regime("c", 0.15, 2.0)["regime"]
    np.testing.assert_allclose(mixity.curve(function, 0.15, 2.0)["A"], mixity.curve("c", 0.15, 2.0)["A"], rtol=1e-10)


def test_fits_of_a_function_are_those_of_the_published_law(function, data):
    for options in ({}, {"objective": "toughness", "checks": False}):
        fits = mixity.fit(data, [function, "c"], **options)
        assert_same_fit(fits[function.key], fits["c"], stderr=1e-7)
    assert "c_as_function(psi, lam)" in str(fits)


def test_parameters_of_a_function_go_by_their_names():
    law = mixity.Law(lambda psi, n, p: 1 + p * np.tan(psi) ** n, p=(0, 1), n=(1.9, 2), key="by_names")
    typed = mixity.Law("1 + p*t^n", p=(0, 1), n=(1.9, 2), key="by_names_typed")
    psi = np.linspace(0, 1.57, 30)
    np.testing.assert_allclose(mixity.toughness(law, (0.3, 1.97), psi), mixity.toughness(typed, (0.3, 1.97), psi), rtol=1e-12)
    assert mixity.models()["by_names"] == ["p", "n"]


def test_what_a_function_raises_is_raised():
    with pytest.raises(ZeroDivisionError):
        mixity.Law(lambda psi, p: psi / 0 + 1 // 0, p=(0, 1))
    with pytest.raises(TypeError, match="unexpected keyword argument 'q'"):
        mixity.Law(lambda psi, p: 1 + p * psi, q=(0, 1))

    def fails(psi, p):
        if allowed.is_set():
            return 1 + p * np.tan(psi) ** 2
        raise LookupError("no more")

    allowed = threading.Event()
    allowed.set()
    law = mixity.Law(fails, p=(0, 1), key="fails")
    allowed.clear()
    with pytest.raises(LookupError, match="no more"):
        mixity.toughness(law, 0.123, 0.3)
    data = mixity.Dataset(psi=np.linspace(0, 1.4, 20), Gc_over_GIc=1 + 0.3 * np.tan(np.linspace(0, 1.4, 20)) ** 2, units=None)
    with pytest.raises(LookupError, match="no more"):
        mixity.fit(data, law)
    allowed.set()
    assert mixity.fit(data, law)["fails"].params["p"].value == pytest.approx(0.3, rel=1e-9)


def test_what_a_function_returns_must_be_f_at_each_psi():
    for function, said in (
        (lambda psi, p: 1.0, r"returned shape \(\); it must return f at each"),
        (lambda psi, p: np.ones(3), r"returned shape \(3,\)"),
        (lambda psi, p: None, "returned None; it must return an array"),
        (lambda psi, p: np.ones_like(psi) + 0j, "must return an array"),
        (lambda psi, p: np.where(psi > 1, np.nan, 1.0), "f is not a positive number at psi = "),
        (lambda psi, p: 2 + p * np.tan(psi) ** 2, "^law: f at psi = 0 is 2 with p = 0, not 1"),
        (lambda psi, p: np.where(psi > 0.7, 1 + p, 1.0), "f cannot be sampled near psi = 40.11 deg"),
    ):
        with pytest.raises(mixity.InputError, match=said):
            mixity.Law(function, p=(0, 1))
    with pytest.warns(UserWarning, match="near psi = 40.11 deg .* f is known only to"):
        mixity.Law(lambda psi, p: 1 - 0.1 * p * np.maximum(0, psi - 0.7), p=(0, 1))


def test_functions_are_called_from_threads(function, data):
    # the refits of a bootstrap share threads out, while Python's own run on
    def spread(model, threads, name, replicates=40):
        fits = mixity.fit(data, model, bootstrap=replicates, threads=threads, checks=False)
        return next(iter(fits.values())).params[name].bootstrap

    assert spread(function, 4, "lam") == spread(function, 1, "lam")
    # of a hundred resamples of ten points one or two may fit by the one only
    own, published = spread(function, 4, "lam", 400), spread("c", 4, "lambda", 400)
    assert own["standard_deviation"] == pytest.approx(published["standard_deviation"], rel=0.05)
    found = []

    def work(lam):
        found.append((lam, float(mixity.area(function, lam, 2.0, 5.0)), mixity.fit(data, function, checks=False)[function.key].params["lam"].value))

    workers = [threading.Thread(target=work, args=(lam,)) for lam in (0.1, 0.2, 0.3, 0.4)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    for lam, area, value in found:
        assert area == pytest.approx(float(mixity.area("c", lam, 2.0, 5.0)), rel=1e-12)
        assert value == found[0][2]
    assert len(found) == 4


def test_a_function_pickles_where_it_is_one_of_a_module(data, tmp_path):
    (tmp_path / "own_laws.py").write_text("import numpy as np\ndef own(psi, lam):\n    return 1 / (1 + (lam - 1) * np.sin(psi) ** 2)\n")
    sys.path.insert(0, str(tmp_path))
    try:
        import own_laws

        law = mixity.Law(own_laws.own, lam=(0, 1), key="own_of_module")
        fits = mixity.fit(data, law)
        stated = fits[law.key].params["lam"].value
        code = (
            "import pickle, sys\n"
            f"sys.path.insert(0, {str(tmp_path)!r})\n"
            "law, fits, stated = pickle.load(sys.stdin.buffer)\n"
            "assert fits[law.key].params['lam'].value == stated"
        )
        subprocess.run([sys.executable, "-c", code], input=pickle.dumps((law, fits, stated)), check=True)
    finally:
        sys.path.remove(str(tmp_path))
    law = mixity.Law(lambda psi, lam: c_as_function(psi, lam), lam=(0, 1), key="of_a_lambda")
    fits = mixity.fit(data, law, checks=False)
    for one in (law, fits):
        with pytest.raises(pickle.PicklingError, match="law of_a_lambda does not pickle, as its function does not"):
            pickle.dumps(one)


def test_a_function_whose_globals_changed_is_another_law():
    code = "def f(psi, p):\n    return 1 + p*np.tan(psi)**n\nlaw = mixity.Law(f, p=(0, 0.9))"
    cell = {"np": np, "mixity": mixity, "n": 2.0}
    exec(code, cell)
    before = float(mixity.area(cell["law"], 0.5, 5.0, 12.0))
    cell["n"] = 1.5
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        exec(code, cell)
    typed = mixity.Law("1 + p*t^n", p=(0, 0.9), n=(1.4, 2), key="of_globals")
    for law, n, area in ((cell["law"], 1.5, mixity.area(cell["law"], 0.5, 5.0, 12.0)), (None, 2.0, before)):
        assert float(area) == pytest.approx(float(mixity.area(typed, (0.5, n), 5.0, 12.0)), rel=1e-12)


def test_nothing_of_a_function_is_reported_as_lost_at_the_end():
    code = "import numpy as np, mixity\nmixity.Law(lambda psi, p: 1 + p*np.tan(psi)**2, p=(0, 1))"
    told = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True, text=True)
    assert told.stderr == ""


def test_data_that_a_function_sees_are_not_reported_as_lost_at_the_end(root):
    # the function has the names of the script, and the engine has the function until the end
    code = f"""
import mixity, warnings
warnings.simplefilter("ignore")
data = mixity.read({str(root / "data/mergel2018.csv")!r})
law = mixity.Law(lambda psi, p: 1 + p * psi**2, p=(0, 1))
fits = mixity.fit(data, [law], checks=False)
"""
    told = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True, text=True)
    assert told.stderr == ""


def test_a_function_is_freed_with_the_gil_held():
    # the engine frees a law on any thread, also on one that has released the GIL, as forget_laws does
    code = """
import ctypes, threading, numpy as np, mixity
from mixity import _core, _law

class Ratio:
    def __call__(self, psi, p):
        return 1 + p * np.tan(psi) ** 2

    def __del__(self):
        print("freed on", threading.current_thread().name, "GIL held:", ctypes.pythonapi.PyGILState_Check())

mixity.Law(Ratio(), p=(0, 1), key="ratio")
_law._functions.clear()
_law._by_key.clear()
print("known to the engine alone")
other = threading.Thread(target=_core.forget_laws, name="another thread")
other.start()
other.join()
"""
    told = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True, text=True)
    assert told.stdout.splitlines() == ["known to the engine alone", "freed on another thread GIL held: 1"]


def test_the_same_function_is_one_law():
    def made(factor):
        return lambda psi, p: 1 + factor * p * np.tan(psi) ** 2

    assert mixity.Law(made(0.5), p=(0, 1)).key == mixity.Law(made(0.5), p=(0, 1)).key  # a cell that is run again
    assert mixity.Law(made(0.5), p=(0, 1)).key != mixity.Law(made(0.6), p=(0, 1)).key
    mixity.Law(made(0.5), p=(0, 1), key="halved")
    with pytest.raises(mixity.InputError, match="there is another law 'halved': .*, another function"):
        mixity.Law(made(0.6), p=(0, 1), key="halved")
