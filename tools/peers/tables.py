"""Tables of work against precision: what the programs precision_TASK print as CSV, for readers."""

import collections
import csv
import io
import math

from peers.markdown import markdown, show_time

TABLES = ("predict", "drawing", "fit", "curve")  # what convergence prints is for readers already
ROUNDING = 1.1e-16  # half the distance of doubles: a smaller error is luck
NUMBERS = ("tolerance", "error", "evaluations", "median_ns", "spread_ns")
CLAIMS_RIGHT = ("ok", "converged", "at_bound")
GOOD = collections.defaultdict(lambda: 1e-9, drawing=1e-3)  # what answers must reach to be compared with
HEADER = ["method", "tolerance", "error", "median", "spread", "ratio", "evaluations", "digits/evaluation", ""]


def read(text):
    """Rows of each case, in their order."""
    cases = collections.defaultdict(list)
    for row in csv.DictReader(io.StringIO(text)):
        cases[row["case"]].append({**row, **{name: float(row[name]) for name in NUMBERS}})
    return cases


def claims_right(row):
    return row["claim"] in CLAIMS_RIGHT


def reference(rows):
    """The row others are compared with."""
    right = [row for row in rows if claims_right(row) and math.isfinite(row["error"])] or rows
    good = [row for row in right if row["error"] <= GOOD[row["task"]]]
    return min(good, key=lambda row: row["median_ns"]) if good else min(right, key=lambda row: row["error"])


def verdict(row):
    if not claims_right(row):
        return row["claim"]
    word = "at bound" if row["claim"] == "at_bound" else ""
    if row["tolerance"] >= 2 or row["error"] <= 10 * row["tolerance"]:  # a number of points promises nothing
        return word
    return "WRONG" if not row["error"] <= 1e-3 else "missed" if row["tolerance"] > 0 else word


def show_tolerance(value):
    return "" if value == 0 else f"N = {value:.0f}" if value >= 2 else f"{value:.0e}"


def cells(row, fastest):
    error, count = row["error"], row["evaluations"]
    digits = f"{-math.log10(max(error, ROUNDING)) / count:.2g}" if count > 0 and 0 <= error < 1 else ""
    return [row["method"], show_tolerance(row["tolerance"]), f"{error:.1e}", show_time(row["median_ns"] * 1e-9),
            show_time(row["spread_ns"] * 1e-9), f"{row['median_ns'] / fastest['median_ns']:.3g}",
            f"{count:g}" if count > 0 else "", digits, verdict(row)]


def tables(cases):
    for case, rows in cases.items():
        header = [*HEADER[:6], "points", "digits/point", ""] if rows[0]["task"] == "drawing" else HEADER
        yield f"\n{case}\n\n" + markdown(header, [cells(row, reference(rows)) for row in rows])


def methods_of(cases):
    return list(dict.fromkeys(row["method"] for rows in cases.values() for row in rows))


def least_time(rows, method, target):
    return min((row["median_ns"] for row in rows
                if row["method"] == method and claims_right(row) and row["error"] <= target), default=math.inf)


def summary(cases, target):
    """The least time in which each method reaches an error, of the answers it says are right."""
    methods = methods_of(cases)
    lines = []
    for case, rows in cases.items():
        times = [least_time(rows, method, target) for method in methods]
        lines.append([case, *(show_time(time * 1e-9) if math.isfinite(time) else "-" for time in times)])
    return f"\nTime to reach an error of {target:.0e}\n\n" + markdown(["case", *methods], lines)


def show_range(values, with_mean=False):
    found = [value for value in values if math.isfinite(value)]
    if not found:
        return "never"
    lost = f", {len(values) - len(found)} of {len(values)} never" if len(found) < len(values) else ""
    spread = f"{min(found):.2g} to {max(found):.2g}"
    if with_mean:
        spread = f"{math.exp(sum(map(math.log, found)) / len(found)):.2g} ({spread})"
    return spread + lost


def ratios(cases, target):
    """The same as multiples of mixity's time: the range over the cases of each model."""
    ranges = collections.defaultdict(list)
    for case, rows in cases.items():
        for method in dict.fromkeys(row["method"] for row in rows):
            ratio = least_time(rows, method, target) / least_time(rows, "mixity", target)
            ranges[case.split(",")[0], method].append(ratio)
    methods, models = (list(dict.fromkeys(key[i] for key in ranges)) for i in (1, 0))
    lines = [[method, *(show_range(ranges[model, method]) for model in models)] for method in methods]
    return ("\nThe same in units of mixity's time, range over the cases of a model\n\n" +
            markdown(["method", *(f"model {model}" for model in models)], lines))


def mean_ratios(cases, target, units, which="all"):
    """Multiples of the times of some methods: geometric mean and range over the cases."""
    def ratios_to(unit, method):
        times = [(least_time(rows, method, target), least_time(rows, unit, target)) for rows in cases.values()]
        return [time / of for time, of in times if math.isfinite(of)]

    lines = [[method, *(show_range(ratios_to(unit, method), with_mean=True) for unit in units)]
             for method in methods_of(cases)]
    return (f"\nTime to reach {target:.0e} in units of other times, geometric mean and range over {which} cases\n\n" +
            markdown(["method", *(f"in units of {unit}" for unit in units)], lines))


def show(task, text, summary_only):
    """Prints all tables of a program's text; returns the rows of each case."""
    print(f"\n## {task}")
    if task not in TABLES:
        print(text, flush=True)
        return {}
    cases = read(text)
    if not summary_only:
        print("\n".join(tables(cases)))
    targets = (1e-2, 1e-3, 1e-4) if task == "drawing" else (1e-9, 1e-12)
    print("\n".join(summary(cases, target) for target in targets), flush=True)
    if task == "predict":
        print(ratios(cases, targets[-1]), flush=True)
    if task in ("fit", "curve"):
        for kind, which in (("", "all"), ("clean", "clean"), ("noise", "noisy")):
            some = {case: rows for case, rows in cases.items() if case.endswith(kind)}
            print(mean_ratios(some, 1e-8, ("mixity kernel", "mixity whole fit"), which), flush=True)
    return cases
