"""scripts/results: pictures of the figures, the gallery and the fits, with programs that are made up."""

import contextlib
import io
import json
import os
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from made_up import SCRIPTS, run
from results import figures, fits, gallery


class Figures(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)
        self.campaign = figures.Campaign(self.folder, self.folder, 0.6)
        self.commands = []
        patch = mock.patch.object(figures.Campaign, "attempt", lambda _, *command, **__: self.commands.append(command))
        patch.start()
        self.addCleanup(patch.stop)
        self.find_ffmpeg("/usr/bin/ffmpeg")

    def find_ffmpeg(self, place):
        patch = mock.patch.object(figures.shutil, "which", lambda _: place)
        patch.start()
        self.addCleanup(patch.stop)

    def leave(self, name, *times):
        folder = self.folder / "shots" / name
        folder.mkdir(parents=True)
        (folder / "summary.json").write_text("{}")
        frames = "".join(f'<DataSet timestep="{time}" part="0" file="{time}.vtm"/>' for time in times)
        (folder / "perforation.pvd").write_text(f'<?xml version="1.0"?><VTKFile><Collection>{frames}</Collection></VTKFile>')
        rows = "".join(f"{time},{180 - time}\n" for time in times)
        (folder / "history.csv").write_text("time_us,velocity_m_per_s\n" + rows)
        return folder

    def test_pictures_of_the_shots_that_are_there(self):
        thick = self.leave("stabilised_mjc_weldox_460e_blunt_10mm_180mps_0.6mm", 0, 20, 41.5)
        thin = self.leave("stabilised_mjc_weldox_460e_blunt_6mm_160mps_0.6mm", 0, 30)
        with contextlib.redirect_stdout(io.StringIO()) as said:
            self.campaign.pictures("stabilised")
        drawn = [list(map(str, command)) for command in self.commands]
        self.assertEqual([Path(command[0]).name for command in drawn], [
            "figure_7_stabilised.png", "figure_7_temperature_stabilised.png", "figure_7_stabilised.webm",
            "figure_8_stabilised.png"])
        self.assertEqual(drawn[0][2:7], ["draw", "--series", str(thick), "--times-us", "0,10,20,last"])
        self.assertEqual(drawn[2][2:6], ["draw", "--series", str(thick), "--title"])
        self.assertEqual(drawn[2][7:8], ["--animate"])
        self.assertEqual(drawn[3][2:13], ["draw", "--series", str(thin), str(thick), "--times-us", "0,15,last", "--label",
                                          "(a) 6 mm, 0 µs, 180 m/s", "(a) 6 mm, 15 µs, 180 m/s", "(a) 6 mm, 30 µs, 150 m/s",
                                          "(b) 10 mm, 0 µs, 180 m/s"])
        self.assertIn("(b) 10 mm, 42 µs, 138 m/s", drawn[3])  # 41.5 µs, of its own last frame
        self.assertIn("figure 14_stabilised is left out: no shot with frames", said.getvalue())

    def test_a_picture_newer_than_its_series_stays(self):
        self.leave("paper_mjc_aa5083_h116_conical_15mm_214mps_0.6mm", 0, 400)
        pictures = [self.folder / f"figure_{name}.png" for name in ("14", "14_behind")]
        for picture in pictures:
            picture.touch()
        self.find_ffmpeg(None)
        for age, commands in ((-100, 2), (100, 2)):
            series = (self.folder / "shots/paper_mjc_aa5083_h116_conical_15mm_214mps_0.6mm/perforation.pvd").stat().st_mtime
            for picture in pictures:
                os.utime(picture, (series + age, series + age))
            with contextlib.redirect_stdout(io.StringIO()):
                self.campaign.pictures("paper")
            self.assertEqual(len(self.commands), commands)

    def test_fits_are_made_when_curves_or_program_are_newer(self):
        program, last = self.folder / "ogive", self.folder / "aluminium_power" / "fit.json"
        program.touch()
        self.assertFalse(fits.are_done(self.folder, program, page_only=True))
        last.parent.mkdir()
        last.touch()
        self.assertTrue(fits.are_done(self.folder, program))
        os.utime(last, (1, 1))
        self.assertFalse(fits.are_done(self.folder, program))
        self.assertTrue(fits.are_done(self.folder, program, page_only=True))


class Gallery(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def test_page_is_that_of_the_rows(self):
        root = SCRIPTS.parent
        rows = gallery.kept()
        self.assertEqual([case["name"] for case in gallery.cases()], list(rows), "scripts/results.sh gallery --run --insert")
        self.assertIn(gallery.text_of(rows), (root / "docs" / "gallery.md").read_text(encoding="utf-8"))
        for name in rows:
            self.assertLessEqual((gallery.PICTURES / f"{name}.png").stat().st_size, gallery.MOST_BYTES)
        for case in gallery.cases():
            for word in gallery.shot(case):
                self.assertTrue(not word.endswith(".toml") or (root / word).is_file(), word)

    def test_missing_shots_are_run_drawn_and_kept(self):
        program = self.folder / "ogive"
        program.write_text('#!/bin/sh\nwhile [ "$1" != --out ]; do [ "$1" != --series ] || drawn=yes; shift; done\n'
                           f'mkdir -p {self.folder}/shots; [ -z "$drawn" ] || {{ echo png > "$2"; exit; }}\n'
                           'mkdir -p "$2"; echo \'{"verdict": "perforated", "initial_velocity_mps": 200, "residual_velocity_mps": '
                           '98.7, "plug_mass_g": 12.3, "test_residual_velocity_mps": null, "particles": 9, "cpu_s": 1.25, '
                           '"version": "0.1.0"}\' > "$2/summary.json"\n')
        program.chmod(0o755)
        one = {"name": "one", "text": "One", "material": "../../examples/aa6061_t651_jc.toml", "rigid": "true", "nose": "",
               "velocity_mps": "200", "spacing_mm": "1.2"}
        with (mock.patch.object(gallery, "cases", lambda: [one]), mock.patch.object(gallery, "ROWS", self.folder / "rows.csv"),
              mock.patch.object(gallery, "PICTURES", self.folder / "pictures"),
              mock.patch.object(gallery, "FOLDER", str(self.folder / "shots")), contextlib.redirect_stderr(io.StringIO())):
            gallery.run_missing_shots(program)
            text = gallery.text_of(gallery.kept())
            one["velocity_mps"] = "210"
            self.assertEqual({}, gallery.kept())
        self.assertIn("| ![One](gallery/one.png) | One | 200 m/s before the plate, 99 m/s behind it; plug of 12.3 g | 1.2 | 9 | 1.2 |",
                      text)
        self.assertIn(f"ogive shoot --material examples/aa6061_t651_jc.toml --rigid --velocity-mps 200 --spacing-mm 1.2 --out "
                      f"{self.folder}/shots/one\n", text)


class Fits(unittest.TestCase):
    FIT = {"A_MPa": 1, "B_MPa": 2, "a": 3, "n": 3, "C": 4, "b": 5, "m": 5, "rms_percent": 6, "version": "0.1.0"}

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)
        self.program, self.curves = self.folder / "ogive", self.folder / "curves"
        fit = {**self.FIT, "standard_error": self.FIT, "simultaneous": self.FIT,
               "quasi_static": {"A_MPa": 1, "B_MPa": 2, "rate_per_s": 7.4e-4}}
        self.program.write_text('#!/bin/sh\necho "$@" >> ' + f"{self.folder}/commands\n"
                                'while [ "$1" != --out ]; do shift; done\nmkdir -p "$2"\n'
                                f"echo '{json.dumps(fit)}' > \"$2/fit.json\"\n")
        self.program.chmod(0o755)
        self.curves.mkdir()

    def fit(self, *arguments):
        return run("fits", "--program", self.program, "--folder", self.folder / "fits", *arguments)

    def test_synthetic_curves(self):
        done = self.fit()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("from synthetic curves.", done.stdout)
        self.assertEqual(done.stdout.count("law that made the curves"), 2)
        commands = (self.folder / "commands").read_text().splitlines()
        self.assertEqual(len(commands), 7)
        self.assertRegex(commands[0],
                         r"^calibrate --data \S*/synthetic_weldox_460e.csv --name Weldox 460 E synthetic --melting-K")

    def test_curves_of_the_user(self):
        (self.curves / "aa5083_h116.csv").write_text("")
        done = self.fit("--curves", self.curves)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("from measured curves.", done.stdout)
        self.assertIn("| paper, Table 2 |", done.stdout)
        self.assertNotIn("Table 1", done.stdout)
        self.assertNotIn("law that made the curves", done.stdout)
        commands = (self.folder / "commands").read_text().splitlines()
        self.assertEqual(len(commands), 3)
        self.assertTrue(all(f"--data {self.curves}/aa5083_h116.csv --name AA5083-H116 --melting-K" in c for c in commands))

    def test_wrong_input(self):
        for arguments, text in (((), "must be a folder that holds weldox_460e.csv or aa5083_h116.csv"),
                                (("--insert",), "must not go with --curves")):
            done = self.fit("--curves", self.curves, *arguments)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn(text, done.stderr)
            self.assertFalse((self.folder / "commands").exists())


if __name__ == "__main__":
    unittest.main()
