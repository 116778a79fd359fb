"""Units of other libraries are kept or refused, and frames of any kind are read."""

import numpy as np
import pytest

import mixity

SPHERE = {"radius": "9.42 mm", "modulus": "2.133 MPa", "toughness": "27 mJ/m^2"}


@pytest.fixture(scope="module")
def mergel():
    return mixity.read("data/mergel2018.csv")


@pytest.fixture(scope="module")
def truth(mergel):
    return mixity.fit(mergel, "c", checks=False)["c"].params["lambda"].value


def fitted(data):
    return mixity.fit(data, "c", checks=False)["c"].params["lambda"].value


def astropy_arrays(P, T, A):
    u = pytest.importorskip("astropy.units")
    return P * u.mN, T * u.mN, A * u.mm**2, {"radius": 9.42 * u.mm, "modulus": 2.133 * u.MPa, "toughness": 27 * u.mJ / u.m**2}


def unyt_arrays(P, T, A):
    u = pytest.importorskip("unyt")
    return P * u.mN, T * u.mN, A * u.mm**2, {"radius": 9.42 * u.mm, "modulus": 2.133 * u.MPa, "toughness": 27 * u.mJ / u.m**2}


def pint_arrays(P, T, A):
    u = pytest.importorskip("pint").UnitRegistry()
    return P * u.mN, T * u.mN, A * u.mm**2, {"radius": 9.42 * u.mm, "modulus": 2.133 * u.MPa, "toughness": 27 * u.mJ / u.m**2}


def arrays_of_quantities(P, T, A):
    u = pytest.importorskip("quantities")
    return P * 1e-3 * u.N, T * 1e-3 * u.N, A * u.mm**2, {"radius": 9.42 * u.mm, "modulus": 2.133 * u.MPa, "toughness": 0.027 * u.J / u.m**2}


@pytest.mark.parametrize("arrays", [astropy_arrays, unyt_arrays, pint_arrays, arrays_of_quantities])
def test_quantities_keep_their_units(arrays, mergel, truth):
    P, T, A, sphere = arrays(mergel.P, mergel.T, mergel.A)
    assert fitted(mixity.Dataset(P=P, T=T, A=A, **sphere)) == pytest.approx(truth, rel=1e-9)  # units round
    contact = tuple(sphere.values())
    plain = mixity.area("c", 0.01, 3e-3, 5e-3, contact=(9.42e-3, 2.133e6, 0.027))
    loads = [unit * number / mergel.P[0] for unit in (P[0],) for number in (3, 5)]  # mN
    assert float(mixity.area("c", 0.01, *loads, contact=contact)) == pytest.approx(plain, rel=1e-12)
    with pytest.raises(mixity.InputError, match="'A' must be in m.2"):
        mixity.Dataset(P=P, T=T, A=T, **sphere)
    with pytest.raises(mixity.InputError, match="has a unit of its own"):
        mixity.Dataset(P=P, T=T, A=A, units={"P": "N"}, **sphere)


def test_errors_of_uncertain_quantities_are_kept_or_refused(mergel):
    u = pytest.importorskip("quantities")
    P, T, A, sphere = arrays_of_quantities(mergel.P, mergel.T, mergel.A)
    uncertain = mixity.Dataset(P=P, T=T, A=A, **{**sphere, "radius": u.UncertainQuantity(9.42, u.mm, 0.1)})
    stated = mixity.Dataset(P=P, T=T, A=A, **{**sphere, "radius": "9.42 mm +/- 0.1 mm"})
    assert fitted(uncertain) == pytest.approx(fitted(stated), rel=1e-9) != fitted(mixity.Dataset(P=P, T=T, A=A, **sphere))
    with pytest.raises(mixity.InputError, match="'A' has standard errors"):
        mixity.Dataset(P=P, T=T, A=u.UncertainQuantity(mergel.A, u.mm**2, 0.01 * mergel.A), **sphere)


def pint_pandas(P, T, A):
    pandas = pytest.importorskip("pandas")
    pytest.importorskip("pint_pandas")
    units = {"P": "pint[mN]", "T": "pint[mN]", "A": "pint[mm^2]"}
    return pandas.DataFrame({name: pandas.Series(values, dtype=units[name]) for name, values in {"P": P, "T": T, "A": A}.items()})


def polars(P, T, A):
    return pytest.importorskip("polars").DataFrame({"P [mN]": P, "T [mN]": T, "A [mm^2]": A})


def pyarrow(P, T, A):
    return pytest.importorskip("pyarrow").table({"P [mN]": P, "T [mN]": T, "A [mm^2]": A})


def structured(P, T, A):
    return np.rec.fromarrays([P, T, A], names=["P [mN]", "T [mN]", "A [mm^2]"])


def astropy_table(P, T, A):
    table = pytest.importorskip("astropy.table").Table({"P": P, "T": T, "A": A})
    for name, unit in {"P": "mN", "T": "mN", "A": "mm2"}.items():
        table[name].unit = unit
    return table


def astropy_table_with_headings(P, T, A):
    return pytest.importorskip("astropy.table").Table({"P [mN]": P, "T [mN]": T, "A [mm^2]": A})


def astropy_qtable(P, T, A):
    return pytest.importorskip("astropy.table").QTable(astropy_table(P, T, A))


def xarray(P, T, A):
    return pytest.importorskip("xarray").Dataset(
        {"P": ("i", P, {"units": "mN"}), "T": ("i", T, {"units": "mN"}), "A": ("i", A, {"units": "mm^2"})}
    )


def test_arrays_of_pint_pandas_are_columns(mergel, truth):
    frame = pint_pandas(mergel.P, mergel.T, mergel.A)
    columns = {name: frame[name].array for name in frame}
    assert fitted(mixity.Dataset(**columns, **SPHERE)) == pytest.approx(truth, rel=1e-9)


@pytest.mark.parametrize("made", [pint_pandas, polars, pyarrow, structured, astropy_table, astropy_table_with_headings, astropy_qtable, xarray])
def test_frames_of_any_kind(made, mergel, truth):
    frame = made(mergel.P, mergel.T, mergel.A)
    assert fitted(mixity.from_frame(frame, **SPHERE)) == pytest.approx(truth, rel=1e-9)


def test_missing_values_are_left_out(mergel):
    pandas, polars, pyarrow = map(pytest.importorskip, ("pandas", "polars", "pyarrow"))
    A = [None, *mergel.A[1:]]
    columns = {"P [mN]": mergel.P, "T [mN]": mergel.T}
    for frame in (
        pandas.DataFrame({**columns, "A [mm^2]": pandas.array(A, dtype="Float64")}),
        polars.DataFrame({**columns, "A [mm^2]": A}, strict=False),
        pyarrow.table({**columns, "A [mm^2]": A}),
    ):
        data = mixity.from_frame(frame, **SPHERE)
        assert len(data) == len(mergel) - 1 and data.excluded[0][0] == 2


@pytest.mark.parametrize("made", [astropy_table, astropy_table_with_headings, astropy_qtable])
def test_masked_values_of_astropy_tables_are_left_out(made, mergel):
    from astropy.table import Table

    masked = Table(astropy_table(mergel.P, mergel.T, mergel.A) if made is astropy_qtable else made(mergel.P, mergel.T, mergel.A), masked=True)
    area = next(name for name in masked.colnames if name.startswith("A"))
    masked[area].mask[0] = True
    data = mixity.from_frame(type(made(mergel.P, mergel.T, mergel.A))(masked), **SPHERE)
    assert len(data) == len(mergel) - 1 and data.excluded[0][0] == 2


def test_matrices_of_one_column_are_columns(mergel, truth):
    columns = {"P": mergel.P[:, None], "T": mergel.T[:, None], "A": mergel.A[None, :]}
    units = {"P": "mN", "T": "mN", "A": "mm^2"}
    assert fitted(mixity.Dataset(**columns, units=units, **SPHERE)) == pytest.approx(truth, rel=1e-9)


@pytest.mark.parametrize("kind", ["datetime64[s]", "timedelta64[s]"])
def test_times_are_no_loads(kind, mergel):
    with pytest.raises(mixity.InputError, match="'P' holds no numbers: .* are times"):
        mixity.Dataset(P=mergel.P.astype(kind), T=mergel.T, A=mergel.A, **SPHERE)


def test_an_unknown_library_of_units_is_refused(mergel):
    class Tagged(np.ndarray):
        units = "furlong"

    with pytest.raises(mixity.InputError, match="Tagged with units furlong, which cannot be converted"):
        mixity.Dataset(P=mergel.P.view(Tagged), T=mergel.T, A=mergel.A, **SPHERE)


def test_laws_in_single_precision_are_refused():
    with pytest.raises(mixity.InputError, match="returned float32.*jax_enable_x64"):
        mixity.Law(lambda psi, l: (1 + (1 - l) * np.tan(psi) ** 2).astype(np.float32), l=(0, 1), key="single")
