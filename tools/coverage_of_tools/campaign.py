"""Runs tools on experiments. Each line of a result depends on cell and number alone, but for its times."""

import json
import math
import time
import warnings

import numpy as np

from coverage_of_tools import by_emcee, by_iminuit, by_lmfit, by_mixity, by_odrpack, by_scipy, objectives, problems

FAST = (by_scipy.curve_fit, by_scipy.effective_variance, by_scipy.orthogonal,
        *(by_odrpack.form(form, scheme) for form in ("explicit", "implicit") for scheme in ("forward", "central")),
        by_lmfit.wald, by_iminuit.hesse, by_iminuit.minos, by_mixity.default, by_mixity.bare, by_mixity.linear_scale)
SLOW = (by_lmfit.conf_interval, by_mixity.bootstrap, by_emcee.sample)  # where they are affordable
BATCH = 10  # replicates of one task


def affordable(tool, cell):
    if tool is by_emcee.sample:
        return cell.noise == "constant" and cell.points <= 20 and cell.errors in ("known", "unknown")
    return cell.points <= 100


def unsaid(problem, data, answer, lowest):
    """Whether a success is no minimum: a lower one, by what a tenth of a standard error makes, is known."""
    if answer.said or not answer.kind or answer.theta is None:
        return None
    here = objectives.squares(answer.kind, answer.theta, data)
    freedom = max(len(data.x) - len(problem.start), 1)
    return bool(not here - lowest[answer.kind] < 0.01 * max(1.0, lowest[answer.kind] / freedom))


def replicate(cell, number, options):
    problem, data = problems.PROBLEMS[cell.problem], problems.experiment(cell, number)
    line, answers = {"cell": problems.words(cell), "number": number, "tools": {}}, {}
    slow = [tool for tool in SLOW if affordable(tool, cell)] if number < options["slow"] else []
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        for tool in (*FAST, *slow):
            begin = time.thread_time()
            found = tool(problem, cell, data)
            seconds = time.thread_time() - begin
            for name, answer in (found() if callable(found) else found).items():
                answers[name] = answer
                ends = {level: [float(one) for one in both] for level, both in answer.ends.items()}
                line["tools"][name] = {"value": answer.value, "stderr": answer.stderr, "ends": ends, "said": answer.said[:200],
                                       "seconds": seconds}
        if number < options["judged"]:
            line["exact"] = objectives.exact_interval(problem, data)
            kinds = {answer.kind for answer in answers.values() if answer.kind}
            lowest = {kind: objectives.best(kind, problem, data)[1] for kind in kinds}
            for answer in answers.values():
                if answer.kind and answer.theta is not None:
                    at = objectives.squares(answer.kind, answer.theta, data)
                    lowest[answer.kind] = min(lowest[answer.kind], at) if math.isfinite(at) else lowest[answer.kind]
            for name, answer in answers.items():
                line["tools"][name]["unsaid"] = unsaid(problem, data, answer, lowest)
    return line


def batch(cell, numbers, options):
    return [json.dumps(plain(replicate(cell, number, options))) for number in numbers]


def plain(value):
    """As JSON has it: infinite and missing numbers as texts."""
    if isinstance(value, dict):
        return {key: plain(one) for key, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(one) for one in value]
    if isinstance(value, (bool, np.bool_)):
        return bool(value)
    if isinstance(value, (float, np.floating)):
        return float(f"{value:.10g}") if math.isfinite(value) else str(value)
    return value


def number_of(value):
    return math.nan if value is None else float(value)


def read(folder):
    """Lines by cell and number. A line that a killed run left in part is none."""
    lines = {}
    for path in sorted(folder.glob("*.jsonl")):
        for text in path.read_text(encoding="utf-8").splitlines():
            try:
                line = json.loads(text)
            except json.JSONDecodeError:
                continue
            lines[line["cell"], line["number"]] = line
    return lines


def run(cells, options, folder, executor, tell):
    """Does what is not there yet of this part, a cell at a time."""
    part, parts = options["part"]
    done = set(read(folder))
    path = folder / f"part_{part}_of_{parts}.jsonl"
    if path.exists() and not path.read_bytes().endswith(b"\n"):
        with open(path, "a", encoding="utf-8") as file:
            file.write("\n")
    for cell in cells:
        wanted = [one for one in range(options["replicates"])
                  if one % parts == part - 1 and (problems.words(cell), one) not in done]
        begin = time.perf_counter()
        tasks = [executor.submit(batch, cell, wanted[i : i + BATCH], options) for i in range(0, len(wanted), BATCH)]
        with open(path, "a", encoding="utf-8") as file:
            for task in tasks:
                for text in task.result():
                    file.write(text + "\n")
                file.flush()
        if wanted:
            tell(f"{problems.words(cell)}: {len(wanted)} in {time.perf_counter() - begin:.0f} s")


class Here:
    """An executor that computes in this process, when asked for a result."""

    def submit(self, function, *given):
        class Task:
            def result(self):
                return function(*given)

        return Task()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        return None
