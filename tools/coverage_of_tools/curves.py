"""The curves that are fitted: as y(x), as an equation in x and y, and by a parameter u along them. NumPy alone.

Contacts are dimensionless as in the paper. Model c is the circle (y - 3 pi w)^2 + lambda T^2 = S^2 with
S^2 = 9 pi^2 w^2 + 6 pi w P, where y = 4/3 e a^3 - P is the edge load, w and e the factors on toughness and modulus.
"""

import numpy as np


class Line:
    """Energies of the two modes: G_I = G_Ic - s G_II, s = G_Ic/G_IIc."""

    def height(self, theta, x):
        return theta[0] - theta[1] * x

    def slope(self, theta, x):
        return np.full_like(x, -theta[1])

    def equation(self, theta, x, y):
        return y - theta[0] + theta[1] * x

    def along(self, theta, u):
        return u, theta[0] - theta[1] * u, np.ones_like(u), np.full_like(u, -theta[1])

    def nearby(self, theta, x, y):
        return x


class Contact:
    """Area of model c against shear at loads P. theta: lambda, and, where constants are free, ln w and ln e."""

    def __init__(self, P):
        self.P = P

    def _scales(self, theta):
        w, e = (np.exp(theta[1]), np.exp(theta[2])) if len(theta) > 1 else (1.0, 1.0)
        return max(theta[0], 0.0), 3 * np.pi * w, np.sqrt(9 * np.pi**2 * w * w + 6 * np.pi * w * self.P), e

    def height(self, theta, T):
        """On the stable branch; beyond the fold its last area, as a script goes on that must return a number."""
        lam, centre, radius, e = self._scales(theta)
        y = centre + np.sqrt(np.maximum(radius**2 - lam * T * T, 0))
        return np.pi * np.cbrt(0.75 * (y + self.P) / e) ** 2

    def slope(self, theta, T):
        lam, centre, radius, e = self._scales(theta)
        root = np.sqrt(np.maximum(radius**2 - lam * T * T, 0))
        y = centre + root
        with np.errstate(divide="ignore", invalid="ignore"):
            by_T = np.where(root > 0, -lam * T / root, 0)
        return np.pi * 0.5 / e * np.cbrt(0.75 * (y + self.P) / e) ** -1 * by_T

    def equation(self, theta, T, A):
        lam, centre, radius, e = self._scales(theta)
        y = 4 / 3 * e * (np.maximum(A, 0) / np.pi) ** 1.5 - self.P
        return (y - centre) ** 2 + lam * T * T - radius**2

    def fold(self, theta):
        lam, _, radius, _ = self._scales(theta)
        return radius / np.sqrt(lam) if lam > 0 else np.full_like(radius, np.inf)

    def along(self, theta, u):
        """u = T/S, so that lambda = 0 is no special case; beyond the fold u runs back: u = 2/sqrt(lambda) - T/S."""
        lam, centre, radius, e = self._scales(theta)
        phi = np.sqrt(lam) * u
        x = radius * (u * np.sinc(phi / np.pi))
        y = centre + radius * np.cos(phi)
        base = np.maximum(0.75 * (y + self.P) / e, 1e-9)
        by_y = np.pi * 0.5 / e / np.cbrt(base)
        return x, np.pi * np.cbrt(base) ** 2, radius * np.cos(phi), -by_y * radius * np.sqrt(lam) * np.sin(phi)

    def nearby(self, theta, T, A):
        lam, centre, radius, e = self._scales(theta)
        if lam < 1e-12:
            return T / radius
        y = 4 / 3 * e * (np.maximum(A, 1e-9) / np.pi) ** 1.5 - self.P
        return np.arctan2(np.sqrt(lam) * T, np.maximum(y - centre, -0.5 * radius)) / np.sqrt(lam)


class Law:
    """Toughness ratio against a phase angle that counts as exact."""

    def __init__(self, formula):
        self.formula = formula

    def height(self, theta, psi):
        return self.formula(theta, psi)


def waters_guduru(theta, psi):
    return 1 + np.tan((1 - theta[0] / 2) * psi) ** 2


def benzeggagh_kenane(theta, psi):
    return 1 + (theta[0] - 1) * np.sin(psi) ** (2 * theta[1])


def hutchinson_suo(theta, psi):
    """With a phase shift, and 1 at psi = 0."""
    return (1 + np.tan((1 - theta[0]) * (psi - theta[1])) ** 2) / (1 + np.tan((1 - theta[0]) * theta[1]) ** 2)
