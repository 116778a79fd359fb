"""Draws error against time, one line per method: gnuplot's script and data, and where it is installed the figure."""

import math
import shutil
import subprocess
import sys

from peers.tables import ROUNDING

# Okabe and Ito's colours, with a shape each for those who print in grey. mixity's stand out by size.
STYLES = {"mixity": ("#000000", 7), "mixity anew": ("#000000", 6), "mixity arrays": ("#000000", 9),
          "Newton": ("#D55E00", 4), "bracketed Newton": ("#CC79A7", 5), "Brent": ("#009E73", 8),
          "TOMS 748": ("#0072B2", 10), "bisection": ("#56B4E9", 2), "linear table": ("#E69F00", 1),
          "cubic table": ("#999999", 3), "mixity kernel": ("#000000", 7), "mixity whole fit": ("#000000", 6),
          "linearised": ("#009E73", 8)}
# Fits have a colour for each library and a shape for its derivatives.
LIBRARIES = {"Ceres": "#D55E00", "TinySolver": "#E69F00", "MINPACK": "#0072B2", "GSL": "#009E73",
             "SciPy": "#56B4E9", "ODRPACK": "#56B4E9", "lmfit": "#CC79A7"}
SHAPES = {"analytic": 5, "lmder": 5, "automatic": 13, "numeric": 4, "lmdif": 4}
SPARE = ["#D55E00", "#CC79A7", "#009E73", "#0072B2", "#56B4E9", "#E69F00"]


def look(method, spare):
    library, derivatives = method.split()[0], method.split()[-1]
    if method in STYLES:
        colour, shape = STYLES[method]
    elif library in LIBRARIES:
        colour, shape = LIBRARIES[library], SHAPES.get(derivatives, 7) + 4 * ("trf" in method)
    else:
        colour, shape = spare.setdefault(method, SPARE[len(spare) % len(SPARE)]), 7
    size = 1.5 if method in ("mixity anew", "mixity whole fit") else 1 if library == "mixity" else 0.6
    return f"lc rgb '{colour}' pt {shape} ps {size}"


def plot_data(panels):
    """One block of (time, error) for each method of each panel, and where each is."""
    blocks, places = [], []
    for case, rows in panels:
        for method in dict.fromkeys(row["method"] for row in rows):
            points = [(row["median_ns"] * 1e-9, max(row["error"], ROUNDING)) for row in rows
                      if row["method"] == method and math.isfinite(row["error"])]
            places.append((case, method, len(blocks), len(points)))
            blocks.append(f"# {case}: {method}; time [s], relative error\n" +
                          "".join(f"{time:.4g} {error:.3g}\n" for time, error in points))
    return "\n\n".join(blocks), places


TIMES = ("'1 ns' 1e-9, '10 ns' 1e-8, '100 ns' 1e-7, '1 us' 1e-6, '10 us' 1e-5, '100 us' 1e-4, '1 ms' 1e-3, "
         "'10 ms' 1e-2, '100 ms' 1e-1, '1 s' 1")
SWEEP = ("set yrange [1e-17:10]", "set ytics 1e-16,1e4,1")
SCATTER = ("set yrange [2e-12:5]", "set ytics 1e-12,1e2,1")
PANEL, LEGEND_ROW = 270, 25  # heights in pixels
BARE_TIMES = ", ".join(f"'' 1e-{n}" for n in range(10))


def legend_columns(methods):
    """As many as the longest names leave room for; gnuplot's own key would not keep to columns here."""
    return 2 if max(map(len, methods)) > 19 or max(map(len, methods[2::3])) > 14 else 3


def legend_rows(methods):
    return -(-len(methods) // legend_columns(methods))


def legend(methods, spare, height):
    columns = legend_columns(methods)
    for i, method in enumerate(methods):
        row = LEGEND_ROW * (legend_rows(methods) - i // columns)
        place = f"screen {0.06 + 0.99 / columns * (i % columns):.3f},{(row - 15) / height:.4f}"
        yield f"set label '{method}' at {place} offset 1,-0.25 font ',15' point {look(method, spare)}"


def plot_script(name, panels, places, joined):
    """Panels above each other with one legend below; text as large as it must be at a column's width of 8.6 cm."""
    times = [row["median_ns"] * 1e-9 for _, rows in panels for row in rows]
    methods = list(dict.fromkeys(method for _, method, _, _ in places))
    below = 74 + LEGEND_ROW * legend_rows(methods)
    pixels = below + PANEL * len(panels) + 26
    top, bottom, gap = 1 - 33 / pixels, below / pixels, 41 / pixels
    height = (top - bottom - gap * (len(panels) - 1)) / len(panels)
    lines = [f"# gnuplot draws {name}.svg of this and {name}.dat",
             f"set terminal svg size 520,{pixels} dynamic background '#ffffff' font 'Helvetica,16'",
             f"set output '{name}.svg'", "set logscale xy", "unset mxtics", "unset mytics",
             "set border lc rgb '#444444'",
             "set format y '10^{%L}'", "set lmargin screen 0.165", "set rmargin screen 0.97",
             "set grid lc rgb '#dddddd' lt 1", "set ylabel 'relative error' offset 1.2",
             f"set xrange [{min(times) / 2:.2g}:{max(times) * 2:.2g}]", *(SWEEP if joined else SCATTER),
             "set multiplot"]
    spare = {}
    for number, (case, _) in enumerate(panels):
        last = number + 1 == len(panels)
        high = top - number * (height + gap)
        lines += [f"set tmargin screen {high:.4f}", f"set bmargin screen {high - height:.4f}",
                  f"set title '{case}' noenhanced offset 0,-0.8",
                  "set xlabel 'time for one answer' offset 0,0.4" if last else "unset xlabel",
                  f"set xtics ({TIMES if last else BARE_TIMES})", "unset key"]
        if last:
            lines += legend(methods, spare, pixels)
        drawn = []
        for where, method, block, points in places:
            if where != case:
                continue
            line = "points" if points == 1 or not joined else "linespoints lw 1.5"
            drawn.append(f"'{name}.dat' index {block} with {line} {look(method, spare)}")
        lines.append("plot " + ", \\\n  ".join(drawn))
    return "\n".join([*lines, "unset multiplot", ""])


def draw(cases, wanted, path, joined=True):
    """Script and data stay beside the figure. `joined`: the rows of a method are a sweep."""
    missing = [case for case in wanted if case not in cases]
    if missing:
        sys.exit(f"tools/work_precision: no case '{missing[0]}'; there are:\n  " + "\n  ".join(cases))
    panels = [(case, cases[case]) for case in wanted]
    path.parent.mkdir(parents=True, exist_ok=True)
    data, places = plot_data(panels)
    path.with_suffix(".dat").write_text(data, encoding="utf-8")
    path.with_suffix(".gp").write_text(plot_script(path.stem, panels, places, joined), encoding="utf-8")
    if not shutil.which("gnuplot"):
        print(f"gnuplot is not installed: {path.with_suffix('.gp')} draws the figure", file=sys.stderr)
        return
    subprocess.run(["gnuplot", path.with_suffix(".gp").name], cwd=path.parent, check=True)
