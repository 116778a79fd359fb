"""The paper's fit of the Mergel data as users of SciPy and lmfit would write it, and its exact answer."""

import math
import pathlib

import lmfit
import numpy as np
from scipy import optimize

from peers.solvers import SOLVERS, Problem

DATA = pathlib.Path(__file__).resolve().parents[2] / "data/mergel2018.csv"
UPPER = {"b": 2.0, "c": 1.0}  # bounds of lambda
START = 0.15

# A user's script: the peers of a whole process. Its first part also reads the data for the fits within this one.
READ = """
import numpy as np
R, E, G = 9.42e-3, 2.133e6, 27e-3
P, T, A = np.loadtxt("DATA", delimiter=",", skiprows=1, usecols=(1, 2, 3), unpack=True)
a = np.cbrt(E*R/G)/R*np.sqrt(A*1e-6/np.pi)
P, T = P*1e-3/(R*G), T*1e-3/(R*G)
y = 4/3*a**3 - P
psi, log_f = np.arctan2(T, y), np.log((y**2 + T**2)/(8*np.pi*a**3))
""".replace("DATA", str(DATA))
MODEL = {"b": "def model(psi, lam): return -2*np.log(np.cos((1 - lam/2)*psi))",
         "c": "def model(psi, lam): return -np.log1p((lam - 1)*np.sin(psi)**2)"}
FIT = {"lmfit": """
import lmfit
result = lmfit.Model(model).fit(log_f, psi=psi, lam=lmfit.Parameter("lam", 0.15, min=0, max=UPPER))
print(result.fit_report(), result.params["lam"].value)
""", "scipy": """
from scipy.optimize import curve_fit
(lam,), covariance = curve_fit(model, psi, log_f, 0.15, bounds=(0, UPPER))
print("+/-", covariance[0, 0]**0.5, "lambda", lam)
"""}


def script(kind, model):
    """The text of a user's whole script; the last word it prints is lambda."""
    return READ + MODEL[model] + FIT[kind].replace("UPPER", str(UPPER[model]))


def measured():
    """psi and ln(Gc/GIc) of the data set."""
    names = {}
    exec(READ, names)  # pylint: disable=exec-used
    return names["psi"], names["log_f"]


def log_toughness(model, psi):
    """ln f and d ln f/d lambda as functions of (psi, lambda); what does not depend on lambda is computed once."""
    if model == "c":
        B = np.sin(psi) ** 2
        return lambda _, lam: -np.log1p((lam - 1) * B), lambda _, lam: (-B / (1 + (lam - 1) * B))[:, None]
    if model == "a":
        B = np.tan(psi) ** 2
        return lambda _, lam: np.log1p((1 - lam) * B), lambda _, lam: (-B / (1 + (1 - lam) * B))[:, None]
    return (lambda psi, lam: -2 * np.log(np.cos((1 - lam / 2) * psi)),
            lambda psi, lam: (-psi * np.tan((1 - lam / 2) * psi))[:, None])


def problem(model, psi, log_f, bounds):
    """The fit for solvers.SOLVERS."""
    f, df = log_toughness(model, psi)
    return Problem(lambda lam: f(psi, lam) - log_f, lambda lam: df(psi, lam)[:, 0], *bounds)


def reference(model, psi, log_f, offset=False):
    """lambda of the least squares, and its standard error: lowest of a scan, then the root of the derivative."""
    f, df = log_toughness(model, psi)

    def centred(v):
        return v - v.mean() if offset else v

    def error(lam):
        return centred(f(psi, lam) - log_f)

    def slope(lam):
        return centred(df(psi, lam)[:, 0])

    grid = UPPER[model] * np.geomspace(1e-9, 1 - 1e-9, 4000)
    lowest = np.argmin([np.sum(error(lam) ** 2) for lam in grid])
    lam = optimize.brentq(lambda lam: slope(lam) @ error(lam), *grid[[lowest - 1, lowest + 1]], xtol=1e-18, rtol=1e-15)
    return lam, math.sqrt(np.sum(error(lam) ** 2) / (len(psi) - 1 - offset) / np.sum(slope(lam) ** 2))


def peers(model, psi, log_f):
    """Name and function of each way to fit, which returns lambda."""
    f, df = log_toughness(model, psi)
    bounds = (0, UPPER[model])
    fit = problem(model, psi, log_f, bounds)

    def parameters(**more):
        start = lmfit.Parameters()
        start.add_many(("lam", START, True, 0, UPPER[model]), *more.items())
        return start

    def curve_fit(**more):
        return optimize.curve_fit(f, psi, log_f, START, bounds=bounds, **more)[0][0]

    def lmfit_model():
        return lmfit.Model(lambda psi, lam: f(psi, lam)).fit(log_f, parameters(), psi=psi).params["lam"].value

    def least_squares(solver):
        return lambda: SOLVERS[solver](fit, START).x

    def with_interval():
        both = lmfit.Minimizer(lambda p: f(psi, p["lam"].value) + p["offset"].value - log_f, parameters(offset=0.0))
        result = both.minimize()
        lmfit.conf_interval(both, result, p_names=["lam"], sigmas=[0.95])
        return result.params["lam"].value

    return {"scipy curve_fit, bounds": curve_fit,
            "scipy curve_fit, bounds, Jacobian": lambda: curve_fit(jac=df),
            "scipy least_squares trf": least_squares("SciPy trf numeric"),
            "scipy least_squares trf, Jacobian": least_squares("SciPy trf analytic"),
            "lmfit Model.fit": lmfit_model,
            "lmfit minimize": least_squares("lmfit numeric"),
            "lmfit minimize, Jacobian": least_squares("lmfit analytic"),
            "lmfit minimize + conf_interval, 2 variables": with_interval}
