"""Arguments and results of the models as arrays: units, broadcasting, ``out``."""

import numpy as np

from . import _core
from ._law import key_of
from ._quantities import carries_units
from ._units import plain_array, si_number


class Units:
    """Units of dimensionless quantities: 1, or the SI units of a contact."""

    def __init__(self, contact):
        self.contact = contact
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

    def without(self, name, value):
        """P, T or A made dimensionless."""
        if carries_units(value) and self.contact is None:
            raise _core.InputError(f"'{name}' has a unit; that needs contact=(radius, modulus, toughness)")
        value = plain_array(name, value)
        return value if self.contact is None else value / (self.area if name == "A" else self.force)

    def scale(self, fold):
        """A fold (a dict of numbers) in these units."""
        units = {"T": self.force, "u": self.displacement, "A": self.area, "area_after": self.area, "area_lost": self.area}
        for name, unit in units.items():
            fold[name] *= unit
        return fold


def flat_arrays(*arrays):
    """The common shape, and the arrays broadcast to it and flattened. Single numbers stay single; copies only if necessary."""
    shape = np.broadcast_shapes(*(array.shape for array in arrays))
    flat = [
        array.reshape(1) if array.size == 1 else np.ascontiguousarray(np.broadcast_to(array, shape)).reshape(-1)
        for array in arrays
    ]
    return shape, flat


def _parameters(model, lam):
    """One array per parameter; a tuple of arrays for a model with several."""
    names = _core.parameter_names(model)
    if not names:
        raise _core.InputError(f"there is no model '{model}'; there are {', '.join(_core.known_models())}")
    given = lam if isinstance(lam, tuple) else (lam,)
    if len(given) != len(names):
        raise _core.InputError(f"model '{model}' has the parameters ({', '.join(names)}), a tuple of {len(names)}, not {len(given)}")
    return [plain_array(name, one) for name, one in zip(names, given)]


def numbers(lam):
    return [float(one) for one in (lam if isinstance(lam, tuple) else (lam,))]


def target(out, shape, inputs):
    """The array for the results: ``out``, or a new one if ``out`` overlaps an argument that is still to be read."""
    if out is None:
        return np.empty(shape)
    if not isinstance(out, np.ndarray):
        raise TypeError(f"out must be a NumPy array of float64 and shape {shape}, not a {type(out).__name__}")
    if out.shape != shape or out.dtype != np.float64 or not out.flags.c_contiguous:
        raise ValueError(f"out must be a contiguous array of float64 and shape {shape}, not of {out.dtype} and shape {out.shape}")
    if not out.flags.writeable:
        raise ValueError("out is read-only")
    return np.empty(shape) if any(np.may_share_memory(out, one) for one in inputs) else out


def _scalar_or_array(array):
    return array if array.ndim else array[()]


def given_back(made, out):
    if out is None:
        return _scalar_or_array(made)
    if made is not out:
        out[...] = made
    return out


def evaluate(function, model, lam, arrays, unit, out, *more):
    """``function`` of the engine for the parameters and dimensionless arrays; what it fills, times ``unit``. ``more`` are
    types of further arrays that it fills."""
    key = key_of(model)
    shape, flat = flat_arrays(*_parameters(key, lam), *arrays)
    made = target(out, shape, flat)
    others = [np.empty(shape, dtype) for dtype in more]
    n = len(arrays)
    function(key, flat[:-n], *flat[-n:], made.reshape(-1), *(other.reshape(-1) for other in others))
    if unit != 1.0:
        made *= unit
    return (given_back(made, out), *map(_scalar_or_array, others))
