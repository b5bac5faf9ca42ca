#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""results_page.py FOLDER OUT: makes a page of the results of a campaign. OUT/index.html opens from the disk; beside it
lie the pictures, results/*.csv with what was computed and run_record.* with how."""

import json
import os
import re
import shutil
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # the modules beside this script leave no files behind

import accept  # noqa: E402
import ogive_results  # noqa: E402
import results_html  # noqa: E402
import results_limits  # noqa: E402
from ogive_results import InputError, KEY_COLUMNS, RECORD_COLUMNS, ROOT, csv_text, write_text  # noqa: E402


def read_facts(file):
    facts = ogive_results.read_toml(file).get("figure", [])
    for fact in facts:
        for name in ("number", "title", "shows", "pictures", "paper", "short"):
            if name not in fact:
                raise InputError(f"{file}: figure {fact.get('number', '?')}: {name}: is required")
    return facts


def cache_values(build):
    """CMakeCache.txt as a dictionary."""
    file = build / "CMakeCache.txt"
    if not file.exists():
        return {}
    lines = file.read_text(encoding="utf-8", errors="replace").splitlines()
    return {match[1]: match[2] for match in (re.match(r"([\w-]+):\w+=(.*)", line) for line in lines) if match}


def compiler_of(build):
    """Name and version, "GNU 12.2.0"."""
    for file in sorted(build.glob("CMakeFiles/*/CMakeCXXCompiler.cmake")):
        found = dict(re.findall(r'set\(CMAKE_CXX_COMPILER_(ID|VERSION) "([^"]*)"\)', file.read_text(encoding="utf-8")))
        if len(found) == 2:
            return f"{found['ID']} {found['VERSION']}"
    name = cache_values(build).get("CMAKE_CXX_COMPILER")
    return Path(name).name if name else None


def flags_of(build):
    """Those of perforate, which runs the shots; else what the cache has."""
    ninja = build / "build.ninja"
    if ninja.exists():
        found = re.search(r"^build \S*perforate\.dir/\S*main\.cpp\.o:.*\n(?:  .*\n)*?  FLAGS = (.*)",
                          ninja.read_text(encoding="utf-8", errors="replace"), re.MULTILINE)
        if found:
            return found[1]
    cache = cache_values(build)
    names = ("CMAKE_CXX_FLAGS", "CMAKE_CXX_FLAGS_" + cache.get("CMAKE_BUILD_TYPE", "").upper())
    return " ".join(filter(None, (cache.get(name) for name in names))) or None


def cpu_models(before):
    """This machine's and those of a record before: rows of several machines may stand on one page."""
    try:
        text = Path("/proc/cpuinfo").read_text(encoding="utf-8", errors="replace")
    except OSError:
        text = ""
    found = re.search(r"^model name\s*:\s*(.*)$", text, re.MULTILINE)
    known = ogive_results.read_json(before).get("cpu_models", []) if before.exists() else []
    return sorted({*known, *([found[1].strip()] if found else [])})


def run_record(results, build, before):
    shots = results.shots
    seconds = sum(s["cpu_s"] for s in shots if s.get("cpu_s"))
    cache = cache_values(build)
    return {
        "version": sorted({s["version"] for s in shots if s.get("version")}),
        "compiler": compiler_of(build),
        "build_type": cache.get("CMAKE_BUILD_TYPE"),
        "flags": flags_of(build),
        "cpu_models": cpu_models(before),
        "cores": os.cpu_count(),
        "shots": len(shots),
        "threads": sorted({int(s["threads"]) for s in shots if s.get("threads")}),
        "core_minutes": round(seconds / 60, 1),
    }


def write_tables(results, out):
    """What was computed, without how long it took and with what: two campaigns can be compared byte for byte."""
    columns = list(results.shots[0].text) if results.shots else list(ogive_results.SHOT_COLUMNS)
    write_text(out / "results" / "shots.csv",
               csv_text([c for c in columns if c not in RECORD_COLUMNS], results.shots))
    limits = list(results.limits[0].text) if results.limits else list(ogive_results.LIMIT_COLUMNS)
    write_text(out / "results" / "limits.csv", csv_text(limits, results.limits))
    write_text(out / "results" / "projectiles.csv", csv_text(ogive_results.PROJECTILE_COLUMNS, results.projectiles))
    write_text(out / "results" / "fits.csv", csv_text(ogive_results.FIT_COLUMNS, results.fits))
    record = [*KEY_COLUMNS, *(c for c in RECORD_COLUMNS if c in columns)]
    write_text(out / "run_record.csv", csv_text(record, results.shots))


def copy_pictures(facts, folder, out):
    """Copies the pictures that are there, takes those away that are not, and returns the names of the former."""
    there = set()
    for picture in (picture for fact in facts for picture in fact["pictures"]):
        source, target = folder / picture.get("from", picture["file"]), out / picture["file"]
        if source.exists():
            shutil.copyfile(source, target)
            there.add(picture["file"])
        else:
            target.unlink(missing_ok=True)
    return there


def link_prefix_of(out):
    """From the page to docs/; nothing where the page lies outside the project."""
    relative = os.path.relpath(ROOT / "docs", out.resolve())
    return relative.replace(os.sep, "/") + "/" if out.resolve().is_relative_to(ROOT) else None


def main():
    parser = ogive_results.OneLineParser(prog="results_page", description=__doc__)
    parser.add_argument("folder", type=Path, help="of a campaign, vtk_out/figures for example")
    parser.add_argument("out", type=Path, help="folder for the page, docs/results for example")
    parser.add_argument("--spacing-mm", type=float, help="particle distance of the runs [that of acceptance.toml]")
    parser.add_argument("--checks", type=Path, default=accept.CHECKS, help="[docs/results/acceptance.toml]")
    parser.add_argument("--facts", type=Path, default=accept.FACTS, help="[docs/results/paper_facts.toml]")
    parser.add_argument("--data", type=Path, default=ogive_results.DATA, help="tables of tests [apps/data]")
    parser.add_argument("--build", type=Path, default=ROOT / "build" / "release", help="[build/release]")
    o = parser.parse_args()
    if o.out.resolve() == o.folder.resolve():
        raise InputError(f"OUT = {o.out}: must not be the folder with the results")
    results, tests = ogive_results.read_results(o.folder), ogive_results.read_tests(o.data)
    facts = read_facts(o.facts)
    usual_mm = ogive_results.read_toml(o.checks).get("defaults", {}).get("spacing_mm", 0)
    spacing_mm = usual_mm if o.spacing_mm is None else o.spacing_mm
    checks = accept.run_checks(results, tests, o.checks, spacing_mm)
    beyond = accept.run_checks(results, tests, accept.BEYOND, spacing_mm)

    o.out.mkdir(parents=True, exist_ok=True)
    write_tables(results, o.out)
    record = run_record(results, o.build, o.out / "run_record.json")
    write_text(o.out / "run_record.json", json.dumps(record, indent=2, ensure_ascii=False) + "\n")
    pictures = copy_pictures(facts, o.folder, o.out)
    page = results_html.Page(facts, results, tests, checks, beyond, {**record, "usual_spacing_mm": usual_mm}, spacing_mm,
                             pictures, link_prefix_of(o.out))
    write_text(o.out / "index.html", results_html.whole_page(page))
    for line in results_limits.stale_limits(results):
        print(f"results_page: {line}", file=sys.stderr)
    print(f"{o.out / 'index.html'}: {len(results.shots)} shots, {len(pictures)} pictures, checks: "
          f"{accept.summary(checks)}")
    return 0


if __name__ == "__main__":
    sys.exit(ogive_results.run_main("results_page", main))
