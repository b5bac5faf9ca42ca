"""The tables of docs/, in Markdown: of shots and limits that sweeps.py runs, and of the page of results."""

import math
from functools import partial
from typing import Callable, NamedTuple

from . import cavity
from . import sweeps as runs
from .data import KEY_COLUMNS, PAGE, ROOT, InputError, Tests, build, markdown_table, metal_of, read_table
from .insert import insert
from .sweeps import Sweep

BRACKETS = ("Tests in brackets: no measured shot but the curve of Recht and Ipson through the measured limit, which is known "
            "to 5 m/s; just above it the curve is uncertain.")
STEEL = ("Weldox 460 E", "blunt")


class Column(NamedTuple):
    title: str
    keys: str  # of summary.json
    format: str
    factor: float = 1

    def cell(self, values):
        text = ", ".join("–" if values.get(key) is None else format(self.factor * values[key], self.format)
                         for key in self.keys.split())
        of_curve = self.keys.startswith("test") and values.get("test_origin", "").startswith("Recht")
        return f"({text})" if of_curve else text


INITIAL = Column("initial, m/s", "initial_velocity_mps", ".1f")
TEST = Column("test, m/s", "test_residual_velocity_mps", ".1f")
RESIDUAL = Column("computed, m/s", "residual_velocity_mps", ".1f")
PLUG = Column("plug, g", "plug_mass_g", ".1f")
ENERGY = Column("energy error, %", "energy_error", ".3f", 100)
INTRUSION = Column("intrusion, mm", "largest_intrusion_mm", ".3f")
DISHING = Column("dishing at the end, mm", "dishing_mm", ".2f")
BONDS = Column("bonds, % of energy", "hourglass_fraction", ".2f", 100)
COST = Column("processor, s", "cpu_s", ".0f")
SHOTS = (INITIAL, TEST, RESIDUAL, PLUG, ENERGY, INTRUSION, Column("momentum error", "momentum_error", ".0e"),
         Column("steps", "steps", ".0f"))
STABILISED = (INITIAL, TEST, RESIDUAL, PLUG, Column("failed particles", "failed_particles", ".0f"), DISHING, BONDS, ENERGY,
              COST)
CONES = (TEST, Column("at the shoulder, m/s", "velocity_at_shoulder_mps", ".1f"), RESIDUAL, ENERGY)
DISHINGS = (Column("size, mm", "case_spacing_mm", ""), RESIDUAL, DISHING, Column("at rest, mm", "dishing_at_rest_mm", ".2f"))


def shots(columns, sweeps, first="case"):
    """A row for each case that has been run, of all sweeps, which share a list."""
    rows = []
    for case in runs.cases(sweeps[0]):
        for sweep in sweeps:
            values = runs.summary(sweep, case["name"])
            if values:
                values["case_spacing_mm"] = float(case.get("spacing_mm") or "nan")
                rows.append([sweep.text.format(case["text"]), *(column.cell(values) for column in columns)])
    return rows and markdown_table([first, *(column.title for column in columns)], rows)


def percent(value, reference):
    return f"{100 * (value / reference - 1):+.1f} %" if value and reference else "–"


def first_limits(sweep):
    """The limits of a sweep with the undisturbed arrangement of the particles, m/s, by the name of the case."""
    return {case["name"]: float(row["bisection_limit_mps"]) for case, row in runs.limit_rows(sweep) if row["seed"] == "0"}


def sizes(sweeps):
    """Limits with several particle distances, the last of which others are compared with."""
    *others, reference = (first_limits(sweep) for sweep in sweeps)
    sizes_mm = [sweep.text for sweep in sweeps]
    rows = []
    for case in runs.cases(sweeps[0]):
        limit = [found.get(case["name"]) for found in (*others, reference)]
        rows.append([f"{case['thickness_mm']} mm", f"{Tests().limit_mps(*STEEL, float(case['thickness_mm'])):.1f}",
                     *(f"{value:.1f}" if value else "–" for value in limit),
                     *(percent(value, limit[-1]) for value in limit[:-1])])
    return any(others) and markdown_table(
        ["plate", "test, m/s", *sizes_mm, *(f"{size} against {sizes_mm[-1]}" for size in sizes_mm[:-1])], rows)


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


def open_limits(sweeps):
    """Limits beside tests with other projectiles and metals than the paper's, and those of cavity expansion."""
    rows, tests = [], open_tests()
    for case, row in (found for sweep in sweeps for found in runs.limit_rows(sweep)):
        test, formula = float(tests[case["text"]]["V50_mps"]), cavity.limit_mps(tests[case["text"]])
        rows.append([case["text"], case["spacing_mm"], f"{test:.0f}", row["bisection_limit_mps"],
                     percent(float(row["bisection_limit_mps"]), test), f"{formula:.0f}" if formula else "–",
                     percent(formula, test)])
    return rows and markdown_table(["projectile and plate", "particle distance, mm", "test, m/s", "computed, m/s", "error",
                                    "cavity expansion, m/s", "error of it"], rows)


def scale(sweeps):
    """Limits of the same geometry in several sizes."""
    found = runs.limits(sweeps[0])
    return found and markdown_table(
        ["geometry", "plate, mm", "projectile, mm", "particle distance, mm", "limit, m/s", "against the geometry of the tests"],
        [[case["text"], case["thickness_mm"], case["diameter_mm"], case["spacing_mm"],
          f"{found[case['name']]:.1f}" if case["name"] in found else "–",
          percent(found.get(case["name"]), found.get("equal"))] for case in runs.cases(sweeps[0])])


def cost(_):
    """Processor time of the shots of the page that both methods have, by plate, and of all of them."""
    seconds, plates = {row.key(KEY_COLUMNS): row["cpu_s"] for row in read_table(PAGE / "run_record.csv")}, {}
    for method, *shot in seconds:
        if method == "stabilised" and shot[0] == "mjc" and ("paper", *shot) in seconds:
            plates.setdefault(tuple(shot[1:4]), []).append(shot)
    rows = [(nose, f"{thickness:g} mm {material}", len(found),
             *(sum(seconds[method, *shot] for shot in found) for method in ("paper", "stabilised")))
            for (material, nose, thickness), found in plates.items()]
    rows = rows and [*rows, ("all", "", *(sum(row[k] for row in rows) for k in (2, 3, 4)))]
    return rows and markdown_table(["nose", "plate", "shots", "paper, s", "stabilised, s", "ratio"], [
        [nose, plate, str(count), f"{paper:.0f}", f"{other:.0f}", f"{other / paper:.2f}"]
        for nose, plate, count, paper, other in rows])


def sharp_limits(sweeps):
    """Limits of sharp noses beside the tests."""
    return markdown_table(["nose and plate", "test, m/s", "computed, m/s", "error"], [
        [case["text"], f"{test:.1f}", row["bisection_limit_mps"], percent(float(row["bisection_limit_mps"]), test)]
        for case, row in runs.limit_rows(sweeps[0])
        for test in [Tests().limit_mps(metal_of(row["material"]), row["nose"], float(row["thickness_mm"]))]])


def accuracy(sweeps):
    """All limits of the default method beside tests: those of blunt noses on steel, of sharp noses, and open ones."""
    blunt, sharp, *others = sweeps
    rows = [[f"blunt, {case['thickness_mm']} mm Weldox 460 E", row, Tests().limit_mps(*STEEL, float(case["thickness_mm"]))]
            for case, row in runs.limit_rows(blunt) if row["seed"] == "0"]
    rows += [[case["text"], row, Tests().limit_mps(metal_of(row["material"]), row["nose"], float(row["thickness_mm"]))]
             for case, row in runs.limit_rows(sharp)]
    rows += [[case["text"], row, float(open_tests()[case["text"]]["V50_mps"])] for sweep in others for case, row in runs.limit_rows(sweep)]
    return rows and markdown_table(["projectile and plate", "particle distance, mm", "limit, m/s", "test, m/s", "error"], [
        [text, row["spacing_mm"], f"{float(row['bisection_limit_mps']):.1f}", f"{test:.1f}",
         percent(float(row["bisection_limit_mps"]), test)] for text, row, test in rows])


class Table(NamedTuple):
    caption: str
    text: Callable  # of the sweeps; empty where nothing has been run
    sweeps: tuple = ()


# The method and the arrangement of the particles of the two pages about the paper's choices.
ON_RINGS = "--method paper --lattice ring"
LIMITS = "--limit --model mjc --spacing-mm 0.6"
REPEATS = Sweep("repeats", "limits", f"{LIMITS} --method stabilised --vary seed=0:2:1")
SHARP = Sweep("sharp", "sharp", "--limit --model mjc --spacing-mm 1 --method stabilised")
OPEN = tuple(Sweep(name, name, "--limit --method stabilised") for name in ("open", "apm2"))

# Name: page, from docs/; tables.
TABLES = {
    "plate_12mm": ("plate_12mm", [Table("", partial(shots, SHOTS), (Sweep("plate_12mm", "plate_12mm", ON_RINGS),))]),
    "sensitivity": ("sensitivity", [
        Table("", partial(shots, SHOTS), (Sweep("sensitivity", "sensitivity", ON_RINGS),)),
        Table("Particle distance, three plates:", partial(shots, SHOTS), tuple(
            Sweep(f"distance_{size}mm", "distance", f"{ON_RINGS} --spacing-mm {size}", f"{{}}, particle distance {size} mm")
            for size in (1.2, 0.9, 0.6, 0.45))),
        Table("Two plates near the limits of the tests, particles 0.8 mm apart:", partial(shots, SHOTS), tuple(
            Sweep(f"near_limit_{thickness}mm", "near_limit", f"{ON_RINGS} --spacing-mm 0.8 --thickness-mm {thickness} "
                  f"--velocity-mps {velocity}", f"{thickness} mm, {{}}") for thickness, velocity in ((8, 180), (16, 265)))),
        Table("Conical nose, particles 1.2 mm apart:", partial(shots, SHOTS),
              (Sweep("conical", "conical", f"{ON_RINGS} --nose conical --spacing-mm 1.2"),))]),
    "paper": ("beyond", [
        Table("Method `paper`, blunt noses, Weldox 460 E, modified law, 0.6 mm: limits by bisection to 2.5 m/s beside the "
              "paper's own and the tests:", paper_limits, (Sweep("limits_paper", "limits", f"{LIMITS} --method paper"),)),
        Table("The same with the standard form and a smoothing length that follows the density:", paper_limits,
              (Sweep("limits_paper_standard", "limits_three",
                     f"{LIMITS} --method paper --form standard --smoothing variable"),))]),
    "measured": ("beyond", [
        Table("Method `stabilised`, 12 mm Weldox 460 E, blunt, modified law, 0.6 mm, at the velocities of measured shots:",
              partial(shots, STABILISED), (Sweep("measured", "measured", "--method stabilised --model mjc --spacing-mm 0.6"),))]),
    "repeats": ("beyond", [
        Table("Method `stabilised`, blunt noses, Weldox 460 E, modified law, 0.6 mm: limits by bisection to 2.5 m/s with three "
              "arrangements of the particles (`--seed`):", repeats,
              (REPEATS,))]),
    "sharp": ("beyond", [
        Table("Method `stabilised`, sharp noses, modified law, particles 1 mm apart: limits by bisection to 2.5 m/s:",
              sharp_limits, (SHARP,))]),
    "open": ("beyond", [
        Table("Method `stabilised`, other projectiles and metals: limits by bisection to 2.5 m/s beside the tests "
              "([v50_open.csv](../apps/data/v50_open.csv)):", open_limits,
              OPEN)]),
    "sizes_stabilised": ("beyond", [
        Table("Method `stabilised`, several particle distances: limits by bisection to 2.5 m/s.", sizes, (
            *(Sweep(f"limits_stabilised_{size}mm", "limits", f"--limit --method stabilised --model mjc --spacing-mm {size}",
                    f"{size} mm") for size in (0.8, 0.45)), REPEATS._replace(text="0.6 mm")))]),
    "scale": ("beyond", [
        Table("Method `stabilised`, blunt nose, Weldox 460 E, modified law, all lengths times 0.5, 1 and 2: limits by bisection "
              "to 2.5 m/s:", scale, (Sweep("scale", "scale", "--limit --method stabilised --model mjc"),))]),
    "stabilised": ("beyond", [
        Table("Method `stabilised`, one parameter at a time, particles 0.8 mm apart:", partial(shots, STABILISED), tuple(
            Sweep(f"stabilised_{thickness}mm", "stabilised", "--method stabilised --model mjc --spacing-mm 0.8 "
                  f"--thickness-mm {thickness} --velocity-mps {velocity}", f"{thickness} mm, {{}}")
            for thickness, velocity in ((12, 224.7), (6, 170))))]),
    "dishing": ("beyond", [
        Table("Plate of 12 mm at 181.5 m/s, modified law, 2 ms more after the shot is decided; the test left 2.92 mm (Børvik et "
              "al. 2002, IJIE 27:19, quoted):", partial(shots, DISHINGS, first="method"),
              (Sweep("dishing", "dishing", "--model mjc --velocity-mps 181.5 --settle-us 2000"),))]),
    "cost": ("beyond", [
        Table("Processor time of the same shots on the page of results, modified law, each with the version and on the machine "
              "of its row in the run record:", cost)]),
    "cone": ("beyond", [
        Table("Method `stabilised`, conical nose, 12 mm Weldox 460 E, 355.6 m/s, particles 1 mm apart, one change at a time:",
              partial(shots, CONES), (Sweep("cone", "cone", "--method stabilised --model mjc --nose conical --spacing-mm 1 "
                                            "--velocity-mps 355.6"),)),
        Table("The same nose and plate at the velocities of measured shots:", partial(shots, CONES), tuple(
            Sweep(f"cone_{size}mm", "cone_measured", f"--method stabilised --model mjc --nose conical --spacing-mm {size}",
                  f"{{}}, particle distance {size} mm") for size in (1, 0.8)))]),
    "accuracy": ("../README", [Table("Ballistic limits, method `stabilised`:", accuracy, (REPEATS, SHARP, *OPEN))]),
}


def versions(tables):
    """Of the shots in the tables."""
    found = {version for table in tables for sweep in table.sweeps for version in runs.versions(sweep)}
    if not any(table.sweeps for table in tables):
        found = {row["version"] for row in read_table(PAGE / "run_record.csv")}
    return f" with ogive {', '.join(sorted(found))}" if found else ""


def make_tables(name, run_missing=False, put_in=False, jobs=None):
    """Prints the tables of that name, and puts them into their page."""
    if name not in TABLES:
        raise InputError(f"tables = {name}: must be one of {', '.join(TABLES)}")
    page, tables = TABLES[name]
    if run_missing:
        build("ogive_main")
        for sweep in (sweep for table in tables for sweep in table.sweeps):
            runs.run(sweep, jobs)
    texts = [(table.caption, text) for table in tables if (text := table.text(table.sweeps))]
    if not texts:
        raise InputError(f"tables {name}: no shot has been run in {runs.FOLDER}: add --run")
    brackets = f" {BRACKETS}" if any("| (" in text for _, text in texts) else ""
    text = "\n\n".join([f"Made by `scripts/results.sh tables {name}`{versions(tables)}.{brackets}",
                        *(part for pair in texts for part in pair if part)])
    print(text)
    if put_in:
        insert(ROOT / "docs" / f"{page}.md", text, f"tables: scripts/results.sh tables {name}")
