"""What the campaigns of apps/figures and `calibrate` left behind, and the tests in apps/data, as Python objects.

A folder of results is either that of a campaign (shots*.csv, *_limits.csv, shots/, figures_1_to_3/) or what
results_page.py made of it (shots.csv, limits.csv, projectiles.csv, fits.csv). Python's standard library only.
"""

import argparse
import csv
import io
import json
import math
import os
import re
import sys
from dataclasses import dataclass
from pathlib import Path

try:
    import tomllib
except ImportError:
    sys.exit(f"error: Python = {sys.version.split()[0]}: must be 3.11 or newer")

ROOT = Path(__file__).resolve().parent.parent
DATA = ROOT / "apps" / "data"

KEY_COLUMNS = ("method", "model", "material", "nose", "thickness_mm", "initial_velocity_mps", "spacing_mm")
SERIES_COLUMNS = ("method", "model", "material", "nose", "thickness_mm", "spacing_mm")
# What tells of the computation and not of the plate.
RECORD_COLUMNS = ("steps", "wall_s", "cpu_s", "threads", "state_hash", "version")
TEXT_COLUMNS = {"method", "model", "material", "nose", "state_hash", "version", "fit_a_origin", "fit_p_origin",
                "series", "source", "confidence", "what", "app", "use", "fit", "parameter"}
SHOT_COLUMNS = KEY_COLUMNS + ("residual_velocity_mps", "perforated")
LIMIT_COLUMNS = SERIES_COLUMNS + ("highest_stopped_mps", "lowest_perforated_mps", "bisection_limit_mps", "consistent",
                                  "fit_limit_mps", "fit_points", "test_limit_mps", "paper_velocity_mps")
# The flow laws and how they are called.
LAWS = {"mjc": "MJC", "jc": "JC"}


class InputError(Exception):
    """Wrong input: one line that names the thing, the value and what is allowed."""


class OneLineParser(argparse.ArgumentParser):
    """Refuses a wrong command line in one line with status 2."""

    def error(self, message):
        self.exit(2, f"{self.prog}: error: {message}\n")


def run_main(program, main):
    """Runs a main program; wrong input ends with one line and status 2."""
    try:
        return main()
    except InputError as error:
        print(f"{program}: error: {error}", file=sys.stderr)
        return 2
    except OSError as error:
        where = f"{error.filename}: " if error.filename else ""
        print(f"{program}: error: {where}{error.strerror or error}", file=sys.stderr)
        return 3


def short(value, digits=4):
    """A number for a reader: 4 significant digits, but none before the decimal point is lost."""
    if value is None or (isinstance(value, float) and not math.isfinite(value)):
        return "–"
    if float(value).is_integer():
        return f"{value:.0f}"
    decimals = max(0, digits - 1 - math.floor(math.log10(abs(value))))
    if decimals > 8:
        return f"{value:.2g}"
    return f"{value:.{decimals}f}".rstrip("0").rstrip(".") if decimals else f"{value:.0f}"


class Row:
    """A line of a table. row["thickness_mm"] is a number (None where the field is empty) or a text; row.text has the
    fields as they stand in the file."""

    def __init__(self, text, where):
        self.text = text
        self.where = where
        self.values = {column: field if column in TEXT_COLUMNS else self._number(column, field)
                       for column, field in text.items()}

    def _number(self, column, field):
        if field == "":
            return None
        try:
            value = float(field)
        except ValueError:
            value = math.nan
        if not math.isfinite(value):
            raise InputError(f"{self.where}: {column} = {field[:40]!r}: must be a finite number")
        return value

    def __getitem__(self, column):
        return self.values[column]

    def get(self, column):
        return self.values.get(column)

    def key(self, columns):
        """For sorting and comparing."""
        return tuple(self.values[column] for column in columns)


def read_table(file, required=()):
    """Rows of a CSV file. Lines that begin with # are comments; a last line without its end, of a process that is
    writing it or was killed, is passed over."""
    with open(file, encoding="utf-8", newline="") as stream:
        content = stream.read()
    content = content[:content.rfind("\n") + 1]
    lines = [(number, line) for number, line in enumerate(content.split("\n"), 1)
             if line.strip() and not line.startswith("#")]
    if not lines:
        return []
    records = list(csv.reader(io.StringIO("\n".join(line for _, line in lines))))
    header = records[0]
    for column in required:
        if column not in header:
            raise InputError(f"{file}: columns = {', '.join(header)[:80]}: must hold {column}")
    rows = []
    for (number, _), fields in zip(lines[1:], records[1:]):
        if len(fields) != len(header):
            raise InputError(f"{file}:{number}: fields in the row = {len(fields)}: must be {len(header)}")
        rows.append(Row(dict(zip(header, fields)), f"{file}:{number}"))
    return rows


def metal_of(material):
    """Name of a metal in the tables of tests: several materials of the library are one metal."""
    return "Weldox 460 E" if material.startswith("weldox") else "AA5083-H116"


def read_shots(folder):
    """The rows of all shots*.csv of a folder, each shot once, sorted by its key."""
    files = sorted(Path(folder).glob("shots*.csv"))
    if not files:
        raise InputError(f"{folder}: holds no shots*.csv: must be a folder with results")
    rows, header = [], None
    for file in files:
        for row in read_table(file, SHOT_COLUMNS):
            if header is not None and list(row.text) != header:
                raise InputError(f"{row.where}: columns: must be those of the other files shots*.csv")
            header = list(row.text)
            rows.append(row)
    # The hash breaks ties, so that the result does not depend on the order of the files.
    rows.sort(key=lambda row: (row.key(KEY_COLUMNS), row.get("state_hash") or ""))
    return [row for before, row in zip([None] + rows, rows)
            if before is None or before.key(KEY_COLUMNS) != row.key(KEY_COLUMNS)]


def half_width_mps(limit):
    """Half of the bisection's bracket; None while it has only one end."""
    if limit["highest_stopped_mps"] is None or limit["lowest_perforated_mps"] is None:
        return None
    return (limit["lowest_perforated_mps"] - limit["highest_stopped_mps"]) / 2


def read_limits(folder):
    """The rows of all *limits.csv of a folder, each series once, sorted. Two programs may have the same series; the one
    that knew more shots is newer."""
    rows = [row for file in sorted(Path(folder).glob("*limits.csv")) for row in read_table(file, LIMIT_COLUMNS)]

    def newest_first(row):
        half = half_width_mps(row)
        return (row.key(SERIES_COLUMNS), math.inf if half is None else half, -(row["fit_points"] or 0),
                list(row.text.values()))

    rows.sort(key=newest_first)
    return [row for before, row in zip([None] + rows, rows)
            if before is None or before.key(SERIES_COLUMNS) != row.key(SERIES_COLUMNS)]


def ended_by_time(shot):
    """Whether a shot ran up to the end that perforate sets if nothing ends it before (default_end_us)."""
    end_us = 500 if shot["nose"] == "blunt" else 1500
    return (shot.get("simulated_us") or 0) >= end_us


def bracket_of(shots):
    """Highest velocity that was stopped below the lowest that perforated, and that one; None where there is none."""
    lowest = min((s["initial_velocity_mps"] for s in shots if s["perforated"]), default=None)
    stopped = [s["initial_velocity_mps"] for s in shots if not s["perforated"]]
    return max((v for v in stopped if lowest is None or v < lowest), default=None), lowest


def read_json(file):
    try:
        with open(file, encoding="utf-8") as stream:
            return json.load(stream)
    except ValueError as error:
        raise InputError(f"{file}: is no JSON: {error}") from None


PROJECTILE_COLUMNS = ("nose", "spacing_mm", "projectile_mass_g", "added_mass_g")


def read_projectiles(folder):
    """Rows of PROJECTILE_COLUMNS, from projectiles.csv and the shots' summaries: one for each nose and particle
    distance, which gives the size of its hexes."""
    file = Path(folder) / "projectiles.csv"
    known = read_table(file, PROJECTILE_COLUMNS) if file.exists() else []
    found = {row.key(("nose", "spacing_mm")): row for row in known}
    for summary in sorted(Path(folder).glob("shots/*/summary.json")):
        # The summary has the particle distance that fits the plate; what was asked for ends the folder's name.
        asked = re.search(r"_([0-9.]+)mm$", summary.parent.name)
        try:
            values = read_json(summary)
        except InputError:
            continue  # a run that is writing it
        if not asked or values.get("fault") is not None or values.get("projectile_mass_g") is None:
            continue
        # Rounded: the mass of the same projectile differs in its last digits from plate to plate.
        row = Row({"nose": str(values["nose"]), "spacing_mm": asked[1],
                   "projectile_mass_g": f"{values['projectile_mass_g']:.6f}",
                   "added_mass_g": f"{abs(values['added_mass_g']):.6f}"}, str(summary))
        found.setdefault(row.key(("nose", "spacing_mm")), row)
    return [found[key] for key in sorted(found)]


FIT_COLUMNS = ("fit", "parameter", "value", "standard_error")


def read_fits(folder):
    """Rows of FIT_COLUMNS, from fits.csv or else from what bench/figures_1_to_3.sh left in figures_1_to_3/."""
    file = Path(folder) / "fits.csv"
    if file.exists():
        return read_table(file, FIT_COLUMNS)
    rows = []

    def take(name, values, source):
        errors = values.get("standard_error", {})
        for parameter, value in values.items():
            if isinstance(value, float):
                error = errors.get(parameter)
                rows.append(Row({"fit": name, "parameter": parameter, "value": repr(value),
                                 "standard_error": "" if error is None else repr(error)}, str(source)))

    for source in sorted(Path(folder).glob("figures_1_to_3/*/fit.json")):
        fit = read_json(source)
        name = source.parent.name
        take(name, fit, source)
        for plate, values in sorted(fit.get("plates", {}).items()):
            take(f"{name}, {plate}", values, source)
    return rows


@dataclass
class Results:
    """Everything that a folder holds."""
    folder: Path
    shots: list
    limits: list
    projectiles: list
    fits: list

    def has_picture(self, name):
        """Pictures lie beside the rows of a campaign, and one folder up from those of a page."""
        return (self.folder / name).exists() or (self.folder.parent / name).exists()


def read_results(folder):
    folder = Path(folder)
    return Results(folder, read_shots(folder), read_limits(folder), read_projectiles(folder), read_fits(folder))


@dataclass
class Tests:
    """The tables in apps/data."""
    shots: list
    limits: list
    listed: list
    paper: list

    def shots_of(self, metal, nose, thickness_mm):
        return [row for row in self.shots if row["material"] == metal and row["nose"] == nose
                and abs(row["thickness_mm"] - thickness_mm) < 0.01]


    def paper_velocity_mps(self, metal, nose, thickness_mm):
        """The strike velocity that the paper names as close to its limit (its Fig. 10); None where there is none."""
        for row in self.paper:
            if (row["figure"] == 10 and row["material"] == metal and row["nose"] == nose
                    and abs(row["thickness_mm"] - thickness_mm) < 0.01):
                return row["initial_velocity_mps"]
        return None


def read_tests(data=DATA):
    return Tests(*(read_table(data / name) for name in ("experiment_shots.csv", "experiment_limits.csv",
                                                        "figure_shots.csv", "paper_simulations.csv")))


def read_toml(file):
    try:
        with open(file, "rb") as stream:
            return tomllib.load(stream)
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"{file}: is no TOML: {error}") from None


def write_text(file, text):
    """Writes a file whole or not at all."""
    file.parent.mkdir(parents=True, exist_ok=True)
    new = file.with_name(file.name + ".new")
    new.write_text(text, encoding="utf-8")
    os.replace(new, file)


def csv_text(columns, rows):
    """Rows as CSV, the fields as they were read."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows([row.text[column] for column in columns] for row in rows)
    return stream.getvalue()
