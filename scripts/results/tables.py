"""The tables of docs/, in Markdown: of shots and limits that sweeps.py runs, and of the page of results."""

from functools import partial
from typing import Callable, NamedTuple

from . import sweeps as runs
from .data import (KEY_COLUMNS, PAGE, ROOT, InputError, Tests, build, half_width_mps, markdown_table, of_plate, read_json,
                   read_limits, read_shots, read_table, short)
from .insert import insert
from .sweeps import Sweep

BRACKETS = ("Tests in brackets: no measured shot but the curve of Recht and Ipson through the measured limit, which is known "
            "to 5 m/s; just above it the curve says little.")
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
ENERGY, FINE_ENERGY = (Column("energy error, %", "energy_error", digits, 100) for digits in (".3f", ".4f"))
INTRUSION = Column("intrusion, mm", "largest_intrusion_mm", ".3f")
DISHING = Column("dishing at the end, mm", "dishing_mm", ".2f")
BONDS = Column("bonds, % of energy", "hourglass_fraction", ".2f", 100)
COST = Column("processor, s", "cpu_s", ".0f")
SHOTS = (INITIAL, TEST, RESIDUAL, PLUG, ENERGY, INTRUSION, Column("momentum error", "momentum_error", ".0e"),
         Column("steps", "steps", ".0f"))
STABILISED = (INITIAL, TEST, RESIDUAL, PLUG, Column("failed particles", "failed_particles", ".0f"), DISHING, BONDS, ENERGY,
              COST)
ADAPTIVE = (INITIAL, TEST, RESIDUAL, PLUG, Column("hexes failed, distorted", "failed_hexes distorted_hexes", ".0f"),
            Column("dishing at the end, at rest, mm", "dishing_mm dishing_at_rest_mm", ".2f"),
            BONDS._replace(title="hourglass, % of energy"), FINE_ENERGY, INTRUSION, COST)
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


def damage(sweeps):
    """Limits of two plates."""
    thin, thick = map(runs.limits, sweeps)
    found = [(case["text"], thin[case["name"]], thick[case["name"]]) for case in runs.cases(sweeps[0])
             if case["name"] in thin.keys() & thick.keys()]
    tests = ("tests", *(Tests().limit_mps(*STEEL, thickness) for thickness in (6, 12)))
    return found and markdown_table(["case", "6 mm, m/s", "12 mm, m/s", "6 mm over 12 mm"], [
        [text, f"{a:.1f}", f"{b:.1f}", f"{a / b:.2f}"] for text, a, b in [tests, *found]])


def sizes(method, things, sweeps):
    """Limits with other sizes of hexes or particles beside those of the page, which has 0.6 mm."""
    found, rows = {size: runs.limits(sweep) for size, sweep in zip((1.2, 0.8, 0.45), sweeps)}, []
    for case in runs.cases(sweeps[0]):
        thickness = float(case["thickness_mm"])
        page = of_plate(read_limits(PAGE / "data"), *STEEL, thickness, "mjc", method)
        limits = {size: found[size].get(case["name"]) for size in found} | {0.6: page[0]["bisection_limit_mps"]}
        rows.append([f"{thickness:g} mm", f"{Tests().limit_mps(*STEEL, thickness):.1f}",
                     *(f"{limits[size]:.1f}" if limits[size] else "–" for size in (1.2, 0.8, 0.6, 0.45)),
                     *(percent(limits[size], limits[0.6]) for size in (0.8, 0.45))])
    return any(found.values()) and markdown_table(
        ["plate", "tests, m/s", f"{things} of 1.2 mm", "0.8 mm", "0.6 mm", "0.45 mm", "0.8 mm against 0.6 mm",
         "0.45 mm against 0.6 mm"], rows)


def costs(header, method, rows, total):
    """Of (first cells, seconds with the paper's method, seconds with the other), and their sum."""
    return rows and markdown_table([*header, "the paper's method, s", f"{method}, s", "ratio"], [
        [*cells, f"{paper:.0f}", f"{other:.0f}", f"{other / paper:.2f}"]
        for cells, paper, other in [*rows, (total, sum(row[1] for row in rows), sum(row[2] for row in rows))]])


def timing(sweeps):
    rows = []
    for case in runs.cases(sweeps[0]):
        found = [runs.summary(sweep, case["name"]) for sweep in sweeps]
        if all(found):
            rows.append(([case["nose"], f"{case['thickness_mm']} mm {case['material']}", case["velocity_mps"]],
                         *(values["cpu_s"] for values in found)))
    return costs(["nose", "plate", "initial, m/s"], "adaptive", rows, ["all", "", ""])


def cost(method, _):
    """Of the shots of the page that both methods have, by plate."""
    seconds, plates = {row.key(KEY_COLUMNS): row["cpu_s"] for row in read_table(PAGE / "run_record.csv")}, {}
    for way, *shot in seconds:
        if way == method and shot[0] == "mjc" and ("sfm", *shot) in seconds:
            plates.setdefault(tuple(shot[1:4]), []).append(shot)
    rows = [([nose, f"{thickness:g} mm {material}", str(len(found))],
             *(sum(seconds[way, *shot] for shot in found) for way in ("sfm", method)))
            for (material, nose, thickness), found in plates.items()]
    return costs(["nose", "plate", "shots"], method, rows, ["all", "", str(sum(map(len, plates.values())))])


def limits(_):
    """All limits of the page by plate, with the methods beside each other."""
    def cells(row, test):
        if row and (half_width_mps(row) or 0) > 2.5:
            return [f"{short(row['highest_stopped_mps'])} to {short(row['lowest_perforated_mps'])}", "–"]
        limit = row and row["bisection_limit_mps"]
        return [f"{limit:.1f}" if limit else "–", percent(limit, test)]

    plates = {}
    for row in read_limits(PAGE / "data"):
        if row["model"] == "mjc":
            plates.setdefault(row.key(("material", "nose", "thickness_mm", "test_limit_mps")), {})[row["method"]] = row
    return markdown_table(
        ["nose", "plate", "tests, m/s", "the paper's method, m/s", "off", "stabilised, m/s", "off", "adaptive, m/s", "off"],
        [[nose, f"{thickness:g} mm {material}", f"{test:.1f}",
          *(cell for method in ("sfm", "stabilised", "adaptive") for cell in cells(found.get(method), test))]
         for (material, nose, thickness, test), found in plates.items() if found.keys() - {"sfm"}])


def residuals(_):
    """Of the stabilised particles at 12 mm, on the page, at the velocities of measured shots."""
    tests = {test["initial_velocity_mps"]: test["residual_velocity_mps"] for test in Tests().shots_of(*STEEL, 12)}
    columns = (INITIAL, TEST, RESIDUAL, PLUG, DISHING, BONDS, FINE_ENERGY)
    found = of_plate(read_shots(PAGE / "data"), *STEEL, 12, "mjc", "stabilised")
    return markdown_table([column.title for column in columns], [
        [column.cell({**row, "test_residual_velocity_mps": tests[row["initial_velocity_mps"]]}) for column in columns]
        for row in found if row["initial_velocity_mps"] in tests])


class Table(NamedTuple):
    caption: str
    text: Callable  # of the sweeps; empty where nothing has been run
    sweeps: tuple = ()


def sizes_of(method, things, caption):
    return Table(f"{caption}, other sizes of {things}: limits by bisection to 2.5 m/s. Those with 0.6 mm are those of the page "
                 "of results.", partial(sizes, method, things), tuple(
                     Sweep(f"limits_{method}_{size}mm", "limits", f"--limit --method {method} --model mjc --spacing-mm {size}")
                     for size in (1.2, 0.8, 0.45)))


def cost_of(method):
    return Table("Processor time of the same shots on the page of results, modified law, as it was when each was run, "
                 f"{method}:", partial(cost, method))


# Name: page in docs/, tables.
TABLES = {
    "plate_12mm": ("plate_12mm", [Table("", partial(shots, SHOTS), (Sweep("plate_12mm", "plate_12mm"),))]),
    "sensitivity": ("sensitivity", [
        Table("", partial(shots, SHOTS), (Sweep("sensitivity", "sensitivity"),)),
        Table("Particle distance, three plates:", partial(shots, SHOTS), tuple(
            Sweep(f"distance_{size}mm", "distance", f"--spacing-mm {size}", f"{{}}, particle distance {size} mm")
            for size in (1.2, 0.9, 0.6, 0.45))),
        Table("Two plates near the limits of the tests, particles 0.8 mm apart:", partial(shots, SHOTS), tuple(
            Sweep(f"near_limit_{thickness}mm", "near_limit", f"--spacing-mm 0.8 --thickness-mm {thickness} --velocity-mps "
                  f"{velocity}", f"{thickness} mm, {{}}") for thickness, velocity in ((8, 180), (16, 265)))),
        Table("Conical nose, particles 1.2 mm apart:", partial(shots, SHOTS),
              (Sweep("conical", "conical", "--nose conical --spacing-mm 1.2"),))]),
    "limits": ("beyond", [
        Table("Limits by bisection on the page of results, modified law, 0.6 mm, against the tests; what lies between two shots "
              "more than 5 m/s apart is not known better yet:", limits),
        Table("12 mm of steel, blunt, stabilised, on the page of results, modified law, 0.6 mm, at the velocities of measured "
              "shots:", residuals)]),
    "stabilised": ("beyond", [
        Table("Stabilised, one parameter at a time, particles 0.8 mm apart:", partial(shots, STABILISED), tuple(
            Sweep(f"stabilised_{thickness}mm", "stabilised", "--method stabilised --model mjc --spacing-mm 0.8 "
                  f"--thickness-mm {thickness} --velocity-mps {velocity}", f"{thickness} mm, {{}}")
            for thickness, velocity in ((12, 224.7), (6, 170))))]),
    "adaptive": ("beyond", [Table(caption, partial(shots, ADAPTIVE), (Sweep(name, name, "--method adaptive"),))
                            for name, caption in (
        ("adaptive", "Hexes that turn into particles, the plate that ℓ was chosen on, 12 mm, hexes of 0.6 mm:"),
        ("adaptive_plates", "Other plates and noses:"), ("adaptive_sizes", "Size of the hexes:"))]),
    "damage": ("beyond", [
        Table("Hexes that turn into particles, hexes of 1.2 mm: limits by bisection to 2.5 m/s.", damage, tuple(
            Sweep(f"damage_{thickness}mm", "damage", f"--limit --method adaptive --spacing-mm 1.2 --thickness-mm {thickness}")
            for thickness in (6, 12)))]),
    "dishing": ("beyond", [
        Table("Plate of 12 mm at 181.5 m/s, modified law, 2 ms more after the shot is decided; the test left 2.92 mm (Børvik et "
              "al. 2002, IJIE 27:19, quoted):", partial(shots, DISHINGS, first="method"),
              (Sweep("dishing", "dishing", "--model mjc --velocity-mps 181.5 --settle-us 2000"),))]),
    "sizes_adaptive": ("beyond", [sizes_of("adaptive", "hexes", "Hexes that turn into particles")]),
    "sizes_stabilised": ("beyond", [sizes_of("stabilised", "particles", "Stabilised")]),
    "cost": ("beyond", [cost_of("adaptive"), cost_of("stabilised")]),
    "timing": ("beyond", [
        Table("Processor time of one shot with either method, one after the other, one thread, modified law, 0.6 mm:", timing,
              tuple(Sweep(f"timing_{way}", "timing", f"--model mjc --spacing-mm 0.6 --method {way} --threads 1 --jobs 1")
                    for way in ("sfm", "adaptive")))]),
}


def versions(tables):
    """Of the shots in the tables."""
    found = {read_json(summary)["version"] for table in tables for sweep in table.sweeps
             for summary in (runs.FOLDER / sweep.folder).glob("shots/*/summary.json")}
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
