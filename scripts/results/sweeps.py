"""The sweeps behind the tables of docs/: lists of cases in bench/cases with options for all of them, run by `ogive sweep`
in folders below vtk_out/bench. Cases that a folder holds already are not run again. Their rows are kept in
bench/rows, so that tables and searches resume from them on another machine. They count while options, list and material files are
the same; after a change of the method they must be deleted."""

import csv
import hashlib
import json
import re
import shutil
import subprocess
import sys
from functools import partial
from operator import mul
from pathlib import Path
from typing import NamedTuple

from .data import PROGRAMS, ROOT, InputError, read_json, read_records, write_text

CASES = ROOT / "bench" / "cases"
FOLDER = ROOT / "vtk_out" / "bench"
KEPT = ROOT / "bench" / "rows"
PROGRAM = PROGRAMS / "ogive"
WIDTH_MPS = 5  # of a bracket at the end of a search, the default of ogive sweep


# Of summary.json: what tables show.
SHOWN_KEYS = (
    "version", "initial_velocity_mps", "obliquity_deg", "residual_velocity_mps", "final_speed_mps", "deflection_deg", "turn_deg",
    "test_residual_velocity_mps", "test_origin", "velocity_at_shoulder_mps", "plug_mass_g", "hole_diameter_mm",
    "failed_particles", "dishing_mm", "dishing_at_rest_mm", "hourglass_fraction", "energy_error", "momentum_error",
    "largest_intrusion_mm", "steps", "cpu_s", "state_hash")
PATHS = {"material"}  # columns whose values may be paths


class Sweep(NamedTuple):
    folder: str  # below vtk_out/bench
    cases: str  # bench/cases/CASES.csv
    options: str = ""  # for all cases
    text: str = "{}"  # of a row, from that of its case


# Metals of the lists, by the file names there: a metal of the library, and what becomes of its constants.
METALS = {
    "floor_0.001.toml": ("weldox_460e", {"rate_floor_per_s": lambda _: 0.001}),
    "floor_100.toml": ("weldox_460e", {"rate_floor_per_s": lambda _: 100}),
    **{f"aluminium_{name}_{factor}.toml": ("aa5083_h116", {key: partial(mul, factor)})
       for name, key in (("A", "A_MPa"), ("B", "B_MPa"), ("a", "a")) for factor in (0.9, 1.1)},
}


def changed_metal(text, name, changes):
    """A material file with other constants."""
    for key, change in changes.items():
        text, count = re.subn(rf"^({key} = )([^ \n#]+)", lambda m, change=change: f"{m[1]}{change(float(m[2])):.10g}", text,
                              flags=re.MULTILINE)
        if count != 1:
            raise InputError(f"{name}: {key}: is no constant of the metal: must be one")
    return re.sub(r'^name = .*', f'name = "{name.removesuffix(".toml")}"', text, flags=re.MULTILINE)


def cases_file(sweep, folder):
    """The list with the names of its material files as paths; makes those files."""
    source = CASES / f"{sweep.cases}.csv"
    header, records = read_records(source)
    if not any(field in METALS for _, fields in records for field in fields):
        return source.relative_to(ROOT)  # so that rows name no folder above
    at = header.index("material")
    for _, fields in records:
        if fields[at] in METALS:
            metal, changes = METALS[fields[at]]
            shown = subprocess.run([PROGRAM, "materials", "show", metal], check=True, capture_output=True, text=True)
            write_text(folder / fields[at], changed_metal(shown.stdout, fields[at], changes))
            fields[at] = str(folder / fields[at])
    folder.mkdir(parents=True, exist_ok=True)
    with open(folder / "cases.csv", "w", encoding="utf-8", newline="") as stream:
        csv.writer(stream, lineterminator="\n").writerows([header, *(fields for _, fields in records)])
    return folder / "cases.csv"


def is_of_limits(sweep):
    return "--limit" in sweep.options.split()


def recipe(sweep):
    """A hash of options, list and material files of a sweep."""
    _, records = read_records(CASES / f"{sweep.cases}.csv")
    files = sorted({field for _, fields in records for field in fields if field.endswith(".toml")} - METALS.keys())
    parts = [sweep.options.encode(), *(path.read_bytes() for path in [CASES / f"{sweep.cases}.csv",
                                                                       *(CASES / name for name in files)])]
    return hashlib.sha256(b"\n".join(parts)).hexdigest()


def kept(sweep, name):
    """A file of the kept rows; None if there is none or they were made by another recipe."""
    folder = KEPT / sweep.folder
    same = (folder / "recipe.txt").exists() and (folder / "recipe.txt").read_text().strip() == recipe(sweep)
    return folder / name if same and (folder / name).exists() else None


def has_portable_rows(sweep):
    """Rows that name material files of this machine are not kept, only what tables show of their shots."""
    _, records = read_records(CASES / f"{sweep.cases}.csv")
    return not any(field in METALS for _, fields in records for field in fields)


def take_kept(sweep):
    """Puts the kept rows where the folder of a sweep has none."""
    rows = FOLDER / sweep.folder / "shots.csv"
    if kept(sweep, "shots.csv") and not rows.exists():
        rows.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(kept(sweep, "shots.csv"), rows)


def keep(sweep):
    """Keeps the rows of a sweep, unless more of them are kept, and of shots what the tables show."""
    folder, target = FOLDER / sweep.folder, KEPT / sweep.folder
    rows, earlier = folder / "shots.csv", kept(sweep, "shots.csv")
    if not rows.exists() or (earlier and len(texts(earlier)) > len(texts(rows))):
        return
    known = {case["name"]: found for case in cases(sweep) if (found := summary(sweep, case["name"]))}  # kept ones, too
    target.mkdir(parents=True, exist_ok=True)
    for name in ("shots.csv", "limits.csv") if has_portable_rows(sweep) else ():
        if (folder / name).exists():
            shutil.copy(folder / name, target / name)
    if known and not is_of_limits(sweep):
        shown = {name: {key: found[key] for key in SHOWN_KEYS if key in found} for name, found in known.items()}
        write_text(target / "summaries.json", json.dumps(shown, indent=1) + "\n")
    write_text(target / "recipe.txt", recipe(sweep) + "\n")


def run(sweep, jobs=None):
    """Runs the cases that the folder lacks; those that fail are reported and have no row."""
    folder = FOLDER / sweep.folder
    take_kept(sweep)
    command = list(map(str, [PROGRAM, "sweep", cases_file(sweep, folder), *(["--jobs", jobs] if jobs else []),
                             *sweep.options.split(), "--no-vtk", "--no-picture", "--out", folder]))
    print(" ".join(command), file=sys.stderr)
    # Standard output belongs to the tables.
    status = subprocess.run(command, check=False, stdout=2, cwd=ROOT).returncode
    if status:
        print(f"results: {sweep.folder} ended with status {status}", file=sys.stderr)
    keep(sweep)


def texts(file):
    """Rows as texts."""
    header, records = read_records(file)
    return [dict(zip(header, fields)) for _, fields in records]


def cases(sweep):
    return texts(CASES / f"{sweep.cases}.csv")


def summary(sweep, name):
    """summary.json of a case that has been run, with the options of its row, or SHOWN_KEYS of it if only that is kept; None
    if it has not been run, or ended with a fault."""
    file = FOLDER / sweep.folder / "shots" / name / "summary.json"
    if not file.exists():
        return read_json(kept(sweep, "summaries.json")).get(name) if kept(sweep, "summaries.json") else None
    found = read_json(file)
    return None if found.get("fault") else found


def limit_rows(sweep):
    """(case, row of limits.csv) of the limits that have been found. The rows of limits have no names but values of all
    options except the velocity: that of a case has its values, and in columns that it leaves empty none that others of the
    list give. With --vary a case has several. A search that has not ended has a wider bracket than WIDTH_MPS."""
    file, listed = FOLDER / sweep.folder / "limits.csv", cases(sweep)
    file = file if file.exists() else kept(sweep, "limits.csv") or file
    columns = [column for column in listed[0] if column not in ("name", "text", "velocity_mps")]
    for case in listed:
        case.update({column: Path(case[column]).name for column in PATHS & case.keys()})
    given = {column: {case[column] for case in listed} - {""} for column in columns}

    def value(row, column):
        return Path(row[column]).name if column in PATHS else row[column]

    def has_ended(row):
        return row["bisection_limit_mps"] and (
            float(row["lowest_perforated_mps"]) - float(row["highest_stopped_mps"]) <= WIDTH_MPS * (1 + 1e-9))

    return [(case, row) for case in listed for row in (texts(file) if file.exists() else [])
            if has_ended(row) and all(value(row, c) == case[c] if case[c] else value(row, c) not in given[c]
                                                  for c in columns)]


def shot_rows(sweep):
    """Of the shots of a sweep of limits, from its folder or else those that are kept."""
    rows = FOLDER / sweep.folder / "shots.csv"
    rows = rows if rows.exists() else kept(sweep, "shots.csv")
    return texts(rows) if rows else []


def cost_s(sweep, limit):
    """Processor time of all shots of a row of limits.csv, s."""
    keys = list(limit)[:list(limit).index("highest_stopped_mps")]
    return sum(float(shot["cpu_s"]) for shot in shot_rows(sweep) if all(shot.get(key) == limit[key] for key in keys))


def versions(sweep):
    """Of the shots that have been run."""
    summaries = [summary(sweep, case["name"]) for case in cases(sweep)] if not is_of_limits(sweep) else []
    return {found["version"] for found in summaries if found and "version" in found} | {row["version"] for row in shot_rows(sweep)}


def limits(sweep):
    """The limits that have been found, m/s, by the name of the case."""
    return {case["name"]: float(row["bisection_limit_mps"]) for case, row in limit_rows(sweep)}
