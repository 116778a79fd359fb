"""The numbers that fits/ states for measured data, from fits that share nothing with the program: SciPy's least squares in
the plane of the two energies, and dense walks along a law. tests/analysis/published_test.cc holds the program to them."""

import csv
import tomllib
import warnings

import numpy as np
import pytest
from scipy.optimize import least_squares, minimize

import mixity

TIGHT = dict(jac="cs", xtol=1e-15, ftol=1e-15, gtol=1e-15)  # complex steps: slopes to rounding


def published(root, name, model):
    return tomllib.loads((root / f"fits/{name}.toml").read_text())["published"][model]


def expect(numbers, found):
    assert set(numbers) <= set(found)
    for name, number in numbers.items():
        assert abs(found[name] - number["value"]) <= number["tolerance"], name


def energies(root, name):
    """Columns without their units; `curve` as numbers."""
    with open(root / f"data/{name}.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    columns = {heading.split(" ")[0]: [row[heading] for row in rows] for heading in rows[0]}
    return {key: np.array(columns[key], float) for key in ("curve", "G_I", "sigma_GI", "G_II", "sigma_GII") if key in columns}


def line(of, series):
    """Model c, G_I = G_Ic - lambda G_II, with a G_Ic of each series: distances of the points in standard errors."""

    def residuals(x):
        excess = of["G_I"] + x[0] * of["G_II"] - x[1:][series]
        return excess / np.sqrt(of["sigma_GI"] ** 2 + (x[0] * of["sigma_GII"]) ** 2)

    count = series.max() + 1
    fits = [least_squares(residuals, [start] + [0.3] * count, **TIGHT) for start in (0.05, 0.3, 0.8)]
    best = min(fits, key=lambda fit: fit.cost)
    return best.x[0], best.x[1:], 2 * best.cost


def test_snow_by_hand_has_one_coupling_and_three_toughnesses(root):
    of = energies(root, "snow_weak_layers_manual")
    coupling, toughness, chi2 = line(of, of["curve"].astype(int) - 1)
    found = {"lambda": coupling, "chi2": chi2} | {f"toughness({i + 1})": one for i, one in enumerate(toughness)}
    expect(published(root, "snow_weak_layers_manual", "c"), found)
    # as they were stated beforehand
    assert round(coupling, 4) == 0.3660
    assert round(chi2, 2) == 280.44


def test_each_series_of_snow_by_hand_has_its_coupling(root):
    of = energies(root, "snow_weak_layers_manual")
    ours = mixity.fit(mixity.read(root / "data/snow_weak_layers_manual.csv"), "c", free=["toughness"], per="curve").to_dict()
    alone = {one["curve"]: one["parameters"]["lambda"] for one in ours["datasets"][0]["per_curve"][0]["curves"]}
    total = 0
    for series, expected in ((1, 0.5131), (2, 0.4008), (3, 0.2318)):
        part = {key: column[of["curve"] == series] for key, column in of.items()}
        coupling, toughness, chi2 = line(part, np.zeros(len(part["G_I"]), int))
        total += chi2
        assert round(coupling, 4) == expected
        # both stop where a step no longer changes chi^2, which is flat: half of the digits
        assert alone[str(series)]["value"] == pytest.approx(coupling, rel=1e-7)
    chi2 = published(root, "snow_weak_layers_manual", "c")["chi2"]["value"]
    F = (chi2 - total) / 2 / (total / (len(of["G_I"]) - 6))
    assert round(F, 2) == 2.25


def bk_chi2(of, r, eta, G_Ic):
    """Squared distances from a polygon of 4,000 sides along the law bk."""
    B = np.sin(np.linspace(0, np.pi / 2, 4001)) ** 2
    Gc = G_Ic * (1 + (r - 1) * B**eta)
    I = (Gc * (1 - B))[:, None] / of["sigma_GI"] - of["G_I"] / of["sigma_GI"]
    II = (Gc * B)[:, None] / of["sigma_GII"] - of["G_II"] / of["sigma_GII"]
    step_I, step_II = np.diff(I, axis=0), np.diff(II, axis=0)
    along = np.clip(-(I[:-1] * step_I + II[:-1] * step_II) / (step_I**2 + step_II**2), 0, 1)
    return ((I[:-1] + along * step_I) ** 2 + (II[:-1] + along * step_II) ** 2).min(axis=0).sum()


def test_an_interval_ends_where_chi2_has_risen_although_another_minimum_over_the_others_is_higher(root):
    """bk of the first series by hand: from r = 6 on, steps outwards may end at eta = 0.06, where chi^2 is larger."""
    of = energies(root, "snow_weak_layers_manual")
    of = {key: column[of["curve"] == 1] for key, column in of.items()}
    errors = {key: of[key] for key in ("sigma_GI", "sigma_GII")}
    fit = mixity.fit(mixity.Dataset(G_I=of["G_I"], G_II=of["G_II"], **errors), "bk", free=["toughness"], checks=False)["bk"]

    def lowest(r, start):
        function = lambda x: bk_chi2(of, r, *np.exp(x))
        return minimize(function, np.log(start), method="Nelder-Mead", options={"xatol": 1e-6, "fatol": 1e-7}).fun

    r, eta, toughness = (fit.params[name].value for name in ("r", "eta", "toughness"))
    least = bk_chi2(of, r, eta, toughness)
    low, high = fit.params["r"].interval
    assert lowest(low, [0.7, 0.49]) - least == pytest.approx(3.8415, abs=1e-3)
    assert lowest(high, [10, 0.51]) - least == pytest.approx(3.8415, abs=1e-3)


def test_snow_by_video_has_one_line_for_all_series(root):
    of = energies(root, "snow_weak_layers_video")
    coupling, toughness, chi2 = line(of, np.zeros(len(of["G_I"]), int))
    found = {"r": 1 / coupling, "toughness": toughness[0], "chi2": chi2}
    expect(published(root, "snow_weak_layers_video", "linear"), found)
    assert (round(found["toughness"], 5), round(found["r"], 3), round(chi2, 1)) == (0.30295, 6.188, 3200.6)


def power_chi2(of, G_Ic, r, m, n):
    """Squared distances from (G_I/G_Ic)^m + (G_II/(r G_Ic))^n = 1, by a walk along it, dense towards both axes, and a
    finer one about its nearest point."""
    walk = np.unique(np.concatenate([[0, 1], np.geomspace(1e-14, 0.5, 2000), 1 - np.geomspace(1e-14, 0.5, 2000)]))
    chi2 = 0
    for G_I, G_II, sigma_I, sigma_II in zip(of["G_I"], of["G_II"], of["sigma_GI"], of["sigma_GII"]):

        def squares(t):
            return ((G_Ic * (1 - t) ** (1 / m) - G_I) / sigma_I) ** 2 + ((r * G_Ic * t ** (1 / n) - G_II) / sigma_II) ** 2

        t = walk
        for _ in range(3):
            k = np.argmin(squares(t))
            t = np.linspace(t[max(k - 1, 0)], t[min(k + 1, len(t) - 1)], 101)
        chi2 += squares(t).min()
    return chi2


def test_the_power_law_of_snow_by_video_is_at_two_bounds(root):
    of = energies(root, "snow_weak_layers_video")
    numbers = published(root, "snow_weak_layers_video", "power")
    r, n = numbers["r"]["value"], numbers["n"]["value"]

    def best(r, n, **options):
        found = minimize(lambda x: power_chi2(of, x[0], r, x[1], n), [0.47, 0.26], method="Nelder-Mead", options=options)
        return found.x, found.fun

    (toughness, m), chi2 = best(r, n, xatol=1e-8, fatol=1e-7)
    expect(numbers, {"r": r, "n": n, "toughness": toughness, "m": m, "chi2": chi2})
    assert best(0.95 * r, n, xatol=1e-3)[1] > chi2
    assert best(r, 1.02 * n, xatol=1e-3)[1] > chi2


LAWS = {
    "quadratic": (["r"], lambda B, r: 1 / np.sqrt((1 - B) ** 2 + (B / r) ** 2)),
    "bk": (["r", "eta"], lambda B, r, eta: 1 + (r - 1) * np.where(B > 0, np.exp(eta * np.log(B + (B == 0))), 0)),
    "c": (["lambda"], lambda B, coupling: 1 / (1 + (coupling - 1) * B)),
}


@pytest.mark.parametrize("model", LAWS)
def test_delamination_of_im7_8552(root, model):
    with open(root / "data/im7_8552_mmb.csv", newline="") as file:
        rows = np.array([row[1:] for row in list(csv.reader(file))[1:]], float)
    B, Gc, sigma = rows.T
    names, law = LAWS[model]
    fit = least_squares(
        lambda x: np.log(x[0] * law(B, *x[1:]) / Gc) / (sigma / Gc), [0.32] + [0.8] * len(names), **TIGHT
    )
    expect(published(root, "im7_8552_mmb", model), {"toughness": 1e3 * fit.x[0], "chi2": 2 * fit.cost, **dict(zip(names, fit.x[1:]))})


def test_pearsons_line_by_two_programs(root):
    numbers = published(root, "pearson_york", "c")
    of = energies(root, "pearson_york")
    coupling, toughness, chi2 = line(of, np.zeros(10, int))
    expect(numbers, {"lambda": coupling, "toughness": toughness[0], "chi2": chi2})
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)  # SciPy 1.19 removes it
        odr = pytest.importorskip("scipy.odr")
        data = odr.RealData(of["G_II"], of["G_I"], of["sigma_GII"], of["sigma_GI"])
        model = odr.Model(
            lambda b, x: b[0] + b[1] * x,
            fjacb=lambda b, x: np.stack([np.ones_like(x), x]),
            fjacd=lambda b, x: np.full_like(x, b[1]),
        )
        job = odr.ODR(data, model, beta0=[5, -0.5], partol=1e-15, sstol=1e-15, maxit=500)
        job.set_job(deriv=3)
        found = job.run()
    # ODRPACK stops at half of the digits of what it minimises
    assert found.beta == pytest.approx([numbers["toughness"]["value"], -numbers["lambda"]["value"]], rel=1e-7)
