"""Quantities in the program's form: texts with units."""

import numpy as np

from . import _core
from ._quantities import carries_units, in_si, is_quantity, refuse_units, si_names, si_unit, standard_error


def _numbers(name, value):
    """An array of doubles; what is missing is NaN."""
    if hasattr(value, "mask") and hasattr(value, "filled"):  # numpy.ma and astropy's Masked
        return np.asarray(np.asarray(value.astype(np.float64).filled(np.nan)))
    if hasattr(value, "isna") and hasattr(value, "to_numpy"):  # pandas: NA of nullable types
        kind = getattr(value.dtype, "kind", "O")
        if kind not in "mM":
            return value.to_numpy(dtype=np.float64, na_value=np.nan)
    array = np.asarray(value)
    if array.dtype.kind in "mM":
        raise ValueError(f"{array.dtype} are times")
    if array.dtype.kind == "c":
        raise ValueError("complex numbers")
    return np.asarray(array, dtype=np.float64)


def plain_array(name, value):
    """Doubles of any shape: what carries units in SI, masked and missing values as NaN; not copied if there is nothing to convert."""
    if carries_units(value):
        if standard_error(name, value) is not None:
            raise _core.InputError(f"'{name}' has standard errors: give its values alone, and the errors as a column, as sigma_T or sigma_A")
        value = in_si(name, value)
    else:
        refuse_units(name, value)
    try:
        return _numbers(name, value)
    except (TypeError, ValueError) as error:
        raise _core.InputError(f"'{name}' holds no numbers: {error}") from None


def si_number(name, value):
    """A number in SI or a quantity, as a float in SI."""
    if standard_error(name, value) is not None:
        raise TypeError("a number without an error is needed")
    return float(in_si(name, value) if is_quantity(value) else value)


def _with_error(name, value):
    """(value, standard error) of a number from uncertainties, quantities or pint's plus_minus; (value,) of any other."""
    plain = in_si(name, value) if is_quantity(value) else value
    error = standard_error(name, value)
    if error is not None:
        return plain, error
    return (plain.nominal_value, plain.std_dev) if hasattr(plain, "nominal_value") else (plain,)


def _quantity_text(name, value, dimensional=True):
    """A number (in SI, or dimensionless) or a quantity, as a text."""
    if isinstance(value, (bool, np.bool_)):
        raise TypeError("a truth value is not a quantity")
    return f"{si_number(name, value)!r} {si_unit(name) if dimensional or is_quantity(value) else ''}".strip()


def error_text(name, value, dimensional=True):
    """A standard error as a text: "1%" stays, numbers are SI, or dimensionless as the data are."""
    if isinstance(value, str):
        return value
    try:
        return _quantity_text(name, value, dimensional)
    except (TypeError, ValueError):
        raise _core.InputError(
            f"{name} is {value!r}; it must be a text such as \"1%\" or \"0.2 mN\", a number in SI or a quantity with a unit"
        ) from None


def load_list(name, value, approach=False):
    """Loads [N], or approaches [m], as a list of floats, from numbers in SI, texts ("1,4 mN", or one per load) and quantities."""
    if isinstance(value, str):
        return _core.held_values(name, value, approach)
    if isinstance(value, (list, tuple)) and any(isinstance(one, str) or is_quantity(one) for one in value):
        return [load for one in value for load in load_list(name, one, approach)]
    return np.atleast_1d(plain_array("delta" if approach else "P", value)).tolist()


def load_number(name, value, approach=False):
    """One load [N], or one approach [m]."""
    loads = load_list(name, value, approach)
    if len(loads) != 1:
        raise _core.InputError(f"{name} is {value!r}; it must be one {'approach' if approach else 'load'}")
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
            f"value and standard error, or a quantity with a unit{_core.did_you_mean(name, [*_core.column_names(), *si_names()])}"
        )
    return " +/- ".join(texts)
