"""One figure a problem: coverage of nominal 95 % and width of every tool, a mark for each cell. SVG, written by hand."""

import html
import math

from coverage_of_tools import problems, tables

# Okabe and Ito's colours, with a shape each for those who print in grey
MARKS = {"known": ("#0072B2", "o"), "to a factor": ("#56B4E9", "s"), "proportional": ("#009E73", "^"),
         "floor and proportional": ("#009E73", "v"), "memory 0.6": ("#D55E00", "d"), "2 % outliers": ("#CC79A7", "x"),
         6: ("#B8860B", "<"), 100: ("#B8860B", ">"), 1000: ("#B8860B", "+")}
SHAPES = {"s": "M-3-3H3V3H-3Z", "^": "M0-4L4 3H-4Z", "v": "M0 4L4-3H-4Z", "d": "M0-4.5L4.5 0L0 4.5L-4.5 0Z", "<": "M-4 0L3-4V4Z",
          ">": "M4 0L-3-4V4Z", "x": "M-3-3L3 3M3-3L-3 3", "+": "M-4 0H4M0-4V4"}
LOWEST, NARROWEST, WIDEST = 40, 0.2, 5  # what is beyond lies at the edge
ROW, TOP, LEGEND, ENDS = 24, 40, 17, ((200, 500), (530, 740))  # pixels; ends of both panels


def look(result):
    """Label, colour and shape of a cell's marks."""
    for key, base in problems.BASE.items():
        value = result[key]
        if value != base:
            return f"errors {value}" if key == "errors" else f"{value} points" if key == "points" else value, *MARKS[value]
    return "20 points, errors unknown, constant", "#000000", "base"


def mark(shape, x, y, colour):
    if shape in ("o", "base"):
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{3 if shape == "o" else 5}" fill="{colour}"/>'
    style = f'fill="none" stroke="{colour}" stroke-width="1.6"' if shape in "x+" else f'fill="{colour}"'
    return f'<path d="{SHAPES[shape]}" transform="translate({x:.1f},{y:.1f})" {style}/>'


def text(x, y, words, anchor="start", size=12):
    return f'<text x="{x}" y="{y:.1f}" text-anchor="{anchor}" font-size="{size}">{html.escape(words)}</text>'


def of_coverage(value):
    low, high = ENDS[0]
    return low + (max(value, LOWEST) - LOWEST) / (100 - LOWEST) * (high - low)


def of_width(value):
    low, high = ENDS[1]
    share = math.log(min(max(value, NARROWEST), WIDEST) / NARROWEST) / math.log(WIDEST / NARROWEST)
    return low + share * (high - low)


def axes(tools, bottom):
    for place, tool in enumerate(tools):
        y = TOP + ROW * (place + 0.5)
        yield text(ENDS[0][0] - 10, y + 4, tool, "end", 11)
        yield "".join(f'<path d="M{low} {y}H{high}" stroke="#e4e4e4"/>' for low, high in ENDS)
    for at, ticks in ((of_coverage, (40, 50, 60, 70, 80, 90, 95, 100)), (of_width, (0.2, 0.5, 1, 2, 5))):
        for tick in ticks:
            x = at(tick)
            colour = "#444444" if tick in (1, 95) else "#e4e4e4"
            yield f'<path d="M{x:.1f} {TOP}V{bottom + 4}" stroke="{colour}"/>'
            if tick != 95:
                yield text(f"{x:.1f}", bottom + 17, ("≤" if tick == LOWEST else "") + f"{tick:g}", "middle", 11)
    yield text(sum(ENDS[0]) / 2, bottom + 34, "95 % intervals that hold the truth, %", "middle")
    yield text(sum(ENDS[1]) / 2, bottom + 34, "width over the exact likelihood's", "middle")


def drawn(name, results):
    tools = tables.tools_of(result["tools"] for result in results)
    bottom = TOP + ROW * len(tools)
    height = bottom + 44 + LEGEND * math.ceil(len(results) / 3) + 8
    title = f"{problems.PROBLEMS[name].title}: coverage and width of {len(tools)} intervals"
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 760 {height}" font-family="Helvetica, Arial, sans-serif" '
             'role="img">', f"<title>{html.escape(title)}</title>", f'<rect width="760" height="{height}" fill="#ffffff"/>',
             text(12, 22, problems.PROBLEMS[name].title, size=14), *axes(tools, bottom)]
    for number, result in reversed(list(enumerate(results))):  # the base on top
        label, colour, shape = look(result)
        shift = ROW * (0.5 if shape == "base" else 0.14 + 0.72 * number / max(len(results) - 1, 1))
        for place, tool in enumerate(tools):
            row = result["tools"].get(tool, {})
            for at, key in ((of_coverage, "coverage 95"), (of_width, "width")):
                if row.get(key) is not None and row["answers"] >= tables.FEWEST:
                    lines.append(mark(shape, at(row[key]), TOP + ROW * place + shift, colour))
        x, y = 20 + 250 * (number % 3), bottom + 56 + LEGEND * (number // 3)
        lines += [mark(shape, x, y - 4, colour), text(x + 12, y, label, size=11)]
    return "\n".join([*lines, "</svg>", ""])


def draw(results, folder):
    for name in problems.PROBLEMS:
        found = [result for result in results if result["problem"] == name]
        if found:
            (folder / f"who_covers_{name}.svg").write_text(drawn(name, found), encoding="utf-8")
