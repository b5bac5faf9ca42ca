"""The tables of ballistic limits in docs/, in Markdown."""

import math
import statistics

from . import cavity
from . import sweeps as runs
from .data import ROOT, Tests, markdown_table, metal_of

STEEL = ("Weldox 460 E", "blunt")


def percent(value, reference):
    return f"{100 * (value / reference - 1):+.1f} %" if value and reference else "–"


def first_limits(sweep):
    """The limits of a sweep with the undisturbed arrangement of the particles, m/s, by the name of the case."""
    return {case["name"]: float(row["bisection_limit_mps"]) for case, row in runs.limit_rows(sweep)
            if row.get("seed", "0") == "0"}  # rows of a sweep that varies no seed have none


def slope_percent(sizes_mm, limits, reference):
    """Slope of the straight line through limits of several particle distances, per 0.1 mm in % of the reference."""
    known = [(float(size.split()[0]), limit) for size, limit in zip(sizes_mm, limits) if limit]
    if len(known) < 2 or not reference:
        return "–"
    return f"{10 * statistics.linear_regression(*zip(*known)).slope / reference:+.1f} %"


def sizes(sweeps):
    """Limits with several particle distances, the last of which others are compared with."""
    *others, reference = (first_limits(sweep) for sweep in sweeps)
    sizes_mm = [sweep.text for sweep in sweeps]
    rows = []
    for case in runs.cases(sweeps[0]):
        limit = [found.get(case["name"]) for found in (*others, reference)]
        rows.append([f"{case['thickness_mm']} mm", f"{Tests().limit_mps(*STEEL, float(case['thickness_mm'])):.1f}",
                     *(f"{value:.1f}" if value else "–" for value in limit),
                     *(percent(value, limit[-1]) for value in limit[:-1]), slope_percent(sizes_mm, limit, limit[-1])])
    return any(others) and markdown_table(
        ["plate", "test, m/s", *sizes_mm, *(f"{size} against {sizes_mm[-1]}" for size in sizes_mm[:-1]), "per 0.1 mm"], rows)


def paper_limits(sweeps):
    """Limits beside the paper's own and the tests."""
    rows = []
    for case, row in runs.limit_rows(sweeps[0]):
        plate, limit = (*STEEL, float(case["thickness_mm"])), float(row["bisection_limit_mps"])
        test, paper = Tests().limit_mps(*plate), Tests().paper_velocity_mps(*plate)
        rows.append([f"{plate[2]:g} mm", f"{test:.1f}", f"{paper:.0f}", f"{limit:.1f}", percent(limit, paper),
                     percent(limit, test)])
    return rows and markdown_table(
        ["plate", "test, m/s", "paper, m/s", "computed, m/s", "against the paper", "against the test"], rows)


# 95 % quantiles of Student's distribution by degrees of freedom, from 1 on.
STUDENT_95 = (6.3138, 2.9200, 2.3534, 2.1318, 2.0150, 1.9432, 1.8946, 1.8595, 1.8331)


def repeated_limit(limits):
    """Mean, standard deviation and half of the 90 % interval of the mean of (limit, half width of its bracket), two or
    more: the rule of include/ogive/fit/repeated_limit.hpp."""
    values, halves = zip(*limits)
    mean = sum(values) / len(values)
    variance = sum((value - mean) ** 2 for value in values) / (len(values) - 1)
    of_brackets = sum(half ** 2 for half in halves) / (3 * len(halves))
    return (mean, math.sqrt(variance),
            STUDENT_95[len(values) - 2] * math.sqrt(max(variance, of_brackets) / len(values)))


def repeats(sweeps):
    """Limits with several arrangements of the particles, one column each."""
    plates, seeds = {}, []
    for case, row in runs.limit_rows(sweeps[0]):
        half = (float(row["lowest_perforated_mps"]) - float(row["highest_stopped_mps"])) / 2
        plates.setdefault(float(case["thickness_mm"]), {})[row["seed"]] = (float(row["bisection_limit_mps"]), half)
        seeds.append(int(row["seed"]))
    seeds, rows = [str(seed) for seed in sorted(set(seeds))], []
    for thickness, found in plates.items():
        test, cells = Tests().limit_mps(*STEEL, thickness), ["–"] * 4
        if len(found) > 1:
            mean, deviation, half = repeated_limit(found.values())
            cells = [f"{mean:.1f}", f"{deviation:.1f}", f"{mean - half:.1f} to {mean + half:.1f}", percent(mean, test)]
        rows.append([f"{thickness:g} mm", f"{test:.1f}",
                     *(f"{found[seed][0]:.1f}" if seed in found else "–" for seed in seeds), *cells])
    return rows and markdown_table(
        ["plate", "test, m/s", *(f"seed {seed}, m/s" for seed in seeds), "mean, m/s", "standard deviation, m/s",
         "90 % interval of the mean, m/s", "mean against the test"], rows)


def open_tests():
    """Tests with other projectiles and metals than the paper's, by the text of their cases."""
    return {f"{test['projectile']} at {test['thickness_mm']} mm {test['target']}": test
            for test in runs.texts(ROOT / "apps" / "data" / "v50_open.csv")}


def scale(sweeps):
    """Limits of the same geometry in several sizes."""
    found = runs.limits(sweeps[0])
    return found and markdown_table(
        ["geometry", "plate, mm", "projectile, mm", "particle distance, mm", "limit, m/s", "against the geometry of the tests"],
        [[case["text"], case["thickness_mm"], case["diameter_mm"], case["spacing_mm"],
          f"{found[case['name']]:.1f}" if case["name"] in found else "–",
          percent(found.get(case["name"]), found.get("equal"))] for case in runs.cases(sweeps[0])])
