#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""random_shots.py [--count N] [--seed S] [--jobs J] [--program PROGRAM] [--out FOLDER] [--end-us T] [--verdicts]

Shoots N random but legal cases for a short time (200 cases of 30 us unless said otherwise) and checks each: no fault, an
energy error below 1 %, no particle deeper in the projectile than half a particle distance, finite numbers. The same seed
gives the same cases. Prints a line for each case that is not in order and, last, how many are. Exit status 1 if one is
not, 2 for wrong options. Shots that ended in FOLDER with the same program are not run again. A case that failed runs
again with `ogive shoot --config FOLDER/<number>/case.toml`.

With --verdicts 400 cases run to their end, over calibres of 1 to 100 mm, plates of 0.05 to 5 calibres, one or several, 50
to 3000 m/s, obliquities up to 60 degrees and all methods, and its verdict is checked by position and energy: a perforated
plate has the projectile behind it that moves on, a stopped one does not; far more energy than the plate can take up
perforates, far less does not. Undecided shots are printed and counted, with their reason.

A hex with several points can lose the volume of one of them at a sharp tip that yields. ogive stops such a shot
because of that volume, or of the time step that it allows, before its energy goes wrong: it is printed as refused and is
no failure. Neither is a shot above 1500 m/s, for which ogive warns, that a fault stops, nor one where a particle gets into a
projectile that has lost hexes, whose surface may overlap itself: ogive warns of that, too, and it is printed.
"""

import argparse
import csv
import json
import math
import random
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MOST_PARTICLES = 6000
MOST_PARTICLES_TO_THE_END = 400
ENERGY_ERROR = 0.01
ENERGY_ERROR_TO_THE_END = 0.03  # as coarse as they are
FASTEST_TESTED = 1500
REFUSED = ("a hex has no volume left at its point", "the stable time step fell to")


def log_uniform(draw, low, high):
    return math.exp(draw.uniform(math.log(low), math.log(high)))


def random_case(draw):
    """Options of `ogive shoot`: sizes, velocities and spacings log-uniform, everything else by lot."""
    thickness = log_uniform(draw, 2, 40)
    extent, part = draw.choice([("quarter", 0.25), ("quarter", 0.25), ("half", 0.5), ("full", 1.0)])
    radius = draw.uniform(18, 30)
    finest = (part * math.pi * radius**2 * thickness / MOST_PARTICLES) ** (1 / 3)
    coarsest = min(thickness / 2, 3.5, (radius - 10) / 2.5)
    spacing = log_uniform(draw, min(finest, coarsest), coarsest)
    damage = draw.choice(["none", "none", "jc", "cockcroft_latham"])
    nose = draw.choice(["blunt", "conical", "ogival", "hemispherical"])
    case = {
        "material": draw.choice(["weldox_460e", "aa5083_h116", "aa5083_h116_25mm"]),
        "model": draw.choice(["mjc", "jc"]),
        "damage": damage,
        "thickness_mm": round(thickness, 2),
        "clamp_radius_mm": round(draw.uniform(radius + 10, 250), 1),
        "nose": nose,
        "projectile": draw.choice(["deformable", "deformable", "rigid"]),
        "velocity_mps": round(log_uniform(draw, 50, 1500), 1),
        "friction": draw.choice([0, 0.02, 0.08, 0.3]),
        "spacing_mm": math.floor(spacing * 1000) / 1000,
        "sph_radius_mm": round(radius, 1),
        "extent": extent,
        "lattice": draw.choice(["ring", "cubic"]),
        "form": draw.choice(["renormalised", "renormalised", "standard"]),
        "kernel": draw.choice(["cubic_spline", "cubic_spline", "wendland_c2"]),
        "smoothing": draw.choice(["constant", "constant", "variable"]),
        "element": draw.choice(["one_point", "one_point", "selective_reduced"]),
        "pressure": draw.choice(["linear", "mie_gruneisen"]),
    }
    if damage != "none":
        case["failure"] = draw.choice(["none", "no_tension", "removal"])
    return case


def random_shot(draw):
    """Options of a shot to its verdict: all sizes scale with a calibre of 1 to 100 mm."""
    diameter = log_uniform(draw, 1, 100)
    oblique = draw.random() < 0.25
    method = draw.choice(["paper", "stabilised"])
    plates = 1 if draw.random() < 0.8 else 2
    thickness = diameter * log_uniform(draw, 0.05, 5 if not oblique else 1)
    gap = diameter * draw.choice([0, 0.5]) * (plates - 1)
    depth = plates * thickness + gap
    obliquity = draw.choice([15, 30, 45, 60]) if oblique else 0
    turn = math.radians(obliquity)
    least = diameter / 2 / math.cos(turn) + depth * math.tan(turn)
    radius = least * 1.25 + 0.4 * diameter
    extent, part = ("half", 0.5) if oblique else ("quarter", 0.25)
    finest = (part * math.pi * radius**2 * thickness * plates / MOST_PARTICLES_TO_THE_END) ** (1 / 3)
    spacing = 0.999 * min(max(finest, diameter / 20), thickness / 2, (radius - least) / 2.1, diameter / 5)
    case = {
        "material": draw.choice(["weldox_460e", "aa5083_h116"]),
        "method": method,
        "nose": draw.choice(["blunt", "blunt", "conical", "ogival", "hemispherical"]),
        "projectile": draw.choice(["deformable", "rigid"]),
        "diameter_mm": diameter,
        "length_mm": diameter * (4 if draw.random() < 0.7 else 2.5),
        "clamp_radius_mm": radius + diameter * draw.uniform(1, 6),
        "velocity_mps": log_uniform(draw, 50, 3000),
        "spacing_mm": spacing,
        "sph_radius_mm": radius,
    }
    case |= {"thickness_mm": thickness} if plates == 1 else {"layers_mm": ",".join([f"{thickness:.4g}"] * plates)}
    if plates > 1:
        case["gaps_mm"] = gap
    if oblique:
        case |= {"obliquity_deg": obliquity, "extent": extent}
    return {key: float(f"{value:.4g}") if isinstance(value, float) else value for key, value in case.items()}


def arguments_of(case):
    return [f"--{key.replace('_', '-')}={value}" for key, value in case.items()]


def outcome_of(case, folder, status, output, most_energy_error):
    """What is not in order with a shot, as a list of texts, and why it is set apart, if it is."""
    try:
        summary = json.loads((folder / "summary.json").read_text())
    except (OSError, json.JSONDecodeError):
        last = output.strip().splitlines()[-1:] or ["no output"]
        return [f"status {status}: {last[0]}"], None
    found = []
    if status != 0 or summary["fault"]:
        fault = summary["fault"] or {}
        text = f"{fault.get('what')} ({fault.get('body')} {fault.get('id')}, {fault.get('time_us')} us)"
        tip = case.get("element") == "selective_reduced" and str(fault.get("what")).startswith(REFUSED)
        if status == 3 and (tip or case["velocity_mps"] > FASTEST_TESTED):
            return [], f"refused: {text}"
        found.append(f"status {status}: {text}")
    numbers = {key: value for key, value in summary.items() if isinstance(value, float)}
    found += [f"{key} is {value}" for key, value in numbers.items() if not math.isfinite(value)]
    if summary["energy_error"] is None or not summary["energy_error"] <= most_energy_error:
        found.append(f"energy error {100 * (summary['energy_error'] or math.nan):.2f} %")
    if not summary["largest_intrusion_mm"] <= 0.5 * summary["spacing_mm"]:
        text = f"a particle {summary['largest_intrusion_mm']:.3f} mm inside the projectile"
        if summary.get("removed_hexes", 0) > 0:
            return found, f"{text}, of which {summary['removed_hexes']} hexes were removed"
        found.append(text)
    return found, None


def wrong_verdict(case, folder):
    """What speaks against the verdict of a shot, as a list of texts; and that it is undecided, if it is."""
    summary = json.loads((folder / "summary.json").read_text())
    with open(folder / "history.csv", encoding="utf-8") as file:
        last = list(csv.DictReader(file))[-1]
    depth = case.get("thickness_mm") or sum(map(float, case["layers_mm"].split(","))) + case.get("gaps_mm", 0)
    initial, final = case["velocity_mps"], float(last["velocity_m_per_s"])
    nose, tail = float(last["nose_depth_mm"]), float(last["tail_depth_mm"])
    verdict, found = summary["verdict"], []
    if verdict == "undecided":
        return [], f"undecided: {summary['undecided_because'] or 'without a reason'}"
    if verdict == "perforated" and not (nose > depth and 0 < final <= initial * 1.001):
        found.append(f"perforated, with the nose {nose:.3g} mm deep in {depth:.3g} mm at {final:.4g} m/s")
    if verdict == "stopped" and tail > depth and final > 0.005 * initial:
        found.append(f"stopped, with the tail {tail - depth:.3g} mm behind the plate at {final:.4g} m/s")
    # Bounds that hold for any mode of failure, J: the volume in the way times a pressure of 50 MPa, a tenth of what steel
    # needs to yield in a test of hardness, and of 8 GPa, four times that.
    way = math.pi / 4 * (case["diameter_mm"] * 1e-3) ** 2 * depth * 1e-3
    mass = summary["projectile_mass_g"] * 1e-3
    energy = mass * initial**2 / 2
    if case.get("obliquity_deg", 0) == 0:
        if verdict == "perforated" and energy < 50e6 * way:
            found.append(f"perforated with {energy:.3g} J, where {50e6 * way:.3g} J are the least")
        if verdict == "stopped" and energy * mass / (mass + 7850 * way) > 8e9 * way:
            found.append(f"stopped with {energy:.3g} J, where {8e9 * way:.3g} J are enough")
    return found, None


def shoot(number, case, options):
    folder = options.out / f"{number:03d}"
    command = [str(options.program), "shoot", *arguments_of(case), "--threads=1", "--quiet", "--no-vtk", "--no-picture",
               f"--out={folder}", *([] if options.verdicts else [f"--end-us={options.end_us}"])]
    ended, run = folder / "ended.json", [*command, options.program.stat().st_mtime_ns]
    if ended.is_file() and (record := json.loads(ended.read_text()))["run"] == run:
        status, output = record["status"], record["output"]
    else:
        done = subprocess.run(command, capture_output=True, text=True)
        status, output = done.returncode, done.stderr
        if folder.is_dir():
            ended.write_text(json.dumps({"run": run, "status": status, "output": output}))
    found, apart = outcome_of(case, folder, status, output,
                                ENERGY_ERROR_TO_THE_END if options.verdicts else ENERGY_ERROR)
    if options.verdicts and not found and (folder / "summary.json").is_file() and status == 0:
        wrong, undecided = wrong_verdict(case, folder)
        found, apart = wrong, undecided or apart
    return found, apart


def main():
    parser = argparse.ArgumentParser(usage=__doc__.replace("%", "%%"))
    parser.add_argument("--count", type=int)
    parser.add_argument("--seed", type=int, default=20120726)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--end-us", type=float, default=30)
    parser.add_argument("--verdicts", action="store_true")
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/apps/ogive")
    parser.add_argument("--out", type=Path, default=ROOT / "vtk_out/random_shots")
    options = parser.parse_args()
    if not options.program.is_file():
        parser.error(f"--program = {options.program}: there is no such program; scripts/build.sh ogive_main")
    options.count = options.count or (400 if options.verdicts else 200)
    draw = random.Random(options.seed)
    cases = [random_shot(draw) if options.verdicts else random_case(draw) for _ in range(options.count)]
    failed = aside = 0
    with ThreadPoolExecutor(options.jobs) as pool:
        for number, (faults, apart) in enumerate(pool.map(lambda item: shoot(*item, options), enumerate(cases))):
            failed += bool(faults)
            aside += apart is not None and not faults
            for text in filter(None, ["; ".join(faults), apart]):
                print(f"{number:03d}: {text}\n     {' '.join(arguments_of(cases[number]))}", flush=True)
    print(f"{options.count - failed - aside} of {options.count} random shots in order, {aside} "
          f"{'undecided, refused or with a warning' if options.verdicts else 'refused'}, {failed} failed (seed {options.seed}"
          f"{'' if options.verdicts else f', {options.end_us:g} us'})")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
