"""All computed ballistic limits beside the tests: a table, a summary by groups and a plot."""

import os
import subprocess
from typing import NamedTuple

from . import cavity
from . import sweeps as runs
from .data import ROOT, InputError, Tests, markdown_table, metal_of
from .limits import open_tests, percent, repeated_limit

PLOT = ROOT / "docs" / "predicted_measured.svg"
TEST_HALF_MPS = 5  # of the tests with 20 mm projectiles: half of the gap between stopped and perforating shots

# What was known of a test when the parameters of the method were chosen.
CHOSEN, KNOWN, PREDICTED = "chosen on", "known", "predicted"


class Group(NamedTuple):
    """Limits that are summed up together."""

    text: str
    folder: str  # of their sweep
    basis: str
    cases: tuple = ()  # names; empty: all others of the sweep


GROUPS = (
    Group("blunt, 6 to 20 mm Weldox 460 E", "repeats", CHOSEN),
    Group("cone and ogive, 12 mm Weldox 460 E", "sharp", CHOSEN, ("steel_conical", "steel_ogival")),
    Group("hemisphere, 12 mm Weldox 460 E", "sharp", PREDICTED, ("steel_hemispherical",)),
    Group("cone, 15 to 30 mm AA5083-H116", "sharp", KNOWN),
    Group("blunt, 12 mm Weldox 700 E", "open", CHOSEN, ("weldox_700e",)),
    Group("20 mm fragment simulator, 12.7 mm AA6061-T651", "open", CHOSEN, ("fsp_12.7",)),
    Group("20 mm fragment simulator, 25.7 mm AA6061-T651", "open", KNOWN),
    Group("7.62 mm APM2 core, aluminium", "apm2", PREDICTED),
)


class Comparison(NamedTuple):
    """A limit beside its test, m/s."""

    group: Group
    text: str
    spacing_mm: str
    test: float
    test_half: float | None
    limit: float
    half: float  # of the bracket, or of the 90 % interval of the mean
    seeds: int
    formula: float | None
    cpu_s: float


def group_of(folder, name):
    found = [group for group in GROUPS if group.folder == folder]
    return next((group for group in found if name in group.cases), None) or next(
        group for group in found if not group.cases)


def comparisons(sweeps):
    """Of each case of the sweeps whose limit has been found; all arrangements of the particles together."""
    open_rows, found = open_tests(), []
    for sweep in sweeps:
        cases = {}
        for case, row in runs.limit_rows(sweep):
            cases.setdefault(case["name"], (case, []))[1].append(row)
        for name, (case, rows) in cases.items():
            open_row = open_rows.get(case.get("text"))
            if open_row:
                text, test = case["text"], float(open_row["V50_mps"])
                test_half = float(open_row["sigma_mps"]) if open_row["sigma_mps"] else None
            else:
                plate = (metal_of(rows[0]["material"]), rows[0]["nose"], float(rows[0]["thickness_mm"]))
                text, test, test_half = f"{plate[1]}, {plate[2]:g} mm {plate[0]}", Tests().limit_mps(*plate), TEST_HALF_MPS
            values = [(float(row["bisection_limit_mps"]),
                       (float(row["lowest_perforated_mps"]) - float(row["highest_stopped_mps"])) / 2) for row in rows]
            limit, half = values[0]
            if len(values) > 1:
                limit, _, half = repeated_limit(values)
            found.append(Comparison(group_of(sweep.folder, name), text, rows[0]["spacing_mm"], test, test_half, limit, half,
                                    len(values), cavity.limit_mps(open_row) if open_row else None,
                                    sum(runs.cost_s(sweep, row) for row in rows)))
    return found


def table(sweeps):
    """A row for each limit."""
    rows = [[c.text, c.spacing_mm, f"{c.test:.1f}" + (f" ± {c.test_half:g}" if c.test_half else ""),
             f"{c.limit:.1f} ± {c.half:.1f}", f"{c.seeds}", percent(c.limit, c.test), c.group.basis,
             percent(c.formula, c.test), f"{c.cpu_s / 60:.0f}"] for c in comparisons(sweeps)]
    return rows and markdown_table(
        ["projectile and plate", "particle distance, mm", "test, m/s", "computed, m/s", "arrangements", "error", "test was",
         "error of cavity expansion", "processor, min"], rows)


def summary(sweeps):
    """A row for each group."""
    found, rows = comparisons(sweeps), []
    for group in GROUPS:
        errors = [c.limit / c.test - 1 for c in found if c.group == group]
        if errors:
            worst = max(errors, key=abs)
            rows.append([group.text, str(len(errors)), f"{100 * sum(errors) / len(errors):+.1f} %", f"{100 * worst:+.1f} %",
                         group.basis])
    return rows and markdown_table(["projectile and plate", "limits", "mean error", "largest error", "test was"], rows)


def draw(sweeps, picture=PLOT):
    """Computed against measured limits, with their uncertainties, as SVG by gnuplot."""
    found = comparisons(sweeps)
    if not found:
        raise InputError(f"{picture}: no limit has been found: run scripts/validate.sh")
    colours = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#404040", "#8c6d00")
    blocks, curves = [], []
    groups = [group for group in GROUPS if any(c.group == group for c in found)]
    for k, group in enumerate(groups):
        lines = [f"{c.test} {c.limit} {c.test_half or 0} {c.half}" for c in found if c.group == group]
        blocks.append(f"$group{k} << END\n" + "\n".join(lines) + "\nEND")
        curves.append(f"$group{k} using 1:2:3:4 with xyerrorbars pointtype 7 pointsize 0.9 linewidth 1.4 "
                      f"linecolor '{colours[k % len(colours)]}' title \"{group.text}\"")
    script = "\n".join([
        "set encoding utf8", "set terminal svg size 900,640 noenhanced font 'Helvetica,Arial,sans-serif,16' background 'white'",
        f"set output '{picture.name}'", *blocks, "set border 3 linecolor '#404040'", "set tics nomirror out",
        "set grid linecolor '#d8d8d8'", "set key bottom right reverse Left", "set xlabel 'measured ballistic limit / (m/s)'",
        "set ylabel 'computed ballistic limit / (m/s)'", "set xrange [100:*]", "set yrange [100:*]",
        "plot x title 'equal' with lines linecolor '#404040', "
        "1.1 * x title '± 10 %' with lines dashtype 2 linecolor '#808080', 0.9 * x notitle with lines dashtype 2 linecolor "
        "'#808080', " + ", ".join(curves)])
    subprocess.run(["gnuplot", "-d", "-"], input=script, text=True, check=True, cwd=picture.parent,
                   env={**os.environ, "LC_ALL": "C.UTF-8"})
    print(f"plot: {picture}")
