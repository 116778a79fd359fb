"""Results as rows, JSON and Markdown."""

import json
import math

import numpy as np

from coverage_of_tools import problems
from coverage_of_tools.campaign import number_of
from coverage_of_tools.objectives import COVERAGES

FEWEST = 16  # answers; coverage of fewer is not shown
HEADER = ["tool", "n", "68 %", "95 %", "width", "bias", "says so, %", "does not say so, %"]


def share(flags):
    """In %, and its standard error (Agresti-Coull)."""
    if not flags:
        return None, None
    n, k = len(flags), sum(flags)
    middle = (k + 2) / (n + 4)
    return 100 * k / n, 100 * math.sqrt(middle * (1 - middle) / (n + 4))


def row_of(tool, lines, truth):
    """Of one tool in one cell. Coverage, width and bias are of the answers that the tool does not itself call a failure."""
    every = [(line, line["tools"][tool]) for line in lines if tool in line["tools"]]
    good = [(line, one) for line, one in every if not one["said"] and one["ends"]]
    row = {"replicates": len(every), "answers": len(good), "said": share([bool(one["said"]) for _, one in every])[0]}
    for level in COVERAGES:
        found = [[number_of(end) for end in one["ends"][level]] for _, one in good if level in one["ends"]]
        row[f"coverage {level}"], row[f"error {level}"] = share([low <= truth <= high for low, high in found])
    everyone = [[number_of(end) for end in one["ends"]["95"]] for _, one in every if "95" in one["ends"]]
    row["coverage 95 of all"] = share([low <= truth <= high for low, high in everyone])[0]
    widths = [width(one["ends"]["95"]) / width(line["exact"][1]["95"])
              for line, one in good if "exact" in line and "95" in one["ends"]]
    row["width"] = float(np.median(widths)) if widths else None
    pulls = [(number_of(one["value"]) - truth) / number_of(one["stderr"]) for _, one in good]
    pulls = [one for one in pulls if math.isfinite(one)]
    row["bias"] = float(np.median(pulls)) if pulls else None
    judged = [one["unsaid"] for _, one in every if one.get("unsaid") is not None]
    row["judged"], row["unsaid"] = len(judged), share(judged)[0]
    row["seconds"] = float(np.median([one["seconds"] for _, one in every]))
    said = {}
    for _, one in every:
        if one["said"]:
            said[one["said"][:60]] = said.get(one["said"][:60], 0) + 1
    row["most often said"] = max(said, key=said.get) if said else ""
    return row


def width(ends):
    low, high = (number_of(end) for end in ends)
    return high - low


def exact_row(lines, truth):
    found = [line["exact"][1] for line in lines if "exact" in line]
    row = {"replicates": len(found), "answers": len(found), "width": 1.0}
    for level in COVERAGES:
        row[f"coverage {level}"], row[f"error {level}"] = share([ends[level][0] <= truth <= ends[level][1] for ends in found])
    return row


def summary(lines, cells):
    """[{cell..., tools: {name: row}}], of the cells that have results."""
    by_cell = {}
    for (name, _), line in sorted(lines.items()):
        by_cell.setdefault(name, []).append(line)
    results = []
    for cell in cells:
        found = by_cell.get(problems.words(cell))
        if not found:
            continue
        truth = float(problems.PROBLEMS[cell.problem].truth)
        tools = sorted({tool for line in found for tool in line["tools"]}, key=order)
        rows = {"exact likelihood, true errors": exact_row(found, truth)}
        rows |= {tool: row_of(tool, found, truth) for tool in tools}
        results.append({**cell._asdict(), "cell": problems.words(cell), "truth": truth, "tools": rows})
    return results


ORDER = ["exact", "curve_fit", "least_squares", "scipy.odr", "odrpack", "lmfit", "iminuit", "emcee", "mixity, profile",
         "mixity, Wald", "mixity, credible", "mixity, bootstrap", "mixity"]


def order(tool):
    return next(i for i, name in enumerate(ORDER) if tool.startswith(name)), tool


def tools_of(rows_of_cells):
    """Names of all tools of these cells, in the order of the tables."""
    return sorted({tool for rows in rows_of_cells for tool in rows}, key=order)


def cells_of(tool, row):
    def shown(key, form, error=None):
        value = row.get(key)
        if value is None or row.get("answers", 0) < FEWEST and key not in ("said", "unsaid"):
            return ""
        return format(value, form) + (f" ± {row[error]:.1f}" if error else "")
    return [tool, str(row["replicates"]), shown("coverage 68", ".1f", "error 68"), shown("coverage 95", ".1f", "error 95"),
            shown("width", ".3g"), shown("bias", "+.2f"), shown("said", ".1f"), shown("unsaid", ".1f")]


def text(results):
    from peers.markdown import markdown

    parts = []
    for result in results:
        rows = [cells_of(tool, row) for tool, row in result["tools"].items()]
        parts.append(f"{result['cell']}\n\n{markdown(HEADER, rows)}\n")
    return "\n".join(parts)


VARIATIONS = {"known": "known", "to a factor": "factor", "proportional": "prop.", "floor and proportional": "floor + prop.",
              "memory 0.6": "memory", "2 % outliers": "outliers", 6: "6 pts", 100: "100 pts", 1000: "1000 pts"}
MARK = "<!-- tables: tools/who_covers writes what follows -->"


def variation(result):
    """What differs from the base cell, or "" for it."""
    return next((result[key] for key, base in problems.BASE.items() if result[key] != base), "")


def by_problem(results, name):
    """A row for each tool: its base cell in full, and the 95 % coverage of the others."""
    found = {variation(result): result["tools"] for result in results if result["problem"] == name}
    tools = tools_of(found.values())
    others = [key for key in VARIATIONS if key in found]
    rows = []
    for tool in tools:
        base = cells_of(tool, found.get("", {}).get(tool, {"replicates": ""}))
        rows.append([tool, *base[1:], *(whole(found[key].get(tool, {})) for key in others)])
    return [*HEADER, *(VARIATIONS[key] for key in others)], rows


def whole(row):
    """Coverage in whole %; of fewer answers than 16 it says nothing."""
    return f"{row['coverage 95']:.0f}" if row.get("coverage 95") is not None and row["answers"] >= FEWEST else ""


def page_tables(results):
    from peers.markdown import markdown

    parts = []
    for name, problem in problems.PROBLEMS.items():
        if any(result["problem"] == name for result in results):
            parts.append(f"### {name}: {problem.title}\n\n![Coverage and width of every tool](who_covers_{name}.svg)\n\n"
                         f"{markdown(*by_problem(results, name))}\n")
    return "\n".join(parts)


def rounded(value):
    """To digits from which the page's are the same."""
    if isinstance(value, dict):
        return {key: rounded(one) for key, one in value.items()}
    if isinstance(value, list):
        return [rounded(one) for one in value]
    if isinstance(value, float):
        return float(f"{value:.6g}") if math.isfinite(value) else None
    return value


def with_earlier(results, folder):
    """The cells that the JSON in this folder has, with these in place of the same ones."""
    path = folder / "who_covers.json"
    found = {result["cell"]: result for result in json.loads(path.read_text(encoding="utf-8"))} if path.is_file() else {}
    found |= {result["cell"]: result for result in results}
    return [found[words] for words in map(problems.words, problems.cells()) if words in found]


def write(results, folder):
    """JSON, and the tables at the end of the page if there is one."""
    lines = ",\n".join(json.dumps(rounded(result)) for result in results)
    (folder / "who_covers.json").write_text(f"[\n{lines}\n]\n", encoding="utf-8")
    page = folder / "who_covers.md"
    above = page.read_text(encoding="utf-8").partition(MARK)[0] if page.is_file() else ""
    page.write_text(f"{above}{MARK}\n\n{page_tables(results)}", encoding="utf-8")
