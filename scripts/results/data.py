"""Rows of shots, limits and fits, and the tests in apps/data, as Python objects.

A folder of results is either that of a campaign (shots*.csv, *limits.csv, shots/, figures_1_to_3/) or the folder data/
of a page (shots.csv, limits.csv, projectiles.csv, fits.csv).
"""

import csv
import io
import json
import math
import os
import re
import subprocess
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TESTS = ROOT / "apps" / "data"
PAGE = ROOT / "docs" / "results"
PROGRAMS = ROOT / "build" / "release" / "apps"

SERIES_COLUMNS = ("method", "model", "material", "nose", "thickness_mm", "spacing_mm")
KEY_COLUMNS = SERIES_COLUMNS[:5] + ("initial_velocity_mps", "spacing_mm")
# Columns about the computation, not about the plate.
RECORD_COLUMNS = ("steps", "wall_s", "cpu_s", "threads", "state_hash", "version")
TEXT_COLUMNS = {"method", "model", "material", "nose", "state_hash", "version", "fit_a_origin", "fit_p_origin", "name",
                "text", "series", "source", "confidence", "what", "app", "use", "fit", "parameter"}
SHOT_COLUMNS = KEY_COLUMNS + ("residual_velocity_mps", "perforated")
LIMIT_COLUMNS = SERIES_COLUMNS + ("highest_stopped_mps", "lowest_perforated_mps", "bisection_limit_mps", "consistent",
                                  "fit_limit_mps", "fit_points", "test_limit_mps", "paper_velocity_mps")
PROJECTILE_COLUMNS = ("nose", "spacing_mm", "projectile_mass_g", "added_mass_g")
FIT_COLUMNS = ("fit", "parameter", "value", "standard_error")
LAWS = {"mjc": "MJC", "jc": "JC"}


class InputError(Exception):
    """Wrong input: one line that names the thing, the value and what is allowed."""


def short(value, digits=4):
    """A number with `digits` significant digits, all of those before the decimal point; a dash for None."""
    if value is None or (isinstance(value, float) and not math.isfinite(value)):
        return "–"
    if float(value).is_integer():
        return f"{value:.0f}"
    decimals = max(0, digits - 1 - math.floor(math.log10(abs(value))))
    if decimals > 8:
        return f"{value:.2g}"
    return f"{value:.{decimals}f}".rstrip("0").rstrip(".") if decimals else f"{value:.0f}"


def percent_of(value, reference):
    """Deviation from the reference in percent; None where either is missing."""
    return None if value is None or not reference else 100 * (value - reference) / reference


def close(a, b, within=1e-6):
    return abs(a - b) < within


class Row(dict):
    """A line of a table: numbers (None where the field is empty) and texts by column; `text` has the fields of the file."""

    def __init__(self, text, where):
        super().__init__((column, field if column in TEXT_COLUMNS else self._number(where, column, field))
                         for column, field in text.items())
        self.text, self.where = text, where

    @staticmethod
    def _number(where, column, field):
        try:
            value = float(field) if field else None
        except ValueError:
            value = math.nan
        if value is not None and not math.isfinite(value):
            raise InputError(f"{where}: {column} = {field[:40]!r}: must be a finite number")
        return value

    def key(self, columns):
        return tuple(self[column] for column in columns)


def read_records(file):
    """Header of a CSV file and its (line number, fields). Lines that begin with # are comments; a last line without its
    end, of a process that is writing it or was killed, is passed over."""
    content = Path(file).read_text(encoding="utf-8")
    lines = [(number, line) for number, line in enumerate(content[:content.rfind("\n") + 1].split("\n"), 1)
             if line.strip() and not line.startswith("#")]
    records = list(csv.reader(line for _, line in lines))
    header = records[0] if records else []
    for (number, _), fields in zip(lines, records):
        if len(fields) != len(header):
            raise InputError(f"{file}:{number}: fields in the row = {len(fields)}: must be {len(header)}")
    return header, [(number, fields) for (number, _), fields in zip(lines[1:], records[1:])]


def read_table(file, required=()):
    """Rows of a CSV file."""
    header, records = read_records(file)
    for column in required:
        if header and column not in header:
            raise InputError(f"{file}: columns = {', '.join(header)[:80]}: must hold {column}")
    return [Row(dict(zip(header, fields)), f"{file}:{number}") for number, fields in records]


def _parsed(file, parse, kind):
    try:
        return parse(Path(file).read_text(encoding="utf-8"))
    except ValueError as error:
        raise InputError(f"{file}: is no {kind}: {error}") from None


def read_json(file):
    return _parsed(file, json.loads, "JSON")


def read_toml(file):
    return _parsed(file, tomllib.loads, "TOML")


def build(*targets):
    """Sets up and builds programs, where that is to be done."""
    subprocess.run([ROOT / "scripts" / "build.sh", *targets], check=True)


def write_text(file, text):
    """Writes a file whole or not at all."""
    file.parent.mkdir(parents=True, exist_ok=True)
    new = file.with_name(file.name + ".new")
    new.write_text(text, encoding="utf-8")
    os.replace(new, file)


def csv_text(columns, rows):
    """Rows as CSV, with the fields that were read."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerows([columns, *([row.text[column] for column in columns] for row in rows)])
    return stream.getvalue()


def markdown_table(header, rows):
    lines = ["| " + " | ".join(cells) + " |" for cells in [header, *rows]]
    return "\n".join([lines[0], "|" + "---|" * len(header), *lines[1:]])


def metal_of(material):
    """Name of a metal in the tables of tests: several materials of the library are one metal."""
    return "Weldox 460 E" if material.startswith("weldox") else "AA5083-H116"


def plate_of(row):
    """Metal, nose and thickness of a shot or a limit."""
    return metal_of(row["material"]), row["nose"], row["thickness_mm"]


def of_plate(rows, metal, nose, thickness_mm, model="mjc", method="paper", *, spacing_mm):
    """Rows of shots or limits of a plate."""
    return [row for row in rows if metal_of(row["material"]) == metal and row["nose"] == nose
            and row["method"] == method and row["model"] == model and close(row["thickness_mm"], thickness_mm)
            and close(row["spacing_mm"], spacing_mm)]


def _first_of_each(rows, columns):
    """The first of the rows with the same key, which must be neighbours."""
    return [row for before, row in zip([None, *rows], rows) if before is None or before.key(columns) != row.key(columns)]


def read_shots(folder):
    """The rows of all shots*.csv of a folder, each shot once, sorted by its key."""
    files = sorted(Path(folder).glob("shots*.csv"))
    if not files:
        raise InputError(f"{folder}: holds no shots*.csv: must be a folder with results")
    rows = [row for file in files for row in read_table(file, SHOT_COLUMNS)]
    for row in rows:
        if list(row.text) != list(rows[0].text):
            raise InputError(f"{row.where}: columns: must be those of the other files shots*.csv")
    def first_of_its_key(row):
        # A search runs an undecided shot again, for longer. The hash breaks ties, so that the result does not depend on the
        # order of the files.
        undecided = row["perforated"] is None
        return row.key(KEY_COLUMNS), undecided, -(row.get("simulated_us") or 0) * undecided, row.get("state_hash") or ""

    rows.sort(key=first_of_its_key)
    return _first_of_each(rows, KEY_COLUMNS)


def half_width_mps(limit):
    """Half of the bisection's bracket; None while it has only one end."""
    if limit["highest_stopped_mps"] is None or limit["lowest_perforated_mps"] is None:
        return None
    return (limit["lowest_perforated_mps"] - limit["highest_stopped_mps"]) / 2


def read_limits(folder):
    """The rows of all *limits.csv of a folder, each series once, sorted. Where two programs have the same series, the row
    with the narrower bracket counts, then the one with more shots."""
    rows = [row for file in sorted(Path(folder).glob("*limits.csv")) for row in read_table(file, LIMIT_COLUMNS)]

    def newest_first(row):
        half = half_width_mps(row)
        return (row.key(SERIES_COLUMNS), math.inf if half is None else half, -(row["fit_points"] or 0),
                list(row.text.values()))

    return _first_of_each(sorted(rows, key=newest_first), SERIES_COLUMNS)


def ended_by_time(shot):
    """Whether a shot ran up to the end of its time, undecided or, by versions that did not know that, at 500 or 1500 us."""
    return shot.get("perforated", 0) is None or (shot.get("simulated_us") or 0) >= (500 if shot["nose"] == "blunt" else 1500)


def bracket_of(shots):
    """Highest velocity that was stopped below the lowest that perforated, and that one; None where there is none."""
    lowest = min((s["initial_velocity_mps"] for s in shots if s["perforated"]), default=None)
    stopped = [s["initial_velocity_mps"] for s in shots if s["perforated"] == 0]
    return max((v for v in stopped if lowest is None or v < lowest), default=None), lowest


def stale_limits(results):
    """Series whose limits do not belong to the shots: one line for each."""
    return [f"{limit['model']}, {limit['material']}, {limit['nose']}, {short(limit['thickness_mm'])} mm: the limit is "
            "older than the shots" for limit in results.limits
            if bracket_of([s for s in results.shots if s.key(SERIES_COLUMNS) == limit.key(SERIES_COLUMNS)])
            != (limit["highest_stopped_mps"], limit["lowest_perforated_mps"])]


def read_projectiles(folder):
    """Rows of PROJECTILE_COLUMNS, from projectiles.csv and the shots' summaries: one for each nose and particle
    distance, which gives the size of its hexes."""
    file = Path(folder) / "projectiles.csv"
    found = {row.key(PROJECTILE_COLUMNS[:2]): row for row in (read_table(file, PROJECTILE_COLUMNS) if file.exists() else [])}
    for summary in sorted(Path(folder).glob("shots/*/summary.json")):
        # The summary has the particle distance that fits the plate; the nominal one ends the folder's name.
        nominal = re.search(r"_([0-9.]+)mm$", summary.parent.name)
        try:
            values = read_json(summary)
        except InputError:
            continue  # a run is writing it
        if not nominal or values.get("fault") is not None or values.get("projectile_mass_g") is None:
            continue
        # Rounded: the mass of the same projectile differs in its last digits from plate to plate.
        row = Row({"nose": str(values["nose"]), "spacing_mm": nominal[1],
                   "projectile_mass_g": f"{values['projectile_mass_g']:.6f}",
                   "added_mass_g": f"{abs(values['added_mass_g']):.6f}"}, str(summary))
        found.setdefault(row.key(PROJECTILE_COLUMNS[:2]), row)
    return [found[key] for key in sorted(found)]


def read_fits(folder):
    """Rows of FIT_COLUMNS, from fits.csv or else from the fit.json files in figures_1_to_3/."""
    file = Path(folder) / "fits.csv"
    if file.exists():
        return read_table(file, FIT_COLUMNS)
    rows = []

    def take(name, values, source):
        for parameter, value in values.items():
            if isinstance(value, float):
                error = values.get("standard_error", {}).get(parameter)
                rows.append(Row({"fit": name, "parameter": parameter, "value": repr(value),
                                 "standard_error": "" if error is None else repr(error)}, str(source)))

    for source in sorted(Path(folder).glob("figures_1_to_3/*/fit.json")):
        fit, name = read_json(source), source.parent.name
        take(name, fit, source)
        for plate, values in sorted(fit.get("plates", {}).items()):
            take(f"{name}, {plate}", values, source)
    return rows


class Results:
    """Everything that a folder holds."""

    def __init__(self, folder):
        self.folder, self.shots, self.limits = folder, read_shots(folder), read_limits(folder)
        self.projectiles, self.fits = read_projectiles(folder), read_fits(folder)

    def has_picture(self, name):
        """Pictures lie beside the rows of a campaign, and one folder up from those of a page."""
        return (self.folder / name).exists() or (self.folder.parent / name).exists()


class Tests:
    """The tables in apps/data; `spacing_mm` replaces the particle distances of the listed shots."""

    def __init__(self, spacing_mm=None):
        self.spacing_mm = spacing_mm
        self.shots, self.limits, self.listed, self.paper = (read_table(TESTS / f"{name}.csv") for name in (
            "experiment_shots", "experiment_limits", "figure_shots", "paper_simulations"))

    def _of(self, rows, metal, nose, thickness_mm):
        return [row for row in rows if row["material"] == metal and row["nose"] == nose
                and close(row["thickness_mm"], thickness_mm, 0.01)]

    def distance_mm(self, nose, metal=None, thickness_mm=None):
        """Particle distance of the listed shots with a nose, on any plate or on one; None where none is listed."""
        found = (row["spacing_mm"] for row in self.listed
                 if row["nose"] == nose and (metal is None or plate_of(row) == (metal, nose, thickness_mm)))
        return next(found, None) if self.spacing_mm is None else self.spacing_mm

    def shots_of(self, *plate):
        return self._of(self.shots, *plate)

    def limit_of(self, *plate):
        """The row with the measured limit; None where there is none."""
        return next(iter(self._of(self.limits, *plate)), None)

    def limit_mps(self, *plate):
        row = self.limit_of(*plate)
        return row and row["ballistic_limit_mps"]

    def paper_velocity_mps(self, *plate):
        """The strike velocity that the paper names as close to its limit (its Fig. 10); None where there is none."""
        return next((row["initial_velocity_mps"] for row in self._of(self.paper, *plate) if row["figure"] == 10), None)
