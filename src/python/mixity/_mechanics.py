"""The models themselves, for arrays. Dimensionless, or in SI with ``contact=(radius, modulus, toughness)``."""

import numpy as np

from . import _core
from ._law import key_of
from ._units import carries_units, plain_array

#: What the status arrays mean.
STATUS = ("ok", "no_equilibrium", "invalid")


def models():
    """{key: names of its parameters} of all models."""
    return {key: _core.parameter_names(key) for key in _core.model_keys()}


class _Units:
    def __init__(self, contact):
        self.force = self.area = self.displacement = self.stress = 1.0
        if contact is None:
            return
        try:
            radius, modulus, toughness = map(float, contact)
        except (TypeError, ValueError):
            radius = modulus = toughness = 0.0
        if not (0 < radius < np.inf and 0 < modulus < np.inf and 0 < toughness < np.inf):
            raise _core.InputError(f"contact is {contact!r}; it must be (radius [m], modulus [Pa], toughness [J/m^2]), all above 0")
        xi = np.cbrt(modulus * radius / toughness)
        self.force, self.area = radius * toughness, (radius / xi) ** 2
        self.displacement, self.stress = radius / xi**2, modulus / xi


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
        raise _core.InputError(f"there is no model '{model}'; there are {', '.join(_core.model_keys())}")
    given = lam if isinstance(lam, tuple) else (lam,)
    if len(given) != len(names):
        raise _core.InputError(f"model '{model}' has the parameters ({', '.join(names)}), a tuple of {len(names)}, not {len(given)}")
    return [plain_array(name, one) for name, one in zip(names, given)]


def _output(out, shape):
    if out is None:
        return np.empty(shape)
    if out.shape != shape or out.dtype != np.float64 or not out.flags.c_contiguous:
        raise ValueError(f"out must be a contiguous array of float64 and shape {shape}")
    return out


def _shown(array):
    return array if array.ndim else array[()]


def area(model, lam, P, T, *, contact=None, out=None, return_status=False):
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
        Where the areas go; C-contiguous, of the broadcast shape.
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
    model = key_of(model)
    units = _Units(contact)
    parameters = _parameters(model, lam)
    shape, flat = _flat([*parameters, _scaled("P", P, units.force, contact), _scaled("T", T, units.force, contact)])
    A = _output(out, shape)
    status = np.empty(shape, dtype=np.uint8)
    _core.areas(model, flat[:-2], flat[-2], flat[-1], A.reshape(-1), status.reshape(-1))
    if units.area != 1.0:
        A *= units.area
    return (_shown(A), _shown(status)) if return_status else _shown(A)


def toughness(model, lam, psi):
    """f = G_c/G_Ic at phase angles psi [rad], 0..pi/2; NaN outside and for ``lam`` out of range."""
    model = key_of(model)
    parameters = _parameters(model, lam)
    shape, flat = _flat([*parameters, np.asarray(psi, dtype=np.float64)])
    f = np.empty(shape)
    _core.toughness_ratios(model, flat[:-1], flat[-1], f.reshape(-1))
    return _shown(f)


def tangential_load(model, lam, P, A, *, contact=None):
    """T >= 0 at which a contact of load P has the area A in equilibrium, stable or not.

    NaN where there is none: an area above that of JKR, or not above that of Hertz. Units as of :func:`area`.
    """
    model = key_of(model)
    units = _Units(contact)
    parameters = _parameters(model, lam)
    shape, flat = _flat([*parameters, _scaled("P", P, units.force, contact), _scaled("A", A, units.area, contact)])
    T = np.empty(shape)
    _core.tangential_loads(model, flat[:-2], flat[-2], flat[-1], T.reshape(-1))
    return _shown(T * units.force)


def displacement(model, lam, P, T, *, contact=None):
    """Tangential displacement u = 3 T/(4 a) of an incompressible half-space (nu = 1/2), dimensionless or [m].

    NaN where :func:`area` is.
    """
    model = key_of(model)
    units = _Units(contact)
    T = _scaled("T", T, units.force, contact)
    A = area(model, lam, _scaled("P", P, units.force, contact), T)
    return 0.75 * np.abs(T) / np.sqrt(A / np.pi) * units.displacement


def phase_angle(P, T, A, *, contact=None):
    """(psi [rad], G_c/G_Ic) that a measured area says of the interface; NaN where it does not exceed that of Hertz."""
    units = _Units(contact)
    shape, flat = _flat([_scaled("P", P, units.force, contact), _scaled("T", T, units.force, contact), _scaled("A", A, units.area, contact)])
    psi, f = np.empty(shape), np.empty(shape)
    _core.phase_angles(*flat, psi.reshape(-1), f.reshape(-1))
    return _shown(psi), _shown(f)


def folds(model, lam, P, *, control="load", stiffness=0.0, contact=None):
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
    model = key_of(model)
    units = _Units(contact)
    found = _core.folds(model, _one_each(lam), float(P) / units.force, control, float(stiffness))
    for fold in found:
        fold["T"] *= units.force
        fold["u"] *= units.displacement
        for key in ("A", "area_after", "area_lost"):
            fold[key] *= units.area
    return found


def regime(model, lam, P, *, shear_strength=None, contact=None):
    """What becomes of the contact when it is sheared: 1 shrinks to an asymptote, 2 to Hertz, 3 jumps, 4 slides first.

    ``shear_strength`` is tau_0 of T = tau_0 A. Returns a dict: regime, fracture (without a limit to the strength),
    T_end, T_strength, jumps_to.
    """
    model = key_of(model)
    units = _Units(contact)
    tau0 = None if shear_strength is None else float(shear_strength) / units.stress
    found = _core.regime(model, _one_each(lam), float(P) / units.force, tau0)
    for key in ("T_end", "T_strength"):
        if found[key] is not None:
            found[key] *= units.force
    return found


def curve(model, lam, P, *, points=400, contact=None):
    """The whole equilibrium curve at load P, through every fold.

    Returns a dict of arrays of at least 2 ``points``: phi, T, A, a, u, psi, f, and stable (under load control).
    """
    model = key_of(model)
    units = _Units(contact)
    found = _core.curve(model, _one_each(lam), float(P) / units.force, int(points))
    found["T"] *= units.force
    found["y"] *= units.force
    found["A"] *= units.area
    found["a"] *= np.sqrt(units.area)
    found["u"] *= units.displacement
    found["stable"] = found.pop("dT") >= 0
    return found


def _one_each(lam):
    return [float(one) for one in (lam if isinstance(lam, tuple) else (lam,))]
