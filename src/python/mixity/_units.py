"""Quantities as the program takes them: texts with units."""

_SI = {
    "P": "N",
    "T": "N",
    "A": "m^2",
    "a": "m",
    "a_par": "m",
    "a_perp": "m",
    "major": "m",
    "minor": "m",
    "sigma_T": "N",
    "sigma_A": "m^2",
    "psi": "rad",
    "Gc": "J/m^2",
    "G_I": "J/m^2",
    "G_II": "J/m^2",
    "sigma_Gc": "J/m^2",
    "sigma_GI": "J/m^2",
    "sigma_GII": "J/m^2",
    "radius": "m",
    "modulus": "Pa",
    "youngs_modulus": "Pa",
    "toughness": "J/m^2",
    "toughness_II": "J/m^2",
    "shear_strength": "Pa",
    "load_offset": "N",
    "shear_offset": "N",
    "area_offset": "m^2",
    "pixel": "m",
    "load": "N",
}
_PINT = {"J/m^2": "J/m**2", "m^2": "m**2"}


def si_unit(name):
    """The SI unit of a column or constant; empty if it has none."""
    return _SI.get(name, "")


def is_pint(value):
    return hasattr(value, "magnitude") and hasattr(value, "to")


def in_si(name, quantity):
    """Magnitude of a pint quantity in the SI unit of that name."""
    unit = si_unit(name)
    return quantity.to(_PINT.get(unit, unit) or "dimensionless").magnitude


def constant_text(name, value):
    """A constant as a text: strings stay, floats are SI, a pair is a value and its standard error."""
    if isinstance(value, str):
        return value
    if isinstance(value, (tuple, list)) and len(value) == 2:
        one, error = (in_si(name, v) if is_pint(v) else v for v in value)
        unit = si_unit(name)
        return f"{float(one)!r} {unit} +/- {float(error)!r} {unit}".replace("  ", " ").strip()
    if is_pint(value):
        value = in_si(name, value)
    return f"{float(value)!r} {si_unit(name)}".strip()
