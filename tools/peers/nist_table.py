"""Tables of NIST's sets: who finds the certified values, and who says so."""

import math
import statistics

from peers import tables
from peers.markdown import markdown

RIGHT = 1e-6  # six digits of the worst parameter
FAR = 1e-2
TIGHT = " 1e-15"
CERTIFIED = 1e-11  # NIST gives no more
HEADER = ["solver", "right", "digits, mean", "worst", 'wrong but "converged"', "wrong and said so",
          "right but not said", "time, median ratio"]


def digits(row):
    return -math.log10(max(row["error"], CERTIFIED)) if row["error"] < 1 else 0


def is_right(row):
    return row["error"] <= RIGHT and tables.claims_right(row)


def summary(cases):
    """One line per solver. Times are compared with the first's, over the starts at which both are right."""
    unit = tables.methods_of(cases)[0]
    lines = []
    for method in tables.methods_of(cases):
        rows = {case: row for case, rows in cases.items() for row in rows if row["method"] == method}
        right = [row for row in rows.values() if is_right(row)]
        found = [digits(row) for row in right]
        ratios = [rows[case]["median_ns"] / other["median_ns"] for case, all_rows in cases.items()
                  for other in all_rows if other["method"] == unit and is_right(other) and is_right(rows[case])]
        wrong = [row for row in rows.values() if row["error"] > RIGHT]
        silent = [row for row in wrong if tables.claims_right(row)]
        far = sum(not row["error"] <= FAR for row in silent)
        lines.append([method, f"{len(right)} of {len(rows)}", f"{statistics.mean(found):.1f}", f"{min(found):.1f}",
                      f"{len(silent)}, {far} by more than 1 %" if far else str(len(silent)),
                      str(len(wrong) - len(silent)), str(len(rows) - len(right) - len(wrong)),
                      f"{statistics.median(ratios):.2g}"])
    return "\n" + markdown(HEADER, lines)


def each(cases):
    """The digits of each start: marked where they are too few, in brackets where the solver says so."""
    def cell(row):
        text = f"{digits(row):.1f}" + (" WRONG" if row["error"] > RIGHT else "")
        return text if tables.claims_right(row) else f"({digits(row):.1f})"

    methods = tables.methods_of(cases)
    return "\n" + markdown(["digits", *methods], [[case, *map(cell, rows)] for case, rows in cases.items()])


def panels(cases):
    """What is drawn: all starts of a solver that it calls solved, mixity's in both panels. Errors of less than NIST's
    digits say nothing, nor do differences between those above 1."""
    rows = [row | {"error": min(max(row["error"], CERTIFIED), 1)} for of_case in cases.values() for row in of_case
            if tables.claims_right(row)]
    ours = [row for row in rows if row["method"] == "mixity"]
    usual = [row for row in rows if not row["method"].startswith("mixity") and not row["method"].endswith(TIGHT)]
    tight = [row | {"method": row["method"].removesuffix(TIGHT)} for row in rows if row["method"].endswith(TIGHT)]
    return {"usual tolerances": ours + usual, "1e-15 everywhere": ours + tight}


def show(task, text, summary_only):
    """Prints both tables, or the summary alone; returns what is drawn."""
    print(f"\n## {task}")
    cases = tables.read(text)
    if not summary_only:
        print(each(cases))
    print(summary(cases), flush=True)
    return panels(cases)
