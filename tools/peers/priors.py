"""A fit with five uncertain constants: mixity's library beside lmfit (value and Wald error), iminuit (MINOS) and emcee, on
the same points with the same normal priors. Model c.

The peers minimise, or sample, what mixity does by another road: the equilibrium curve of model c at a load is
y = 3 pi + R cos(phi), sqrt(lambda) T = R sin(phi) with R^2 = 9 pi^2 + 6 pi P and A = pi (3/4 (y + P))^(2/3), and the nearest
point of it is found by Gauss-Newton steps in phi.
"""

import emcee
import iminuit
import lmfit
import numpy as np

from peers import curve_fits
from peers.markdown import show_time
from peers.timing import alternate

# as tests/benchmarks/curve/fits.cc states them: logarithms of factors, and offsets in units of R G_Ic
ERRORS = {"toughness": 0.10, "modulus": 0.05, "area_scale": 0.01, "load_offset": 0.5, "shear_offset": 0.5}
HEADER = ["what", "time", "ratio", "lambda", "+/-", "95 % low", "95 % high"]
POINTS = 200


def residuals(lam, constants, points):
    """Signed distances in standard errors of the points, and the constants in those of their priors."""
    P, T, A, sigma_T, sigma_A = points.T
    toughness, modulus, area_scale, load_offset, shear_offset = constants
    force = np.exp(-toughness)
    area = np.exp(2 / 3 * (modulus - toughness) + area_scale)
    load, shear, size = (P + load_offset) * force, (T + shear_offset) * force, A * area
    sigma_T, sigma_A = sigma_T * force, sigma_A * area
    radius, stretch = np.sqrt(9 * np.pi**2 + 6 * np.pi * load), np.sqrt(lam)
    phi = np.arctan2(stretch * shear, 4 / 3 * (size / np.pi) ** 1.5 - load - 3 * np.pi)
    for _ in range(8):
        y = 3 * np.pi + radius * np.cos(phi)
        root = np.cbrt(3 / 4 * (y + load))
        u = (radius * np.sin(phi) / stretch - shear) / sigma_T
        v = (np.pi * root**2 - size) / sigma_A
        du = radius * np.cos(phi) / stretch / sigma_T
        dv = -np.pi / 2 / root * radius * np.sin(phi) / sigma_A
        phi = phi - (u * du + v * dv) / (du**2 + dv**2)
    return np.append(np.copysign(np.hypot(u, v), v), np.asarray(constants) / list(ERRORS.values()))


def by_lmfit(points, interval=False):
    parameters = lmfit.Parameters()
    parameters.add("lam", 0.15, min=1e-9, max=1)
    for name in ERRORS:
        parameters.add(name, 0.0)
    def function(values):
        found = values.valuesdict()
        return residuals(found["lam"], [found[name] for name in ERRORS], points)
    task = lmfit.Minimizer(function, parameters, scale_covar=False)
    result = task.minimize()
    found = result.params["lam"]
    ends = (None, None)
    if interval:
        rows = lmfit.conf_interval(task, result, p_names=["lam"], sigmas=[0.95])["lam"]
        ends = rows[0][1], rows[-1][1]
    return found.value, found.stderr, *ends


def minimised(points):
    def chi2(values):
        r = residuals(values[0], values[1:], points)
        return r @ r
    task = iminuit.Minuit(chi2, np.array([0.15, 0, 0, 0, 0, 0]), name=["lam", *ERRORS])
    task.errordef = iminuit.Minuit.LEAST_SQUARES
    task.limits["lam"] = (1e-9, 1)
    task.strategy, task.tol = 2, 1e-4
    task.migrad()
    return task


def by_minos(points):
    task = minimised(points)
    task.hesse()
    task.minos("lam", cl=0.95)
    low, high = task.merrors["lam"].lower, task.merrors["lam"].upper
    return task.values["lam"], task.errors["lam"], task.values["lam"] + low, task.values["lam"] + high


def by_emcee(points, steps=4000, walkers=32):
    """Mean, standard deviation and credible interval of the posterior, and what the chain leaves open of the mean."""
    def log_posterior(values):
        if not 0 < values[0] < 1:
            return -np.inf
        with np.errstate(all="ignore"):  # a proposal may be absurd
            r = residuals(values[0], values[1:], points)
        return -0.5 * (r @ r) if np.all(np.isfinite(r)) else -np.inf
    task = minimised(points)
    random = np.random.default_rng(1)
    start = random.multivariate_normal(np.array(task.values), np.array(task.covariance), walkers)
    np.random.seed(1)  # emcee's moves
    sampler = emcee.EnsembleSampler(walkers, start.shape[1], log_posterior)
    sampler.run_mcmc(np.clip(start, [1e-6] + [-np.inf] * 5, [1 - 1e-6] + [np.inf] * 5), steps)
    correlation = sampler.get_autocorr_time(quiet=True)[0]
    chain = sampler.get_chain(discard=steps // 5, flat=True)[:, 0]
    effective = chain.size / correlation
    return chain.mean(), chain.std(), *np.quantile(chain, [0.025, 0.975]), chain.std() / np.sqrt(effective)


def rows(options):
    """What is printed: mixity's first, then the others beside it."""
    program = options.benchmarks / "curve_fits"
    with curve_fits.served(program, "c", POINTS, False, False, "priors") as (process, fit, points):
        tasks = {"mixity, whole fit": lambda: curve_fits.own_time(process, options.clock, "whole"),
                 "mixity, bare": lambda: curve_fits.own_time(process, options.clock, "bare"),
                 "lmfit, least squares with the priors as residuals": lambda: by_lmfit(points),
                 "lmfit, with conf_interval of lambda (by F)": lambda: by_lmfit(points, True),
                 "iminuit, MIGRAD, HESSE and MINOS of lambda": lambda: by_minos(points)}
        times, answers = alternate(tasks, 5, options.clock)
        ours = (fit["values"][0], fit["errors"][0], fit["lows"][0], fit["highs"][0])
        answers |= {name: ours for name in list(tasks)[:2]}
        first = float(np.median(times["mixity, whole fit"]))
        for name in tasks:
            taken = float(np.median(times[name]))
            yield [name, show_time(taken), f"{taken / first:.3g}", *shown(answers[name])]
        yield ["mixity, posterior by quadrature and Laplace", "", "", *shown(fit["posterior"])]
        *answer, open_ = by_emcee(points)
        yield [f"emcee (mean known to {open_:.2g})", "", "", *shown(answer)]


def shown(answer):
    return ["" if one is None else f"{one:.6g}" for one in answer]
