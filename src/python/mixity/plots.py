"""Figures of fits and plans on matplotlib axes, in the style of the report: methods of :class:`mixity.Fit` and
:class:`mixity.Plan`. Each draws on ``ax``, a matplotlib Axes, by default on new ones, and returns it. Each raises
:class:`InputError` if there is nothing to draw."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import _mechanics
from ._core import InputError, parameter_names

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# As in the report; also distinct without colour.
_STYLE = {"a": ("#0072b2", "--"), "b": ("#d55e00", "-."), "c": ("#009e73", "-"), "bk": ("#cc79a7", ":")}
_RUN_COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#5b3a8c")
_RUN_MARKERS = ("o", "s", "^", "D", "v", "x", "<", "+")  # eight beside seven colours: 56 runs before a pair repeats
_MOST_IN_LEGEND = 12
_POINTS: dict[str, Any] = {"linestyle": "none", "marker": "o", "fillstyle": "none", "color": "0.3", "markersize": 4}


def _axes(ax):
    if ax is not None:
        return ax
    import matplotlib.pyplot as plt

    axes = plt.subplots(constrained_layout=True)[1]
    axes.spines[["top", "right"]].set_visible(False)
    return axes


def _label(name, unit):
    unit = unit.replace("^2", "²")
    return f"{name} [{unit}]" if unit else name


def _style(fit):
    """Colour and line of the fit's model."""
    return _STYLE.get(fit.model, ("k", "-"))


def _of_run(i):
    """Colour and mark of a run."""
    return {**_POINTS, "color": _RUN_COLOURS[i % len(_RUN_COLOURS)], "marker": _RUN_MARKERS[i % len(_RUN_MARKERS)]}


def _draw_runs(ax, data, x, y, run):
    """Points, a colour and a mark for each run; ``run``: that of each point."""
    few = 1 < len(data.runs) <= _MOST_IN_LEGEND
    for i, name in enumerate(data.runs):
        label = f"run {name}" if few else "data" if i == 0 else None
        ax.plot(x[run == i], y[run == i], label=label, **_of_run(i))


def _finished(ax, x, y, legend=False):
    ax.set_xlabel(x)
    ax.set_ylabel(y)
    if legend:
        many = len(ax.get_legend_handles_labels()[0]) > 4  # would hide points: beside the axes
        ax.legend(frameon=False, **({"loc": "upper left", "bbox_to_anchor": (1, 1)} if many else {}))
    return ax


def area(fit: Any, ax: Axes | None = None) -> Axes:
    """Draws A(T) of each run: points, the model with its 95 % band, and where it jumps.

    Parameters
    ----------
    fit : Fit
        The fit that is drawn.
    ax : matplotlib Axes, optional
        New axes by default.

    Returns
    -------
    matplotlib Axes
        ``ax``, or the new axes.

    Raises
    ------
    InputError
        If the data have no loads.
    """
    data = fit.data
    if not data._core.has_loads:
        raise InputError(f"{data.name} has no loads, so that there is no A(T) to draw; plot_toughness() draws what was fitted")
    ax = _axes(ax)
    colour, line = _style(fit)
    P, T, A, run = data.delta if data._core.holds_approach else data.P, data.T, data.A, data.run_of_point
    _draw_runs(ax, data, T, A, run)
    for i in range(len(data.runs)):
        load = np.median(P[run == i])
        jumps = fit.folds(load)
        end = jumps[0]["T"] if jumps else 1.1 * np.max(T[run == i])
        # denser towards the fold, where the curve is steep
        shear = end * (1 - np.linspace(1, 0, 200) ** 2) * (1 - 1e-12)
        A_fit, low, high = fit.area(load, shear)
        ax.fill_between(shear, low, high, color=colour, alpha=0.25, linewidth=0)
        ax.plot(shear, A_fit, line, color=colour, label=f"model {fit.model}" if i == 0 else None)
        if jumps:
            ax.plot(jumps[0]["T"], jumps[0]["A"], "s", color=colour, label="jump" if i == 0 else None)
    return _finished(ax, _label("T", data.units["force"]), _label("A", data.units["area"]), legend=True)


def toughness(fit: Any, ax: Axes | None = None) -> Axes:
    """Draws G_c/G_Ic against psi [deg]: points, the model, and the band of its first parameter's interval.

    Parameters
    ----------
    fit, ax
        As for :func:`area`.

    Returns
    -------
    matplotlib Axes
        ``ax``, or the new axes.
    """
    ax = _axes(ax)
    data = fit.data
    colour, line = _style(fit)
    psi = np.linspace(0, np.nanmax(data.psi) * 1.01, 300)
    # over the toughness that was fitted, where one was
    ratio = data.toughness_ratio * fit._fits._results.over_fitted_toughness(fit._index)[data.run_of_point]
    _draw_runs(ax, data, np.degrees(data.psi), ratio, data.run_of_point)
    lam = tuple(fit.params[name].value for name in parameter_names(fit.model))
    interval = next(iter(fit.params.values())).interval
    if interval and None not in interval:
        low, high = (_mechanics.toughness(fit.model, (end, *lam[1:]), psi) for end in interval)
        ax.fill_between(np.degrees(psi), low, high, color=colour, alpha=0.25, linewidth=0)
    ax.plot(np.degrees(psi), _mechanics.toughness(fit.model, lam, psi), line, color=colour, label=f"model {fit.model}")
    ax.set_yscale("log")
    return _finished(ax, "psi [deg]", "G_c/G_Ic", legend=True)


def residuals(fit: Any, ax: Axes | None = None) -> Axes:
    """Draws the residuals against T, or against psi [deg] if the data have no loads.

    Parameters
    ----------
    fit, ax
        As for :func:`area`.

    Returns
    -------
    matplotlib Axes
        ``ax``, or the new axes.
    """
    ax = _axes(ax)
    data = fit.data
    loads = data._core.has_loads
    x = data.T if loads else np.degrees(data.psi)
    ax.axhline(0, color="0.7", linewidth=1)
    used = fit.used_points
    _draw_runs(ax, data, x[used], fit.residuals, data.run_of_point[used])
    y = "residual [standard errors]" if fit.objective == "curve" else "residual"
    return _finished(ax, _label("T", data.units["force"]) if loads else "psi [deg]", y, legend=len(data.runs) > 1)


def profile(fit: Any, parameter: str | None = None, ax: Axes | None = None) -> Axes:
    """Draws the profile likelihood of a parameter: the rise of the cost when it is held, and the limit of the interval.

    Parameters
    ----------
    fit, ax
        As for :func:`area`.
    parameter : str, optional
        The model's first by default.

    Returns
    -------
    matplotlib Axes
        ``ax``, or the new axes.

    Raises
    ------
    InputError
        If there is no such parameter, or if it is held, at a bound or not identifiable.
    """
    if parameter is None:
        parameter = next(iter(fit.params))
    if parameter not in fit.params:
        raise InputError(f"this fit of model '{fit.model}' has no parameter '{parameter}'; there are {', '.join(fit.params)}")
    x, rise, level = fit._fits._results.profile(fit._index, parameter)
    if not len(x):
        raise InputError(f"'{parameter}' is held, at a bound or not identifiable: there is no profile to draw")
    ax = _axes(ax)
    ax.plot(x, rise, color=_style(fit)[0])
    ax.axhline(level, color="0.6", linestyle="--")
    return _finished(ax, _label(parameter, fit.params[parameter].unit), "rise of the cost [variances]")


def budget(fit: Any, ax: Axes | None = None) -> Axes:
    """Draws the shares of the first parameter's variance: scatter, and the uncertainty of each constant.

    Parameters
    ----------
    fit, ax
        As for :func:`area`.

    Returns
    -------
    matplotlib Axes
        ``ax``, or the new axes.

    Raises
    ------
    InputError
        If the fit has no budget.
    """
    ax = _axes(ax)
    found = fit.budget
    if not found or found["scatter"] is None:
        raise InputError("this fit has no budget: no parameter of it is free and inside its bounds")
    parts = [("scatter", found["scatter"]), *((part["constant"], part["share"]) for part in found["parts"])]
    left = 0.0
    for i, (name, share) in enumerate(parts):
        ax.barh(0, share, left=left, color=f"{0.35 + 0.5 * i / max(1, len(parts) - 1):.2f}", edgecolor="white", label=name)
        left += share
    ax.set_yticks([])
    ax.set_ylim(-1, 1)
    ax.set_xlim(0, 1)
    ax.set_xlabel(f"share of the variance of {found['parameter']}")
    ax.legend(frameon=False, ncols=2, loc="lower center", bbox_to_anchor=(0.5, 1))
    return ax


def loads(plan: Any, least: Any, most: Any, rivals: Any = "abc", ax: Axes | None = None) -> Axes:
    """Draws the expected error of lambda [%] against the load [mN] of one more run of a plan.

    A second axis has the odds against the rival that is hardest to distinguish, as a power of ten.

    Parameters
    ----------
    plan : Plan
        The experiment so far.
    least, most, rivals
        As for :meth:`Plan.next_loads`.
    ax
        As for :func:`area`.

    Returns
    -------
    matplotlib Axes
        ``ax``, or the new axes.
    """
    ax = _axes(ax)
    candidates = plan.next_loads(least, most, 41, rivals)
    scale, label = (1e6, "approach of the next run [um]") if plan._approach else (1e3, "load of the next run [mN]")
    load = [scale * one for one, _ in candidates]
    guess = plan._given[1][0]
    error = [np.nan if found["standard_error"] is None else 100 * found["standard_error"] / guess for _, found in candidates]
    ax.plot(load, error, "-", color=_STYLE["c"][0], label="error of lambda")
    _finished(ax, label, "expected error of lambda [%]")
    odds = [min(found["chi2"].values(), default=np.nan) / (2 * np.log(10)) for _, found in candidates]
    if np.isfinite(odds).any():
        right = ax.twinx()
        right.plot(load, odds, "--", color=_STYLE["b"][0], label="odds")
        right.set_ylabel("odds against the nearest model [power of ten]")
        right.legend(*(sum(pair, []) for pair in zip(ax.get_legend_handles_labels(), right.get_legend_handles_labels())), frameon=False)
    return ax
