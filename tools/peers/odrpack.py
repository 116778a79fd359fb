"""ODRPACK on the points of a fit under the objective curve: SciPy's implicit model, the printed equation with tan and
the angle replaced by T and y."""

import numpy as np
from scipy import odr


def excess(model, parameters, P, T, A):
    """(y^2 + T^2)/f - 8 pi a^3, which vanishes in equilibrium."""
    a = np.sqrt(A / np.pi)
    y, hertz = 4 / 3 * a**3 - P, 8 * np.pi * a**3
    if model == "a":
        return (y**2 + T**2) * y**2 / (y**2 + (1 - parameters[0]) * T**2) - hertz
    if model == "c":
        return y**2 + parameters[0] * T**2 - hertz
    if model == "b":
        return (y**2 + T**2) * np.cos((1 - parameters[0] / 2) * np.arctan2(T, y)) ** 2 - hertz
    r, eta = parameters
    return (y**2 + T**2) / (1 + (r - 1) * (T**2 / (y**2 + T**2)) ** eta) - hertz


def slopes(model, parameters, P, T, A):
    """Derivatives of the excess of model a, b or c in lambda, T, A and P, as a careful user would give them."""
    a = np.sqrt(A / np.pi)
    y, square, lam = 4 / 3 * a**3 - P, (4 / 3 * a**3 - P) ** 2 + T**2, parameters[0]
    if model == "a":
        d = y**2 + (1 - lam) * T**2
        by_lambda, by_T = square * (y * T / d) ** 2, 2 * lam * T * (y * y / d) ** 2
        by_y = 2 * y * ((y**2 + square) / d - square * (y / d) ** 2)
    elif model == "b":
        k, psi = 1 - lam / 2, np.arctan2(T, y)
        cosine, sine = np.cos(k * psi) ** 2, np.sin(2 * k * psi)
        by_lambda, by_T, by_y = square * psi * sine / 2, 2 * T * cosine - k * y * sine, 2 * y * cosine + k * T * sine
    else:
        by_lambda, by_T, by_y = T**2, 2 * lam * T, 2 * y
    return by_lambda, by_T, (by_y - 6 * np.pi) * 2 * a / np.pi, -by_y


def implicit_model(model, P, count, analytic):
    """As ODRPACK takes it. Behind the `count` parameters of the model: the factors on toughness and modulus."""
    def scaled(beta, x):
        factors = (beta[count], beta[count + 1]) if len(beta) > count else (1.0, 1.0)
        force, area = 1 / factors[0], (factors[1] / factors[0]) ** (2 / 3)
        return P * force, x[0] * force, x[1] * area, force, area, factors

    def function(beta, x):
        return excess(model, beta[:count], *scaled(beta, x)[:3])

    def by_parameters(beta, x):
        P_, T, A, _, _, factors = scaled(beta, x)
        by_lambda, by_T, by_A, by_P = slopes(model, beta, P_, T, A)
        if len(beta) == count:
            return by_lambda[None, :]
        by_force, by_area = -(by_P * P_ + by_T * T), 2 / 3 * by_A * A
        return np.array([by_lambda, (by_force - by_area) / factors[0], by_area / factors[1]])

    def by_data(beta, x):
        P_, T, A, force, area, _ = scaled(beta, x)
        _, by_T, by_A, _ = slopes(model, beta, P_, T, A)
        return np.array([by_T * force, by_A * area])

    derivatives = {"fjacb": by_parameters, "fjacd": by_data} if analytic else {}
    return odr.Model(function, implicit=1, **derivatives)


def fit(model, points, starts, analytic=False, **options):
    """ODRPACK's output. Rows of `points`: P, T, A and the errors of T and A."""
    P, T, A, sigma_T, sigma_A = points.T
    data = odr.RealData(np.array([T, A]), 1, sx=np.array([sigma_T, sigma_A]))
    law = implicit_model(model, P, 2 if model == "bk" else 1, analytic)
    task = odr.ODR(data, law, beta0=starts, **{"maxit": 500} | options)
    if analytic:
        task.set_job(deriv=3)
    return task.run()
