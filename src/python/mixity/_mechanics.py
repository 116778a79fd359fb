"""The models themselves, for arrays. Dimensionless, or in SI with ``contact=(radius, modulus, toughness)``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, Sequence, overload

import numpy as np

from . import _core
from ._arrays import Units, evaluate, flat_arrays, given_back, numbers, target
from ._law import Law, key_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    FloatArray = NDArray[np.float64]
    Codes = NDArray[np.uint8]
    Parameters = ArrayLike | tuple[ArrayLike, ...]
    Contact = Sequence[Any] | None

#: Names of the values in status arrays.
STATUS = ("ok", "no_equilibrium", "invalid")


def models() -> dict[str, list[str]]:
    """Keys of all models, and the names of their parameters.

    Returns
    -------
    dict
        {key: list of names}.
    """
    return {key: _core.parameter_names(key) for key in _core.model_keys()}


@overload
def area(
    model: str | Law, lam: Parameters, P: ArrayLike, T: ArrayLike, *, contact: Contact = None, out: FloatArray | None = None,
    return_status: Literal[False] = False,
) -> FloatArray: ...


@overload
def area(
    model: str | Law, lam: Parameters, P: ArrayLike, T: ArrayLike, *, contact: Contact = None, out: FloatArray | None = None,
    return_status: Literal[True],
) -> tuple[FloatArray, Codes]: ...


def area(
    model: str | Law, lam: Parameters, P: ArrayLike, T: ArrayLike, *, contact: Contact = None, out: FloatArray | None = None,
    return_status: bool = False,
) -> Any:
    """Contact area at loads, on the branch that a contact follows when it is sheared from T = 0.

    Parameters
    ----------
    model : str or Law
        A key of :func:`models`, such as "a", "b", "c" or "bk".
    lam : array_like, or tuple of array_like
        The model's parameter; for several a tuple, in the order of :func:`models`.
    P, T : array_like
        Normal and tangential load, broadcast against each other and ``lam``. Equilibrium depends on T**2.
    contact : (radius [m], modulus [Pa], toughness [J/m^2]), optional
        Loads are then in N, areas in m^2; else dimensionless.
    out : ndarray of float64, optional
        Array to write the areas to; C-contiguous, of the broadcast shape. It may be, or overlap, an argument.
    return_status : bool
        Also an array of indices into :data:`STATUS`.

    Returns
    -------
    A : ndarray
        Relative error below 4e-15 away from folds. NaN exactly where the status is not "ok": beyond the last
        equilibrium or below pull-off (no_equilibrium), or for arguments out of range (invalid).
    status : ndarray of uint8
        With ``return_status``.

    Notes
    -----
    y**2 + T**2 = 8 pi a**3 f(psi), psi = atan2(T, y), y = 4/3 a**3 - P [1]_. Mode III is weighted by 1/2. Where it is averaged
    over the edge (``mode_III="averaged"`` of a data set), T here is sqrt((2 - nu)/(2 - 2 nu)) times the tangential load.

    .. [1] Papangelo & Ciavarella, "On mixed-mode fracture mechanics models for contact area reduction under shear load
       in soft materials", J. Mech. Phys. Solids (2019).

    Examples
    --------
    >>> area("c", 0.15, 2.0, [0.0, 10.0, 20.0]).round(6).tolist()
    [20.774557, 20.352272, 18.840051]
    """
    units = Units(contact)
    loads = units.without("P", P), units.without("T", T)
    A, status = evaluate(_core.areas, model, lam, loads, units.area, out, np.uint8)
    return (A, status) if return_status else A


def toughness(model: str | Law, lam: Parameters, psi: ArrayLike, *, out: FloatArray | None = None) -> FloatArray:
    """Ratio of toughnesses f = G_c/G_Ic at phase angles.

    Parameters
    ----------
    model, lam, out
        As for :func:`area`.
    psi : array_like
        Phase angles [rad], broadcast against ``lam``.

    Returns
    -------
    ndarray
        The ratio f, of the broadcast shape. NaN where psi is not within 0..pi/2, for ``lam`` out of range, and where an argument is NaN.

    Raises
    ------
    InputError
        For an unknown model, or another number of parameters than it has.
    """
    return evaluate(_core.toughness_ratios, model, lam, (np.asarray(psi, dtype=np.float64),), 1.0, out)[0]


def tangential_load(
    model: str | Law, lam: Parameters, P: ArrayLike, A: ArrayLike, *, contact: Contact = None, out: FloatArray | None = None
) -> FloatArray:
    """Tangential load at which a contact has a given area in equilibrium, stable or not.

    Parameters
    ----------
    model, lam, P, contact, out
        As for :func:`area`.
    A : array_like
        Contact area, broadcast against P and ``lam``; in m^2 with ``contact``.

    Returns
    -------
    ndarray
        T >= 0. NaN where there is no such T: an area above that of JKR, or not above that of Hertz, ``lam`` out of range,
        and where an argument is NaN.
    """
    units = Units(contact)
    arrays = units.without("P", P), units.without("A", A)
    return evaluate(_core.tangential_loads, model, lam, arrays, units.force, out)[0]


def axes(
    model: str | Law, lam: Parameters, P: ArrayLike, T: ArrayLike, *, contact: Contact = None
) -> tuple[FloatArray, FloatArray]:
    """Semi-axes of an elliptic contact along and across the shear, on the branch that starts at T = 0.

    Parameters
    ----------
    model : str or Law
        Of elliptic contacts: "a-ellipse", "b-ellipse", "c-ellipse", "bk-ellipse". A circle has two equal axes.
    lam : tuple of array_like
        (lambda_II, lambda_III, poisson_ratio).
    P, T, contact
        As for :func:`area`. With ``contact`` the axes are in m.

    Returns
    -------
    a : ndarray
        Along the shear. Relative error below 1e-13 away from a fold; NaN beyond the last equilibrium.
    b : ndarray
        Across the shear, likewise. ``area`` is pi a b.

    Examples
    --------
    >>> a, b = axes("c-ellipse", (0.008, 0.0, 0.5), 3.0, 95.3202193183654)
    >>> round(float(a), 10), round(float(b), 10)
    (2.5479939831, 2.6075078769)
    """
    units = Units(contact)
    loads = units.without("P", P), units.without("T", T)
    a, b = evaluate(_core.semi_axes, model, lam, loads, 1.0, None, np.float64)
    length = np.sqrt(units.area)
    return a * length, b * length


@overload
def displacement(
    model: str | Law, lam: Parameters, P: ArrayLike, T: ArrayLike, *, contact: Contact = None, out: FloatArray | None = None,
    return_status: Literal[False] = False,
) -> FloatArray: ...


@overload
def displacement(
    model: str | Law, lam: Parameters, P: ArrayLike, T: ArrayLike, *, contact: Contact = None, out: FloatArray | None = None,
    return_status: Literal[True],
) -> tuple[FloatArray, Codes]: ...


def displacement(
    model: str | Law, lam: Parameters, P: ArrayLike, T: ArrayLike, *, contact: Contact = None, out: FloatArray | None = None,
    return_status: bool = False,
) -> Any:
    """Tangential displacement u = 3 T/(4 a) of an incompressible half-space (nu = 1/2).

    Parameters
    ----------
    model, lam, P, T, contact, out, return_status
        As for :func:`area`.

    Returns
    -------
    u : ndarray
        In m with ``contact``, else dimensionless. NaN where the area is: exactly where the status is not "ok".
    status : ndarray of uint8
        With ``return_status``.
    """
    units = Units(contact)
    T = units.without("T", T)
    A, status = area(model, lam, units.without("P", P), T, return_status=True)
    u = target(out, np.shape(A), [])
    np.multiply(0.75 * np.abs(T) / np.sqrt(A / np.pi), units.displacement, out=u)
    u = given_back(u, out)
    return (u, status) if return_status else u


def phase_angle(
    P: ArrayLike,
    T: ArrayLike,
    A: ArrayLike,
    *,
    contact: Contact = None,
    out: tuple[FloatArray | None, FloatArray | None] = (None, None),
) -> tuple[FloatArray, FloatArray]:
    """Phase angle and ratio of toughnesses from a measured area.

    Parameters
    ----------
    P, T, A : array_like
        Loads and area, broadcast against each other; in N and m^2 with ``contact``, else dimensionless.
    contact : (radius [m], modulus [Pa], toughness [J/m^2]), optional
        As for :func:`area`.
    out : pair of ndarray of float64, optional
        Arrays to write psi and f to; they must not overlap.

    Returns
    -------
    psi : ndarray
        Phase angles [rad]. NaN where the area does not exceed that of Hertz, so that there is no phase angle, and where
        an argument is NaN.
    f : ndarray
        G_c/G_Ic; NaN where psi is.

    Raises
    ------
    ValueError
        If the arrays of ``out`` overlap or have another shape.
    """
    units = Units(contact)
    if not isinstance(out, (tuple, list)) or len(out) != 2:
        raise TypeError("out must be a pair of arrays: of psi, and of G_c/G_Ic")
    shape, flat = flat_arrays(units.without("P", P), units.without("T", T), units.without("A", A))
    psi, f = (target(one, shape, flat) for one in out)
    if np.may_share_memory(psi, f):
        raise ValueError("the two arrays of out overlap")
    loads, shears, areas = flat
    _core.phase_angles(loads, shears, areas, psi.reshape(-1), f.reshape(-1))
    return given_back(psi, out[0]), given_back(f, out[1])


def folds(
    model: str | Law,
    lam: Parameters,
    P: float,
    *,
    control: str = "load",
    stiffness: float = 0.0,
    contact: Contact = None,
) -> list[dict[str, Any]]:
    """The folds at which the contact loses stability, in order along the curve from T = 0.

    Parameters
    ----------
    model, lam, contact
        As for :func:`area`; the parameters are single numbers.
    P : float
        Normal load, in N with ``contact``.
    control : {"load", "displacement", "stiffness"}
        The controlled quantity; "stiffness": a spring in series.
    stiffness : float
        Of that spring: dimensionless, k/(xi^2 G_Ic).

    Returns
    -------
    list of dict
        T, u, A, psi [rad] there, ``met_on`` ("loading" or "reversal"), ``jumps_to``, ``area_after``, ``area_lost``.
        T within 1e-13.
    """
    units = Units(contact)
    found = _core.folds(key_of(model), numbers(lam), float(P) / units.force, control, float(stiffness))
    return [units.scale(fold) for fold in found]


def regime(
    model: str | Law, lam: Parameters, P: float, *, shear_strength: float | None = None, contact: Contact = None
) -> dict[str, Any]:
    """The regime of the contact when it is sheared.

    Parameters
    ----------
    model, lam, P, contact
        As for :func:`folds`.
    shear_strength : float, optional
        Strength tau_0 of T = tau_0 A, in Pa with ``contact``; unlimited by default.

    Returns
    -------
    dict
        ``regime``: 1 shrinks to an asymptote, 2 shrinks to Hertz, 3 jumps, 4 slides first. ``fracture``: the regime for
        unlimited strength. ``regime_name`` and ``fracture_name``: the same as words (shrinks, reaches_hertz, jumps,
        slides_first). ``T_end``, ``T_strength`` (None without ``shear_strength``), ``jumps_to``.
    """
    units = Units(contact)
    tau0 = None if shear_strength is None else float(shear_strength) / units.stress
    found = _core.regime(key_of(model), numbers(lam), float(P) / units.force, tau0)
    for name in ("T_end", "T_strength"):
        if found[name] is not None:
            found[name] *= units.force
    return found


def curve(
    model: str | Law, lam: Parameters, P: float, *, points: int = 400, contact: Contact = None
) -> dict[str, NDArray[Any]]:
    """The whole equilibrium curve at one load, through every fold.

    Parameters
    ----------
    model, lam, P, contact
        As for :func:`folds`.
    points : int
        Number of points; fewer than 2 are taken as 2.

    Returns
    -------
    dict of ndarray
        ``phi``, ``T``, ``A``, ``a``, ``u``, ``psi`` [rad], ``f``, ``y``, each of shape (points,), and ``stable`` (bool, under
        load control).
    """
    units = Units(contact)
    found = _core.curve(key_of(model), numbers(lam), float(P) / units.force, int(points))
    found["T"] *= units.force
    found["y"] *= units.force
    found["A"] *= units.area
    found["a"] *= np.sqrt(units.area)
    found["u"] *= units.displacement
    found["stable"] = found.pop("dT") >= 0
    return found
