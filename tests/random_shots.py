#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""random_shots.py [--count N] [--seed S] [--jobs J] [--program PROGRAM] [--out FOLDER] [--end-us T]

Shoots N random but legal cases for a short time (200 cases of 30 us unless said otherwise) and checks each: no fault, an
energy error below 1 %, no particle deeper in the projectile than half a particle distance, finite numbers. The same seed
gives the same cases. Prints a line for each case that is not in order and, last, how many are. Exit status 1 if one is
not, 2 for wrong options. A case that failed runs again with `ogive shoot --config FOLDER/<number>/case.toml`.

A hex with several points can lose the volume of one of them at a sharp tip that yields. ogive stops such a shot
because of that volume, or of the time step that it allows, before its energy goes wrong: it is printed as refused and is
no failure.
"""

import argparse
import json
import math
import random
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MOST_PARTICLES = 6000
ENERGY_ERROR = 0.01
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


def arguments_of(case):
    return [f"--{key.replace('_', '-')}={value}" for key, value in case.items()]


def outcome_of(case, folder, status, output):
    """What is not in order with a shot, as a list of texts, and why it was refused, if it was."""
    try:
        summary = json.loads((folder / "summary.json").read_text())
    except (OSError, json.JSONDecodeError):
        last = output.strip().splitlines()[-1:] or ["no output"]
        return [f"status {status}: {last[0]}"], None
    found, refused = [], None
    if status != 0 or summary["fault"]:
        fault = summary["fault"] or {}
        text = f"{fault.get('what')} ({fault.get('body')} {fault.get('id')}, {fault.get('time_us')} us)"
        if status == 3 and case["element"] == "selective_reduced" and str(fault.get("what")).startswith(REFUSED):
            refused = text
        else:
            found.append(f"status {status}: {text}")
    numbers = {key: value for key, value in summary.items() if isinstance(value, float)}
    found += [f"{key} is {value}" for key, value in numbers.items() if not math.isfinite(value)]
    if not summary["energy_error"] <= ENERGY_ERROR:
        found.append(f"energy error {100 * summary['energy_error']:.2f} %")
    if not summary["largest_intrusion_mm"] <= 0.5 * summary["spacing_mm"]:
        found.append(f"a particle {summary['largest_intrusion_mm']:.3f} mm inside the projectile")
    return found, refused


def shoot(number, case, options):
    folder = options.out / f"{number:03d}"
    command = [str(options.program), "shoot", *arguments_of(case), f"--end-us={options.end_us}", "--threads=1", "--quiet",
               "--no-vtk", "--no-picture", f"--out={folder}"]
    done = subprocess.run(command, capture_output=True, text=True)
    return outcome_of(case, folder, done.returncode, done.stderr)


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=20120726)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--end-us", type=float, default=30)
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/apps/ogive")
    parser.add_argument("--out", type=Path, default=ROOT / "vtk_out/random_shots")
    options = parser.parse_args()
    if not options.program.is_file():
        parser.error(f"--program = {options.program}: there is no such program; scripts/build.sh ogive_main")
    draw = random.Random(options.seed)
    cases = [random_case(draw) for _ in range(options.count)]
    with ThreadPoolExecutor(options.jobs) as pool:
        results = list(pool.map(lambda item: shoot(*item, options), enumerate(cases)))
    for number, (case, (faults, refused)) in enumerate(zip(cases, results)):
        for text in filter(None, ["; ".join(faults), refused and f"refused: {refused}"]):
            print(f"{number:03d}: {text}\n     {' '.join(arguments_of(case))}")
    failed = sum(bool(faults) for faults, _ in results)
    refusals = sum(refused is not None and not faults for faults, refused in results)
    print(f"{options.count - failed - refusals} of {options.count} random shots in order, {refusals} refused, "
          f"{failed} failed (seed {options.seed}, {options.end_us:g} us)")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
