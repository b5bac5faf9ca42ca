"""The gallery of docs/gallery.md: the shots of bench/cases/gallery.csv, each with its commands, its picture and its cost.
Results are kept in bench/rows/gallery.csv; a shot is run again when its command has changed."""

import csv
import io
import os
import shlex
import subprocess
import sys

from . import sweeps as runs
from .data import PROGRAMS, ROOT, InputError, build, markdown_table, read_json, short, write_text
from .insert import insert
from .tables import BRACKETS

FOLDER = "vtk_out/gallery"  # of the shots, from the project's folder
ROWS = runs.KEPT / "gallery.csv"
PICTURES = ROOT / "docs" / "gallery"
PIXELS = 320
MOST_BYTES = 60_000  # of a picture
KEYS = ("verdict", "initial_velocity_mps", "residual_velocity_mps", "test_residual_velocity_mps", "test_origin", "plug_mass_g",
        "particles", "cpu_s", "version")
LEAST_PLUG_G = 1  # less is debris


def cases():
    return runs.cases(runs.Sweep("gallery", "gallery"))


def value_of(option, text):
    """Names of files in a list count from its folder, on the command line from the project's."""
    if option in runs.PATHS and text.endswith(".toml"):
        return os.path.relpath(runs.CASES / text, ROOT)
    return text


def shot(case):
    """The command of a shot, in words."""
    words = ["ogive", "shoot"]
    for option, text in case.items():
        if option not in ("name", "text") and text:
            words += [f"--{option.replace('_', '-')}", *([] if text == "true" else [value_of(option, text)])]
    return [*words, "--out", f"{FOLDER}/{case['name']}"]


def drawing(case):
    folder = f"{FOLDER}/{case['name']}"
    return ["ogive", "draw", "--series", folder, "--pixels", str(PIXELS), "--out", f"{folder}.png"]


def kept():
    """The rows of shots by the name of their case: only those that the present command made."""
    rows = {row["name"]: row for row in (runs.texts(ROWS) if ROWS.exists() else [])}
    return {case["name"]: rows[case["name"]] for case in cases()
            if rows.get(case["name"], {}).get("command") == shlex.join(shot(case))}


def run_missing_shots(program):
    """Runs, draws and keeps the shots that have no row, one at a time on one thread."""
    found = kept()
    for case in cases():
        name = case["name"]
        if name in found and (PICTURES / f"{name}.png").exists():
            continue
        print(shlex.join(shot(case)), file=sys.stderr)
        for command in ([*shot(case), "--threads", "1", "--quiet", "--no-picture"], drawing(case)):
            subprocess.run([program, *command[1:]], check=True, stdout=2, cwd=ROOT)
        picture = (ROOT / FOLDER / f"{name}.png").read_bytes()
        if len(picture) > MOST_BYTES:
            raise InputError(f"{FOLDER}/{name}.png = {len(picture)} bytes: must be at most {MOST_BYTES}")
        PICTURES.mkdir(parents=True, exist_ok=True)
        (PICTURES / f"{name}.png").write_bytes(picture)
        summary = read_json(ROOT / FOLDER / name / "summary.json")
        found[name] = {"name": name, "command": shlex.join(shot(case)),
                       **{key: "" if summary.get(key) is None else str(summary[key]) for key in KEYS}}
        stream = io.StringIO()
        writer = csv.DictWriter(stream, ["name", "command", *KEYS], lineterminator="\n")
        writer.writeheader()
        writer.writerows(found[case["name"]] for case in cases() if case["name"] in found)
        write_text(ROWS, stream.getvalue())


def outcome(row):
    """The result in one line."""
    number = {key: float(row[key]) for key in KEYS if key.endswith(("_mps", "_g")) and row[key]}
    if row["verdict"] != "perforated":
        return f"{number['initial_velocity_mps']:g} m/s: {row['verdict']}"
    text = f"{number['initial_velocity_mps']:g} m/s before the plate, {number['residual_velocity_mps']:.0f} m/s behind it"
    if number.get("plug_mass_g", 0) >= LEAST_PLUG_G:
        text += f"; plug of {number['plug_mass_g']:.1f} g"
    if "test_residual_velocity_mps" in number:
        test = f"{number['test_residual_velocity_mps']:.0f} m/s"
        text += f"; test: {f'({test})' if row['test_origin'].startswith('Recht') else test}"
    return text


def text_of(rows):
    """The table, and below it the commands of each case."""
    listed = [(case, rows[case["name"]]) for case in cases() if case["name"] in rows]
    table = markdown_table(["picture", "case", "result", "particle distance, mm", "particles", "processor, s"], [
        [f"![{case['text']}](gallery/{case['name']}.png)", case["text"], outcome(row), case["spacing_mm"],
         row["particles"], short(float(row["cpu_s"]), 2)] for case, row in listed])
    commands = [f"### {case['text']}\n\n```\n{shlex.join(shot(case))}\n{shlex.join(drawing(case))}\n```" for case, _ in listed]
    versions = ", ".join(sorted({row["version"] for _, row in listed}))
    return "\n\n".join([f"Made by `scripts/results.sh gallery` with ogive {versions}, one thread for each shot. {BRACKETS}", table,
                        "## Commands", *commands])


def make_gallery(run_missing=False, program=None, put_in=False):
    """Prints the gallery, and puts it into its page."""
    if run_missing:
        if program is None:
            build("ogive_main")
        run_missing_shots((program or PROGRAMS / "ogive").resolve())
    rows = kept()
    if not rows:
        raise InputError(f"gallery: no row in {ROWS.relative_to(ROOT)} fits its command: add --run")
    text = text_of(rows)
    print(text)
    if put_in:
        insert(ROOT / "docs" / "gallery.md", text, "tables: scripts/results.sh gallery")
