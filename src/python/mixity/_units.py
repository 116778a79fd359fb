"""Quantities in the program's form: texts with units."""

import numpy as np

from . import _core

_SI = _core.si_units()  # units of columns and constants
_PINT = {"J/m^2": "J/m**2", "m^2": "m**2"}


def si_unit(name):
    """The SI unit of a column or constant; empty if it has none."""
    return _SI.get(name, "")


def plain_array(name, value):
    """Doubles of any shape: pint quantities in SI, masked values as NaN; not copied if there is nothing to convert."""
    if carries_units(value):
        value = in_si(name, value) if is_pint(value) else [in_si(name, one) for one in value]
    try:
        if np.ma.isMaskedArray(value):
            return value.astype(np.float64).filled(np.nan)
        if np.iscomplexobj(value):
            raise ValueError("complex numbers")
        return np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise _core.InputError(f"'{name}' holds no numbers: {error}") from None


def si_names():
    """Names of columns and constants that have a unit."""
    return _SI.keys()


def is_pint(value):
    return hasattr(value, "magnitude") and hasattr(value, "to")


def carries_units(value):
    """Whether it is a pint quantity or a list of them, which plain_array converts to SI."""
    return is_pint(value) or (isinstance(value, (list, tuple)) and len(value) > 0 and all(map(is_pint, value)))


def in_si(name, quantity):
    """Magnitude of a pint quantity in the SI unit of the column or constant ``name``."""
    unit = si_unit(name)
    try:
        return quantity.to(_PINT.get(unit, unit) or "dimensionless").magnitude
    except Exception as error:  # raised by pint, which this package does not import
        raise _core.InputError(f"'{name}' must be in {unit or 'no unit'}: {error}") from None


def si_number(name, value):
    """A number in SI or a pint quantity, as a float in SI."""
    return float(in_si(name, value) if is_pint(value) else value)


def _with_error(name, value):
    """(value, standard error) of a number from uncertainties or pint's plus_minus; (value,) of any other."""
    plain = in_si(name, value) if is_pint(value) else value
    return (plain.nominal_value, plain.std_dev) if hasattr(plain, "nominal_value") else (plain,)


def _quantity_text(name, value, dimensional=True):
    """A number (in SI, or dimensionless) or a pint quantity, as a text."""
    if isinstance(value, (bool, np.bool_)):
        raise TypeError("a truth value is not a quantity")
    return f"{si_number(name, value)!r} {si_unit(name) if dimensional or is_pint(value) else ''}".strip()


def error_text(name, value, dimensional=True):
    """A standard error as a text: "1%" stays, numbers are SI, or dimensionless as the data are."""
    if isinstance(value, str):
        return value
    try:
        return _quantity_text(name, value, dimensional)
    except (TypeError, ValueError):
        raise _core.InputError(
            f"{name} is {value!r}; it must be a text such as \"1%\" or \"0.2 mN\", a number in SI or a pint quantity"
        ) from None


def load_list(name, value):
    """Loads [N] as a list of floats, from numbers in SI, texts ("1,4 mN", or one per load) and pint quantities."""
    if isinstance(value, str):
        return _core.forces(name, value)
    if isinstance(value, (list, tuple)) and any(isinstance(one, str) or is_pint(one) for one in value):
        return [load for one in value for load in load_list(name, one)]
    return np.atleast_1d(plain_array("P", value)).tolist()


def load_number(name, value):
    """One load [N]."""
    loads = load_list(name, value)
    if len(loads) != 1:
        raise _core.InputError(f"{name} is {value!r}; it must be one load")
    return loads[0]


def whole_number(name, value, least=0):
    """The value as an int, if it is a whole number not below ``least``."""
    try:
        number = int(value)
    except (TypeError, ValueError, OverflowError):
        number = None
    if number is None or isinstance(value, bool) or number != value or not least <= number < 2**64:
        raise _core.InputError(f"{name} is {value!r}; it must be a whole number, {least} or more")
    return number


def constant_text(name, value):
    """A constant as a text: strings unchanged, floats in SI, pairs and uncertain numbers as value and standard error."""
    if isinstance(value, str):
        return value
    parts = value if isinstance(value, (tuple, list)) else _with_error(name, value)
    try:
        texts = [part if isinstance(part, str) else _quantity_text(name, part) for part in parts]
    except (TypeError, ValueError):
        texts = []
    if len(texts) not in (1, 2):
        raise _core.InputError(
            f"'{name}' is no column, and as a constant it must be a number in SI, a text such as \"9.42 mm +/- 1%\", a pair of "
            f"value and standard error, or a pint quantity{_core.did_you_mean(name, [*_core.column_names(), *si_names()])}"
        )
    return " +/- ".join(texts)
