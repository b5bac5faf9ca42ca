#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Reads results of ogive with VTK's Python modules (Debian: python3-vtk9) and the standard library.

Run: 11_read_results.py FOLDER, of `ogive shoot` (with frames), or of `ogive sweep` or `ogive limit`. For a shot it prints time,
velocity and largest plastic strain of each frame and what became of the plate; for a study a line for each shot.
"""
import bisect
import csv
import json
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader


def grid_of(file):
    """The points and cells of a .vtu file: positions in mm, every array with its unit in its name."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(file))
    reader.Update()
    return reader.GetOutput()


def frames_of(pvd):
    """(time in us, {name of the part: its grid}) of each frame of a series."""
    frames = {}
    for entry in xml.parse(pvd).iter("DataSet"):
        frames.setdefault(float(entry.get("timestep")), {})[entry.get("name")] = pvd.parent / entry.get("file")
    for time_us, files in frames.items():
        yield time_us, {part: grid_of(file) for part, file in files.items()}


def values_of(grid, name):
    """The numbers of a scalar array: of particles it is on the points, of hexes on the cells."""
    array = grid.GetPointData().GetArray(name) or grid.GetCellData().GetArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def rows_of(file):
    """The rows of a table, by the names of its columns."""
    with open(file, newline="", encoding="utf-8") as table:
        return list(csv.DictReader(table))


def print_shot(folder):
    history = rows_of(folder / "history.csv")
    times = [float(row["time_us"]) for row in history]
    for time_us, parts in frames_of(folder / "perforation.pvd"):
        strain = max(max(values_of(grid, "plastic_strain")) for part, grid in parts.items() if part != "projectile")
        row = history[min(bisect.bisect_left(times, time_us), len(history) - 1)]
        print(f"{time_us:7.2f} us {float(row['velocity_m_per_s']):7.1f} m/s   largest plastic strain {strain:.3f}")
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    print(f"{summary['verdict']}: plug {summary['plug_mass_g']:.2f} g, energy error {summary['energy_error']:.1e}")


def print_study(folder):
    for row in rows_of(folder / "shots.csv"):
        residual = row["residual_velocity_mps"] or "undecided"
        print(f"{row['thickness_mm']} mm at {row['initial_velocity_mps']} m/s: {residual}")


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: 11_read_results.py FOLDER")
    folder = Path(sys.argv[1])
    (print_study if (folder / "shots.csv").exists() else print_shot)(folder)


if __name__ == "__main__":
    main()
