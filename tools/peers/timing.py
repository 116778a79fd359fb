"""Runs tasks in turn, times them and shows the times side by side."""

import collections
import json
import resource
import statistics
import subprocess
import time

import numpy as np

from peers.markdown import show_time

OwnTime = collections.namedtuple("OwnTime", "seconds")  # what a task returns that has its own clock


def run(command):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        raise RuntimeError(f"{str(command)[:80]} ended with code {done.returncode}: {done.stderr[-300:]}")
    return done.stdout


def benchmark(program, name, field="cpu_time"):
    """Seconds that a Google Benchmark program takes for one of its tasks; `field` may be a counter of seconds."""
    text = run([program, f"--benchmark_filter=^{name}$", "--benchmark_min_time=0.02", "--benchmark_format=json"])
    value = json.loads(text)["benchmarks"][0][field]
    return OwnTime(value * 1e-9 if field == "cpu_time" else value)


def cpu_time():
    """Seconds of this process and of those it has waited for."""
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.process_time() + children.ru_utime + children.ru_stime


CLOCKS = {"cpu": cpu_time, "wall": time.perf_counter}


def alternate(tasks, repetitions, clock):
    """Times of every task, taken in turn after one round to warm up, and its last answer."""
    answers = {name: task() for name, task in tasks.items()}
    times = {name: [] for name in tasks}
    for _ in range(repetitions):
        for name, task in tasks.items():
            start = CLOCKS[clock]()
            answers[name] = task()
            seconds = CLOCKS[clock]() - start
            times[name].append(answers[name].seconds if isinstance(answers[name], OwnTime) else seconds)
    return {name: np.array(taken) for name, taken in times.items()}, answers


def time_cells(times):
    """Name, median, spread, ratio of each task; the first is what the others are compared with."""
    unit = statistics.median(next(iter(times.values())))
    for name, taken in times.items():
        low, middle, high = statistics.quantiles(taken, n=4, method="inclusive")
        yield [name, show_time(middle), show_time((high - low) / 2), f"{middle / unit:.3g}"]
