"""Plans, simulated experiments, and campaigns on other processes."""

import functools
import pathlib
import pickle
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ProcessPoolExecutor

import pytest

import mixity

CONSTANTS = dict(radius="9.42 mm", modulus="2.133 MPa +/- 3%", toughness="27 mJ/m^2")


def task(plan, seed, index):
    parameter = mixity.fit(plan.simulate(seed, index), "c", checks=False, compare=False)["c"].params["lambda"]
    return index, parameter.value, parameter.interval


def slow_task(plan, seed, index):
    time.sleep(0.05)
    return task(plan, seed, index)


@pytest.fixture
def plan():
    return mixity.Plan("c", 0.01, [1e-3, 4e-3], **CONSTANTS)


def test_experiments_are_a_function_of_plan_seed_and_index(plan):
    again = pickle.loads(pickle.dumps(plan))
    assert again.simulate(3, 8).A.tolist() == plan.simulate(3, 8).A.tolist()
    assert again.simulate(3, 9).A.tolist() != plan.simulate(3, 8).A.tolist()
    data = plan.simulate(3, 8)
    assert pickle.loads(pickle.dumps(data)).T.tolist() == data.T.tolist()


def test_expected_errors_are_those_of_experiments(plan):
    found = plan.experiments(500, seed=2)
    # 500 experiments tell a spread to 3 %
    assert plan.expect()["standard_error"] == pytest.approx(found["spread"], rel=0.1)
    assert found["covered"] == pytest.approx(0.95, abs=0.03)


def test_chosen_loads_are_better(plan):
    chosen = mixity.design(plan, 0.5e-3, 10e-3, runs=2)
    assert len(chosen.loads) == 4
    even = plan.with_loads([*plan.loads, 3e-3, 6e-3])
    assert chosen.expect("")["standard_error"] < even.expect("")["standard_error"]
    loads, expected = zip(*plan.next_loads(0.5e-3, 10e-3, 5))
    assert loads[0] == 0.5e-3 and loads[-1] == 10e-3
    assert set(expected[0]["chi2"]) == {"a", "b"}


def test_a_plan_draws_what_each_load_would_tell(plan):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    axes = plt.figure().gca()
    assert plan.plot_loads(0.5e-3, 10e-3, ax=axes) is axes
    assert len(axes.lines) == 1 and "error" in axes.get_ylabel()
    plt.close("all")


def test_a_plan_that_cannot_be_is_refused():
    with pytest.raises(mixity.InputError, match="pull-off"):
        mixity.Plan("c", 0.01, [-1.0], **CONSTANTS)
    with pytest.raises(mixity.InputError, match="must be stated"):
        mixity.Plan("c", 0.01, [1e-3])
    with pytest.raises(mixity.InputError, match="sigma_A"):
        mixity.Plan("c", 0.01, [1e-3], sigma_A="much", **CONSTANTS)


def test_ctrl_c_ends_a_search_for_loads():
    plan = mixity.Plan("c", 0.01, [1e-3], points=2000, **CONSTANTS)
    threading.Timer(0.5, signal.raise_signal, [signal.SIGINT]).start()
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        plan.next_loads(0.5e-3, 10e-3, 4000)
    assert time.monotonic() - begin < 10


def test_campaigns_give_the_same_in_other_processes(plan):
    work = functools.partial(task, plan, 5)
    here = mixity.campaign(work, 24)
    with ProcessPoolExecutor(2) as pool:
        assert mixity.campaign(work, 24, pool) == here
    assert [one[0] for one in here] == list(range(24))


def test_campaigns_lose_nothing_when_a_worker_is_killed(plan):
    distributed = pytest.importorskip("distributed")
    work = functools.partial(slow_task, plan, 5)
    here = mixity.campaign(functools.partial(task, plan, 5), 60)
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None
    ) as cluster, distributed.Client(cluster) as client:
        tasks_before = client.submit(time.sleep, 0)
        tasks_before.result()
        victim = list(cluster.workers.values())[0]

        class Killer:
            """Submits as the client does, and kills one of the workers when half of the tasks are there."""

            def __init__(self):
                self.submitted = 0

            def submit(self, *arguments):
                self.submitted += 1
                future = client.submit(*arguments, pure=False)
                if self.submitted == 10:
                    time.sleep(0.3)
                    victim.process.process.kill()
                return future

        assert mixity.campaign(work, 60, Killer(), chunk=3) == here


def test_calibrate_says_the_same_on_one_process_and_on_two():
    tool = pathlib.Path(__file__).parents[2] / "tools/calibrate"
    told = [
        subprocess.run(
            [sys.executable, tool, "--models=c", "--lambdas=0.15", "--replicates=6", "--compare-replicates=2", f"--jobs={jobs}"],
            capture_output=True, text=True, check=True,
        ).stdout
        for jobs in (1, 2)
    ]
    assert told[0] == told[1]
    rows = [line.split("|") for line in told[0].splitlines() if line.startswith("|     c")]
    assert len(rows) == 6 and all(row[4].strip() in ("6", "2") for row in rows)
