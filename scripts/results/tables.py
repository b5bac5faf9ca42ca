"""The tables of docs/, in Markdown, by name: of shots and limits that sweeps.py runs, and of the page of results."""

import sys
from functools import partial
from typing import Callable, NamedTuple

from . import sweeps as runs
from . import validation
from .data import KEY_COLUMNS, PAGE, ROOT, InputError, build, markdown_table, read_table
from .insert import insert
from .limits import paper_limits, repeats, scale, sizes
from .sweeps import Sweep

BRACKETS = ("Tests in brackets: no measured shot but the curve of Recht and Ipson through the measured limit, which is known "
            "to 5 m/s; just above it the curve is uncertain.")


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
MEASURED = (*STABILISED[:4], Column("hole, mm", "hole_diameter_mm", ".1f"), *STABILISED[4:])
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


def open_shots(sweeps):
    """Shots beside measured ones with other projectiles than the paper's, in the order of apps/data/shots_open.csv."""
    tests = {(test["obliquity_deg"], float(test["initial_velocity_mps"])): test
             for test in runs.texts(ROOT / "apps" / "data" / "shots_open.csv")}
    rows = []
    for sweep in sweeps:
        for case in runs.cases(sweep):
            values = runs.summary(sweep, case["name"])
            if values:
                test = tests[f"{values['obliquity_deg']:g}", values["initial_velocity_mps"]]
                measured, computed = float(test["residual_velocity_mps"]), values["final_speed_mps"]
                rows.append([sweep.text, INITIAL.cell(values), f"{measured:.0f}", f"{computed:.1f}", f"{computed - measured:+.1f}",
                             f"{values['deflection_deg']:.1f}", f"{values['turn_deg']:.1f}", ENERGY.cell(values), COST.cell(values)])
    return rows and markdown_table(["projectile and plate", INITIAL.title, TEST.title, RESIDUAL.title, "error, m/s",
                                    "deflection, degrees", "turn, degrees", ENERGY.title, COST.title], rows)


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


class Table(NamedTuple):
    caption: str
    text: Callable  # of the sweeps; empty where nothing has been run
    sweeps: tuple = ()


PAPER = "--method paper"
LIMITS = "--limit --model mjc --spacing-mm 0.6"
SEEDS = "--vary seed=0:2:1"
REPEATS = Sweep("repeats", "limits", f"{LIMITS} --method stabilised {SEEDS}")
SHARP = Sweep("sharp", "sharp", f"--limit --model mjc --spacing-mm 1 --method stabilised {SEEDS}")
OPEN = tuple(Sweep(name, name, f"--limit --method stabilised {SEEDS}") for name in ("open", "apm2"))
OBLIQUE = Sweep("oblique", "oblique", "--method stabilised --material examples/aa6061_t651_jc.toml --nose ogival --diameter-mm 12.9 "
                "--length-mm 88.9 --calibre-radius-head 3 --tip-diameter-mm 0.6 --mass-g 81 --thickness-mm 26.3 "
                "--obliquity-deg 30 --extent half --spacing-mm 1 --sph-radius-mm 26 --clamp-radius-mm 150",
                "12.9 mm ogive at 30 degrees on 26.3 mm AA6061-T651")
ALL_LIMITS = (REPEATS, SHARP, *OPEN)

# Name: page, from docs/; tables.
TABLES = {
    "sensitivity": ("sensitivity", [
        Table("", partial(shots, SHOTS), (Sweep("sensitivity", "sensitivity", PAPER),)),
        Table("Particle distance, three plates:", partial(shots, SHOTS), tuple(
            Sweep(f"distance_{size}mm", "distance", f"{PAPER} --spacing-mm {size}", f"{{}}, particle distance {size} mm")
            for size in (1.2, 0.9, 0.6, 0.45))),
        Table("Two plates near the limits of the tests, particles 0.8 mm apart:", partial(shots, SHOTS), tuple(
            Sweep(f"near_limit_{thickness}mm", "near_limit", f"{PAPER} --spacing-mm 0.8 --thickness-mm {thickness} "
                  f"--velocity-mps {velocity}", f"{thickness} mm, {{}}") for thickness, velocity in ((8, 180), (16, 265)))),
        Table("Conical nose, particles 1.2 mm apart:", partial(shots, SHOTS),
              (Sweep("conical", "conical", f"{PAPER} --nose conical --spacing-mm 1.2"),))]),
    "paper": ("beyond", [
        Table("Method `paper`, blunt noses, Weldox 460 E, modified law, 0.6 mm: limits by bisection, ± 2.5 m/s beside the "
              "paper's own and the tests:", paper_limits, (Sweep("limits_paper", "limits", f"{LIMITS} --method paper"),)),
        Table("The same with the standard form and a smoothing length that follows the density:", paper_limits,
              (Sweep("limits_paper_standard", "limits_three",
                     f"{LIMITS} --method paper --form standard --smoothing variable"),))]),
    "measured": ("beyond", [
        Table("Method `stabilised`, 12 mm Weldox 460 E, blunt, modified law, 0.6 mm, at the velocities of measured shots; the "
              "tests' plugs had 15 to 36 g, their holes 19.3 to 23.8 mm (Børvik et al. 2002, quoted):", partial(shots, MEASURED),
              (Sweep("measured", "measured", "--method stabilised --model mjc --spacing-mm 0.6"),))]),
    "repeats": ("beyond", [
        Table("Method `stabilised`, blunt noses, Weldox 460 E, modified law, 0.6 mm: limits by bisection, ± 2.5 m/s with three "
              "arrangements of the particles (`--seed`):", repeats,
              (REPEATS,))]),
    "oblique": ("beyond", [
        Table("Method `stabilised`, oblique impact, particles 1 mm apart, beside measured shots "
              "([shots_open.csv](../apps/data/shots_open.csv)):", open_shots, (OBLIQUE,))]),
    "sizes_stabilised": ("beyond", [
        Table("Method `stabilised`, several particle distances: limits by bisection, ± 2.5 m/s.", sizes, (
            *(Sweep(f"limits_stabilised_{size}mm", "sizes", f"--limit --method stabilised --model mjc --spacing-mm {size}",
                    f"{size} mm") for size in (0.8, 0.45)), REPEATS._replace(text="0.6 mm")))]),
    "scale": ("beyond", [
        Table("Method `stabilised`, blunt nose, Weldox 460 E, modified law, all lengths times 0.5, 1 and 2: limits by bisection, "
              "± 2.5 m/s:", scale, (Sweep("scale", "scale", "--limit --method stabilised --model mjc"),))]),
    "stabilised": ("beyond", [
        Table("Method `stabilised`, one parameter at a time, particles 0.8 mm apart:", partial(shots, STABILISED), tuple(
            Sweep(f"stabilised_{thickness}mm", "stabilised", "--method stabilised --model mjc --spacing-mm 0.8 "
                  f"--thickness-mm {thickness} --velocity-mps {velocity}", f"{thickness} mm, {{}}")
            for thickness, velocity in ((12, 224.7), (6, 170))))]),
    "dishing": ("beyond", [
        Table("Method `stabilised`, 12 mm Weldox 460 E, modified law, plates that held, 2 ms more after the shot is decided; tests of "
              "Børvik et al. (2002, IJIE 27:19, quoted):", partial(shots, DISHINGS, first="nose, velocity and test"),
              (Sweep("dishing", "dishing", "--method stabilised --model mjc --settle-us 2000"),))]),
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
    "accuracy": ("../README", [Table("Ballistic limits, method `stabilised`:", validation.summary, ALL_LIMITS)]),
    "validation": ("doxygen/validation", [Table("", validation.table, ALL_LIMITS)]),
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


# What other people's tests say: all limits, and the shots beside measured ones.
VALIDATION = ("repeats", "oblique", "measured", "cone", "dishing", "validation", "accuracy")


def validate(page_only=False, jobs=None):
    """Runs or resumes all comparisons with tests, and puts their tables into docs/ and the README and draws the plot of
    measured and computed limits. Those of which nothing is known are named and left as they are."""
    for name in VALIDATION:
        try:
            make_tables(name, not page_only and name != "accuracy", True, jobs)
        except InputError as error:
            print(f"validate: left out: {error}", file=sys.stderr)
    validation.draw(ALL_LIMITS)
