"""The models themselves, for arrays. Dimensionless, or in SI with ``contact=(radius, modulus, toughness)``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, Sequence, overload

import numpy as np

from . import _core
from ._law import Law, key_of
from ._units import carries_units, plain_array, si_number

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    FloatArray = NDArray[np.float64]
    Codes = NDArray[np.uint8]
    Parameters = ArrayLike | tuple[ArrayLike, ...]
    Contact = Sequence[Any] | None

#: What the status arrays mean.
STATUS = ("ok", "no_equilibrium", "invalid")


def models() -> dict[str, list[str]]:
    """{key: names of its parameters} of all models."""
    return {key: _core.parameter_names(key) for key in _core.model_keys()}


class _Units:
    def __init__(self, contact):
        self.force = self.area = self.displacement = self.stress = 1.0
        if contact is None:
            return
        try:
            radius, modulus, toughness = map(si_number, ("radius", "modulus", "toughness"), contact)
        except (TypeError, ValueError):
            radius = modulus = toughness = 0.0
        if not (0 < radius < np.inf and 0 < modulus < np.inf and 0 < toughness < np.inf):
            raise _core.InputError(f"contact is {contact!r}; it must be (radius [m], modulus [Pa], toughness [J/m^2]), all above 0")
        self.force, self.area, self.displacement, self.stress = _core.contact_units(radius, modulus, toughness)


def _scaled(name, value, unit, contact):
    if carries_units(value) and contact is None:
        raise _core.InputError(f"'{name}' has a unit; that needs contact=(radius, modulus, toughness)")
    value = plain_array(name, value)
    return value if unit == 1.0 else value / unit


def _flat(arrays):
    """Arrays with their common shape; one number stays one, others become rows without a copy where they can."""
    shape = np.broadcast_shapes(*(array.shape for array in arrays))
    flat = [
        array.reshape(1) if array.size == 1 else np.ascontiguousarray(np.broadcast_to(array, shape)).reshape(-1)
        for array in arrays
    ]
    return shape, flat


def _parameters(model, lam):
    """One array for each parameter: of a model with several, a tuple of them."""
    names = _core.parameter_names(model)
    if not names:
        raise _core.InputError(f"there is no model '{model}'; there are {', '.join(_core.known_models())}")
    given = lam if isinstance(lam, tuple) else (lam,)
    if len(given) != len(names):
        raise _core.InputError(f"model '{model}' has the parameters ({', '.join(names)}), a tuple of {len(names)}, not {len(given)}")
    return [plain_array(name, one) for name, one in zip(names, given)]


def _target(out, shape, inputs):
    """Where results are computed: in ``out``, or beside it where it overlaps an argument that is still to be read."""
    if out is None:
        return np.empty(shape)
    if not isinstance(out, np.ndarray):
        raise TypeError(f"out must be a NumPy array of float64 and shape {shape}, not a {type(out).__name__}")
    if out.shape != shape or out.dtype != np.float64 or not out.flags.c_contiguous:
        raise ValueError(f"out must be a contiguous array of float64 and shape {shape}, not of {out.dtype} and shape {out.shape}")
    if not out.flags.writeable:
        raise ValueError("out is read-only")
    return np.empty(shape) if any(np.may_share_memory(out, one) for one in inputs) else out


def _given_back(made, out):
    if out is None:
        return made if made.ndim else made[()]
    if made is not out:
        out[...] = made
    return out


def _shown(array):
    return array if array.ndim else array[()]


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
    model : str
        "a", "b", "c" or "bk".
    lam : array_like, or tuple of array_like
        The model's parameter; of one with several a tuple, in the order of :func:`models`.
    P, T : array_like
        Normal and tangential load, broadcast against each other and ``lam``. Equilibrium depends on T**2.
    contact : (radius [m], modulus [Pa], toughness [J/m^2]), optional
        Loads are then in N, areas in m^2; else dimensionless.
    out : ndarray of float64, optional
        Where the areas go; C-contiguous, of the broadcast shape. It may be, or overlap, an argument.
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
    y**2 + T**2 = 8 pi a**3 f(psi), psi = atan2(T, y), y = 4/3 a**3 - P [1]_.

    .. [1] Papangelo & Ciavarella, "On mixed-mode fracture mechanics models for contact area reduction under shear load
       in soft materials", J. Mech. Phys. Solids (2019).

    Examples
    --------
    >>> area("c", 0.15, 2.0, [0.0, 10.0, 20.0]).round(6).tolist()
    [20.774557, 20.352272, 18.840051]
    """
    key = key_of(model)
    units = _Units(contact)
    parameters = _parameters(key, lam)
    shape, flat = _flat([*parameters, _scaled("P", P, units.force, contact), _scaled("T", T, units.force, contact)])
    A = _target(out, shape, flat)
    status = np.empty(shape, dtype=np.uint8)
    _core.areas(key, flat[:-2], flat[-2], flat[-1], A.reshape(-1), status.reshape(-1))
    if units.area != 1.0:
        A *= units.area
    A = _given_back(A, out)
    return (A, _shown(status)) if return_status else A


def toughness(model: str | Law, lam: Parameters, psi: ArrayLike, *, out: FloatArray | None = None) -> FloatArray:
    """f = G_c/G_Ic at phase angles psi [rad]. ``out`` as of :func:`area`.

    NaN where psi is not within 0..pi/2, for ``lam`` out of range, and where an argument is NaN.
    """
    key = key_of(model)
    parameters = _parameters(key, lam)
    shape, flat = _flat([*parameters, np.asarray(psi, dtype=np.float64)])
    f = _target(out, shape, flat)
    _core.toughness_ratios(key, flat[:-1], flat[-1], f.reshape(-1))
    return _given_back(f, out)


def tangential_load(
    model: str | Law, lam: Parameters, P: ArrayLike, A: ArrayLike, *, contact: Contact = None, out: FloatArray | None = None
) -> FloatArray:
    """T >= 0 at which a contact of load P has the area A in equilibrium, stable or not.

    Units and ``out`` as of :func:`area`. NaN where there is no such T: an area above that of JKR, or not above that of
    Hertz, ``lam`` out of range, and where an argument is NaN.
    """
    key = key_of(model)
    units = _Units(contact)
    parameters = _parameters(key, lam)
    shape, flat = _flat([*parameters, _scaled("P", P, units.force, contact), _scaled("A", A, units.area, contact)])
    T = _target(out, shape, flat)
    _core.tangential_loads(key, flat[:-2], flat[-2], flat[-1], T.reshape(-1))
    T *= units.force
    return _given_back(T, out)


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
    """Tangential displacement u = 3 T/(4 a) of an incompressible half-space (nu = 1/2), dimensionless or [m].

    Arguments, ``out`` and status as of :func:`area`. NaN where the area is: exactly where the status is not "ok".
    """
    units = _Units(contact)
    T = _scaled("T", T, units.force, contact)
    A, status = area(model, lam, _scaled("P", P, units.force, contact), T, return_status=True)
    u = _target(out, np.shape(A), [])
    np.multiply(0.75 * np.abs(T) / np.sqrt(A / np.pi), units.displacement, out=u)
    u = _given_back(u, out)
    return (u, status) if return_status else u


def phase_angle(
    P: ArrayLike,
    T: ArrayLike,
    A: ArrayLike,
    *,
    contact: Contact = None,
    out: tuple[FloatArray | None, FloatArray | None] = (None, None),
) -> tuple[FloatArray, FloatArray]:
    """(psi [rad], G_c/G_Ic) that a measured area says of the interface.

    Units as of :func:`area`; ``out`` is a pair of arrays. Both are NaN where the area does not exceed that of Hertz, so
    that there is no phase angle, and where an argument is NaN.
    """
    units = _Units(contact)
    if not isinstance(out, (tuple, list)) or len(out) != 2:
        raise TypeError("out must be a pair of arrays: of psi, and of G_c/G_Ic")
    shape, flat = _flat([_scaled("P", P, units.force, contact), _scaled("T", T, units.force, contact), _scaled("A", A, units.area, contact)])
    psi, f = (_target(one, shape, flat) for one in out)
    if np.may_share_memory(psi, f):
        raise ValueError("the two arrays of out overlap")
    loads, shears, areas = flat
    _core.phase_angles(loads, shears, areas, psi.reshape(-1), f.reshape(-1))
    return _given_back(psi, out[0]), _given_back(f, out[1])


def folds(
    model: str | Law,
    lam: Parameters,
    P: float,
    *,
    control: str = "load",
    stiffness: float = 0.0,
    contact: Contact = None,
) -> list[dict[str, Any]]:
    """Where the contact loses stability, in the order in which it is met from T = 0.

    Parameters
    ----------
    P : float
    control : {"load", "displacement", "stiffness"}
        What drives it; "stiffness": a spring of ``stiffness`` (dimensionless, k/(xi^2 G_Ic)) in series.

    Returns
    -------
    list of dict
        T, u, A, psi [rad] there, ``met_on`` ("loading" or "reversal"), ``jumps_to``, ``area_after``, ``area_lost``.
        T within 1e-13.
    """
    key = key_of(model)
    units = _Units(contact)
    found = _core.folds(key, _one_each(lam), float(P) / units.force, control, float(stiffness))
    for fold in found:
        fold["T"] *= units.force
        fold["u"] *= units.displacement
        for name in ("A", "area_after", "area_lost"):
            fold[name] *= units.area
    return found


def regime(
    model: str | Law, lam: Parameters, P: float, *, shear_strength: float | None = None, contact: Contact = None
) -> dict[str, Any]:
    """What becomes of the contact when it is sheared: 1 shrinks to an asymptote, 2 to Hertz, 3 jumps, 4 slides first.

    ``shear_strength`` is tau_0 of T = tau_0 A. Returns a dict: regime, fracture (without a limit to the strength),
    T_end, T_strength, jumps_to.
    """
    key = key_of(model)
    units = _Units(contact)
    tau0 = None if shear_strength is None else float(shear_strength) / units.stress
    found = _core.regime(key, _one_each(lam), float(P) / units.force, tau0)
    for name in ("T_end", "T_strength"):
        if found[name] is not None:
            found[name] *= units.force
    return found


def curve(
    model: str | Law, lam: Parameters, P: float, *, points: int = 400, contact: Contact = None
) -> dict[str, NDArray[Any]]:
    """The whole equilibrium curve at load P, through every fold.

    Returns a dict of arrays of at least 2 ``points``: phi, T, A, a, u, psi, f, and stable (under load control).
    """
    key = key_of(model)
    units = _Units(contact)
    found = _core.curve(key, _one_each(lam), float(P) / units.force, int(points))
    found["T"] *= units.force
    found["y"] *= units.force
    found["A"] *= units.area
    found["a"] *= np.sqrt(units.area)
    found["u"] *= units.displacement
    found["stable"] = found.pop("dT") >= 0
    return found


def _one_each(lam):
    return [float(one) for one in (lam if isinstance(lam, tuple) else (lam,))]
