"""scripts/results: the tables of docs/, of made-up shots."""

import contextlib
import io
import json
import math
import shutil
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from made_up import SCRIPTS, run
from results import cavity, limits, sweeps, tables, validation


class Tables(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)
        for patch in (mock.patch.object(sweeps, "FOLDER", self.folder), mock.patch.object(sweeps, "PROGRAM", "false"),
                      mock.patch.object(sweeps, "KEPT", self.folder / "kept")):
            patch.start()
            self.addCleanup(patch.stop)

    def leave(self, folder, name, **values):
        shot = self.folder / folder / "shots" / name
        shot.mkdir(parents=True)
        (shot / "summary.json").write_text(json.dumps({"version": "0.1.0", "fault": None, **values}))

    def table(self, name):
        with contextlib.redirect_stdout(io.StringIO()) as text:
            tables.make_tables(name)
        return text.getvalue().splitlines()

    def test_every_list_is_there_with_names_and_texts(self):
        for name, (page, blocks) in tables.TABLES.items():
            text = (SCRIPTS.parent / "docs" / f"{page}.md").read_text()
            self.assertEqual(text.count(f"<!-- tables: scripts/results.sh tables {name} -->"), 2, name)
            for sweep in (sweep for block in blocks for sweep in block.sweeps):
                names = [case["name"] for case in sweeps.cases(sweep)]
                self.assertEqual(len(names), len(set(names)), sweep)
                for case in sweeps.cases(sweep):
                    metal = case.get("material", "")
                    self.assertTrue(not metal.endswith(".toml") or metal in sweeps.METALS or (sweeps.CASES / metal).is_file(),
                                    case)

    def test_kept_rows_are_those_of_the_lists(self):
        # Otherwise tables lose them without a word. After a change of a list its rows are run again, or deleted.
        kept = SCRIPTS.parent / "bench" / "rows"
        for _, blocks in tables.TABLES.values():
            for sweep in (sweep for block in blocks for sweep in block.sweeps):
                recipe = kept / sweep.folder / "recipe.txt"
                if recipe.exists():
                    self.assertEqual(recipe.read_text().strip(), sweeps.recipe(sweep), recipe)

    def test_shots(self):
        self.leave("near_limit_8mm", "bonds", initial_velocity_mps=180.0, residual_velocity_mps=59.64, plug_mass_g=22.01,
                   test_residual_velocity_mps=84.31, test_origin="Recht-Ipson curve", energy_error=0.000141,
                   largest_intrusion_mm=0.0, momentum_error=2.3e-15, steps=2228)
        self.leave("near_limit_16mm", "bonds", initial_velocity_mps=265.0, fault={"what": "stopped"})
        lines = self.table("sensitivity")
        self.assertEqual(lines[0][:72], "Made by `scripts/results.sh tables sensitivity` with ogive 0.1.0. Tests ")
        self.assertEqual(lines[2:], [
            "Two plates near the limits of the tests, particles 0.8 mm apart:", "",
            "| case | initial, m/s | test, m/s | computed, m/s | plug, g | energy error, % | intrusion, mm | momentum error | "
            "steps |", "|---|---|---|---|---|---|---|---|---|",
            "| 8 mm, bonds against zero-energy modes, 0.3 | 180.0 | (84.3) | 59.6 | 22.0 | 0.014 | 0.000 | 2e-15 | 2228 |"])

    def test_values_that_are_missing(self):
        self.leave("stabilised_6mm", "base", initial_velocity_mps=170, residual_velocity_mps=0.0, failed_particles=26,
                   dishing_mm=13.92)
        self.assertEqual(self.table("stabilised")[-1], "| 6 mm, default | 170.0 | – | 0.0 | – | 26 | 13.92 | – | – | – |")

    def leave_limits(self, folder, head, *rows):
        """Rows without a bracket get one as wide as that of a search that has ended."""
        if "lowest_perforated_mps" not in head:
            head, rows = f"{head},highest_stopped_mps,lowest_perforated_mps", [f"{row},200,205" for row in rows]
        (self.folder / folder).mkdir()
        (self.folder / folder / "limits.csv").write_text("\n".join([head, *rows, ""]))

    def test_limits_beside_those_of_the_paper(self):
        head = "thickness_mm,highest_stopped_mps,lowest_perforated_mps,bisection_limit_mps"
        self.leave_limits("limits_paper", head, "6,110,115,112.5", "8,145,,", "12,190,195,192.5")
        self.leave_limits("limits_paper_standard", head, "12,180,185,182.5")
        lines = self.table("paper")
        self.assertEqual([line for line in lines if "mm |" in line], [
            "| 6 mm | 145.5 | 110 | 112.5 | +2.3 % | -22.7 % |", "| 12 mm | 184.5 | 195 | 192.5 | -1.3 % | +4.3 % |",
            "| 12 mm | 184.5 | 195 | 182.5 | -6.4 % | -1.1 % |"])
        self.assertIn("The same with the standard form", lines[-5])

    def test_repeated_limits(self):
        self.leave_limits("repeats", "thickness_mm,seed,highest_stopped_mps,lowest_perforated_mps,bisection_limit_mps",
                          "12,0,189.5,190.5,190", "12,2,196.5,197.5,197", "12,1,191.5,192.5,192", "20,0,280,285,282.5",
                          "16,0,217,227,222")  # a search that has not ended
        # As in tests/fit/repeated_limit.cpp: mean 193, variance 13, t(0.95, 2) = 2.920.
        self.assertEqual(self.table("repeats")[-2:], [
            "| 12 mm | 184.5 | 190.0 | 192.0 | 197.0 | 193.0 | 3.6 | 186.9 to 199.1 | +4.6 % |",
            "| 20 mm | 293.9 | 282.5 | – | – | – | – | – | – |"])
        # Brackets that agree leave the interval as wide as they are.
        mean, deviation, half = limits.repeated_limit([(190, 3), (190, 3)])
        self.assertEqual((mean, deviation), (190, 0))
        self.assertAlmostEqual(half, 6.3138 * math.sqrt(3 / 2), places=4)

    def test_limits_in_other_sizes(self):
        head = "thickness_mm,diameter_mm,spacing_mm,sph_radius_mm,clamp_radius_mm,bisection_limit_mps"
        self.leave_limits("scale", head, "6,10,0.3,12,125,202", "12,20,0.6,24,250,192.5", "24,40,1.2,48,500,")
        self.assertEqual(self.table("scale")[-3:], ["| half | 6 | 10 | 0.3 | 202.0 | +4.9 % |",
                                                    "| that of the tests | 12 | 20 | 0.6 | 192.5 | +0.0 % |",
                                                    "| double | 24 | 40 | 1.2 | – | – |"])
        # Only the lengths differ between the cases: the plate's and the projectile's over the particle distance are the same.
        ratios = {tuple(float(case[key]) / float(case["spacing_mm"]) for key in case if key.endswith("_mm"))
                  for case in sweeps.cases(tables.TABLES["scale"][1][0].sweeps[0])}
        self.assertEqual(ratios, {(20, 20 / 0.6, 1, 40, 250 / 0.6)})

    def test_limits_with_other_particles(self):
        self.leave_limits("limits_stabilised_0.45mm", "thickness_mm,bisection_limit_mps", "6,136")
        self.leave_limits("repeats", "thickness_mm,seed,bisection_limit_mps", "6,0,140.5", "6,1,139", "12,0,191")
        self.assertEqual(self.table("sizes_stabilised")[6:8], [
            "| 6 mm | 145.5 | – | 136.0 | 140.5 | – | -3.2 % | +2.1 % |",
            "| 12 mm | 184.5 | – | – | 191.0 | – | – | – |"])

    def test_cost(self):
        record = self.folder / "run_record.csv"
        record.write_text("method,model,material,nose,thickness_mm,initial_velocity_mps,spacing_mm,cpu_s,version\n" + "".join(
            f"{method},mjc,weldox_460e,blunt,{thickness},200,0.6,{seconds},0.1.0\n" for method, thickness, seconds in (
                ("paper", 6, 10), ("stabilised", 6, 25), ("paper", 12, 20), ("stabilised", 12, 20), ("paper", 8, 7))))
        with mock.patch.object(tables, "PAGE", self.folder):
            self.assertEqual(self.table("cost")[-3:], [
                "| blunt | 6 mm weldox_460e | 1 | 10 | 25 | 2.50 |", "| blunt | 12 mm weldox_460e | 1 | 20 | 20 | 1.00 |",
                "| all |  | 2 | 30 | 45 | 1.50 |"])

    def test_accuracy_of_the_default_method(self):
        head = "material,nose,thickness_mm,spacing_mm,seed,highest_stopped_mps,lowest_perforated_mps,bisection_limit_mps"
        self.leave_limits("repeats", head, "weldox_460e,blunt,6,0.6,0,138,143,140.5", "weldox_460e,blunt,6,0.6,1,137,141,139")
        (self.folder / "repeats" / "shots.csv").write_text(
            "material,nose,thickness_mm,spacing_mm,seed,initial_velocity_mps,cpu_s,version\n" + "".join(
                f"weldox_460e,blunt,{row},0.1.0\n" for row in ("6,0.6,0,143,50", "6,0.6,1,141,70", "8,0.6,0,141,900")))
        self.leave_limits("sharp", "material,nose,thickness_mm,spacing_mm,bisection_limit_mps",
                          "aa5083_h116,conical,15,1,211.5")
        self.leave_limits("open", "material,projectile,thickness_mm,sph_radius_mm,clamp_radius_mm,spacing_mm,bisection_limit_mps",
                          "/a/b/aa6061_t651_jc.toml,fsp_20mm,12.7,24,150,1,204.9")
        self.assertEqual(self.table("accuracy")[-3:], [
            "| blunt, 6 to 20 mm Weldox 460 E | 1 | -4.0 % | -4.0 % | chosen on |",
            "| cone, 15 to 30 mm AA5083-H116 | 1 | -2.4 % | -2.4 % | known |",
            "| 20 mm fragment simulator, 12.7 mm AA6061-T651 | 1 | -6.0 % | -6.0 % | chosen on |"])
        # Mean of two arrangements; the brackets allow (2.5^2 + 2^2) / 6, the limits differ by 0.75^2 * 2.
        half = 6.3138 * math.sqrt((2.5 ** 2 + 2 ** 2) / 6 / 2)
        self.assertEqual(self.table("validation")[-3:], [
            f"| blunt, 6 mm Weldox 460 E | 0.6 | 145.5 ± 5 | 139.8 ± {half:.1f} | 2 | -4.0 % | chosen on | – | 2 |",
            "| conical, 15 mm AA5083-H116 | 1 | 216.8 ± 5 | 211.5 ± 2.5 | 1 | -2.4 % | known | – | 0 |",
            "| 20 mm FSP at 12.7 mm AA6061-T651 | 1 | 218.0 | 204.9 ± 2.5 | 1 | -6.0 % | chosen on | – | 0 |"])
        picture = self.folder / "limits.svg"
        with contextlib.redirect_stdout(io.StringIO()):
            validation.draw(tables.ALL_LIMITS, picture)
        drawn = picture.read_text()
        self.assertIn("20 mm fragment simulator, 12.7 mm AA6061-T651", drawn)
        self.assertNotIn("APM2", drawn)  # of which there is no limit

    def test_no_shot_is_an_error(self):
        done = run("tables", "no_such_table")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("tables = no_such_table: must be one of sensitivity,", done.stderr)
        with self.assertRaisesRegex(tables.InputError, "no shot has been run"):
            tables.make_tables("dishing")

    def test_metals_with_other_constants(self):
        text = 'name = "aa"\nA_MPa = 200 # yield stress\nB_MPa = 300\n'
        self.assertEqual(sweeps.changed_metal(text, "b_0.9.toml", {"B_MPa": lambda v: 0.9 * v}),
                         'name = "b_0.9"\nA_MPa = 200 # yield stress\nB_MPa = 270\n')
        with self.assertRaisesRegex(tables.InputError, "D1: is no constant"):
            sweeps.changed_metal(text, "b.toml", {"D1": lambda v: 2 * v})

    def test_cavity_expansion(self):
        # Without hardening the integral is ln(E/(sqrt(3) Y)).
        self.assertAlmostEqual(cavity.expansion_stress(300e6, 70e9, 0) / 1e6,
                               300 / math.sqrt(3) * (1 + math.log(70e3 / (math.sqrt(3) * 300))), 4)
        core = {"projectile": "7.62 mm APM2 core", "thickness_mm": "20", "obliquity_deg": "0", "yield_MPa": "300",
                "young_GPa": "70", "ludwik_n": "0"}
        # The energy of 5.25 g is the work of that stress on the hole.
        work = cavity.expansion_stress(300e6, 70e9, 0) * 20e-3 * math.pi * (6.17e-3 / 2) ** 2
        self.assertAlmostEqual(cavity.limit_mps(core), math.sqrt(2 * work / 5.25e-3), 6)
        for change in ({"obliquity_deg": "30"}, {"yield_MPa": ""}, {"projectile": "20 mm FSP"}):
            self.assertIsNone(cavity.limit_mps({**core, **change}))

    def test_rows_are_kept_and_taken_up_again(self):
        program = self.folder / "ogive"
        program.write_text('#!/bin/sh\nwhile [ "$1" != --out ]; do shift; done\n[ -f "$2/shots.csv" ] || echo version > '
                           '"$2/shots.csv"\necho 1.2.3 >> "$2/shots.csv"\ncp "$2/shots.csv" "$2/limits.csv"\n')
        program.chmod(0o755)
        limit = tables.SHARP
        shot = tables.TABLES["measured"][1][0].sweeps[0]
        (self.folder / limit.folder).mkdir()
        (self.folder / shot.folder).mkdir()
        (self.folder / shot.folder / "shots" / "304").mkdir(parents=True)
        (self.folder / shot.folder / "shots" / "304" / "summary.json").write_text(
            '{"fault": null, "initial_velocity_mps": 303.5, "residual_velocity_mps": 208.6, "particles": 25820}')
        with mock.patch.object(sweeps, "PROGRAM", program), contextlib.redirect_stderr(io.StringIO()):
            sweeps.run(limit)
            sweeps.run(shot)
            shutil.rmtree(self.folder / limit.folder)
            shutil.rmtree(self.folder / shot.folder)
            sweeps.run(limit)
        rows = "version\n1.2.3\n1.2.3\n"
        self.assertEqual((self.folder / limit.folder / "shots.csv").read_text(), rows)
        self.assertEqual((self.folder / "kept" / limit.folder / "limits.csv").read_text(), rows)
        self.assertEqual(sweeps.versions(limit), {"1.2.3"})
        self.assertEqual((self.folder / "kept" / shot.folder / "shots.csv").read_text(), "version\n1.2.3\n")
        self.assertEqual(sweeps.summary(shot, "304"), {"initial_velocity_mps": 303.5, "residual_velocity_mps": 208.6})
        self.assertIsNone(sweeps.summary(shot, "400"))
        with_own_metals = tables.TABLES["sensitivity"][1][0].sweeps[0]
        self.assertFalse(sweeps.has_portable_rows(with_own_metals))
        self.assertTrue(sweeps.has_portable_rows(shot))
        shown = {key for column in (*tables.SHOTS, *tables.STABILISED, *tables.CONES, *tables.DISHINGS)
                 for key in column.keys.split()}
        self.assertEqual(shown - set(sweeps.SHOWN_KEYS), {"case_spacing_mm"})

    def test_sweeps_get_all_options(self):
        program = self.folder / "ogive"
        program.write_text('#!/bin/sh\n[ "$1" = sweep ] || { echo \'name = "x"\'; echo "rate_floor_per_s = 1"; exit; }\n'
                           f'echo "$@" > {self.folder}/said; cat "$2" >> {self.folder}/said\n')
        program.chmod(0o755)
        with mock.patch.object(sweeps, "PROGRAM", program), contextlib.redirect_stderr(io.StringIO()):
            sweeps.run(tables.TABLES["sensitivity"][1][0].sweeps[0], 2)
        said = (self.folder / "said").read_text().splitlines()
        folder = self.folder / "sensitivity"
        self.assertEqual(said[0], f"sweep {folder}/cases.csv --jobs 2 --method paper --no-vtk --no-picture "
                                  f"--out {folder}")
        self.assertTrue(said[-1].endswith(f",{folder}/floor_100.toml"))
        self.assertEqual((folder / "floor_100.toml").read_text(), 'name = "floor_100"\nrate_floor_per_s = 100\n')


if __name__ == "__main__":
    unittest.main()
