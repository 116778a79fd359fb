"""Quantities of other libraries: of pint, astropy, unyt and quantities, of pint-pandas columns, columns of astropy tables, and
xarray arrays with an attribute ``units``. None of these libraries is imported. What has a unit that cannot be converted is refused."""

import numpy as np

from . import _core

_SI = _core.si_units()  # units of columns and constants


def si_unit(name):
    """The SI unit of a column or constant; empty if it has none."""
    return _SI.get(name, "")


def si_names():
    """Names of columns and constants that have a unit."""
    return _SI.keys()


def _of_attributes(value):
    """The unit that an xarray array has as an attribute; empty if none."""
    attributes = getattr(value, "attrs", None) if hasattr(value, "dims") else None
    return str(attributes.get("units") or attributes.get("unit") or "") if attributes else ""


def _within(value):
    """The quantity that a column or an xarray array holds; anything else unchanged."""
    if hasattr(value, "quantity") and hasattr(value, "unit"):  # a column of an astropy table, whose quantity has no mask
        if value.unit is None:
            return value
        return (value.astype(np.float64).filled(np.nan) if hasattr(value, "filled") else value).quantity
    values = getattr(value, "array", value)  # of a pandas Series
    if hasattr(values, "quantity"):  # pint-pandas
        return values.quantity
    if hasattr(value, "dims") and is_quantity(getattr(value, "data", None)):
        return value.data
    return value


def is_quantity(value):
    """Whether it is a number or an array of pint, astropy, unyt or quantities."""
    return hasattr(value, "to_value") or hasattr(value, "rescale") or (hasattr(value, "magnitude") and hasattr(value, "to"))


def carries_units(value):
    """Whether it has a unit, or is a list of such values: ``without_unit`` then gives SI."""
    if isinstance(value, (list, tuple)):
        return len(value) > 0 and all(map(carries_units, value))
    return is_quantity(_within(value)) or _of_attributes(value) != ""


def in_si(name, value):
    """The numbers of what carries a unit, in the SI unit of the column or constant ``name``."""
    if isinstance(value, (list, tuple)):
        return [in_si(name, one) for one in value]
    quantity, unit = _within(value), si_unit(name)
    if not is_quantity(quantity):
        return np.asarray(value, dtype=np.float64) * _core.size_of_unit(name, _of_attributes(value), unit)
    power = unit.replace("^", "**")
    try:
        if hasattr(quantity, "rescale"):
            return quantity.rescale(power or "dimensionless").magnitude
        if not hasattr(quantity, "to_value"):
            return quantity.to(power or "dimensionless").magnitude
        if hasattr(quantity, "units"):  # unyt
            return quantity.to_value(power or "dimensionless")
        return quantity.to_value(power)
    except Exception as error:  # raised by libraries that this package does not import
        raise _core.InputError(f"'{name}' must be in {unit or 'no unit'}: {error}") from None


def standard_error(name, value):
    """The error of an UncertainQuantity of quantities or a Distribution of astropy, in the SI unit of ``name``; None for any
    other value."""
    error = value.pdf_std() if hasattr(value, "pdf_std") else getattr(value, "uncertainty", None)
    return in_si(name, error) if error is not None and is_quantity(error) else None


def refuse_units(name, value):
    """Raises InputError where a value without a known way to convert it says that it has a unit."""
    for attribute in ("units", "unit", "dimensionality"):
        unit = getattr(value, attribute, None)
        if unit is not None and not callable(unit) and str(unit).strip():
            raise _core.InputError(
                f"'{name}' is a {type(value).__name__} with {attribute} {unit}, which cannot be converted: give its numbers, with their "
                f'unit in units={{"{name}": ...}}'
            )
