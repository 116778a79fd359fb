"""Arguments as notebooks have them: frames with units, arrays given for results, quantities, whole numbers."""

import logging
import pickle

import numpy as np
import pytest

import mixity

CONSTANTS = dict(radius=9.42e-3, modulus=2.133e6, toughness=0.027)
CONTACT = tuple(CONSTANTS.values())
MILLI = {"P": "mN", "T": "mN", "A": "mm^2"}


@pytest.fixture
def frame(data):
    return pytest.importorskip("pandas").DataFrame({"P [mN]": data.P, "T [mN]": data.T, "A [mm^2]": data.A, "who": ["x"] * len(data)})


@pytest.mark.parametrize("columns", [None, {"P": "P [mN]", "T": "T [mN]", "A": "A [mm^2]"}])
@pytest.mark.parametrize("units", ["SI", MILLI, {"P": "mN"}])
def test_a_frame_is_read_in_the_units_of_its_headings(data, frame, columns, units):
    made = mixity.from_frame(frame, columns, units=units, **CONSTANTS)
    for one in ("P", "T", "A"):
        np.testing.assert_allclose(getattr(made, one), getattr(data, one), rtol=1e-14)
    assert made.units == {"force": "mN", "area": "mm^2"}


def test_a_frame_whose_headings_and_units_contradict_each_other_is_refused(frame):
    with pytest.raises(mixity.InputError, match=r"column 'P \[mN\]' is in mN, units says N"):
        mixity.from_frame(frame, units={"P": "N"}, **CONSTANTS)
    with pytest.raises(mixity.InputError, match=r"column 'P \[mN\]' is in mN, units says that it has none"):
        mixity.from_frame(frame, units=None)
    with pytest.raises(mixity.InputError, match="'x' of column 'A' is no unit"):
        mixity.from_frame({"P [N]": [1.0], "T [N]": [1.0], "Area [x]": [1.0]}, {"P": "P [N]", "T": "T [N]", "A": "Area [x]"}, **CONSTANTS)


def test_a_column_without_a_unit_beside_columns_that_have_one_is_refused(data):
    # in SI its values would be a thousand times too large, and lambda a million times too small
    u = pytest.importorskip("astropy.units")
    sentence = r"column 'T' has no unit, 'P' has one: state it in units=\{\"T\": \"N\"\}"
    for made in (
        lambda **units: mixity.Dataset(P=data.P * u.mN, T=data.T, A=data.A * u.mm**2, **units, **CONSTANTS),
        lambda **units: mixity.from_frame({"P [mN]": data.P, "T": data.T, "A [mm^2]": data.A}, **units, **CONSTANTS),
    ):
        with pytest.raises(mixity.InputError, match=sentence):
            made()
        np.testing.assert_allclose(made(units={"T": "mN"}).T * (1 if made(units={"T": "mN"}).units["force"] == "mN" else 1e3), data.T, rtol=1e-12)
    with pytest.raises(mixity.InputError, match=sentence):
        mixity.Dataset(P=data.P, T=data.T, A=data.A, units={"P": "mN", "A": "mm^2"}, **CONSTANTS)


def test_headings_of_a_frame_are_those_of_a_file(data):
    own = {"Normal force (mN)": data.P, "Friction force [mN]": data.T, "Contact area / mm^2": data.A}
    np.testing.assert_allclose(mixity.from_frame(own, **CONSTANTS).A, data.A, rtol=1e-14)
    # without a unit: SI
    plain = mixity.from_frame({"P": data.P * 1e-3, "T": data.T * 1e-3, "A": data.A * 1e-6}, **CONSTANTS)
    np.testing.assert_allclose(plain.A, data.A * 1e-6, rtol=1e-14)
    with pytest.raises(mixity.InputError, match=r'none of its columns is known; there are x, 7. Say which is which: columns=\{"P"'):
        mixity.from_frame({"x": [1.0], 7: [2.0]})


def test_a_misspelt_keyword_is_refused_with_the_one_that_was_meant(data, frame):
    columns = dict(P=data.P, T=data.T, A=data.A)
    with pytest.raises(mixity.InputError, match=r"'simga_T' is no column, .*: did you mean sigma_T\?$"):
        mixity.Dataset(**columns, simga_T=data.T, **CONSTANTS)
    with pytest.raises(mixity.InputError, match=r'unknown key "raduis": did you mean radius\?'):
        mixity.Dataset(**columns, raduis="9.42 mm")
    with pytest.raises(mixity.InputError, match=r'unknown key "sigmaT": did you mean sigma_T\?'):
        mixity.Dataset(**columns, sigmaT="0.2 mN", **CONSTANTS)
    with pytest.raises(mixity.InputError, match=r"units: 'sigma_t' is no column; there are .*: did you mean sigma_T\?$"):
        mixity.Dataset(**columns, sigma_T=data.T, units={"sigma_t": "mN"}, **CONSTANTS)
    with pytest.raises(mixity.InputError, match=r"has no column 'A \[mm2\]'; there are .*: did you mean A \[mm\^2\]\?$"):
        mixity.from_frame(frame, {"P": "P [mN]", "T": "T [mN]", "A": "A [mm2]"}, **CONSTANTS)
    with pytest.raises(ValueError, match=r"there is no option 'modles': did you mean models\?"):
        mixity.fit(data, modles="c")


def test_arrays_without_units_beside_constants_are_refused_with_the_argument():
    with pytest.raises(mixity.InputError, match=r'say the units, such as units=\{"P": "mN", "T": "mN", "A": "mm\^2"\}'):
        mixity.Dataset(P=[1, 1], T=[0, 1], A=[8, 7], units=None, **CONSTANTS)
    with pytest.raises(mixity.InputError, match="but the data state load"):
        mixity.Dataset(T=[0, 1], A=[8, 7], units=None, load="1 mN")


def test_a_frame_has_its_runs_by_any_name_of_them(data):
    runs = ["dry" if load < 4 else "wet" for load in data.P]
    frame = {"P [mN]": data.P, "T [mN]": data.T, "A [mm^2]": data.A, "run": runs}
    assert set(mixity.from_frame(frame, **CONSTANTS).runs) == set(runs)


def test_what_is_missing_is_called_as_the_argument(data):
    with pytest.raises(mixity.InputError) as error:
        mixity.Dataset(P=[1.0], T=[1.0], A=[1.0], modulus=2e6, toughness=0.03)
    assert str(error.value) == "data: the constant radius is missing: state it: radius=..."
    with pytest.raises(mixity.InputError, match=r"state them: radius=..., modulus=..., toughness=...$"):
        mixity.Dataset(P=[1.0], T=[1.0], A=[1.0])
    with pytest.raises(mixity.InputError, match="'A' or 'a' is missing; not understood: 'size'. Say which is which: columns="):
        mixity.from_frame({"P [mN]": [1.0], "T [mN]": [1.0], "size": [1.0]}, **CONSTANTS)


@pytest.mark.parametrize("contact", [None, CONTACT])
def test_results_may_go_where_arguments_are(contact):
    rise = np.linspace(0, 20, 37) * (1 if contact is None else 1e-3)
    load = 2.0 if contact is None else 2e-3
    area = mixity.area("c", 0.01, load, rise, contact=contact)
    for call, values in [
        (lambda T, out: mixity.area("c", 0.01, load, T, contact=contact, out=out), rise),
        (lambda T, out: mixity.area("b", 0.5, T, T, contact=contact, out=out), rise),
        (lambda T, out: mixity.displacement("c", 0.01, load, T, contact=contact, out=out), rise),
        (lambda psi, out: mixity.toughness("c", 0.01, psi, out=out), np.linspace(0, 1.7, 37)),
        (lambda A, out: mixity.tangential_load("c", 0.01, load, A, contact=contact, out=out), np.linspace(0.5, 1.1, 37) * area[0]),
    ]:
        apart = call(values, np.empty(37))
        np.testing.assert_array_equal(apart, call(values, None))
        same = values.copy()
        assert call(same, same) is same
        np.testing.assert_array_equal(same, apart)
        for begin in (0, 1, 2):  # overlapping from either side
            memory = np.zeros(40)
            given = memory[1:38]
            given[:] = values
            np.testing.assert_array_equal(call(given, memory[begin : begin + 37]), apart)


def test_pairs_of_results_may_go_where_arguments_are():
    T = np.linspace(0, 15, 20)
    A = mixity.area("c", 0.15, 2.0, T)
    psi, f = mixity.phase_angle(2.0, T, A)
    memory = np.concatenate([T, np.zeros(3)])
    other = np.empty(20)
    got = mixity.phase_angle(2.0, memory[:20], A, out=(memory[3:], other))
    assert got[1] is other
    np.testing.assert_array_equal(got, (psi, f))
    with pytest.raises(ValueError, match="overlap"):
        mixity.phase_angle(2.0, T, A, out=(other, other))
    with pytest.raises(TypeError, match="pair of arrays"):
        mixity.phase_angle(2.0, T, A, out=other)


def test_what_results_cannot_go_into_is_refused():
    T = np.linspace(0, 10, 5)
    fixed = np.empty(5)
    fixed.flags.writeable = False
    for out, error, sentence in [
        (fixed, ValueError, "out is read-only"),
        ([0.0] * 5, TypeError, "must be a NumPy array of float64 .* not a list"),
        (np.empty(4), ValueError, "must be a contiguous array"),
        (np.empty(5, np.float32), ValueError, "not of float32"),
    ]:
        with pytest.raises(error, match=sentence):
            mixity.area("c", 0.2, 2.0, T, out=out)
    u, status = mixity.displacement("c", 0.2, 2.0, [1.0, 100.0], return_status=True)
    assert [mixity.STATUS[one] for one in status] == ["ok", "no_equilibrium"] and np.isnan(u).tolist() == [False, True]


def test_an_unknown_model_is_told_all_that_there_are():
    with pytest.raises(mixity.InputError, match="no model 'x'; there are a, b, c, .*hutchinson_suo"):
        mixity.area("x", 0.2, 2.0, 1.0)


def test_quantities_of_pint_are_taken_everywhere(data):
    Q = pytest.importorskip("pint").UnitRegistry().Quantity
    contact = (Q(9.42, "mm"), Q(2.133, "MPa"), Q(27, "mJ/m^2"))
    assert mixity.area("c", 0.01, 2e-3, 1e-3, contact=contact) == pytest.approx(
        mixity.area("c", 0.01, 2e-3, 1e-3, contact=CONTACT), rel=1e-13
    )
    si = dict(P=data.P * 1e-3, T=data.T * 1e-3, A=data.A * 1e-6, radius=9.42e-3, toughness=0.027)
    stated, uncertain = (
        mixity.fit(mixity.Dataset(**si, modulus=modulus), "c")["c"].params["lambda"].stderr
        for modulus in ("2.133e6 +/- 0.1e6 Pa", Q(2.133, "MPa").plus_minus(0.1))
    )
    assert uncertain == pytest.approx(stated, rel=1e-9)
    errors = [mixity.fit(data, "c", sigma_T=one)["c"].params["lambda"].stderr for one in ("0.2 mN", 0.2e-3, Q(0.2, "mN"))]
    assert errors[1:] == pytest.approx([errors[0]] * 2, rel=1e-12)
    with pytest.raises(mixity.InputError, match="sigma_T is None|sigma_T is \\[\\]; it must be a text"):
        mixity.fit(data, "c", sigma_T=[])


def test_plans_take_loads_and_errors_in_every_form():
    Q = pytest.importorskip("pint").UnitRegistry().Quantity
    plans = [
        mixity.Plan("c", 0.01, loads, sigma_T=error, **CONSTANTS)
        for loads, error in [([1e-3, 4e-3], 1e-4), ("1,4 mN", "0.1 mN"), (["1 mN", "0.004 N"], Q(0.1, "mN")), (Q([1, 4], "mN"), 1e-4)]
    ]
    for plan in plans:
        assert plan.loads == pytest.approx([1e-3, 4e-3], rel=1e-13)
        assert plan.expect("")["standard_error"] == pytest.approx(plans[0].expect("")["standard_error"], rel=1e-9)
    assert len(plans[0].next_loads("0.5 mN", Q(1, "mN"), 2, "")) == 2
    for loads, sentence in [("1,4", "loads with a unit"), ("much", "it must be loads with a unit"), ("1 mm", "loads with a unit")]:
        with pytest.raises(mixity.InputError, match=sentence):
            plans[0].with_loads(loads)


def test_whole_numbers_are_asked_for_in_sentences():
    plan = mixity.Plan("c", 0.01, [1e-3], **CONSTANTS)
    for call in (lambda: plan.simulate(seed=-1), lambda: plan.simulate(1, 0.5), lambda: plan.experiments(2, seed="x")):
        with pytest.raises(mixity.InputError, match="must be a whole number, 0 or more"):
            call()
    with pytest.raises(mixity.InputError, match="key is .*no parameter can be called key"):
        mixity.Law("1 + key*B", key=(0, 1))


def test_models_of_lmfit_pickle():
    pytest.importorskip("lmfit")
    model = mixity.lmfit.model("c", contact=CONTACT)
    model.set_param_hint("lambda_", value=0.02, max=0.5)
    again = pickle.loads(pickle.dumps(model))
    loads = dict(P=2e-3, T=np.linspace(0, 10e-3, 9))
    np.testing.assert_array_equal(again.eval(lambda_=0.01, **loads), model.eval(lambda_=0.01, **loads))
    assert again.make_params() == model.make_params()


def test_fits_are_told_to_the_log(data, caplog):
    with caplog.at_level(logging.DEBUG, logger="mixity"):
        mixity.fit(data, "c", checks=False)
        mixity.from_frame({"P": data.P, "T": data.T, "A": data.A * 0 + 8.0}, units=None, load="1 mN")
    told = [(record.levelname, record.getMessage()) for record in caplog.records]
    assert any(level == "INFO" and message.startswith("fit of data: c ok; ") and message.endswith(" s") for level, message in told)
    assert ("DEBUG", "options: models=c, checks=false") in told
    assert any(level == "WARNING" and "the load that is stated is not used" in message for level, message in told)
    handlers = logging.getLogger("mixity").handlers
    assert [type(one) for one in handlers if not isinstance(one, type(caplog.handler))] == [logging.NullHandler]
