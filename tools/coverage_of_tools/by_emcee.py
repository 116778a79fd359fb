"""emcee on the exact likelihood: the true place of each point is integrated over, parameters have uniform priors within their
bounds. Where errors are not known, a common factor on them has a uniform prior in its logarithm."""

import emcee
import numpy as np

from coverage_of_tools import objectives
from coverage_of_tools.answers import Answer

WALKERS, STEPS, BURN, NODES = 8, 500, 100, 150


def log_likelihood(theta, factor, data, nodes, exact_x):
    sigma_y = factor * data.sigma_y
    if exact_x:
        return -0.5 * np.sum(((data.y - data.curve.height(theta, data.x)) / sigma_y) ** 2) - np.sum(np.log(sigma_y))
    sigma_x = factor * data.sigma_x
    X, Y, _, _ = data.curve.along(theta, nodes[:, None] * np.ones_like(data.x))
    inner = -0.5 * (((data.x - X) / sigma_x) ** 2 + ((data.y - Y) / sigma_y) ** 2)
    top = inner.max(axis=0)
    return np.sum(top + np.log(np.mean(np.exp(inner - top), axis=0)) - np.log(sigma_x * sigma_y))


def sample(problem, cell, data):
    low, high = problem.bounds
    count, sizes = len(problem.start), int(cell.errors != "known")
    nodes = None
    if not problem.exact_x:
        u = data.curve.nearby(problem.theta, data.x, data.y)
        margin = 0.25 * (u.max() - u.min())
        nodes = np.linspace(u.min() - margin, u.max() + margin, NODES)

    def log_posterior(all_of):
        theta, logs = all_of[:count], all_of[count:]
        if np.any(theta < low) or np.any(theta > high) or np.any(np.abs(logs - scatter) > 1.5):
            return -np.inf
        return log_likelihood(theta, np.exp(logs[0]) if sizes else 1.0, data, nodes, problem.exact_x)

    theta, least = objectives.best("vertical" if problem.exact_x else "distance", problem, data)
    scatter = 0.5 * np.log(max(least / len(data.x), 1e-3)) if sizes else 0
    random = np.random.RandomState(1)
    start = np.concatenate([theta, np.full(sizes, scatter)])
    walkers = start + 0.02 * np.concatenate([np.abs(problem.theta) + 0.02, np.full(sizes, 5)]) * random.standard_normal(
        (WALKERS, len(start)))
    walkers[:, :count] = low + np.abs(walkers[:, :count] - low)  # reflected, so that they differ at a bound
    walkers[:, :count] = high - np.abs(high - walkers[:, :count])
    sampler = emcee.EnsembleSampler(WALKERS, len(start), log_posterior)
    sampler.random_state = random.get_state()
    sampler.run_mcmc(walkers, STEPS)
    chain = sampler.get_chain(discard=BURN, flat=True)[:, problem.judged]
    ends = {level: tuple(np.quantile(chain, [0.5 - share / 2, 0.5 + share / 2])) for level, share in objectives.COVERAGES.items()}
    return {"emcee, exact likelihood": Answer(float(np.mean(chain)), float(np.std(chain)), ends, "", None, "")}
