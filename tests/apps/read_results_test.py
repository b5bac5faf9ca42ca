#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""read_results_test.py <ogive> <folder> <project>: the Python example reads a shot and a study, and the guide describes every
key, column and array that they have."""
import importlib.util
import json
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

SMALL = ["--spacing-mm", "2", "--sph-radius-mm", "15", "--clamp-radius-mm", "30", "--projectile", "rigid", "--end-us", "20",
         "--output-every-us", "10", "--threads", "1"]
ogive, folder, project = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
example = project / "examples/11_read_results.py"
spec = importlib.util.spec_from_file_location("read_results", example)


def run(*arguments):
    return subprocess.run([ogive, *map(str, arguments)], check=True, capture_output=True, text=True).stdout


def printed_by_example(of):
    return subprocess.run([sys.executable, example, of], check=True, capture_output=True, text=True).stdout.splitlines()


class Results(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        run("shoot", *SMALL, "--thickness-mm", 4, "--velocity-mps", 200, "--no-picture", "--quiet", "--out", folder / "shot")
        for name, *options in (("layers", "--layers-mm", "4,4"), ("paper", "--thickness-mm", 4, "--method", "paper")):
            run("shoot", *SMALL, *options, "--velocity-mps", 200, "--no-picture", "--quiet", "--out", folder / name)
        run("sweep", *SMALL, "--thickness-mm", 4, "--vary", "velocity_mps=150,200", "--out", folder / "study")
        guide = (project / "docs/doxygen/guide.md").read_text(encoding="utf-8")
        section = guide[guide.index("{#guide_numbers}"):guide.index("{#guide_calibrate}")]
        cls.described = set(re.findall(r"`(\w+)`", section))
        cls.read = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(cls.read)

    def test_summary(self):
        for name in ("shot", "layers", "paper"):
            summary = json.loads((folder / name / "summary.json").read_text())
            keys = set(summary) | {key for layer in summary.get("layers", []) for key in layer}
            self.assertEqual(keys - self.described, set())

    def test_columns(self):
        self.assertEqual(set(self.read.rows_of(folder / "shot/history.csv")[0]) - self.described, set())
        self.assertEqual(set(self.read.rows_of(folder / "study/shots.csv")[0]) - self.described, set())

    def test_arrays(self):
        for _, parts in self.read.frames_of(folder / "layers/perforation.pvd"):
            for grid in parts.values():
                for data in (grid.GetPointData(), grid.GetCellData(), grid.GetFieldData()):
                    names = {data.GetArrayName(k) for k in range(data.GetNumberOfArrays())}
                    self.assertEqual(names - self.described, set())

    def test_shot(self):
        frames = list(self.read.frames_of(folder / "shot/perforation.pvd"))
        self.assertEqual([round(time_us / 10) for time_us, _ in frames], [0, 1, 2])
        summary = json.loads((folder / "shot/summary.json").read_text())
        particles = frames[-1][1]["disc"]
        self.assertEqual(particles.GetNumberOfPoints(), summary["particles"])
        strain = self.read.values_of(particles, "plastic_strain")
        self.assertEqual(len(strain), summary["particles"])
        self.assertGreater(max(strain), 0.05)
        lines = printed_by_example(folder / "shot")
        self.assertEqual(len(lines), 4)
        self.assertRegex(lines[0], r"^ +0\.00 us +200\.0 m/s   largest plastic strain 0\.000$")
        self.assertRegex(lines[2], f"largest plastic strain {max(strain):.3f}$")
        self.assertTrue(lines[3].startswith("undecided: plug "), lines[3])

    @unittest.skipUnless(shutil.which("ffmpeg"), "needs ffmpeg")
    def test_film_of_a_shot(self):
        run("shoot", *SMALL, "--thickness-mm", 4, "--velocity-mps", 200, "--no-picture", "--quiet", "--animate",
            folder / "film.gif", "--out", folder / "film")
        self.assertEqual((folder / "film.gif").read_bytes()[:6], b"GIF89a")

    def test_study(self):
        # Rows come in the order in which the shots end.
        self.assertEqual(sorted(printed_by_example(folder / "study")),
                         ["4 mm at 150 m/s: undecided", "4 mm at 200 m/s: undecided"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
