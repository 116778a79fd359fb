"""Residuals and their derivatives for ``scipy.optimize``, for those who keep their own scripts."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable

import numpy as np

from . import _core, _mechanics
from ._arrays import Units
from ._law import Law, key_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    FloatArray = NDArray[np.float64]


def residuals(
    model: str | Law, P: ArrayLike, T: ArrayLike, A: ArrayLike, *, sigma: ArrayLike | None = None, contact: Any = None
) -> tuple[Callable[[ArrayLike], FloatArray], Callable[[ArrayLike], FloatArray]]:
    """A residual function of a model's parameters, and its Jacobian.

    Parameters
    ----------
    model : str or Law
        As for :func:`mixity.area`.
    P, T, A : array_like, shape (n,)
        Dimensionless, or SI with ``contact``.
    sigma : array_like, optional
        Standard errors of A; else residuals are in the unit of A.
    contact : (radius [m], modulus [Pa], toughness [J/m^2]), optional
        P, T are then in N, A and ``sigma`` in m^2.

    Returns
    -------
    fun : callable
        ``fun(x)``: shape (n,), the model's area minus A; beyond the last equilibrium the area at the fold.
    jac : callable
        ``jac(x)``: shape (n, p), the engine's derivatives dA/dx = -F_x/F_A of the equilibrium F = 0; 0 on and beyond the fold.

    Examples
    --------
    >>> import numpy as np, mixity
    >>> T = np.linspace(0, 20, 30)
    >>> fun, jac = mixity.scipy.residuals("c", 2.0, T, mixity.area("c", 0.15, 2.0, T))
    >>> from scipy.optimize import least_squares
    >>> float(np.round(least_squares(fun, [0.1], jac, bounds=(0, 1)).x[0], 10))
    0.15
    """
    model = key_of(model)
    units = Units(contact)
    P, T, A = np.broadcast_arrays(units.without("P", P), np.abs(units.without("T", T)), units.without("A", A))
    weight = 1.0 if sigma is None else units.area / np.asarray(sigma, float)
    scale = units.area if sigma is None else weight

    def fun(x):
        return scale * (areas_to_the_fold(model, x, P, T) - A)

    def jac(x):
        return np.column_stack([scale * slope for slope in slopes(model, x, P, T)])

    return fun, jac


def areas_to_the_fold(model, x, P, T):
    """Dimensionless areas; beyond the last equilibrium the area at the fold, so that a minimiser sees no NaN."""
    lam = tuple(map(float, x))
    shape = np.broadcast_shapes(np.shape(P), np.shape(T))
    A, status = map(np.atleast_1d, _mechanics.area(model, lam, P, T, return_status=True))
    P = np.broadcast_to(P, A.shape)
    for load in np.unique(P[status == 1]):
        beyond = (status == 1) & (P == load)
        folds = [fold for fold in _mechanics.folds(model, lam, load) if fold["met_on"] == "loading"]
        A[beyond] = folds[-1]["A"] if folds else 0.0
    return A.reshape(shape)


def slopes(model, x, P, T):
    """dA/dx for each parameter at dimensionless loads; 0 on and beyond the fold, where the areas above do not depend on
    it smoothly."""
    lam = [np.array([float(one)]) for one in x]
    A = np.atleast_1d(_mechanics.area(model, tuple(map(float, x)), P, T))
    found = [np.empty(A.size) for _ in lam]
    _core.area_slopes(model, lam, np.ascontiguousarray(P).ravel(), np.ascontiguousarray(T).ravel(), A.ravel(), found)
    return [np.where(np.isfinite(slope), slope, 0.0).reshape(np.shape(A)) for slope in found]
