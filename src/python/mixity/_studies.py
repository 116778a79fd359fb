"""Planned experiments, simulated ones, and campaigns of many on one machine or several."""

import numpy as np

from . import _core
from ._data import Dataset, _made
from ._fits import _model_keys
from ._law import define, definitions, key_of
from ._units import constant_text, plain_array


def _keys(models):
    """"abc", "bk", "a,bk" or a list as a list of keys."""
    keys = _model_keys(models)
    return [key.strip() for key in keys.split(",") if key.strip()] if isinstance(keys, str) else list(keys)


class Plan:
    """An experiment that is to be done.

    Parameters
    ----------
    model : str
    lam : float or tuple
        The guess; of a model with several parameters a tuple.
    loads : sequence of float
        Normal load of each run [N]; empty if they are to be found.
    points : int
        Of a run, at equal steps of T from 0.
    reach : float
        The longest T, as a share of that at which the contact jumps.
    sigma_T, sigma_A : str
        Standard errors: "1%" of each value, or a quantity ("0.2 mN", "0.002 mm^2").
    **constants
        As of :class:`mixity.Dataset`; those with an error count as nuisance parameters with a prior.

    Examples
    --------
    >>> plan = Plan("c", 0.01, [1e-3, 4e-3], radius="9.42 mm", modulus="2.133 MPa +/- 5%", toughness="27 mJ/m^2")
    >>> expected = plan.expect()
    >>> 0 < expected["standard_error"] < 0.01
    True
    """

    def __init__(self, model, lam, loads=(), *, points=25, reach=0.9, sigma_T="1%", sigma_A="1%", **constants):
        model = key_of(model)
        parameters = [float(one) for one in (lam if isinstance(lam, tuple) else (lam,))]
        stated = [(key, constant_text(key, value)) for key, value in constants.items()]
        if points != int(points) or points < 1:
            raise _core.InputError(f"points is {points}; it must be a whole number above 0")
        for name, error in (("sigma_T", sigma_T), ("sigma_A", sigma_A)):
            if not isinstance(error, str):
                raise _core.InputError(f"{name} is {error!r}; it must be a text such as \"1%\" or \"0.2 mN\"")
        loads = np.atleast_1d(plain_array("P", loads)).tolist()
        self._given = (model, parameters, stated, loads, int(points), float(reach), sigma_T, sigma_A)
        self._core = _made(_core.Plan, self._given)

    def __reduce__(self):
        return _plan_again, (self._given, definitions([self._given[0]]))

    @property
    def loads(self):
        """Normal loads [N]."""
        return self._core.loads

    def with_loads(self, loads):
        """The same plan at other loads [N]."""
        given = list(self._given)
        given[3] = [float(load) for load in loads]
        return _plan_again(tuple(given))

    def simulate(self, seed=1, index=0):
        """Experiment ``index`` of the stream ``seed`` as a data set: the same wherever it is made."""
        return Dataset._of(self._core.simulate(seed, index), ("simulated", (self, seed, index)))

    def expect(self, rivals="abc"):
        """What the plan will tell: {"standard_error": of lambda, "chi2": {rival: T-criterion}}.

        The error is that of the Fisher information with the constants as nuisance parameters (Ds-optimality, Silvey
        1980); chi2/2 is the expected logarithm of the odds against a rival (Atkinson & Fedorov 1975).
        """
        return self._core.expect(_keys(rivals))

    def next_loads(self, least, most, candidates=21, rivals="abc"):
        """[(load [N], expectation of the plan with it)] for one more run between two loads [N]."""
        return self._core.next_loads(least, most, candidates, _keys(rivals))

    def plot_loads(self, least, most, rivals="abc", ax=None):
        """The error of lambda and the odds between models with one more run, against its load; on matplotlib axes."""
        from . import plots

        return plots.loads(self, least, most, rivals, ax)

    def best(self, least, most, runs, goal="error", rivals="abc"):
        """The plan with so many more runs at the loads that serve best: goal "error" of lambda, or "model"."""
        if goal not in ("error", "model"):
            raise ValueError("goal must be 'error' or 'model'")
        return self.with_loads(self._core.best(least, most, runs, goal == "model", _keys(rivals)).loads)

    def experiments(self, count, seed=1, rivals="", progress=None):
        """Simulates and fits so many experiments: mean and spread of lambda, the mean stated standard error, the share of
        95 % intervals that hold the truth, and of experiments that decide for the right model (with rivals)."""
        if count < 2:
            raise _core.InputError(f"experiments is {count}; a spread needs two at least")
        return self._core.experiments(seed, int(count), _keys(rivals), progress or None)


def _plan_again(given, laws=()):
    define(laws)
    model, parameters, stated, loads, points, reach, sigma_T, sigma_A = given
    return Plan(
        model, tuple(parameters), loads, points=points, reach=reach, sigma_T=sigma_T, sigma_A=sigma_A, **dict(stated)
    )


def simulate(plan, seed=1, index=0):
    """Experiment ``index`` of the stream ``seed`` of a plan: see :meth:`Plan.simulate`."""
    return plan.simulate(seed, index)


def design(plan, least, most, runs=1, goal="error", rivals="abc"):
    """The best loads for more runs of a plan: see :meth:`Plan.best`."""
    return plan.best(least, most, runs, goal, rivals)


def _some(function, indices):
    return [function(index) for index in indices]


def campaign(function, count, executor=None, chunk=None):
    """Results of ``function(0)`` to ``function(count - 1)``, in order, the same wherever they are computed.

    Parameters
    ----------
    function : callable
        Pure: what it returns depends on its argument alone, such as ``functools.partial(task, plan, seed)``. For
        executors of other processes it must pickle, and so must its results.
    executor : optional
        None: one after the other, here. Else anything with ``submit``: ``concurrent.futures`` executors, or a
        ``distributed.Client`` (which gives the work of a worker that dies to another one).
    chunk : int, optional
        How many make one task; by default so many that there are some sixty tasks.

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
