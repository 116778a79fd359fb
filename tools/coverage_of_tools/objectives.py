"""What the tools minimise, written independently of them, its least value by many starts, and the exact likelihood's interval.

    vertical    ((y - f(x))/sigma_y)^2
    effective   (y - f(x))^2/(sigma_y^2 + f'(x)^2 sigma_x^2), f' at the reading
    distance    the least ((x - X)/sigma_x)^2 + ((y - Y)/sigma_y)^2 over the points (X, Y) of the curve
    graph       the same over the graph of y(x), which for a contact ends in a horizontal line behind the fold
"""

import numpy as np
from scipy.optimize import brentq, least_squares, minimize_scalar
from scipy.special import erf

LEVELS = {"68": 1.0, "95": 1.959963984540054}  # normal standard errors
COVERAGES = {level: erf(z / np.sqrt(2)) for level, z in LEVELS.items()}


def nearest(curve, theta, data, sigma_x, sigma_y):
    """Offsets of the readings from their nearest points of the curve, in standard errors. Newton's method in u with the
    Gauss-Newton matrix where the true one is not positive, halved where the distance would grow."""
    def offsets(u):
        X, Y, by_x, by_y = curve.along(theta, u)
        return (data.x - X) / sigma_x, (data.y - Y) / sigma_y, by_x / sigma_x, by_y / sigma_y

    u = curve.nearby(theta, data.x, data.y)
    p, q, dp, dq = offsets(u)
    for _ in range(12):
        step = (p * dp + q * dq) / (dp**2 + dq**2)
        new = offsets(u + step)
        for _ in range(4):
            worse = new[0] ** 2 + new[1] ** 2 > p**2 + q**2
            if not worse.any():
                break
            step = np.where(worse, step / 3, step)
            new = offsets(u + step)
        step = np.where(new[0] ** 2 + new[1] ** 2 <= p**2 + q**2, step, 0)
        u = u + step
        p, q, dp, dq = offsets(u)
        if np.all(np.abs(step) < 1e-9 * (1 + np.abs(u))):
            break
    return p, q, u


def signed_distances(curve, theta, data, sigma_x, sigma_y):
    p, q, _ = nearest(curve, theta, data, sigma_x, sigma_y)
    return np.sign(curve.equation(theta, data.x, data.y)) * np.hypot(p, q)


def distances_to_graph(curve, theta, data):
    """To the stable branch or the line behind the fold, whichever is nearer; the lower branch is none of this graph."""
    p, q, u = nearest(curve, theta, data, data.sigma_x, data.sigma_y)
    found, fold = np.hypot(p, q), curve.fold(theta)
    if np.all(np.isfinite(fold)):
        lying = np.hypot(np.maximum(fold - data.x, 0) / data.sigma_x, (data.y - curve.height(theta, fold)) / data.sigma_y)
        below = np.sqrt(theta[0]) * np.abs(u) > np.pi / 2
        found = np.where(below, lying, np.minimum(lying, found))
    return np.sign(data.y - curve.height(theta, data.x)) * found


def residuals(kind, theta, data):
    curve, sigma_x, sigma_y = data.curve, data.sigma_x, data.sigma_y
    if kind == "graph" and hasattr(curve, "fold"):
        return distances_to_graph(curve, theta, data)
    if kind in ("distance", "graph"):
        return signed_distances(curve, theta, data, sigma_x, sigma_y)
    away = data.y - curve.height(theta, data.x)
    if kind == "vertical":
        return away / sigma_y
    return away / np.hypot(sigma_y, np.nan_to_num(curve.slope(theta, data.x), posinf=1e9, neginf=-1e9) * sigma_x)


def squares(kind, theta, data):
    return float(np.sum(residuals(kind, theta, data) ** 2))


def least(function, problem, theta, held=None):
    """Least squares of a vector function within the bounds, from one start; `held`: the judged parameter's value."""
    free = [i for i in range(len(theta)) if held is None or i != problem.judged]
    theta = np.array(theta, float)
    if held is not None:
        theta[problem.judged] = held
    if not free:
        return theta, float(np.sum(function(theta) ** 2))
    low, high = problem.bounds[:, free]

    def of(x):
        theta[free] = x
        return function(theta)

    span = high - low
    done = least_squares(of, np.clip(theta[free], low + 1e-6 * span, high - 1e-6 * span), bounds=(low, high), x_scale="jac",
                         xtol=1e-12, ftol=1e-12, gtol=1e-12)
    theta[free] = done.x
    return theta.copy(), 2 * done.cost


def coarse(problem):
    """Values of the only parameter over its whole range, closer about the truth."""
    (low,), (high,) = problem.bounds
    return np.unique(np.concatenate([[low], np.geomspace(1e-4, 1, 13) * high, np.linspace(0.8, 1.3, 8) * problem.truth]))


def best(kind, problem, data):
    """Parameters and squares of the lowest minimum that a scan (one parameter) or several starts find."""
    if len(problem.theta) == 1:
        grid = coarse(problem)
        values = [squares(kind, [one], data) for one in grid]
        k = int(np.argmin(values))
        done = minimize_scalar(lambda one: squares(kind, [one], data), method="bounded", options={"xatol": 1e-10},
                               bounds=(grid[max(k - 1, 0)], grid[min(k + 1, len(grid) - 1)]))
        return min(((np.array([done.x]), float(done.fun)), (np.array([grid[k]]), values[k])), key=lambda one: one[1])
    starts = (problem.theta, problem.start, 0.5 * (problem.theta + problem.start))
    return min((least(lambda theta: residuals(kind, theta, data), problem, start) for start in starts), key=lambda one: one[1])


def likelihood(problem, data):
    """Residuals whose squares are -2 ln L with the true errors, the true values of x being free."""
    if problem.exact_x:
        def plain(theta):
            return (data.y - data.curve.height(theta, data.x)) / data.true_sigma_y
        return whitened(plain, data.memory)
    if not data.memory:
        return lambda theta: signed_distances(data.curve, theta, data, data.true_sigma_x, data.true_sigma_y)
    whiten = whitener(len(data.x), data.memory)

    def correlated(theta):
        """Gauss-Newton in all places at once."""
        _, _, u = nearest(data.curve, theta, data, data.true_sigma_x, data.true_sigma_y)
        for _ in range(6):
            X, Y, by_x, by_y = data.curve.along(theta, u)
            offsets = np.concatenate([whiten @ ((data.x - X) / data.true_sigma_x), whiten @ ((data.y - Y) / data.true_sigma_y)])
            slopes = np.vstack([whiten * (by_x / data.true_sigma_x), whiten * (by_y / data.true_sigma_y)])
            step = np.linalg.lstsq(slopes, offsets, rcond=None)[0]
            u = u + step
            if np.max(np.abs(step)) < 1e-8:
                break
        return offsets
    return correlated


def whitener(count, memory):
    """Rows that make a stationary autoregressive series independent."""
    matrix = np.eye(count)
    for i in range(1, count):
        matrix[i, i - 1 : i + 1] = np.array([-memory, 1]) / np.sqrt(1 - memory**2)
    return matrix


def whitened(function, memory):
    if not memory:
        return function

    def independent(theta):
        values = function(theta)
        return whitener(len(values), memory) @ values
    return independent


def exact_interval(problem, data):
    """Value and profile intervals of the likelihood with the true errors, ends at the bounds where they are not within."""
    function = likelihood(problem, data)
    if len(problem.theta) == 1:
        grid = coarse(problem)
        k = int(np.argmin([np.sum(function([one]) ** 2) for one in grid]))
        done = minimize_scalar(lambda one: np.sum(function([one]) ** 2), method="bounded", options={"xatol": 1e-9},
                               bounds=(grid[max(k - 1, 0)], grid[min(k + 1, len(grid) - 1)]))
        theta, smallest = np.array([done.x]), done.fun
    else:
        found = [least(function, problem, start) for start in (problem.theta, problem.start)]
        theta, smallest = min(found, key=lambda one: one[1])
    value, where = theta[problem.judged], [theta]

    def excess(one):
        nuisance, squares_there = least(function, problem, where[0], held=one)
        where[0] = nuisance
        return squares_there - smallest

    ends = {}
    for level, z in LEVELS.items():
        found = []
        for side in (0, 1):
            bound, where[0] = problem.bounds[side][problem.judged], theta
            step, inner, outer = (bound - value) * 1e-3, value, None  # grows until the end is between two values
            while outer is None:
                tried = bound if abs(step) >= abs(bound - value) else value + step
                if excess(tried) > z * z:
                    outer = tried
                elif tried == bound:
                    break
                inner, step = (inner if outer is not None else tried), step * 3
            found.append(bound if outer is None else brentq(lambda one: excess(one) - z * z, inner, outer, rtol=1e-4, xtol=1e-9))
        ends[level] = found
    return float(value), ends
