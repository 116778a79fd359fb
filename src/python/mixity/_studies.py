"""Planned and simulated experiments, and campaigns of many on one or several machines."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable, Sequence

from . import _core, plots
from ._arrays import numbers
from ._data import Dataset, stated_constants
from ._law import Law, define, definitions, key_of, model_keys
from ._units import error_text, load_list, load_number, whole_number

if TYPE_CHECKING:
    Models = str | Law | Sequence[str | Law]


def _keys(models: Models) -> list[str]:
    """"abc", "bk", "a,bk" or a list as a list of keys."""
    keys = model_keys(models)
    return [key.strip() for key in keys.split(",") if key.strip()] if isinstance(keys, str) else list(keys)


class Plan:
    """A planned experiment.

    Parameters
    ----------
    model : str or Law
        The law that is expected to hold.
    lam : float or tuple
        The guess; a tuple for a model with several parameters.
    loads : sequence of float, or str
        Normal load of each run [N], or held approach [m], a text with units ("1,4 mN") or quantities; empty to have them found. With
        ``control="approach"`` the approaches [m] ("3,8 um"), here and wherever loads are named below.
    points : int
        Number of points per run, at equal steps of T from 0.
    reach : float
        The largest T, as a fraction of the T at which the contact jumps.
    sigma_T, sigma_A : str or float
        Standard errors: "1%" of each value, or a quantity ("0.2 mN", "0.002 mm^2", floats in SI, quantities).
    **constants
        Those of :class:`mixity.Dataset`; those with an error are nuisance parameters with a prior.

    Examples
    --------
    >>> plan = Plan("c", 0.01, [1e-3, 4e-3], radius="9.42 mm", modulus="2.133 MPa +/- 5%", toughness="27 mJ/m^2")
    >>> expected = plan.expect()
    >>> 0 < expected["standard_error"] < 0.01
    True
    """

    def __init__(
        self,
        model: str | Law,
        lam: float | tuple[float, ...],
        loads: Any = (),
        *,
        points: int = 25,
        reach: float = 0.9,
        sigma_T: Any = "1%",
        sigma_A: Any = "1%",
        **constants: Any,
    ) -> None:
        key = key_of(model)
        parameters = numbers(lam)
        stated = stated_constants(constants)
        sigma_T, sigma_A = error_text("sigma_T", sigma_T), error_text("sigma_A", sigma_A)
        points = whole_number("points", points, 1)
        self._approach = constants.get("control") == "approach"
        loads = load_list("loads", loads, self._approach)
        self._given = (key, parameters, stated, loads, points, float(reach), sigma_T, sigma_A)
        self._core = _core.Plan(*self._given)

    def __reduce__(self) -> tuple[Any, ...]:
        return _plan_again, (self._given, definitions([self._given[0]]))

    @property
    def loads(self) -> list[float]:
        """Normal loads [N], or held approaches [m]."""
        return self._core.loads

    def with_loads(self, loads: Any) -> Plan:
        """The same plan at other loads.

        Parameters
        ----------
        loads : sequence of float, or str
            As for the plan, in N.

        Returns
        -------
        Plan
            A new one.
        """
        given = list(self._given)
        given[3] = load_list("loads", loads, self._approach)
        return _plan_again(tuple(given))

    def simulate(self, seed: int = 1, index: int | None = 0) -> Dataset:
        """One simulated experiment as a data set, the same on every machine.

        Parameters
        ----------
        seed : int
            The stream of random numbers.
        index : int or None
            The experiment of that stream; None: readings and constants without errors.

        Returns
        -------
        Dataset
            Ready to fit.
        """
        seed, index = whole_number("seed", seed), None if index is None else whole_number("index", index)
        return Dataset._of(self._core.simulate(seed, index), ("simulated", (self, seed, index)))

    def expect(self, rivals: Models = "abc") -> dict[str, Any]:
        """The expected results of the plan.

        Parameters
        ----------
        rivals : str, Law, or list of them
            The models to tell apart, as in :func:`fit`.

        Returns
        -------
        dict
            {"standard_error": of lambda, or None, "chi2": {rival: T-criterion}}.

        Notes
        -----
        The error is that of the Fisher information with the constants as nuisance parameters (Ds-optimality, Silvey
        1980); chi2/2 is the expected logarithm of the odds against a rival (Atkinson & Fedorov 1975).
        """
        return self._core.expect(_keys(rivals))

    def next_loads(
        self, least: Any, most: Any, candidates: int = 21, rivals: Models = "abc"
    ) -> list[tuple[float, dict[str, Any]]]:
        """What one more run would bring, at several loads.

        Parameters
        ----------
        least, most : float or str
            The range of loads, in N or with a unit.
        candidates : int
            Number of loads, at least 2.
        rivals : str, Law, or list of them
            As for :meth:`expect`.

        Returns
        -------
        list of (float, dict)
            Load [N] or held approach [m], and what :meth:`expect` returns for the plan with a run at it.
        """
        least, most = (load_number(name, one, self._approach) for name, one in (("least", least), ("most", most)))
        return self._core.next_loads(least, most, whole_number("candidates", candidates, 2), _keys(rivals))

    plot_loads = plots.loads

    def best(self, least: Any, most: Any, runs: int, goal: str = "error", rivals: Models = "abc") -> Plan:
        """The plan with more runs, at the best loads.

        Parameters
        ----------
        least, most : float or str
            The range of loads, in N or with a unit.
        runs : int
            Number of runs to add.
        goal : {"error", "model"}
            The smallest error of lambda, or the greatest odds against the nearest rival.
        rivals : str, Law, or list of them
            As for :meth:`expect`.

        Returns
        -------
        Plan
            A new one.

        Raises
        ------
        ValueError
            For another goal.
        """
        if goal not in ("error", "model"):
            raise ValueError("goal must be 'error' or 'model'")
        least, most = (load_number(name, one, self._approach) for name, one in (("least", least), ("most", most)))
        return self.with_loads(self._core.best(least, most, whole_number("runs", runs), goal == "model", _keys(rivals)).loads)

    def experiments(
        self, count: int, seed: int = 1, rivals: Models = "", progress: Callable[[float], Any] | None = None
    ) -> dict[str, Any]:
        """Simulates and fits experiments of the plan.

        Parameters
        ----------
        count : int
            Number of experiments, at least 2.
        seed : int
            The stream of random numbers.
        rivals : str, Law, or list of them
            Models that are fitted, too.
        progress : callable, optional
            Called with the fraction done, 0..1.

        Returns
        -------
        dict
            Mean and spread of lambda, the mean standard error, the share of 95 % intervals that contain the true value,
            and with rivals the share of experiments that find the right model.
        """
        count = whole_number("count", count, 2)  # a spread needs two
        return self._core.experiments(whole_number("seed", seed), count, _keys(rivals), progress or None)


def _plan_again(given: tuple[Any, ...], laws: Sequence[Any] = ()) -> Plan:
    define(laws)
    model, parameters, stated, loads, points, reach, sigma_T, sigma_A = given
    return Plan(
        model, tuple(parameters), loads, points=points, reach=reach, sigma_T=sigma_T, sigma_A=sigma_A, **dict(stated)
    )


def simulate(plan: Plan, seed: int = 1, index: int | None = 0) -> Dataset:
    """One simulated experiment of a plan.

    Parameters
    ----------
    plan : Plan
        The experiment.
    seed, index
        As for :meth:`Plan.simulate`.

    Returns
    -------
    Dataset
        Ready to fit.
    """
    return plan.simulate(seed, index)


def design(
    plan: Plan, least: Any, most: Any, runs: int = 1, goal: str = "error", rivals: Models = "abc"
) -> Plan:
    """A plan with more runs, at the best loads.

    Parameters
    ----------
    plan : Plan
        The experiment so far.
    least, most, runs, goal, rivals
        As for :meth:`Plan.best`.

    Returns
    -------
    Plan
        A new one.
    """
    return plan.best(least, most, runs, goal, rivals)


def _some(function, indices):
    return [function(index) for index in indices]


def campaign(function: Callable[[int], Any], count: int, executor: Any = None, chunk: int | None = None) -> list[Any]:
    """Results of ``function(0)`` to ``function(count - 1)``, in order, the same on every machine.

    Parameters
    ----------
    function : callable
        A pure function, which depends on its argument alone, such as ``functools.partial(task, plan, seed)``. For
        executors of other processes it must pickle, and so must its results.
    count : int
        Number of calls.
    executor : optional
        None: one after the other, in this process. Else anything with ``submit``: an executor of ``concurrent.futures``, or
        a ``distributed.Client`` (which repeats the work of a worker that dies on another).
    chunk : int, optional
        Number of calls in one task; by default such that there are about sixty tasks.

    Returns
    -------
    list
        The results.

    Examples
    --------
    >>> campaign(abs, 3)
    [0, 1, 2]
    """
    if executor is None:
        return _some(function, range(count))
    if chunk is not None and (chunk != int(chunk) or chunk < 1):
        raise ValueError(f"chunk is {chunk}; it must be a whole number above 0")
    size = int(chunk) if chunk else max(1, -(-count // 64))
    tasks = [executor.submit(_some, function, range(i, min(i + size, count))) for i in range(0, count, size)]
    return [result for task in tasks for result in task.result()]
